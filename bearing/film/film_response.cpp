#include "bearing/film/film_response.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/solids.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {

namespace {

constexpr double kKrylovPart = 0.1;  ///< of the tolerance that GMRES may use up [-]
constexpr double kCorrectionTolerance =
    1e-3;  ///< of GMRES for a correction, itself a few per cent [-]

}  // namespace

LinearFilm::LinearFilm(const BearingModel& model, const OperatingPoint& point,
                       const FilmEquilibrium& s, const Field& thermal_deformation, double tolerance)
    : model_(model),
      point_(point),
      s_(s),
      thermal_deformation_(thermal_deformation),
      tolerance_(tolerance),
      film_(model, point.scene, s, 0, factor_, cost_),
      good_(film_.good()) {
  if (!rheology::thins(model.oil)) return;
  FilmEquilibrium sharp = s;
  good_ = good_ && evaluate(model, point, thermal_deformation, kRoundOff, sharp);
  residual_ = fluid::film_residual(point.scene, sharp.flow);
}

LinearFilm::Answer LinearFilm::solve(const Field& a, const Field& r, double tolerance) {
  if (s_.elastic.empty()) {
    Answer x = film_.held(a, {});
    x.P = sum(x.P, r);
    return x;
  }
  const auto answer = [&](const Field& b, bool homogeneous) {
    if (homogeneous) return film_.held({}, b);
    Field pressed = r;  // on the foundation the pressure that is known beforehand is a displacement
    for (std::size_t k = 0; k < pressed.size(); ++k) pressed[k] *= film_.foundation()[k];
    Answer x = film_.held(a, sum(b, pressed));
    x.P = sum(x.P, r);
    return x;
  };
  CompliantAnswer found = with_compliance(model_, s_, {}, answer, tolerance);
  converged_ = converged_ && found.reduction <= tolerance;
  return std::move(found.x);
}

Field LinearFilm::residual_along(const Answer& x, int component) const {
  const std::size_t n = x.u.size();
  const double gap = gap_with_summits(model_, s_);
  const double p_scale = largest_magnitude(s_.film.p);
  double size = 0.0;  // how far one unit of the answer moves the film, relative
  for (std::size_t k = 0; k < n; ++k) {
    size = larger(size, std::abs(x.u[k]) / (s_.film.full[k] ? p_scale : 1.0));
  }
  if (component >= 0)
    size = std::max(size, (component < 2 ? 1.0 : 0.5 * model_.domain.grid.width) / gap);
  size = larger(size, largest_magnitude(x.d) / gap);
  // Difference and round-off err alike by the root of what the states are known to.
  const double t = std::sqrt(kRoundOff) / size;
  FilmEquilibrium f = s_;
  if (component >= 0) f.position.q[component] += t;
  for (std::size_t k = 0; k < n; ++k) {
    if (model_.supply.cell[k] >= 0) continue;
    (f.film.full[k] ? f.film.p : f.film.theta)[k] += t * x.u[k];
  }
  for (std::size_t k = 0; k < x.d.size(); ++k) f.elastic[k] += t * x.d[k];
  if (!evaluate(model_, point_, thermal_deformation_, kRoundOff, f)) return Field(n, NAN);
  Field r = fluid::film_residual(point_.scene, f.flow);
  for (std::size_t k = 0; k < n; ++k) r[k] = (r[k] - residual_[k]) / t;
  return r;
}

FilmResponse LinearFilm::sharpened(const Field& a, const Field& r, const Field& stored,
                                   int component) {
  const std::size_t n = a.size();
  Answer x = solve(a, r, kKrylovPart * tolerance_);
  double last = largest_magnitude(x.P);
  bool settled =
      residual_.empty() || (largest_magnitude(x.u) == 0.0 && largest_magnitude(x.P) == 0.0);
  for (int sweep = 0; sweep < kMostIterations && !settled; ++sweep) {
    Field defect = residual_along(x, component);
    for (std::size_t k = 0; k < n; ++k) {
      defect[k] = -defect[k] - (stored.empty() ? 0.0 : stored[k]);
    }
    const Answer more = solve(defect, Field(n, 0.0), kCorrectionTolerance);
    for (std::size_t k = 0; k < n; ++k) {
      x.u[k] += more.u[k];
      x.P[k] += more.P[k];
    }
    for (std::size_t k = 0; k < x.d.size(); ++k) x.d[k] += more.d[k];
    const double correction = largest_magnitude(more.P);
    const double left = last > 0.0 ? correction / last : 0.0;  // part that a sweep leaves wrong
    settled = left * correction <= tolerance_ * largest_magnitude(x.P);
    last = correction;
  }
  converged_ = converged_ && settled;
  FilmResponse answer{Field(n, 0.0), std::move(x.d), std::move(x.P)};
  for (std::size_t k = 0; k < n; ++k) {
    if (!s_.film.full[k]) answer.theta[k] = x.u[k];
  }
  return answer;
}

FilmResponse LinearFilm::to_position(int component) {
  const fluid::FilmScene& scene = point_.scene;
  Field a = fluid::residual_by_position(scene, s_.flow, component);
  for (double& x : a) x = -x;
  Field r = fluid::gap_slopes(scene.grid, scene.angles, component);
  for (std::size_t k = 0; k < r.size(); ++k) r[k] *= s_.dp_contact[k];
  return sharpened(a, r, {}, component);
}

Field LinearFilm::pressure_by_storage(const Field& s) {
  Field a = s;
  for (double& x : a) x = -x;
  return solve(a, Field(s.size(), 0.0), kCorrectionTolerance).P;
}

FilmResponse LinearFilm::to_storage(const Field& s) {
  Field a = s;
  for (double& x : a) x = -x;
  return sharpened(a, Field(s.size(), 0.0), s, -1);
}

}  // namespace shellback::bearing
