// What a step in time may err, told from its embedded method of lower order: of the loaded film, of
// the vessels' oil, of the viscosity that heat has surprised it with.
#include <cmath>

#include "bearing/film/equilibrium.hpp"
#include "bearing/film/film_motion.hpp"
#include "bearing/over_time/film_step.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {

double FilmSteps::error_of_film(const FilmInTime& now, const FilmEquilibrium& end,
                                const std::vector<FilmStage>& stages, double dt) const {
  const Tableau by = method_at(now);
  constexpr double kLoaded = 0.01;  // of the largest specific load of the course: counts as loaded
  if (now.full_before.empty()) return 0.0;
  const FilmGrid& g = model_.domain.grid;
  const double loaded = kLoaded * course_.largest_load() / (2.0 * g.radius * g.width);
  std::vector<char> full = end.film.full;
  Field missing(g.cells(), 0.0);
  for (int c = 0; c < g.cells(); ++c) {
    full[c] = full[c] && now.film.film.full[c] && now.full_before[c];
    for (int i = 0; i < by.stages; ++i) missing[c] += (by.b(i) - by.other[i]) * stages[i].oil[c];
    missing[c] *= dt / end.oil.density[c];
  }
  const auto error = loaded_film_error(model_, point_.load.unknowns, end, missing,
                                       away_from_fronts(g, full), loaded);
  if (error || !(mass_ > 0.0)) return error.value_or(0.0);
  // Nothing is loaded: a journal in flight, judged by its own position.
  std::array<double, 2> off{};
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < by.stages; ++i) off[k] += (by.b(i) - by.other[i]) * stages[i].velocity[k];
  }
  return dt * std::hypot(off[0], off[1]) / room(model_, end);
}

double FilmSteps::error_of(const FilmInTime& now, const FilmEquilibrium& end,
                           const std::vector<FilmStage>& stages, double dt) const {
  const Tableau by = method_at(now);
  double error = error_of_film(now, end, stages, dt);
  if (vessels_.any()) {
    std::vector<double> missing(vessels_begun_.size(), 0.0);
    for (int i = 0; i < by.stages; ++i) {
      add(dt * (by.b(i) - by.other[i]), vessels_.slopes(stages[i].flows), missing);
    }
    error = larger(error, vessels_.largest_share(missing));
  }
  if (heat_) {
    constexpr double kOfViscosity = 0.1;  // missed viscosity turns into film by a tenth and less
    error = larger(error, kOfViscosity * heat_->surprise(model_, end, stages.back().heat.T));
  }
  return error;
}

}  // namespace shellback::bearing
