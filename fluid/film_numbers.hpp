#pragma once
/// Where a film holds a value that is no finite number.
#include "core/not_a_number.hpp"
#include "fluid/film_flux.hpp"

namespace shellback::fluid {

/// The first field that holds one, in the order in which they follow from each other; film_flow
/// without a place if only their residual does.
[[nodiscard]] NotANumber first_not_a_number(const Gap& gap, const FilmState& state,
                                            const FilmCoefficients& oil, const FilmFlow& flow);

/// Its ending, with the place of its cell.
[[nodiscard]] Verdict ended_by(const FilmGrid& grid, const NotANumber& found);

}  // namespace shellback::fluid
