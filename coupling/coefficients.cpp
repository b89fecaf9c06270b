#include "coupling/coefficients.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/largest.hpp"
#include "coupling/film_response.hpp"
#include "coupling/solve.hpp"

namespace shellback::coupling {
namespace {

double determinant(const Matrix2& m) { return m[0][0] * m[1][1] - m[0][1] * m[1][0]; }

double largest_entry(const Matrix2& m) {
  return larger(largest_magnitude(m[0]), largest_magnitude(m[1]));
}

void put_column(const BearingModel& model, int unknowns, int column, const Field& pressure,
                Matrix4& m) {
  const fluid::Wrench w = fluid::wrench(model.scene, pressure);
  for (int i = 0; i < unknowns; ++i) m[i][column] -= w[i];
}

/// Oil that a displacement brings into the cells [kg per unit].
struct Content {
  Field all;
  Field cavitated;  ///< that of the cavitated film alone
};

Content content_by(const Solution& s, const fluid::OilStore& store, const FilmResponse& answer,
                   int component) {
  const fluid::FilmScene& scene = s.model.scene;
  const FilmGrid& g = scene.grid;
  Content m{Field(g.cells(), 0.0), Field(g.cells(), 0.0)};
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      double dh =
          fluid::gap_slope(component, scene.angles.cos_cell[i], scene.angles.sin_cell[i], g.z[j]);
      if (!answer.elastic.empty()) dh += answer.elastic[k];
      const double change = store.by_gap[k] * dh + store.by_theta[k] * answer.theta[k];
      m.all[k] = change;
      if (!s.film.film.full[k]) m.cavitated[k] = change;
    }
  }
  return m;
}

/// K and C; the part of C from cavitated film in `C_cavitated`.
void perturb(const Solution& s, double tolerance, Coefficients& out, Matrix4& C_cavitated) {
  LinearFilm film(s.model, s.film, s.heat.growth, tolerance);
  if (!film.good()) {
    out.verdict = {Status::iteration_limit, "the matrix of the linearised film is singular", "",
                   "feed more oil"};
    return;
  }
  const fluid::OilStore store =
      fluid::oil_store(s.model.scene, s.film.gap, s.film.oil, s.film.film);
  for (int j = 0; j < out.unknowns; ++j) {
    const FilmResponse slow = film.to_position(j);
    put_column(s.model, out.unknowns, j, slow.total, out.K);
    const Content m = content_by(s, store, slow, j);
    put_column(s.model, out.unknowns, j, film.to_storage(m.all).total, out.C);
    if (j > 1) continue;
    put_column(s.model, 2, j, film.pressure_by_storage(m.cavitated), C_cavitated);
  }
  out.krylov_iterations = film.krylov_iterations();
  if (!film.converged()) {
    out.verdict = {Status::iteration_limit,
                   "the linearised elastic film did not settle (GMRES stopped at its limit)", "",
                   "try a finer grid"};
  }
}

/// Load axes, dimensionless forms and threshold, from K and C.
void derive(const Solution& s, Coefficients& out) {
  out.load = std::hypot(s.film.force[0], s.film.force[1]);
  out.clearance = s.model.clearance;
  out.omega = s.model.input.operation.omega;
  const double speed = std::abs(out.omega);
  const double angle = std::atan2(-s.film.force[1], -s.film.force[0]);
  const int turn = out.omega >= 0.0 ? 1 : -1;
  out.K_load = in_axes(forces_of(out.K), angle, turn);
  out.C_load = in_axes(forces_of(out.C), angle, turn);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      out.K_load[i][j] *= out.clearance / out.load;
      out.C_load[i][j] *= out.clearance * speed / out.load;
    }
  }
  out.whirl = whirl_threshold(forces_of(out.K), forces_of(out.C));
  out.whirl_ratio = out.whirl.whirl_frequency / speed;
  out.speed_ratio = speed * std::sqrt(out.clearance * out.whirl.critical_mass / out.load);
}

}  // namespace

Matrix2 forces_of(const Matrix4& m) { return {{{m[0][0], m[0][1]}, {m[1][0], m[1][1]}}}; }

Matrix2 in_axes(const Matrix2& m, double angle, int turn) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const Matrix2 axis{{{c, s}, {-turn * s, turn * c}}};
  Matrix2 out{};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      for (int k = 0; k < 2; ++k) {
        for (int l = 0; l < 2; ++l) out[i][j] += axis[i][k] * m[k][l] * axis[j][l];
      }
    }
  }
  return out;
}

WhirlThreshold whirl_threshold(const Matrix2& K, const Matrix2& C) {
  WhirlThreshold w;
  const double trace = C[0][0] + C[1][1];
  const double kappa =
      (K[0][0] * C[1][1] + K[1][1] * C[0][0] - K[0][1] * C[1][0] - K[1][0] * C[0][1]) / trace;
  const double damping = determinant(C);
  if (!(trace > 0.0 && kappa > 0.0 && damping > 0.0 && determinant(K) > 0.0)) {
    w.verdict = WhirlVerdict::never_stable;
    w.critical_mass = 0.0;
    return w;
  }
  const double rest = (K[0][0] - kappa) * (K[1][1] - kappa) - K[0][1] * K[1][0];
  if (!(rest > 0.0)) {
    w.verdict = WhirlVerdict::always_stable;
    w.critical_mass = INFINITY;
    return w;
  }
  w.critical_mass = kappa * damping / rest;
  w.whirl_frequency = std::sqrt(rest / damping);
  return w;
}

Coefficients coefficients_of(const Solution& s, double tolerance) {
  const auto begin = std::chrono::steady_clock::now();
  Coefficients out;
  out.unknowns = s.model.scene.grid.half ? 2 : 4;
  Matrix4 C_cavitated{};
  perturb(s, tolerance, out, C_cavitated);
  if (out.verdict.good()) {
    derive(s, out);
    const double C = largest_entry(forces_of(out.C));
    out.cavitated_share = C > 0.0 ? largest_entry(forces_of(C_cavitated)) / C : 0.0;
  }
  out.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return out;
}

}  // namespace shellback::coupling
