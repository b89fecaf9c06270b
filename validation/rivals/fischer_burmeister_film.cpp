#include "validation/rivals/fischer_burmeister_film.hpp"

#include <algorithm>
#include <cmath>

#include "core/largest.hpp"
#include "fluid/film_matrix.hpp"
#include "fluid/film_numbers.hpp"
#include "fluid/film_update.hpp"
#include "fluid/fischer_burmeister.hpp"
#include "validation/rivals/method_diverged.hpp"

namespace shellback::validation {

using namespace fluid;

namespace {

/// Largest |phi| of all cells [-].
double complementarity_gap(const FilmScene& scene, const FilmState& s) {
  const double p_ref = pressure_scale(scene, s);
  double most = 0.0;
  for (std::size_t k = 0; k < s.p.size(); ++k) {
    if (scene.supply.cell[k] >= 0) continue;
    const double P = (s.p[k] - scene.p_cavitation) / p_ref;
    const double c = 1.0 - s.theta[k];
    most = std::max(most, std::abs(P + c - std::hypot(P, c)));
  }
  return most;
}

/// Sets every cell to exactly one of full and cavitated.
void make_complementary(const FilmScene& scene, FilmState& s) {
  for (std::size_t k = 0; k < s.p.size(); ++k) {
    if (scene.supply.cell[k] >= 0) continue;
    (s.full[k] ? s.theta[k] : s.p[k]) = s.full[k] ? 1.0 : scene.p_cavitation;
  }
}

/// Half-Sommerfeld start of a film without pressure: the full film, cut at cavitation. Without it
/// there is no scale for the pressures.
bool first_pressures(const FilmScene& scene, const Gap& gap, const Field& profile,
                     const OilLaw& oil, FilmSolution& v) {
  RingMatrix matrix;
  std::fill(v.state.full.begin(), v.state.full.end(), 1);
  std::fill(v.state.theta.begin(), v.state.theta.end(), 1.0);
  oil(v.state, v.oil);
  evaluate_flow(scene, gap, profile, v.oil, v.state, v.flow);
  assemble_film(scene, v.flow, active_set_unknowns(v.state), matrix);
  ++v.factorizations;
  if (!v.factor.factorize(matrix)) return false;
  Field t = film_residual(scene, v.flow);
  for (double& x : t) x = -x;
  v.factor.solve(t.data());
  advance(scene, v.oil, t, 1.0, v.state);
  return true;
}

bool without_pressure(const FilmScene& scene, const FilmState& s) {
  for (std::size_t k = 0; k < s.p.size(); ++k) {
    if (scene.supply.cell[k] < 0 && s.p[k] > std::max(scene.p_edge, scene.p_cavitation)) {
      return false;
    }
  }
  return true;
}

}  // namespace

Outcome<FilmSolution> solve_fischer_burmeister(const FilmScene& scene, const Gap& gap,
                                               const Field& profile, const OilLaw& oil,
                                               const FilmState& guess,
                                               const ReynoldsOptions& options) {
  constexpr double kNearly = 1e-9;  // |phi| from which cells are what they are nearly [-]
  Outcome<FilmSolution> out;
  FilmSolution& v = out.value;
  v.state = guess;
  bool stuck = without_pressure(scene, guess) && !first_pressures(scene, gap, profile, oil, v);
  oil(v.state, v.oil);
  evaluate_flow(scene, gap, profile, v.oil, v.state, v.flow);
  for (int it = 0; it <= options.max_iterations; ++it) {
    const double norm = largest_magnitude(film_residual(scene, v.flow)) / flow_scale(v.flow);
    out.history.push_back(norm);
    if (!std::isfinite(norm)) {
      out.verdict = method_diverged(scene.grid, first_not_a_number(gap, v.state, v.oil, v.flow));
      return out;
    }
    if (norm <= options.tolerance && complementary(scene, v.state)) return out;
    if (stuck || it == options.max_iterations) break;
    stuck = !fischer_burmeister_step(scene, gap, profile, oil, v);
    ++v.factorizations;
    if (complementarity_gap(scene, v.state) > kNearly) continue;
    make_complementary(scene, v.state);
    oil(v.state, v.oil);
    evaluate_flow(scene, gap, profile, v.oil, v.state, v.flow);
  }
  out.verdict = {
      Status::iteration_limit,
      ending::Unsettled{ending::Iteration::fischer_burmeister, v.factorizations,
                        larger(out.history.back(), complementarity_gap(scene, v.state)), stuck}};
  return out;
}

}  // namespace shellback::validation
