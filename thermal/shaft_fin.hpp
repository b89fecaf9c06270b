#pragma once
/// Temperature of the shaft along its axis.
///
///   d/dz (k A dT/dz) + 2 pi R [q - g (T - T_old)] = rho c A dT/dt   over the bearing, A = pi R^2
///   (1) d/dz (k A dT/dz) - 2 pi R h (T - T_ambient)   = rho c A dT/dt   over the overhangs (2)
///
/// The shaft turns: a flux that is fixed in space heats each of its points in turn, and harmonics
/// n >= 1 die out within sqrt(2 a / (n Omega)), tenths of a millimetre (methods 3.3). What is left
/// is uniform over the circumference; over the radius it is taken as uniform as well, which holds
/// for a shaft that is slender against its heat path (R << sqrt(k R / 2 h), Biot number small) and
/// for changes slower than R^2 / a (50 s for steel of 50 mm). Not for a hot spot that turns with
/// the shaft (synchronous whirl).
///
/// (1) in finite volumes on the axial film cells, (2) with nodes along an overhang with insulated
/// tip, a distance d apart, tied by the closed form of the fin (textbook), m^2 = 2 h / (k R):
///   heat from node to node  k A m / sinh(m d) (T_i - T_i+1) (3) heat lost at each       k A m
///   tanh(m d / 2) (T_i - T_ambient)                                (4)
/// exact without storage, so that all nodes together draw G = k A m tanh(m L) from the edge (5).
/// Heat is stored in the cells and, lumped, at the nodes; implicit Euler. Heat in = out + stored
/// to round-off. The steady state is the step without end.
#include <limits>
#include <vector>

#include "core/grid.hpp"
#include "thermal/overhang.hpp"

namespace shellback::thermal {

/// Temperatures of the shaft [K].
struct ShaftState {
  std::vector<double> cells;      ///< of each axial film cell
  std::vector<double> high, low;  ///< of the overhangs' nodes from the bearing's edge to the tip;
                                  ///< low: none on a half grid; none without length
};

/// The time from one state to the next.
struct ShaftStep {
  double dt = std::numeric_limits<double>::infinity();  ///< [s]
  ShaftState before;                                    ///< of a finite step
};

struct ShaftTemperature {
  std::vector<double> temperature;  ///< of each axial film cell [K]
  std::vector<double> high, low;    ///< of the overhangs' nodes, as in ShaftState [K]
  double heat_in = 0.0;             ///< from the film, whole bearing: with the Robin change [W]
  double heat_out = 0.0;            ///< through the overhangs' surface, whole bearing [W]
  double stored = 0.0;              ///< whole shaft, mean over the time step [W]
  [[nodiscard]] ShaftState state() const { return {temperature, high, low}; }
};

/// Conductance (5) of one overhang [W/K]; 0 without convection or length.
[[nodiscard]] double fin_conductance(double radius, const ShaftFin& shaft);

/// Heat that the whole shaft draws from the film per kelvin of all its film cells [W/K], whole
/// bearing: through both overhangs and, over a time step dt [s], into store.
[[nodiscard]] double shaft_conductance(const FilmGrid& grid, const ShaftFin& shaft,
                                       double dt = std::numeric_limits<double>::infinity());

/// Solves (1), (2) for the circumferential mean flux into the shaft q [W/m2] on each axial film
/// cell, met at the temperature t_old [K], with uniform film conductance g >= 0 [W/(m2 K)]. At
/// T = T_old the answer does not depend on g. Throws InputError if the conductivity is not
/// positive, if over a finite step the capacity is not, or if in the steady state no heat can leave
/// (no fin conductance) while g is zero.
[[nodiscard]] ShaftTemperature solve_shaft(const FilmGrid& grid, const ShaftFin& shaft,
                                           const std::vector<double>& q, double g,
                                           const std::vector<double>& t_old,
                                           const ShaftStep& step = {});

/// Heat that enters at q [W/m2] less the heat that leaves through the overhangs and is stored, film
/// cells at temperatures t [K], whole bearing [W]: zero for the solution of (1), (2).
[[nodiscard]] double shaft_imbalance(const FilmGrid& grid, const ShaftFin& shaft,
                                     const std::vector<double>& q, const std::vector<double>& t,
                                     const ShaftStep& step = {});

/// The whole shaft at one temperature [K].
[[nodiscard]] ShaftState uniform_shaft(const FilmGrid& grid, const ShaftFin& shaft, double T);

}  // namespace shellback::thermal
