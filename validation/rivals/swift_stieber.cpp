#include "validation/rivals/swift_stieber.hpp"

#include <cmath>
#include <set>

#include "core/largest.hpp"
#include "fluid/film_numbers.hpp"
#include "fluid/fischer_burmeister.hpp"
#include "validation/rivals/method_diverged.hpp"

namespace shellback::validation {

using namespace fluid;

namespace {

/// Rows of cells without pressure: nothing moves there.
void fix_empty_rows(const FilmScene& scene, const FilmState& s, RingMatrix& a, Field& r) {
  for (std::size_t k = 0; k < r.size(); ++k) {
    if (s.full[k] || scene.supply.cell[k] >= 0) continue;
    a.c[k] = 1.0;
    a.w[k] = a.e[k] = a.s[k] = a.n[k] = 0.0;
    r[k] = 0.0;
  }
}

/// Largest residual of a cell with pressure [kg/s].
double largest_of_full(const FilmState& s, const Field& r) {
  double m = 0.0;
  for (std::size_t k = 0; k < r.size(); ++k) {
    if (s.full[k] || std::isnan(r[k])) m = larger(m, std::abs(r[k]));
  }
  return m;
}

/// Gives pressure back to empty cells into which more oil flows than leaves. Returns how many.
int refill(const FilmScene& scene, const Field& r, double slack, bool only_worst, FilmState& s) {
  int moved = 0;
  int worst = -1;
  for (std::size_t k = 0; k < r.size(); ++k) {
    if (s.full[k] || scene.supply.cell[k] >= 0 || r[k] >= -slack) continue;
    ++moved;
    if (worst < 0 || r[k] < r[worst]) worst = static_cast<int>(k);
    if (!only_worst) s.full[k] = 1;
  }
  if (only_worst && worst >= 0) s.full[worst] = 1;
  return moved;
}

void fill_up(const FilmScene& scene, FilmState& s) {
  for (std::size_t k = 0; k < s.p.size(); ++k) {
    s.theta[k] = 1.0;
    if (s.full[k] && s.p[k] < scene.p_cavitation) s.full[k] = 0;
    if (!s.full[k]) s.p[k] = scene.p_cavitation;
  }
  impose_supply(scene.supply, s);
}

}  // namespace

Outcome<FilmSolution> solve_swift_stieber(const FilmScene& scene, const Gap& gap,
                                          const Field& profile, const OilLaw& oil,
                                          const FilmState& guess, const ReynoldsOptions& options) {
  Outcome<FilmSolution> out;
  FilmSolution& v = out.value;
  v.state = guess;
  fill_up(scene, v.state);
  RingMatrix matrix;
  std::set<std::size_t> seen;
  bool cycling = false;
  int beyond_barus = 0;
  for (int it = 0; it <= options.max_iterations; ++it) {
    oil(v.state, v.oil);
    evaluate_flow(scene, gap, profile, v.oil, v.state, v.flow);
    Field r = film_residual(scene, v.flow);
    const double scale = flow_scale(v.flow);
    const double norm = largest_of_full(v.state, r) / scale;
    out.history.push_back(norm);
    if (!std::isfinite(norm)) {
      out.verdict = method_diverged(scene.grid, first_not_a_number(gap, v.state, v.oil, v.flow));
      return out;
    }
    const int moved = refill(scene, r, options.tolerance * scale, cycling, v.state);
    if (norm <= options.tolerance && moved == 0 && v.factorizations > 0) return out;
    if (it == options.max_iterations) break;
    assemble_film(scene, v.flow, active_set_unknowns(v.state), matrix);
    for (double& x : r) x = -x;
    fix_empty_rows(scene, v.state, matrix, r);
    if (!v.factor.factorize(matrix)) break;
    ++v.factorizations;
    v.factor.solve(r.data());
    for (std::size_t k = 0; k < r.size(); ++k) {
      if (!v.state.full[k]) r[k] = 0.0;  // theta stays 1
    }
    beyond_barus += advance(scene, v.oil, r, 1.0, v.state).beyond_barus;
    cycling = !seen.insert(active_set_hash(v.state)).second && norm > options.tolerance;
  }
  out.verdict = {Status::iteration_limit,
                 ending::Unsettled{ending::Iteration::swift_stieber, v.factorizations,
                                   out.history.back(), beyond_barus > 0}};
  return out;
}

}  // namespace shellback::validation
