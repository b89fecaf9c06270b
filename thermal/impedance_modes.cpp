#include "thermal/impedance_modes.hpp"

#include "core/decompositions.hpp"

namespace shellback::thermal {

ImpedanceModes impedance_modes(const Eigen::MatrixXd& Z, const Eigen::VectorXd& dz) {
  const Eigen::VectorXd root = dz.cwiseSqrt(), over_root = root.cwiseInverse();
  const Eigen::MatrixXd z = root.asDiagonal() * Z * over_root.asDiagonal();
  const SymmetricModes modes = symmetric_modes(0.5 * (z + z.transpose()));
  return {modes.values, over_root.asDiagonal() * modes.vectors};
}

}  // namespace shellback::thermal
