#pragma once
/// Smooth surfaces that touch: told by the gap itself, before a film is sought in it.
#include "bearing/film/equilibrium.hpp"

namespace shellback::bearing {

/// Which gap is closed, where, and by what. No steady state if the position of a journal among
/// rigid surfaces is given (others give way), or if across some diameter the clearance itself is
/// used up, which no position mends.
[[nodiscard]] Verdict closed_gap(const BearingModel& model, const OperatingPoint& point,
                                 const Field& thermal_deformation, const FilmEquilibrium& s);

}  // namespace shellback::bearing
