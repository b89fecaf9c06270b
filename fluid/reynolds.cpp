#include "fluid/reynolds.hpp"

#include <utility>

#include "fluid/active_set.hpp"
#include "fluid/reduced_pressure.hpp"

namespace shellback::fluid {

Outcome<FilmSolution> solve_reynolds(const FilmScene& scene, const Gap& gap, const Field& profile,
                                     const OilLaw& oil, const FilmState& guess,
                                     const ReynoldsOptions& options) {
  ActiveSet film(scene, gap, profile, oil, guess, options);
  ActiveSetEnd end = film.run();
  for (bool again = false; end == ActiveSetEnd::beyond_law; again = true) {
    auto reduced = film_by_reduced_pressure(scene, gap, profile, oil, film.out.value.state);
    film.out.value.state = std::move(reduced.value);
    if (!reduced.good()) {
      film.out.verdict = reduced.verdict;
      return film.out;
    }
    if (again) {  // it is not that of one Barus law
      end = ActiveSetEnd::limit;
      break;
    }
    end = film.run();
  }
  if (end == ActiveSetEnd::limit) film.out.verdict = film.stopped();
  return std::move(film.out);
}

}  // namespace shellback::fluid
