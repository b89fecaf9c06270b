#pragma once
/// Reported scalars: found by name, compared, measured against their natural size.
#include <string>
#include <vector>

#include "bearing/result.hpp"
#include "core/range.hpp"

namespace shellback::fidelity {

using bearing::Quantity;

/// `to` minus `from`, quantity by quantity; what is not in both is not-a-number.
[[nodiscard]] std::vector<Quantity> change(const std::vector<Quantity>& from,
                                           const std::vector<Quantity>& to);

/// True if the tier takes the quantity from the case: what is given has no error of the grid.
[[nodiscard]] bool given_by_case(const bearing::Case& c, bearing::Tier tier,
                                 const std::string& name);

/// True of the asperities' torque and what it is made of, parts of the friction torque.
[[nodiscard]] bool is_part_of_friction(const std::string& name);

/// True of temperatures and heats, which a film of held temperatures does not know.
[[nodiscard]] bool is_of_heat(const std::string& name);

/// True for quantities of one sign, of which a relative change means something.
[[nodiscard]] bool one_sign(const Quantity& q);

/// True of an entry of the stiffness or the damping matrix.
[[nodiscard]] bool is_coefficient(const Quantity& q);
/// And of what follows from them, the threshold of whirl.
[[nodiscard]] bool is_of_motion(const Quantity& q);

/// The size against which a small change of the quantity is measured: for temperatures the rise
/// above the supply, for components of a vector its length, else the value [unit of quantity].
[[nodiscard]] double natural_size(const Quantity& q, double T_supply,
                                  const std::vector<Quantity>& all);

/// True if the value is nothing but round-off beside the shear of the film: pressures, forces and
/// flows of a film whose journal is in the middle and that nothing feeds. Measured by what shear of
/// the friction's size makes at once: p = tau R/c, F = 2 R B p, Q = U B c. And the heat into a
/// shaft that ends at the bearing's edges, from which none leaves.
[[nodiscard]] bool is_round_off(const bearing::Case& c, const Quantity& q,
                                const std::vector<Quantity>& all);

/// Between what the true value lies, where both sides are bounded: shares of the load between 0 and
/// 1, contact pressures between 0 and the hardness, parts of boundary friction between 0 and the
/// law's constants. Else anywhere.
[[nodiscard]] Range bounds_of(const bearing::Case& c, const std::string& name);

/// Shortens bars of grid, steps and model: summits take no more of the friction torque than it may
/// be, and parts of their friction no more than theirs. Where the bar of the whole is not known
/// theirs stay.
void bound_parts_of_friction(const std::vector<Quantity*>& list);

/// How far the true value can be from `q` at most; infinity: it is not bounded.
[[nodiscard]] double furthest(const bearing::Case& c, const Quantity& q);

}  // namespace shellback::fidelity
