#include "fluid/film_numbers.hpp"

#include <cmath>

namespace shellback::fluid {

NotANumber first_not_a_number(const Gap& gap, const FilmState& s, const FilmCoefficients& oil,
                              const FilmFlow& flow) {
  for (const auto& found : {find_not_a_number(FieldName::gap, gap.cell),
                            find_not_a_number(FieldName::film_pressure, s.p),
                            find_not_a_number(FieldName::fill_ratio, s.theta),
                            find_not_a_number(FieldName::viscosity, oil.fluidity),
                            find_not_a_number(FieldName::viscosity, oil.chi),
                            find_not_a_number(FieldName::viscosity, oil.density)}) {
    if (found) return *found;
  }
  for (std::size_t k = 0; k < flow.phi.size(); ++k) {
    if (!std::isfinite(flow.phi[k].m)) return {FieldName::film_flow, static_cast<int>(k)};
  }
  return {FieldName::film_flow, -1};
}

Verdict ended_by(const FilmGrid& grid, const NotANumber& found) {
  return {Status::invalid_number, ending::NotANumber{found.field}, place_of(grid, found.cell)};
}

}  // namespace shellback::fluid
