#pragma once
/// The same case in several tiers, and what caused the difference in friction.
///
/// The split goes from the isothermal film at the equivalent temperature to the full solution by
/// substituting one thing after the other, each time solving film and position for the same load:
///   1 viscosity level      one temperature, but the oil-weighted mean of the full solution
///   2 viscosity variation  the full solution's temperature field, point by point
///   3 clearance            its thermal deformation as well
///   4 elasticity           its elastic deformation as well: the full solution
/// The changes of viscous torque are named so; the change of asperity torque over all steps is
/// shown as one part, `asperity share`. The parts add up to the difference; another order would
/// share it out differently.
///
/// The calibrated equivalent temperature is the film temperature at which the isothermal torque
/// equals the full one (bracketed root in T).
#include <functional>

#include "bearing/steady/solve.hpp"

namespace shellback::bearing {

/// How a solution becomes a result: summarize, or summarize and judge.
using SumUp = std::function<Result(const Solution&, Tier)>;

[[nodiscard]] Comparison compare(const Case& c, const std::vector<Tier>& tiers,
                                 const SolveControl& control = {}, const SumUp& sum_up = summarize);

}  // namespace shellback::bearing
