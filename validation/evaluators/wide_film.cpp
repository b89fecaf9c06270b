/// A bearing so wide that no oil leaves at its sides, solved on one axial cell.
#include <algorithm>
#include <cmath>

#include "app/words/ending_words.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"
#include "core/make_grid.hpp"
#include "fluid/resultants.hpp"
#include "fluid/reynolds.hpp"
#include "validation/evaluators/evaluators.hpp"
#include "validation/evaluators/plain_oil.hpp"

namespace shellback::validation {
namespace {

using namespace fluid;

constexpr double kSpeed = 10.0;  // [m/s]
/// Width over radius: the share of the flow that leaves at the sides is of the order (R/B)^2.
constexpr double kWidthRatio = 1000.0;
constexpr double kNeverReached = -1e12;  // cavitation pressure of a film that stays full [Pa]

FilmScene scene_of(int cells, bool cavitates) {
  FilmScene scene;
  const double width = kWidthRatio * kAnyRadius;
  SupplyPatch line;  // the film begins at the widest gap, which lies at phi = pi
  line.phi = kPi;
  line.length = width;
  scene.grid = make_grid(kAnyRadius, width, cells, 1, false, phi_edges({line}), {});
  scene.angles = Angles(scene.grid);
  scene.supply = map_supplies(scene.grid, {line});
  scene.speed = kSpeed;
  scene.p_cavitation = cavitates ? 0.0 : kNeverReached;
  return scene;
}

void add_numbers(const FilmScene& scene, const Gap& gap, const FilmSolution& film,
                 std::map<std::string, double>& value) {
  const FilmGrid& g = scene.grid;
  const Wrench force = wrench(scene, film.state.p);
  const double W = std::hypot(force[0], force[1]);
  const double N = kSpeed / (2.0 * kPi * kAnyRadius);
  const double area = 2.0 * kAnyRadius * g.width;
  const auto cells = static_cast<std::size_t>(g.cells());
  const ShearStress tau =
      shear_stress(scene, gap.cell, Field(cells, 1.0 / kAnyViscosity), Field(cells, 0.5),
                   film.state, pressure_gradient_x(scene, film.state), CavitatedShear::full);
  double inlet = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    if (scene.supply.line[i] >= 0) inlet = film.flow.phi[i].m;
  }
  value["sommerfeld"] = std::pow(kAnyRadius / kAnyClearance, 2) * kAnyViscosity * N * area / W;
  value["load_number"] = 1.0 / (2.0 * kPi * value["sommerfeld"]);
  value["attitude_angle"] = -std::atan2(-force[1], -force[0]) * 180.0 / kPi;
  value["friction_number"] = torque(scene, tau.journal) / (W * kAnyClearance);
  value["inlet_flow_number"] = inlet / (kAnyDensity * kAnyRadius * kAnyClearance * N * g.width);
  value["mean_over_peak"] = W / area / largest(film.state.p);
}

/// Where the film ends, from its beginning [deg]; resolved to a cell.
double rupture_angle(const FilmScene& scene, const FilmState& state) {
  const FilmGrid& g = scene.grid;
  int start = 0;
  while (start < g.nt && scene.supply.line[start] < 0) ++start;
  double angle = 0.0;
  for (int k = 0; k < g.nt && state.p[(start + k) % g.nt] > 0.0; ++k) {
    angle += g.dphi[(start + k) % g.nt];
  }
  return angle * 180.0 / kPi;
}

}  // namespace

Values wide_film_values(const Question& q) {
  const int cells = static_cast<int>(number_setting(q.entry, "cells"));
  const std::string rule = word_setting(q.entry, "cavitation");
  if (cells < 10 || (rule != "none" && rule != "conserved")) {
    throw InputError(q.entry.folder + "/entry.toml",
                     "settings: cells must be 10 or more and cavitation \"none\" or \"conserved\"");
  }
  const FilmScene scene = scene_of(cells, rule == "conserved");
  const double e = q.number("eps") * kAnyClearance;
  const Gap gap = film_gap(scene.grid, scene.angles, kAnyClearance, {{e, 0.0, 0.0, 0.0}}, {}, {});
  const OilLaw oil = plain_oil(kAnyViscosity, kAnyDensity);
  const auto film = solve_reynolds(scene, gap, {}, oil, cold_film(scene));
  Values values;
  if (!film.good()) {
    values.failure = app::reason_of(film.verdict);
    return values;
  }
  add_numbers(scene, gap, film.value, values.value);
  if (rule == "conserved") values.value["rupture_angle"] = rupture_angle(scene, film.value.state);
  return values;
}

}  // namespace shellback::validation
