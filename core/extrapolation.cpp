#include "core/extrapolation.hpp"

#include <Eigen/Dense>

#include "core/contract.hpp"

namespace shellback {

std::optional<std::vector<double>> extrapolated(const std::vector<Iterate>& of) {
  EXPECTS(of.size() > 1);
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  const auto g = [&](std::size_t j) {
    return Vector(of[j].g.data(), static_cast<Eigen::Index>(of[j].g.size()));
  };
  const auto change = [&](std::size_t j) -> Eigen::VectorXd {
    return g(j) - Vector(of[j].x.data(), static_cast<Eigen::Index>(of[j].x.size()));
  };
  // With gamma of the last one 1 - (the others) the least squares are free.
  const std::size_t last = of.size() - 1;
  const Eigen::VectorXd u = change(last);
  Eigen::MatrixXd A(u.size(), static_cast<Eigen::Index>(last));
  for (std::size_t j = 0; j < last; ++j) A.col(static_cast<Eigen::Index>(j)) = change(j) - u;
  if (!A.allFinite() || !u.allFinite() || A.isZero(0.0)) return std::nullopt;
  const Eigen::VectorXd gamma = A.colPivHouseholderQr().solve(-u);
  Eigen::VectorXd s = (1.0 - gamma.sum()) * g(last);
  for (std::size_t j = 0; j < last; ++j) s += gamma[static_cast<Eigen::Index>(j)] * g(j);
  return std::vector<double>(s.begin(), s.end());
}

}  // namespace shellback
