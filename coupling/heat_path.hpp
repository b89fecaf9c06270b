#pragma once
/// Film and heat by continuation in the load, for bearings whose heat does not settle from one
/// temperature.
///
/// Under a light load film, heat and growth settle from cold. From there the load is raised, each
/// state the start of the next, in steps that grow while they hold and shrink where one fails.
/// Either the whole load is reached, or the steps become small. Where friction rises ever more
/// steeply there, as it does towards a turning point, or rises for good once the last state is
/// loaded a little more and left to itself, no steady state is near: thermal runaway, and the
/// verdict tells the load that was carried. Else the end is open and the verdict says so. Where not
/// even light loads settle, speed is raised in the same way under the whole load. The end of the
/// path on a coarser grid is where that on a finer one begins. Source: textbook (natural
/// continuation).
#include <functional>
#include <optional>

#include "coupling/solve.hpp"

namespace shellback::coupling {

/// Film of `s.target` at one temperature and walls as warm, from cold.
using ColdStart = std::function<Verdict(Solution& s)>;

/// The last state of a path, carried over to the grid of the next.
struct NearPath {
  PathEnd end;
  FilmEquilibrium film;
  HeatState heat;
};

/// Solves film and heat of `s.target` on the model's own grid; given positions by speed alone.
/// `near`: where the path of a coarser grid ended, if it had one; `s.followed` tells where this one
/// does, `s.film` and `s.heat` then being the last state of it. None: no light load and no low
/// speed was found under which film and heat come to rest.
[[nodiscard]] std::optional<Verdict> follow_heat(Solution& s, const NearPath* near,
                                                 const ColdStart& cold,
                                                 const ThermalOptions& options,
                                                 const SolveControl& control);

}  // namespace shellback::coupling
