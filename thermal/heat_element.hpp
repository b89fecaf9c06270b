#pragma once
/// Element integrals of heat conduction in a body of revolution, per radian.
///
///   k0 = int k (N,r N,r^T + N,z N,z^T) r dA,   k2 = int k N N^T / r dA                      (1)
///   capacity = int rho c N N^T r dA,           ends, outer = int h N N^T r ds               (2)
///
/// Harmonic n conducts with k0 + n^2 k2; the capacity is the same for all harmonics (consistent
/// matrix: its rows add up to the capacity of the body). Eight-node rings, full quadrature
/// (core/revolution_mesh.hpp). Source: textbook (semi-analytical finite elements).
#include <array>
#include <vector>

#include "core/eigen.hpp"
#include "core/revolution_mesh.hpp"

namespace shellback::thermal {

enum class BackKind {
  convective,  ///< the outer surface gives heat to the ambient
  prescribed,  ///< the back of the shell, and all that is outside it, has a given temperature
};

struct ConductionBoundary {
  BackKind kind = BackKind::convective;
  double back_heat_transfer = 0.0;  ///< of the outer surface, convective only [W/(m2 K)]
  double end_heat_transfer = 0.0;   ///< of the end faces [W/(m2 K)]
  int back_line = 0;     ///< corner line at the back of the shell (outermost shell layer)
  double covered = 0.0;  ///< half-width of the outer surface that the film covers: it meets no
                         ///< ambient; of a shaft [m]
};

using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// Local nodes that belong to the outer corner line of their row.
inline constexpr std::array<int, 8> kUpperGroup{0, 1, 1, 0, 0, 1, 0, 0};

struct HeatElement {
  Matrix8 k0 = Matrix8::Zero(), k2 = Matrix8::Zero();       ///< [W/K] per radian
  Matrix8 ends = Matrix8::Zero(), outer = Matrix8::Zero();  ///< [W/K] per radian
  /// Conduction and losses of harmonic n.
  [[nodiscard]] Matrix8 steady(int n) const { return k0 + n * n * k2 + ends + outer; }
};

/// Integrals (1) and the losses of (2) of element (row, col) with conductivity k [W/(m K)].
[[nodiscard]] HeatElement heat_element(const RevolutionMesh& mesh, int row, int col, double k,
                                       const ConductionBoundary& boundary);

/// Capacity (2) of element (row, col) [J/K] per radian; `rho_c` [J/(m3 K)].
[[nodiscard]] Matrix8 heat_capacity_matrix(const RevolutionMesh& mesh, int row, int col,
                                           double rho_c);

}  // namespace shellback::thermal
