#include "bearing/over_time/orbit_growth.hpp"

#include <Eigen/Dense>

namespace shellback::bearing {

std::optional<double> growth_per_cycle(const std::vector<JournalState>& states) {
  constexpr double kSeen = 0.01;  // of the largest difference [-]
  const auto n = static_cast<Eigen::Index>(states.size()) - 2;
  if (n < 2) return std::nullopt;
  const auto change = [&](Eigen::Index k) -> Eigen::Vector4d {
    return Eigen::Map<const Eigen::Vector4d>(states[k + 1].data()) -
           Eigen::Map<const Eigen::Vector4d>(states[k].data());
  };
  Eigen::MatrixXd before(4, n), after(4, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    before.col(k) = change(k);
    after.col(k) = change(k + 1);
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(before, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(kSeen);
  const Eigen::Index rank = svd.rank();
  if (!before.allFinite() || !after.allFinite() || rank == 0) return std::nullopt;
  const Eigen::MatrixXd inverse =
      svd.matrixV().leftCols(rank) * svd.singularValues().head(rank).cwiseInverse().asDiagonal();
  const Eigen::MatrixXd M = svd.matrixU().leftCols(rank).transpose() * after * inverse;
  return M.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace shellback::bearing
