#include "bearing/film/film_verdicts.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/film/closed_gap.hpp"
#include "fluid/empty_rings.hpp"
#include "fluid/film_numbers.hpp"

namespace shellback::bearing {
namespace {

/// Rough surfaces so deep in each other that no oil is left between them: no verdict of the
/// bearing.
Verdict interlocked(const fluid::FilmScene& scene, const FilmEquilibrium& s) {
  return {Status::iteration_limit, ending::SurfacesInterlocked{s.least.h, scene.rough.sigma},
          s.least.place()};
}

}  // namespace

Verdict limit_load(const BearingModel& model, const OperatingPoint& point, double carried,
                   int worst_cell) {
  const bool bound = std::holds_alternative<rheology::Barus>(model.oil.pressure);
  if (worst_cell < 0 || !bound) return {Status::iteration_limit, ending::Plain::no_position};
  return {Status::no_steady_state, ending::BeyondPressureBound{point.load.scale(), carried},
          fluid::place_of(model.domain.grid, worst_cell)};
}

Verdict no_film(const FilmTask& task, const FilmEquilibrium& s) {
  const auto& [model, point, thermal_deformation, options, stop, memory] = task;
  const fluid::FilmScene& scene = point.scene;
  for (const auto& found :
       {find_not_a_number(FieldName::journal_position, s.position.q, 4),
        find_not_a_number(FieldName::thermal_deformation, thermal_deformation),
        find_not_a_number(FieldName::elastic_opening, s.elastic),
        find_not_a_number(FieldName::film_temperature, s.columns.T, model.gl.n)}) {
    if (!found) continue;
    const bool placed = found->field != FieldName::journal_position;
    return fluid::ended_by(scene.grid, {found->field, placed ? found->cell : -1});
  }
  if (is_closed(model, s)) return closed_gap(model, point, thermal_deformation, s);
  if (no_gap_shears(model, scene.speed, s)) return interlocked(scene, s);
  const auto contact = find_not_a_number(FieldName::contact_pressure, s.p_contact);
  const NotANumber in_film = fluid::first_not_a_number(s.gap, s.film, s.oil, s.flow);
  if (in_film.cell >= 0) return fluid::ended_by(scene.grid, in_film);
  if (contact) return fluid::ended_by(scene.grid, *contact);
  return {Status::iteration_limit, ending::Plain::ran_off};
}

Verdict singular_film(const OperatingPoint& point, const FilmEquilibrium& s) {
  const fluid::FilmScene& scene = point.scene;
  const NotANumber found = fluid::first_not_a_number(s.gap, s.film, s.oil, s.flow);
  if (found.cell >= 0) return fluid::ended_by(scene.grid, found);
  constexpr double kDeep = 10.0;  // below the mean plane no oil is left between rough surfaces [-]
  const double sigma = scene.rough.sigma;
  if (sigma > 0.0 && s.least.h < -kDeep * sigma) return interlocked(scene, s);
  const std::vector<int> rings = fluid::empty_rings(scene, s.film);
  if (rings.empty()) return {Status::iteration_limit, ending::Plain::singular_film};
  return {Status::iteration_limit, ending::Plain::empty_ring, {NAN, scene.grid.z[rings.front()]}};
}

Verdict stuck(const BearingModel& model, const FilmEquilibrium& s, const Residuals& r,
              int iterations) {
  const auto worst = std::max_element(r.film.begin(), r.film.end(),
                                      [](double a, double b) { return std::abs(a) < std::abs(b); });
  const bool by_film = r.film_norm >= std::max(r.load_norm, r.elastic_norm);
  const bool no_film = model.domain.rough.sigma == 0.0 && s.least.h < kMolecule;
  return {Status::iteration_limit,
          ending::FilmUnsettled{iterations, r.film_norm, r.load_norm, r.elastic_norm, s.least.h,
                                no_film},
          by_film ? fluid::place_of(model.domain.grid, static_cast<int>(worst - r.film.begin()))
                  : s.least.place()};
}

}  // namespace shellback::bearing
