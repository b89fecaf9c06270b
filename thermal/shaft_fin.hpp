#pragma once
/// Temperature of the shaft along its axis.
///
///   d/dz (k A dT/dz) + 2 pi R [q - g (T - T_old)] = 0   over the bearing, A = pi R^2    (1)
///   overhang on each side: fin with convection,  G = k A m tanh(m L),  m^2 = 2 h / (k R) (2)
///
/// The shaft turns: a flux that is fixed in space heats each of its points in turn, and harmonics
/// n >= 1 die out within sqrt(2 a / (n Omega)), tenths of a millimetre (methods 3.3). What is left
/// is uniform over the circumference; over the radius it is taken as uniform as well, which holds
/// for a shaft that is slender against its heat path (R << sqrt(k R / 2 h), Biot number small).
/// Not for a hot spot that turns with the shaft (synchronous whirl).
///
/// (1) in finite volumes on the axial film cells, (2) the closed form of a fin with an insulated
/// tip (textbook), joined at the bearing's edge. Heat in = heat out to round-off.
#include <vector>

#include "core/grid.hpp"

namespace shellback::thermal {

struct ShaftFin {
  double conductivity = 0.0;   ///< k [W/(m K)]
  double overhang = 0.0;       ///< L, length beyond the bearing on each side [m]
  double heat_transfer = 0.0;  ///< h of the overhang's surface [W/(m2 K)]
  double ambient = 0.0;        ///< temperature around the overhang [K]
};

struct ShaftTemperature {
  std::vector<double> temperature;  ///< of each axial film cell [K]
  double heat_in = 0.0;             ///< from the film, whole bearing: with the Robin change [W]
  double heat_out = 0.0;            ///< through the overhangs, whole bearing [W]
};

/// Conductance (2) of one overhang [W/K]; 0 without convection or length.
[[nodiscard]] double fin_conductance(double radius, const ShaftFin& shaft);

/// Solves (1) for the circumferential mean flux into the shaft q [W/m2] on each axial film cell,
/// met at the temperature t_old [K], with uniform film conductance g >= 0 [W/(m2 K)]. At
/// T = T_old the answer does not depend on g. Throws InputError if the conductivity is not
/// positive, or if no heat can leave (no fin conductance) while g is zero.
[[nodiscard]] ShaftTemperature solve_shaft(const FilmGrid& grid, const ShaftFin& shaft,
                                           const std::vector<double>& q, double g,
                                           const std::vector<double>& t_old);

/// Heat that enters at q [W/m2] less the heat that leaves through the overhangs at temperatures
/// t [K], whole bearing [W]: zero for the solution of (1).
[[nodiscard]] double shaft_imbalance(const FilmGrid& grid, const ShaftFin& shaft,
                                     const std::vector<double>& q, const std::vector<double>& t);

}  // namespace shellback::thermal
