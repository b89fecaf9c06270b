#include "bearing/over_time/orbit_growth.hpp"

#include "core/decompositions.hpp"

namespace shellback::bearing {
namespace {

/// Differences between the ends of cycles, as far as something is left of the disturbance.
Eigen::MatrixXd differences(const std::vector<JournalState>& states, double displaced) {
  constexpr double kLeft = 1e-3;  // of the disturbance [-]
  const auto at = [&](std::size_t k) {
    return Eigen::Map<const Eigen::Vector4d>(states[k].data());
  };
  Eigen::MatrixXd d(4, static_cast<Eigen::Index>(states.size()));
  Eigen::Index n = 0;
  for (std::size_t k = 0; k + 1 < states.size(); ++k) {
    d.col(n) = at(k + 1) - at(k);
    if (!(d.col(n).norm() > kLeft * displaced)) break;
    ++n;
  }
  return d.leftCols(n);
}

/// Largest of the last three over largest of the first three.
double kept(const Eigen::MatrixXd& d) {
  return d.rightCols(3).colwise().norm().maxCoeff() / d.leftCols(3).colwise().norm().maxCoeff();
}

}  // namespace

std::optional<double> growth_per_cycle(const std::vector<JournalState>& states, double displaced) {
  constexpr double kSeen = 0.01;  // of the largest difference [-]
  constexpr double kFell = 0.5;   // an ellipse passed in other places each time is within it [-]
  const Eigen::MatrixXd d = differences(states, displaced);
  if (d.cols() < 3) return 0.0;
  const Eigen::Index n = d.cols() - 1;
  const ThinSvd svd = thin_svd(d.leftCols(n));
  const Eigen::Index rank = (svd.values.array() > kSeen * svd.values[0]).count();
  const Eigen::MatrixXd inverse =
      svd.V.leftCols(rank) * svd.values.head(rank).cwiseInverse().asDiagonal();
  const Eigen::MatrixXd M = svd.U.leftCols(rank).transpose() * d.rightCols(n) * inverse;
  const double growth = spectral_radius(M);
  if (growth >= 1.0 && kept(d) < kFell) return std::nullopt;
  return growth;
}

}  // namespace shellback::bearing
