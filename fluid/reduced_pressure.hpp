#pragma once
/// Barus films by their reduced pressure: q = (1 - exp(-alpha p))/alpha.
///
/// With viscosity rising as exp(alpha p) the film equation in q is that of an oil whose viscosity
/// does not depend on pressure, cavitation included, and q < 1/alpha. So the isoviscous film
/// either gives the Barus film, p = -ln(1 - alpha q)/alpha, or shows that there is none.
/// Exact for one alpha everywhere and fluidities that do not depend on p otherwise; then also a
/// good start where that is nearly so. Source: textbook.
#include "fluid/film_solution.hpp"

namespace shellback::fluid {

/// The film at this gap by its reduced pressure. Verdict no_steady_state if q reaches 1/alpha.
[[nodiscard]] Outcome<FilmState> film_by_reduced_pressure(const FilmScene& scene, const Gap& gap,
                                                          const Field& profile, const OilLaw& oil,
                                                          const FilmState& guess);

}  // namespace shellback::fluid
