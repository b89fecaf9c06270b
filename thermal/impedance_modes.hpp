#pragma once
/// Modes of what a surface answers to heat.
#include "core/eigen.hpp"

namespace shellback::thermal {

/// Of the rise T = Z q of axial cells by their fluxes.
struct ImpedanceModes {
  Eigen::VectorXd lambda;  ///< ascending [K m2/W]
  Eigen::MatrixXd V;       ///< Z V = V diag(lambda), V^T diag(dz) V = 1 [1/sqrt(m)]
};

/// `Z`: cells x cells [K m2/W]; diag(dz) Z is symmetric but for what its entries are known to, and
/// its symmetric part is taken. `dz`: lengths of the cells, positive [m]. textbook
[[nodiscard]] ImpedanceModes impedance_modes(const Eigen::MatrixXd& Z, const Eigen::VectorXd& dz);

}  // namespace shellback::thermal
