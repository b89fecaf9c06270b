#include "fluid/reduced_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/largest.hpp"
#include "fluid/active_set.hpp"
#include "fluid/film_update.hpp"

namespace shellback::fluid {

Outcome<FilmState> film_by_reduced_pressure(const FilmScene& scene, const Gap& gap,
                                            const Field& profile, const OilLaw& oil,
                                            const FilmState& guess) {
  FilmState cold = guess;  // fluidities at no pressure, and alpha
  std::fill(cold.p.begin(), cold.p.end(), 0.0);
  FilmCoefficients plain;
  oil(cold, plain);
  const double alpha = largest(plain.alpha);
  std::fill(plain.alpha.begin(), plain.alpha.end(), 0.0);
  const auto reduced = [&](double p) { return alpha > 0.0 ? -std::expm1(-alpha * p) / alpha : p; };
  FilmScene q_scene = scene;
  q_scene.p_cavitation = reduced(scene.p_cavitation);
  q_scene.p_edge = reduced(scene.p_edge);
  for (SupplyPatch& s : q_scene.supply.patches) s.pressure = reduced(s.pressure);
  const OilLaw isoviscous = [&](const FilmState&, FilmCoefficients& c) { c = plain; };
  // Without pressure in the viscosity no step leaves the law's range.
  ActiveSet film(q_scene, gap, profile, isoviscous, cold_film(q_scene), {});
  const ActiveSetEnd end = film.run();
  EXPECTS(end != ActiveSetEnd::beyond_law);
  Outcome<FilmState> out;
  out.value = std::move(film.out.value.state);
  if (end == ActiveSetEnd::limit) film.out.verdict = film.stopped();
  out.verdict = film.out.verdict;
  if (!out.good()) return out;
  const auto peak = std::max_element(out.value.p.begin(), out.value.p.end());
  if (alpha * *peak >= 1.0) {
    out.verdict = {Status::no_steady_state, ending::Plain::no_pressure,
                   place_of(scene.grid, static_cast<int>(peak - out.value.p.begin()))};
    return out;
  }
  for (double& p : out.value.p) p = alpha > 0.0 ? -std::log1p(-alpha * p) / alpha : p;
  impose_supply(scene.supply, out.value);
  return out;
}

}  // namespace shellback::fluid
