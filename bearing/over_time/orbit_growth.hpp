#pragma once
/// Whether a journal comes back to a periodic orbit from which it is displaced.
#include <array>
#include <optional>
#include <vector>

namespace shellback::bearing {

/// Place and velocity of a journal at the end of a cycle, in one unit.
using JournalState = std::array<double, 4>;

/// Modulus of the largest multiplier of s_{k+1} - s_k = M (s_k - s_{k-1}): by how much what is left
/// of a disturbance of size `displaced` grows in a cycle, of the journal and the oil that it moves
/// (Floquet) [-]. M is the least squares of all differences in the directions that they have
/// (those of a hundredth of the largest or more: what dies out at once leaves noise there).
/// Differences of less than a thousandth of the disturbance end what is looked at; 0 where that
/// leaves fewer than three of them. None where M grows and they fell by more than a half all the
/// same, as noise does. Source: textbook (dynamic mode decomposition).
[[nodiscard]] std::optional<double> growth_per_cycle(const std::vector<JournalState>& states,
                                                     double displaced);

}  // namespace shellback::bearing
