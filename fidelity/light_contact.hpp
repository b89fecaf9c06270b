#pragma once
/// Bars of summits that hardly touch. They do not hold the gap open: what they carry hangs on the
/// film alone, and falls by orders of magnitude as it rises, so that what nested grids differ by
/// says little of it. What the smallest film's bar leaves open of the contact pressure,
///   p(max(h - bar, min(h, 0))) - p(h),                                                       (1)
/// down to where the mean planes would meet, counts. Where summits carry, the gap is held by them,
/// and the grids tell.
#include "solid/asperity_contact.hpp"

namespace shellback::fidelity {

/// Share of the load, or of the friction, below which summits hardly touch [-].
inline constexpr double kLight = 0.01;

/// (1) [Pa]: smallest film `h` with its `bar` [m].
[[nodiscard]] inline double left_open_by_film(const solid::AsperityContact& contact, double h,
                                              double bar) {
  return contact.at(std::max(h - bar, std::min(h, 0.0))).p - contact.at(h).p;
}

}  // namespace shellback::fidelity
