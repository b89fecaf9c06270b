#include "thermal/impedance_modes.hpp"

namespace shellback::thermal {

ImpedanceModes impedance_modes(const Eigen::MatrixXd& Z, const Eigen::VectorXd& dz) {
  const Eigen::VectorXd root = dz.cwiseSqrt(), over_root = root.cwiseInverse();
  const Eigen::MatrixXd z = root.asDiagonal() * Z * over_root.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (z + z.transpose()));
  return {eigen.eigenvalues(), over_root.asDiagonal() * eigen.eigenvectors()};
}

}  // namespace shellback::thermal
