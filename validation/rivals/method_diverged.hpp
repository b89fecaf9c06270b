#pragma once
/// How a rival ends that has run away.
#include "fluid/film_numbers.hpp"

namespace shellback::validation {

/// The ending of a method that is shown as it is known elsewhere, without our help.
inline Verdict method_diverged(const FilmGrid& grid, const NotANumber& found) {
  return {Status::invalid_number, ending::NotANumber{found.field, true},
          fluid::place_of(grid, found.cell)};
}

}  // namespace shellback::validation
