#include "fluid/fischer_burmeister.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "fluid/film_matrix.hpp"

namespace shellback::fluid {
namespace {

constexpr double kFillSlack = 1e-12;     ///< round-off allowed in 0 <= theta <= 1 [-]
constexpr double kPressureSlack = 1e-9;  ///< round-off allowed in p >= p_cav, of the scale [-]
constexpr int kHalvings = 12;            ///< shortest step tried: 2^-12

/// Linearised complementarity of one cell: dp = a_p t + b_p, dtheta = a_t t + b_t.
struct Elimination {
  double a_p, b_p, a_t, b_t;
};

Elimination eliminate(double P, double c, double p_ref, bool full) {
  const double norm = std::hypot(P, c);
  if (norm == 0.0 && full) return {1.0, 0.0, 0.0, 0.0};  // of the slopes there, that of a full film
  const double fP = norm > 0.0 ? 1.0 - P / norm : 1.0 - std::sqrt(0.5);
  const double fc = norm > 0.0 ? 1.0 - c / norm : 1.0 - std::sqrt(0.5);
  const double f = P + c - norm;
  if (std::abs(fP) < std::abs(fc)) {  // p is the unknown, c follows
    return {1.0, 0.0, fP / (fc * p_ref), f / fc};
  }
  return {fc / fP * p_ref, -f / fP * p_ref, 1.0, 0.0};
}

double merit(const FilmScene& scene, const FilmSolution& v, double p_ref) {
  const double scale = flow_scale(v.flow);
  double sum = 0.0;
  for (const double r : film_residual(scene, v.flow)) sum += r * r / (scale * scale);
  for (std::size_t k = 0; k < v.state.p.size(); ++k) {
    const double P = (v.state.p[k] - scene.p_cavitation) / p_ref;
    const double c = 1.0 - v.state.theta[k];
    const double f = P + c - std::hypot(P, c);
    sum += f * f;
  }
  return sum;
}

/// Snaps the smooth iterate to the active set it stands for once it is nearly complementary.
void snap(const FilmScene& scene, double p_ref, FilmState& s) {
  for (std::size_t k = 0; k < s.p.size(); ++k) {
    const double P = (s.p[k] - scene.p_cavitation) / p_ref;
    s.full[k] = P >= 1.0 - s.theta[k];
    if (s.full[k] && std::abs(1.0 - s.theta[k]) < kFillSlack * 10) s.theta[k] = 1.0;
    if (!s.full[k] && std::abs(P) < kFillSlack * 10) s.p[k] = scene.p_cavitation;
  }
}

}  // namespace

double pressure_scale(const FilmScene& scene, const FilmState& s) {
  double p = 1.0;
  for (const double x : s.p) p = std::max(p, x - scene.p_cavitation);
  return p;
}

bool complementary(const FilmScene& scene, const FilmState& s) {
  const double slack = kPressureSlack * pressure_scale(scene, s);
  for (std::size_t k = 0; k < s.p.size(); ++k) {
    if (scene.supply.cell[k] >= 0) continue;
    const double over = s.p[k] - scene.p_cavitation;
    const double c = 1.0 - s.theta[k];
    if (over < -slack || c < -kFillSlack || c > 1.0 + kFillSlack) return false;
    if (over > slack && c > kFillSlack) return false;
  }
  return true;
}

std::size_t active_set_hash(const FilmState& s) {
  return std::hash<std::string_view>{}(std::string_view(s.full.data(), s.full.size()));
}

bool fischer_burmeister_step(const FilmScene& scene, const Gap& gap, const Field& profile,
                             const OilLaw& oil, FilmSolution& v) {
  const double p_ref = pressure_scale(scene, v.state);
  const std::size_t n = v.state.p.size();
  UnknownMap u{Field(n), Field(n)};
  Field b_p(n, 0.0), b_t(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    const Elimination e = scene.supply.cell[k] >= 0
                              ? Elimination{1.0, 0.0, 0.0, 0.0}
                              : eliminate((v.state.p[k] - scene.p_cavitation) / p_ref,
                                          1.0 - v.state.theta[k], p_ref, v.state.full[k]);
    u.a_p[k] = e.a_p;
    u.a_theta[k] = e.a_t;
    b_p[k] = e.b_p;
    b_t[k] = e.b_t;
  }
  // The constant parts b move the right-hand side: apply the matrix of the maps (1,0) and (0,1).
  RingMatrix by_p, by_theta, matrix;
  assemble_film(scene, v.flow, {Field(n, 1.0), Field(n, 0.0)}, by_p);
  assemble_film(scene, v.flow, {Field(n, 0.0), Field(n, 1.0)}, by_theta);
  Field move_p, move_theta;
  by_p.multiply(b_p, move_p);
  by_theta.multiply(b_t, move_theta);
  Field t = film_residual(scene, v.flow);
  for (std::size_t k = 0; k < n; ++k) t[k] = -t[k] - move_p[k] - move_theta[k];
  assemble_film(scene, v.flow, u, matrix);
  if (!v.factor.factorize(matrix)) return false;
  v.factor.solve(t.data());

  const double before = merit(scene, v, p_ref);
  const FilmState start = v.state;
  double fraction = 1.0;
  for (int halving = 0; halving <= kHalvings; ++halving, fraction *= 0.5) {
    for (std::size_t k = 0; k < n; ++k) {
      if (scene.supply.cell[k] >= 0) continue;
      v.state.p[k] = start.p[k] + fraction * (u.a_p[k] * t[k] + b_p[k]);
      v.state.theta[k] = start.theta[k] + fraction * (u.a_theta[k] * t[k] + b_t[k]);
    }
    snap(scene, p_ref, v.state);
    oil(v.state, v.oil);
    evaluate_flow(scene, gap, profile, v.oil, v.state, v.flow);
    if (merit(scene, v, p_ref) < before) return true;
  }
  return false;
}

}  // namespace shellback::fluid
