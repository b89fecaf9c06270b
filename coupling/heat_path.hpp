#pragma once
/// Film and heat by continuation in the load, for bearings whose heat does not settle from one
/// temperature.
///
/// Under a light load film, heat and growth settle from cold. From there the load is raised, each
/// state the start of the next, in steps that grow while they hold and shrink where one fails.
/// Either the whole load is reached, or the steps become small: then the last steady state is
/// loaded a little further and followed in small steps, as it would go in time. Where friction
/// rises for good from there, no steady state is near, and the verdict tells the load that was
/// carried; else the end is open and the verdict says so. Source: textbook (natural continuation).
#include <functional>

#include "coupling/solve.hpp"

namespace shellback::coupling {

/// Film of `s.target` at one temperature and walls as warm, from cold.
using ColdStart = std::function<Verdict(Solution& s)>;

/// Solves film and heat of `s.target` on the model's own grid; for loads, not for given positions.
/// `lost` is what the attempt without steps ended with, and what remains of it if no light load is
/// carried either.
[[nodiscard]] Verdict follow_heat(Solution& s, const Verdict& lost, const ColdStart& cold,
                                  const ThermalOptions& options, const SolveControl& control);

}  // namespace shellback::coupling
