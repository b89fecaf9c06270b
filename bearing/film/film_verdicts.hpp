#pragma once
/// Why film, position and elastic surfaces found no equilibrium, and where it shows. A closed gap
/// is told by bearing/film/closed_gap.hpp.
#include "bearing/film/equilibrium.hpp"

namespace shellback::bearing {

/// The load is beyond what rigid surfaces and the pressure law carry, `carried` [N] being about
/// all; where no cell's pressure is to blame (`worst_cell` -1), the gap gave out instead, which
/// proves nothing.
[[nodiscard]] Verdict limit_load(const BearingModel& model, const OperatingPoint& point,
                                 double carried, int worst_cell);

/// Why the state has no film or no residual: a field holds what is not a number, or the gap of
/// smooth surfaces is closed.
[[nodiscard]] Verdict no_film(const FilmTask& task, const FilmEquilibrium& state);

/// The film matrix could not be factorised.
[[nodiscard]] Verdict singular_film(const OperatingPoint& point, const FilmEquilibrium& state);

/// The iteration ended without any of these.
[[nodiscard]] Verdict stuck(const BearingModel& model, const FilmEquilibrium& state,
                            const Residuals& residuals, int iterations);

}  // namespace shellback::bearing
