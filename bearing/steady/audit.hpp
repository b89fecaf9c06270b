#pragma once
/// Conservation audit of a solution: mass, energy, load, moment.
///
///   mass    |supply flow - side flow| / the larger of them, at least 1e-7 of the largest flow
///           through a cell's face
///   energy  |friction power + pump power - heat by oil - heat to shell - heat to shaft|
///           / friction power, at least 1e-7 of the heat that oil carries; heat to shell and shaft
///           as the solids took it up
///   load    |F + W| / |W|; not applicable with a given position
///   moment  |T_journal - T_shell - T_pressure| / |T_journal|, viscous torques and those of
///   asperities; T_pressure =
///           - int p dhT/dphi dA, the moment of the pressure on the eccentric journal (and on the
///           deformed shell). It is not exact on a grid and falls with it.
#include "bearing/steady/solve.hpp"

namespace shellback::bearing {

/// T_journal - T_shell - T_pressure of viscous torques, of a film at an instant, too [N m].
[[nodiscard]] double moment_imbalance(const BearingModel& m, const OperatingPoint& point,
                                      const FilmEquilibrium& f, const Friction& friction);

[[nodiscard]] Audit audit_of(const Solution& s, const Friction& friction);

}  // namespace shellback::bearing
