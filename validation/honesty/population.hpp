#pragma once
/// Random bearings, drawn over the whole space of steady input: what the claims are measured on.
///
/// Geometry, speed, load, oil, supplies, tilt, surfaces, shell, housing, shaft, edges are drawn
/// independently, each over the range in which bearings are built; the specific load additionally
/// so that the Sommerfeld number P (c/R)^2 / (eta omega), with the viscosity of the supplied oil,
/// lies in [0.02, 15] (smooth) or [0.02, 40] (rough, contact carries a part), and the speed so that
/// the film stays laminar and below 60 m/s. Every case has shell and shaft, so that every tier can
/// be solved. All are drawn from the seed alone, by our own mapping of std::mt19937_64, whose
/// sequence the standard fixes: the same cases on every platform (to the last digits of exp, log).
#include <cstdint>

#include "bearing/case.hpp"

namespace shellback::validation {

/// The bearing of that seed, tier tehd, grid 200 x 25.
[[nodiscard]] bearing::Case random_case(std::uint64_t seed);

}  // namespace shellback::validation
