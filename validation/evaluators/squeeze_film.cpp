/// The film between a shell and a journal that does not turn and moves along the line of centres.
#include <cmath>

#include "app/words/ending_words.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/make_grid.hpp"
#include "fluid/resultants.hpp"
#include "fluid/reynolds.hpp"
#include "validation/evaluators/evaluators.hpp"
#include "validation/evaluators/plain_oil.hpp"

namespace shellback::validation {
namespace {

using namespace fluid;

constexpr double kRate = 10.0;  // d eps/dt, towards +X [1/s]
constexpr double kStep =
    1e-3;  // of eps; the gap being linear in it, any step gives the same rate [-]

FilmScene scene_of(double width, int nt, int nz) {
  FilmScene scene;
  scene.grid = make_grid(kAnyRadius, width, nt, nz, true);
  scene.angles = Angles(scene.grid);
  scene.supply = map_supplies(scene.grid, {});
  return scene;
}

Gap gap_at(const FilmScene& scene, double eps) {
  return film_gap(scene.grid, scene.angles, kAnyClearance, {{eps * kAnyClearance, 0.0, 0.0, 0.0}},
                  {}, {});
}

/// The journal comes from eps - kStep, in a gap that was full.
void come_from(double eps, const OilLaw& law, FilmScene& scene) {
  const FilmState full = cold_film(scene);
  FilmCoefficients oil;
  law(full, oil);
  scene.storage = {kStep / kRate, oil_content(scene, gap_at(scene, eps - kStep), oil, full)};
}

}  // namespace

Values squeeze_film_values(const Question& q) {
  const double width = 2.0 * kAnyRadius * q.number("B_over_D");
  FilmScene scene = scene_of(width, static_cast<int>(number_setting(q.entry, "cells")),
                             static_cast<int>(number_setting(q.entry, "cells_across")));
  const OilLaw oil = plain_oil(kAnyViscosity, kAnyDensity);
  const Gap gap = gap_at(scene, q.number("eps"));
  come_from(q.number("eps"), oil, scene);
  const auto film = solve_reynolds(scene, gap, {}, oil, cold_film(scene));
  Values values;
  if (!film.good()) {
    values.failure = app::reason_of(film.verdict);
    return values;
  }
  const double psi = kAnyClearance / kAnyRadius;
  const double force = -wrench(scene, film.value.state.p)[0];
  const double side = oil_flows(scene, film.value.flow).side / kAnyDensity;
  values.value = {{"squeeze_load_number",
                   force * psi * psi / (2.0 * kAnyRadius * width * kAnyViscosity * kRate)},
                  {"squeeze_flow_number", side / (std::pow(kAnyRadius, 3) * psi * kRate)}};
  return values;
}

}  // namespace shellback::validation
