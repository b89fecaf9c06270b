#pragma once
/// Starts of a solve from solved neighbours: the secant of a continuation.
#include "bearing/steady/solve.hpp"

namespace shellback::study {

/// Whether the film of one case can be the start of the other: the same radius and width, both
/// symmetric about mid-width or both not. Grid, tier, clearance, supplies may differ.
[[nodiscard]] bool can_follow(const bearing::Case& next, const bearing::Case& near);

/// near + step (near - before), for what a solve starts from: journal position, elastic and thermal
/// opening, film and wall temperatures, pressures where the film is full, fill where it is not.
/// `step` is the way to the next point over that from `before` to `near`, both in the coordinate of
/// the axis. Pressures do not fall below cavitation, fills stay in [0, 1]: a start, not a result.
/// What the two do not share (another grid, another tier) is that of `near`. Textbook
/// (secant predictor of numerical continuation).
[[nodiscard]] bearing::Solution extrapolated(const bearing::Solution& near,
                                             const bearing::Solution& before, double step);

}  // namespace shellback::study
