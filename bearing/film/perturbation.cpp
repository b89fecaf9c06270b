#include "bearing/film/perturbation.hpp"

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "bearing/film/film_impedance.hpp"
#include "core/stopwatch.hpp"

namespace shellback::bearing {
namespace {

/// Root of the sum of squares: the same in any axes.
double norm(const Matrix2& m) {
  return std::hypot(std::hypot(m[0][0], m[0][1]), std::hypot(m[1][0], m[1][1]));
}

/// Highest frequency that is looked at, over the journal's [-]. Whirl is at half of it where the
/// film is fed well, at up to 2.7 where it is starved: with 3 and 6 all of 144 random bearings come
/// out alike, with 1 nine do not (decision 047).
constexpr double kHighest = 3.0;

/// True if a moment is given: the tilt then is the one that balances it.
bool tilt_follows(const Solution& s) { return s.point.load.unknowns == 4; }

/// Z of forces by places at the frequency nu; with a tilt that follows, which has no inertia, Z_ff
/// - Z_fm Z_mm^-1 Z_mf.
ComplexMatrix2 impedance_of_place(const std::vector<ForceByMotion>& columns, bool follows,
                                  double nu) {
  const int n = follows ? 4 : 2;
  Eigen::Matrix4cd Z = Eigen::Matrix4cd::Zero();
  for (int j = 0; j < n; ++j) {
    const auto force = columns[j].at(nu);
    for (int i = 0; i < n; ++i) Z(i, j) = -force[i];
  }
  Eigen::Matrix2cd place = Z.topLeftCorner<2, 2>();
  if (follows) {
    const Eigen::Matrix2cd tilt = Z.bottomRightCorner<2, 2>();
    place -= Z.topRightCorner<2, 2>() * tilt.inverse() * Z.bottomLeftCorner<2, 2>();
  }
  return {{{place(0, 0), place(0, 1)}, {place(1, 0), place(1, 1)}}};
}

/// K, C and the answer to motions of any frequency; the part of C from cavitated film in
/// `C_cavitated`.
std::vector<ForceByMotion> perturb(const Solution& s, double tolerance, Coefficients& out,
                                   Matrix4& C_cavitated) {
  std::vector<ForceByMotion> columns;
  LinearFilm film(s.model, s.point, s.film, s.heat.thermal_deformation, tolerance);
  if (!film.good()) {
    out.verdict = {Status::iteration_limit, ending::Plain::singular_response};
    return columns;
  }
  const int swinging = tilt_follows(s) ? out.unknowns : 2;
  for (int j = 0; j < out.unknowns; ++j) {
    const double highest = j < swinging ? kHighest * std::abs(s.point.omega()) : 0.0;
    columns.emplace_back(film, s, j, highest, tolerance);
    const ForceByMotion& column = columns.back();
    for (int i = 0; i < out.unknowns; ++i) {
      out.K[i][j] = -column.by_place()[i];
      out.C[i][j] = -column.by_velocity()[i];
      C_cavitated[i][j] = -column.by_cavitated()[i];
    }
    if (column.converged()) continue;
    out.verdict = {Status::iteration_limit, ending::Plain::unsettled_response};
  }
  return columns;
}

/// Load axes, dimensionless forms and threshold.
void derive(const Solution& s, const std::vector<ForceByMotion>& columns, Coefficients& out) {
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
  const bool follows = tilt_follows(s);
  const auto impedance = [&](double nu) { return impedance_of_place(columns, follows, nu); };
  out.whirl = whirl_threshold(impedance, kHighest * speed);
  out.whirl_ratio = out.whirl.whirl_frequency / speed;
  out.speed_ratio = speed * std::sqrt(out.clearance * out.whirl.critical_mass / out.load);
}

}  // namespace

Coefficients coefficients_of(const Solution& s, double tolerance) {
  const Stopwatch watch;
  Coefficients out;
  out.unknowns = s.model.domain.grid.half ? 2 : 4;
  Matrix4 C_cavitated{};
  const auto columns = perturb(s, tolerance, out, C_cavitated);
  if (out.verdict.good()) {
    derive(s, columns, out);
    const double C = norm(forces_of(out.C));
    out.cavitated_share = C > 0.0 ? norm(forces_of(C_cavitated)) / C : 0.0;
  }
  out.wall_s = watch.seconds();
  return out;
}

}  // namespace shellback::bearing
