#pragma once
/// One temperature T for the whole film, from the heat balance of the bearing:
///
///   r(T) = T_supply + P(T)/(Q(T) cp) - T = 0   [K]                                          (1)
///
/// P friction and pump power [W], Q oil fed [kg/s] to the film in equilibrium at T, T_supply its
/// mean temperature over the supplies that feed it, cp between the two temperatures: all heat
/// leaves with the oil, which is as warm as the film. Searched from the coldest supply's
/// temperature, where r cannot be negative, to the rise at which the resolved tiers speak of
/// runaway (kHottestRise, heat_endings.hpp).
///
/// A root at which r falls is stable: a film that is a little too warm makes less heat than leaves.
/// Films whose friction grows as they thin (mixed friction) may have more than one; all are found
/// by a scan (heat_scan.hpp). The solution is the lowest stable one, which a bearing comes to from
/// cold; the others are told. The scan is made on the first grid that is solved. Finer grids settle
/// its root anew where it has one, and scan again where it has more or is not found near by.
#include "bearing/control.hpp"
#include "bearing/film/solution.hpp"

namespace shellback::bearing {

/// Solves (1) from the state that is there (`warm`: its roots are those of a near grid) or cold.
[[nodiscard]] Verdict solve_lumped(Solution& s, bool warm, const SolveControl& control);

}  // namespace shellback::bearing
