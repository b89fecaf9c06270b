#include "bearing/film_verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/closed_gap.hpp"
#include "fluid/empty_rings.hpp"
#include "fluid/film_numbers.hpp"

namespace shellback::bearing {

Verdict limit_load(const BearingModel& model, const LoadTarget& target, double carried,
                   int worst_cell) {
  const std::string place =
      worst_cell >= 0 ? fluid::place_of(model.scene.grid, worst_cell) : std::string();
  if (worst_cell < 0) {  // not the pressure law: the gap gave out
    return {Status::iteration_limit,
            "no position was found in which the film carries the load: each step closes the gap",
            place, "lower the load or the tilt, or give roughness and contact data"};
  }
  return {
      Status::no_steady_state,
      fmt::format("the film cannot carry {:.4g} N: it carries about {:.4g} N, then the pressure "
                  "grows without bound (with rigid surfaces and viscosity rising as exp(alpha p), "
                  "the reduced pressure q = (1 - exp(-alpha p))/alpha cannot exceed 1/alpha)",
                  target.scale(), carried),
      worst_cell >= 0 ? fluid::place_of(model.scene.grid, worst_cell) : "",
      "switch on elastic deformation, use the Roelands law, or lower the load"};
}

Verdict no_pressure(const BearingModel& model, int cell) {
  return {Status::no_steady_state,
          "the film has no steady pressure at this gap: with the pressure-viscosity law "
          "chosen, the reduced pressure would have to exceed its bound 1/alpha "
          "(q = (1 - exp(-alpha p))/alpha)",
          fluid::place_of(model.scene.grid, cell),
          "switch on elastic deformation, use the Roelands law, or lower the load"};
}

Verdict no_film(const BearingModel& model, const LoadTarget& target,
                const Field& thermal_deformation, const FilmEquilibrium& s) {
  const fluid::FilmScene& scene = model.scene;
  for (const auto& found :
       {find_not_a_number(FieldName::journal_position, s.position.q, 4),
        find_not_a_number(FieldName::thermal_deformation, thermal_deformation),
        find_not_a_number(FieldName::elastic_opening, s.elastic),
        find_not_a_number(FieldName::film_temperature, s.columns.T, model.gl.n)}) {
    if (!found) continue;
    const bool placed = found->field != FieldName::journal_position;
    return fluid::ended_by(scene.grid, {found->field, placed ? found->cell : -1});
  }
  if (is_closed(model, s)) return closed_gap(model, target, thermal_deformation, s);
  const auto contact = find_not_a_number(FieldName::contact_pressure, s.p_contact);
  const NotANumber in_film = fluid::first_not_a_number(s.gap, s.film, s.oil, s.flow);
  const bool later = contact && in_film.cell < 0;
  return fluid::ended_by(scene.grid, later ? *contact : in_film);
}

Verdict singular_film(const BearingModel& model, const FilmEquilibrium& s) {
  const fluid::FilmScene& scene = model.scene;
  const NotANumber found = fluid::first_not_a_number(s.gap, s.film, s.oil, s.flow);
  if (found.cell >= 0) return fluid::ended_by(scene.grid, found);
  constexpr double kDeep = 10.0;  // below the mean plane no oil is left between rough surfaces [-]
  const double sigma = scene.rough.sigma;
  if (sigma > 0.0 && s.least.h < -kDeep * sigma) {
    return {Status::iteration_limit,
            fmt::format("no oil passes where the surfaces lie in each other: the nominal gap is "
                        "{:.3g} um, {:.0f} times the roughness below zero",
                        s.least.h * 1e6, -s.least.h / sigma),
            fluid::place_of(s.least),
            "lower the load or the tilt, or give a larger clearance or stiffer contact"};
  }
  const std::vector<int> rings = fluid::empty_rings(scene, s.film);
  if (!rings.empty()) {
    return {
        Status::iteration_limit,
        "a ring of the film is cavitated all round and fed by nothing: its oil only goes round, "
        "and how much of it there is cannot be told",
        fmt::format("z {:.2f} mm", scene.grid.z[rings.front()] * 1e3),
        "feed more oil, or over more of the width"};
  }
  return {Status::iteration_limit, "the film matrix is singular: parts of the film get no oil", "",
          "feed more oil, or turn the supply away from the load"};
}

Verdict stuck(const BearingModel& model, const FilmEquilibrium& s, const Residuals& r,
              int iterations) {
  const auto worst = std::max_element(r.film.begin(), r.film.end(),
                                      [](double a, double b) { return std::abs(a) < std::abs(b); });
  return {
      Status::iteration_limit,
      fmt::format("film and journal position did not settle in {} Newton iterations (film {:.1e}, "
                  "load {:.1e}, elasticity {:.1e}, smallest gap {:.3g} um)",
                  iterations, r.film_norm, r.load_norm, r.elastic_norm, s.least.h * 1e6),
      fluid::place_of(model.scene.grid, static_cast<int>(worst - r.film.begin())),
      "try a finer grid, a lower load, or tier isothermal first"};
}

Verdict not_at_rest(const BearingModel&, const FilmEquilibrium& s, int steps) {
  return {Status::iteration_limit,
          fmt::format("the journal did not come to rest in {} steps in time (smallest gap {:.3g} "
                      "um)",
                      steps, s.least.h * 1e6),
          fluid::place_of(s.least), "try a finer grid, a lower load, or tier isothermal first"};
}

Verdict film_vanishes(const FilmEquilibrium& s) {
  return {Status::no_steady_state,
          fmt::format("no film carries the load: the journal is pressed towards the shell until "
                      "less than a molecule of oil is left ({:.3g} um)",
                      s.least.h * 1e6),
          fluid::place_of(s.least),
          "give roughness and contact data, switch on elastic deformation, or lower the load"};
}

Verdict given_up() {
  return {Status::iteration_limit,
          "the search was given up after twenty times the work of a usual solve on this grid", "",
          "a coarser grid first, or a nearby operating point"};
}

}  // namespace shellback::bearing
