#pragma once
/// A first equilibrium by continuation, for scenes that Newton's method does not reach from a
/// guess.
///
/// The film of a light load on an aligned journal is found from any guess. From there the load is
/// raised in growing steps (geometric), then tilt or moment (linear); a step that fails is halved
/// twice, one that holds lets the next grow. Where even the light load has no film (supply pressure
/// loads the journal too), the speed is lowered from a high one under the whole load instead. Where
/// steps of a thousandth still fail, the branch of steady films that starts at light load ends: the
/// verdict says how much was carried and whether the pressure law is the reason. Source: textbook
/// (natural continuation).
#include "coupling/control.hpp"
#include "coupling/solve.hpp"

namespace shellback::coupling {

/// Solves on the model's own grid at one oil temperature T [K] and without growth; `s.target` is
/// reached or the verdict says why not. For loads only; a given position is not stepped.
[[nodiscard]] Verdict stepped_start(Solution& s, double T, const SolveControl& control);

}  // namespace shellback::coupling
