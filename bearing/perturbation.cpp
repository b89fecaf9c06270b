#include "bearing/perturbation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bearing/film_response.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

double largest_entry(const Matrix2& m) {
  return larger(largest_magnitude(m[0]), largest_magnitude(m[1]));
}

void put_column(const fluid::FilmDomain& domain, int unknowns, int column, const Field& pressure,
                Matrix4& m) {
  const fluid::Wrench w = fluid::wrench(domain, pressure);
  for (int i = 0; i < unknowns; ++i) m[i][column] -= w[i];
}

/// Oil that a displacement brings into the cells [kg per unit].
struct Content {
  Field all;
  Field cavitated;  ///< that of the cavitated film alone
};

Content content_by(const Solution& s, const fluid::OilStore& store, const FilmResponse& answer,
                   int component) {
  const fluid::FilmScene& scene = s.point.scene;
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
  LinearFilm film(s.model, s.point, s.film, s.heat.thermal_deformation, tolerance);
  if (!film.good()) {
    out.verdict = {Status::iteration_limit, ending::Plain::singular_response};
    return;
  }
  const fluid::OilStore store =
      fluid::oil_store(s.point.scene, s.film.gap, s.film.oil, s.film.film);
  for (int j = 0; j < out.unknowns; ++j) {
    const FilmResponse slow = film.to_position(j);
    put_column(s.model.domain, out.unknowns, j, slow.total, out.K);
    const Content m = content_by(s, store, slow, j);
    put_column(s.model.domain, out.unknowns, j, film.to_storage(m.all).total, out.C);
    if (j > 1) continue;
    put_column(s.model.domain, 2, j, film.pressure_by_storage(m.cavitated), C_cavitated);
  }
  out.krylov_iterations = film.krylov_iterations();
  if (!film.converged()) {
    out.verdict = {Status::iteration_limit, ending::Plain::unsettled_response};
  }
}

/// Load axes, dimensionless forms and threshold, from K and C.
void derive(const Solution& s, Coefficients& out) {
  out.load = std::hypot(s.film.force[0], s.film.force[1]);
  out.clearance = s.model.clearance;
  out.omega = s.point.omega();
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

Coefficients coefficients_of(const Solution& s, double tolerance) {
  const auto begin = std::chrono::steady_clock::now();
  Coefficients out;
  out.unknowns = s.model.domain.grid.half ? 2 : 4;
  Matrix4 C_cavitated{};
  perturb(s, tolerance, out, C_cavitated);
  if (out.verdict.good()) {
    derive(s, out);
    const double C = largest_entry(forces_of(out.C));
    out.cavitated_share = C > 0.0 ? largest_entry(forces_of(C_cavitated)) / C : 0.0;
    if (out.whirl.verdict == WhirlVerdict::never_stable && out.cavitated_share > kTelling) {
      out.whirl = {WhirlVerdict::unknown};
      out.speed_ratio = NAN;
    }
  }
  out.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return out;
}

}  // namespace shellback::bearing
