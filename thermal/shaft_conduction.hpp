#pragma once
/// Mean temperature around the shaft, over radius and axis.
///
///   (1/r)(r k T,r),r + (k T,z),z = rho c dT/dt                                        (1)
///   r = R, under the film:    heat flux q(z) - g (T - T_old) enters, constant on each film cell
///   r = R, on the overhangs:  -k T,r = h (T - T_ambient);   tips insulated
///
/// The shaft turns: a flux that is fixed in space heats each of its points in turn, and harmonics
/// n >= 1 die out within sqrt(2 a / (n Omega)), tenths of a millimetre (methods 3.3). What is left
/// is the mean around, harmonic 0 of thermal/conduction_system, on rings from the axis to the
/// journal's surface. Not for a hot spot that turns with the shaft (synchronous whirl).
///
/// Eliminated to the film's cells: with P the integrals of the surface's shape functions over them
/// and A = K + M/dt (implicit Euler; dt = infinity is the steady state),
///   T = A^-1 P R q + A^-1 M/dt T_before   (nodes),   t = Z q + history   (cells)       (2)
/// Z = R diag(1/dz) P^T A^-1 P, diag(dz) Z symmetric and positive: Z = V diag(1/mu) V^T diag(dz),
/// V^T diag(dz) V = 1, mu >= 0 the conductances of its modes [W/(m2 K)]. In the steady state a
/// shaft that can lose no heat, or hardly any, has mu near 0 for its mean: A is eliminated with
/// s = k/R on the film's cells, which is taken from mu again. Heat in = out + stored to round-off.
///
/// A shaft that is slender against its heat path is the fin of the textbooks: h R / k and
/// (R / B)^2 small, d/dz (k A dT/dz) + 2 pi R q = rho c A dT/dt with A = pi R^2. Sources: textbook
/// [Carslaw and Jaeger, Conduction of Heat in Solids]; decision 036.
#include <limits>
#include <vector>

#include "core/grid.hpp"
#include "core/revolution_mesh.hpp"
#include "thermal/conduction_system.hpp"

namespace shellback::thermal {

struct ShaftBody {
  double conductivity = 0.0;   ///< k [W/(m K)]
  double heat_transfer = 0.0;  ///< h of the overhangs' surface [W/(m2 K)]
  double ambient = 0.0;        ///< temperature around the overhangs [K]
  double capacity = 0.0;       ///< rho c [J/(m3 K)]; for time steps
};

/// Section of a solid shaft of the film's radius with an overhang [m] on each side: the elements of
/// the film's cells, growing away from its edges along axis and radius.
[[nodiscard]] RevolutionMesh shaft_mesh(const FilmGrid& grid, double overhang);

struct ShaftTemperature {
  std::vector<double> temperature;  ///< of the surface, mean over each axial film cell [K]
  Eigen::VectorXd nodal;            ///< of the mesh's nodes, above ambient [K]
  double heat_in = 0.0;             ///< from the film, whole bearing: with the Robin change [W]
  double heat_out = 0.0;            ///< through the overhangs' surface, whole bearing [W]
  double stored = 0.0;              ///< whole shaft, mean over the time step [W]
};

/// What the temperatures before a time step add to those after it: the second part of (2).
struct ShaftHistory {
  Eigen::VectorXd nodal, surface;       ///< of nodes and film cells [K]
  double heat_out = 0.0, stored = 0.0;  ///< whole bearing, without any flux [W]
};

/// Owns the operators of one shaft and one time step; solving is const.
class ShaftConduction {
 public:
  /// Steady. Throws InputError if the conductivity is not positive or the coefficient is negative.
  ShaftConduction(const RevolutionMesh& mesh, const FilmGrid& grid, const ShaftBody& body);
  /// The same shaft over a time step dt [s]. Throws InputError if it or the capacity is not
  /// positive.
  [[nodiscard]] ShaftConduction over(double dt) const;

  /// For a time step from nodal temperatures above ambient [K].
  [[nodiscard]] ShaftHistory history(const Eigen::VectorXd& before) const;

  /// Solves (1) for the circumferential mean flux q [W/m2] on each axial film cell, met at the
  /// temperature t_old [K], with uniform film conductance g >= 0 [W/(m2 K)]. At T = T_old the
  /// answer does not depend on g. A time step needs its history, the steady state none. Throws
  /// InputError if in the steady state no heat can leave while g is zero.
  [[nodiscard]] ShaftTemperature solve(const std::vector<double>& q, double g,
                                       const std::vector<double>& t_old,
                                       const ShaftHistory* history = nullptr) const;

  /// Heat that the whole shaft draws from the film per kelvin of all its film cells [W/K], whole
  /// bearing: through both overhangs and, over a time step, into store.
  [[nodiscard]] double conductance() const { return draw_.sum(); }
  /// Heat that enters at q [W/m2] less the heat that leaves and is stored, film cells at
  /// temperatures t [K], whole bearing [W]: zero for the solution of (1).
  [[nodiscard]] double imbalance(const std::vector<double>& q, const std::vector<double>& t,
                                 const ShaftHistory* history = nullptr) const;

  /// Nodal temperatures above ambient of a shaft of one temperature T [K].
  [[nodiscard]] Eigen::VectorXd uniform(double T) const;
  /// Temperatures at given nodal ones above ambient; no flux, no heat.
  [[nodiscard]] ShaftTemperature at(const Eigen::VectorXd& nodal) const;
  [[nodiscard]] const RevolutionMesh& mesh() const { return system_.mesh(); }

 private:
  ShaftConduction(ConductionSystem system, const FilmGrid& grid, const ShaftBody& body);
  [[nodiscard]] bool steady() const;
  /// Cell means of the surface for nodal values, any number of columns.
  [[nodiscard]] Eigen::MatrixXd surface(const Eigen::MatrixXd& nodal) const;
  /// Of surface temperatures [K], less what history and ambient give.
  [[nodiscard]] Eigen::VectorXd rise(const std::vector<double>& t, const ShaftHistory* past) const;
  /// Heat per radian times this is that of the whole bearing [-].
  [[nodiscard]] double whole() const;

  ConductionSystem system_;
  FilmGrid grid_;
  ShaftBody body_;
  Eigen::VectorXd dz_;        ///< of the film's cells [m]
  Eigen::MatrixXd cells_;     ///< P: line nodes x nz [m]
  bool insulated_ = false;    ///< steady, and no heat can leave
  double held_ = 0.0;         ///< s, in the steady state [W/(m2 K)]
  BlockTridiagonal factor_;   ///< A of a time step; empty: steady
  Eigen::MatrixXd nodal_;     ///< rise of the nodes per flux of each cell [K m2/W]
  Eigen::MatrixXd modes_;     ///< V
  Eigen::VectorXd mu_;        ///< [W/(m2 K)]
  Eigen::RowVectorXd out_;    ///< heat lost by nodal rise, whole bearing [W/K]
  Eigen::RowVectorXd store_;  ///< heat stored by nodal rise, whole bearing [W/K]
  Eigen::RowVectorXd draw_;   ///< heat drawn by the cells' rise, whole bearing [W/K]
};

}  // namespace shellback::thermal
