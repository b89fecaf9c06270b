#include "app/study/predictor.hpp"

#include <algorithm>
#include <span>

namespace shellback::study {

using bearing::Solution;

namespace {

/// x + step (x - before), in place; nothing if the two do not match.
void extrapolate(std::span<double> x, std::span<const double> before, double step) {
  if (x.size() != before.size()) return;
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += step * (x[k] - before[k]);
}

void extrapolate_film(const fluid::FilmState& before, double p_cavitation, double step,
                      fluid::FilmState& film) {
  if (film.p.size() != before.p.size()) return;
  for (std::size_t c = 0; c < film.p.size(); ++c) {
    if (film.full[c] != 0) {
      film.p[c] = std::max(p_cavitation, film.p[c] + step * (film.p[c] - before.p[c]));
    } else {
      film.theta[c] =
          std::clamp(film.theta[c] + step * (film.theta[c] - before.theta[c]), 0.0, 1.0);
    }
  }
}

}  // namespace

bool can_follow(const bearing::Case& next, const bearing::Case& near) {
  return next.bearing.radius == near.bearing.radius && next.bearing.width == near.bearing.width &&
         symmetric_about_mid_width(next) == symmetric_about_mid_width(near);
}

Solution extrapolated(const Solution& near, const Solution& before, double step) {
  Solution s = near;
  if (near.model.domain.grid.phi_face != before.model.domain.grid.phi_face ||
      near.model.domain.grid.z_face != before.model.domain.grid.z_face) {
    return s;
  }
  extrapolate(s.film.position.q, before.film.position.q, step);
  extrapolate(s.film.elastic, before.film.elastic, step);
  extrapolate(s.film.columns.T, before.film.columns.T, step);
  extrapolate(s.heat.thermal_deformation, before.heat.thermal_deformation, step);
  extrapolate(s.heat.T_shell, before.heat.T_shell, step);
  extrapolate(s.heat.T_shaft, before.heat.T_shaft, step);
  extrapolate_film(before.film.film, s.model.domain.p_cavitation, step, s.film.film);
  s.T_film += step * (near.T_film - before.T_film);
  return s;
}

}  // namespace shellback::study
