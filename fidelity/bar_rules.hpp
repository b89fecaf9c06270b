#pragma once
/// What bars of one result have in common, however the grids were taken: what is known of one
/// quantity and holds for others.
#include <utility>
#include <vector>

#include "bearing/bearing.hpp"
#include "fidelity/quantities.hpp"

namespace shellback::fidelity {

using Judged = std::vector<std::pair<Quantity*, double>>;  ///< a quantity and its natural size

/// Stiffness and damping share one film, whose ends move by whole cells as the grid changes: which
/// entry feels it, and which of them a few grids happen to agree on, is chance. None has a bar
/// shorter, against its size, than the longest; nor has the threshold of whirl that follows.
void share_bars_of_coefficients(const Judged& judged);

/// Quantities that are differences, or the angle of what another is the length of, on which grids
/// agree by chance. The journal's place is known alike in both directions: an attitude to e_bar/e
/// [rad]. The oil mixed in the supplies is film and feed in parts that flows tell: to half of the
/// side flow's relative bar times the film's rise. Shaft and shell open the gap by a difference: to
/// alpha R times the longer bar of shaft and shell back. Decision 089.
void share_bars_of_place_and_flow(const bearing::Case& c, bearing::Result& result);

/// Summits that hardly touch (light_contact.hpp); their friction is part of the whole, which has a
/// bar.
void widen_bars_of_light_contact(const bearing::BearingModel& m, bearing::Result& result);

/// An elasto-plastic layer that has not flowed under a largest pressure whose bar passes its
/// hardness: how deep it would have flowed is not known.
[[nodiscard]] bool layer_may_have_flowed(const bearing::Case& c, const Quantity& depth,
                                         const Quantity& p_max);
void open_bar_of_layer(const bearing::Case& c, bearing::Result& result);

/// Bars no longer than the true value can be away: quantities between bounds, parts of friction
/// beside the whole.
void bound_bars(const bearing::Case& c, bearing::Result& result);

}  // namespace shellback::fidelity
