#pragma once
/// A load cycle at one temperature T of the film, from the heat balance of a mean cycle:
///
///   r(T) = T_supply + <P>/(<Q> cp) - T = 0   [K]                                     (1)
///
/// <P> mean power of shaft, load and supply [W], <Q> mean side flow [kg/s] of the periodic state at
/// T, cp between the two temperatures: all heat leaves with the oil, which is as warm as the film.
/// The film's heat capacity keeps T from following within a cycle: its oil passes in a cycle or
/// two, and what it wins at a peak it loses between. Searched upwards from the supply's
/// temperature, where r cannot be negative, for the first root.
#include "bearing/cycle_search.hpp"

namespace shellback::bearing {

/// |r| that ends the search [K]: 3e-4 of viscosity.
inline constexpr double kCycleBalance = 0.01;
/// Bracket of temperatures within which the numbers of two cycles differ by their closure alone
/// [K].
inline constexpr double kCycleBracket = 1e-3;

/// Leaves `search` at the root; its verdict otherwise.
[[nodiscard]] Verdict settle_lumped_cycle(CycleSearch& search, const Case& c);

}  // namespace shellback::bearing
