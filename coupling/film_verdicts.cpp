#include "coupling/film_verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace shellback::coupling {

Verdict limit_load(const BearingModel& model, const LoadTarget& target, double carried,
                   int worst_cell) {
  const std::string place =
      worst_cell >= 0 ? fluid::place_of(model.scene.grid, worst_cell) : std::string();
  if (worst_cell < 0 || carried >= target.scale()) {  // not the pressure law: the gap gave out
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

Verdict closed_gap(const FilmEquilibrium& s) {
  return {Status::no_steady_state,
          fmt::format(
              "the surfaces touch before the solve begins (smallest gap {:.3g} um): the clearance "
              "is used up by thermal growth, profile or eccentricity",
              s.least.h * 1e6),
          fmt::format("phi {:.1f} deg, z {:.2f} mm", s.least.phi * 180.0 / kPi, s.least.z * 1e3),
          "give roughness and contact data, or a larger clearance"};
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

Verdict no_film_left(const FilmEquilibrium& s, const LoadTarget& target, double part,
                     const std::string& place) {
  return {Status::no_steady_state,
          fmt::format("no film carries {:.4g} N: it carries {:.4g} N at a smallest gap of {:.3g} "
                      "um, less than a molecule of oil",
                      target.scale(), part * target.scale(), s.least.h * 1e6),
          place, "give roughness and contact data, or lower the load"};
}

}  // namespace shellback::coupling
