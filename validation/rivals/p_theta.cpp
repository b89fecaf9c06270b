#include "validation/rivals/p_theta.hpp"

#include <cmath>

#include "core/constants.hpp"
#include "core/largest.hpp"
#include "fluid/film_numbers.hpp"
#include "fluid/fischer_burmeister.hpp"
#include "validation/rivals/method_diverged.hpp"

namespace shellback::validation {

using namespace fluid;

double young_factor(const FilmGrid& g) {
  const double dx = g.radius * 2.0 * kPi / g.nt;
  const double dz = g.width / g.full_nz();
  const double along = 1.0 / (dx * dx);
  const double across = 1.0 / (dz * dz);
  // The slowest mode: constant around, zero at both side edges.
  const double mu = (along + across * std::cos(kPi / g.full_nz())) / (along + across);
  return 2.0 / (1.0 + std::sqrt(1.0 - mu * mu));
}

namespace {

/// The linearised equations: residual R0 + Ap dp + At dtheta.
struct Linearised {
  RingMatrix by_p;
  RingMatrix by_theta;
  Field R0;
  Field dp, dtheta;

  /// Row k of M x; cell (i, j).
  static double row(const RingMatrix& m, const FilmGrid& g, int i, int j, const Field& x) {
    const int k = g.index(i, j);
    double sum =
        m.c[k] * x[k] + m.w[k] * x[g.index(g.previous(i), j)] + m.e[k] * x[g.index(g.next(i), j)];
    if (j > 0) sum += m.s[k] * x[k - 1];
    if (j + 1 < g.nz) sum += m.n[k] * x[k + 1];
    return sum;
  }
};

void relax_cell(const FilmScene& scene, double over, int i, int j, Linearised& eq, FilmState& s) {
  const int k = scene.grid.index(i, j);
  const double r = eq.R0[k] + Linearised::row(eq.by_p, scene.grid, i, j, eq.dp) +
                   Linearised::row(eq.by_theta, scene.grid, i, j, eq.dtheta);
  const double a = eq.by_p.c[k];
  const double t = eq.by_theta.c[k];
  const double p0 = s.p[k] - eq.dp[k];
  const double theta0 = s.theta[k] - eq.dtheta[k];
  const double p_full = s.p[k] - (r + t * (1.0 - s.theta[k])) / a;
  if (p_full > scene.p_cavitation) {
    s.p[k] = std::max(scene.p_cavitation, s.p[k] + over * (p_full - s.p[k]));
    s.theta[k] = 1.0;
  } else {
    const double fill =
        t > 0.0 ? s.theta[k] - (r + a * (scene.p_cavitation - s.p[k])) / t : s.theta[k];
    s.p[k] = scene.p_cavitation;
    s.theta[k] = std::clamp(fill, 0.0, 1.0);  // theta stays what a fraction can be
  }
  s.full[k] = s.theta[k] >= 1.0;
  eq.dp[k] = s.p[k] - p0;
  eq.dtheta[k] = s.theta[k] - theta0;
}

void sweep(const FilmScene& scene, double over, Linearised& eq, FilmState& s) {
  const FilmGrid& g = scene.grid;
  for (int step = 0; step < g.nt; ++step) {
    const int i = scene.speed >= 0.0 ? step : g.nt - 1 - step;
    for (int j = 0; j < g.nz; ++j) {
      if (scene.supply.cell[g.index(i, j)] < 0) relax_cell(scene, over, i, j, eq, s);
    }
  }
}

}  // namespace

Outcome<RelaxedFilm> relax_p_theta(const FilmScene& scene, const Gap& gap, const Field& profile,
                                   const OilLaw& oil, const FilmState& guess,
                                   const RelaxationOptions& options) {
  Outcome<RelaxedFilm> out;
  FilmState& s = out.value.state;
  s = guess;
  const double over =
      options.over_relaxation > 0.0 ? options.over_relaxation : young_factor(scene.grid);
  const std::size_t n = s.p.size();
  FilmCoefficients coefficients;
  FilmFlow flow;
  Linearised eq;
  while (true) {
    oil(s, coefficients);
    evaluate_flow(scene, gap, profile, coefficients, s, flow);
    eq.R0 = film_residual(scene, flow);
    const double norm = largest_magnitude(eq.R0) / flow_scale(flow);
    out.history.push_back(norm);
    if (!std::isfinite(norm)) {
      out.verdict = method_diverged(scene.grid, first_not_a_number(gap, s, coefficients, flow));
      return out;
    }
    if (norm <= options.tolerance && complementary(scene, s)) return out;
    if (out.value.sweeps >= options.max_sweeps) break;
    assemble_film(scene, flow, {Field(n, 1.0), Field(n, 0.0)}, eq.by_p);
    assemble_film(scene, flow, {Field(n, 0.0), Field(n, 1.0)}, eq.by_theta);
    eq.dp.assign(n, 0.0);
    eq.dtheta.assign(n, 0.0);
    for (int k = 0; k < options.between; ++k) sweep(scene, over, eq, s);
    out.value.sweeps += options.between;
  }
  out.verdict = {Status::iteration_limit, ending::Unsettled{ending::Iteration::p_theta,
                                                            out.value.sweeps, out.history.back()}};
  return out;
}

}  // namespace shellback::validation
