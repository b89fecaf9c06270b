#pragma once
/// A load cycle at one temperature T of the film, from the heat balance of a mean cycle:
///
///   r(T) = T_supply + <P>/(<Q> cp) - T = 0   [K]                                     (1)
///
/// <P> mean power of shaft, load and supply [W], <Q> mean flow of the oil that is fed [kg/s] of the
/// periodic state at T, T_supply its temperature, cp between the two temperatures: all heat leaves
/// with the oil, which is as warm as the film. The film's heat capacity keeps T from following
/// within a cycle: its oil passes in a cycle or two, and what it wins at a peak it loses between.
/// Searched upwards from the supply's temperature, where r cannot be negative, for the first root:
/// by Newton's step with the slope -1 - beta <P>/(<Q> cp) of heat over flow that goes with the
/// viscosity (beta = -d ln eta/dT), then by secants no flatter than -1. Heat over flow falls ever
/// more slowly as the oil thins, so that secants from below end below the root; where it rises
/// (summits that begin to rub) steps of slope -1 do. Oil far hotter than the root, whose film may
/// be nearly gone, is not tried. A step that does pass the root makes a bracket with the one before
/// (decision 046).
#include "bearing/over_time/cycle_search.hpp"

namespace shellback::bearing {

/// |r| that ends the search [K]: 3e-4 of viscosity.
inline constexpr double kCycleBalance = 0.01;
/// Bracket of temperatures within which the numbers of two cycles differ by their closure alone
/// [K].
inline constexpr double kCycleBracket = 1e-3;

/// Leaves `search` at the root; its verdict otherwise.
[[nodiscard]] Verdict settle_lumped_cycle(CycleSearch& search, const Case& c);

}  // namespace shellback::bearing
