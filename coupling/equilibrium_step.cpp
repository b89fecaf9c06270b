#include "coupling/equilibrium_step.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace shellback::coupling {

namespace {

constexpr double kMostClosing = 1.5;    ///< largest ln(gap before / after) in one step [-]
constexpr double kMostOpening = 2.0;    ///< largest opening, in gaps [-]
constexpr double kMostTurning = 0.4;    ///< largest change of the attitude in one step [rad]
constexpr double kMostCartesian = 0.3;  ///< largest step near the centre, in clearances [-]
constexpr double kNearCentre = 0.05;    ///< eccentricity below which steps are Cartesian [-]
constexpr double kMostLog = 2.5;        ///< largest |ln| of the force ratio used [-]

}  // namespace

FilmSystem& film_system() {
  static thread_local FilmSystem system;
  return system;
}

fluid::Wrench wanted_change(const fluid::Wrench& now, const LoadTarget& target) {
  fluid::Wrench d{};
  for (int k = 0; k < 4; ++k) d[k] = target.force[k] - now[k];
  const std::complex<double> f(now[0], now[1]);
  const std::complex<double> aim(target.force[0], target.force[1]);
  if (std::abs(f) > 1e-6 * std::abs(aim)) {
    std::complex<double> ln = std::log(aim / f);
    if (std::abs(ln.imag()) < 1.5) {
      ln.real(std::clamp(ln.real(), -kMostLog, kMostLog));
      const std::complex<double> change = f * ln;
      d[0] = change.real();
      d[1] = change.imag();
    }
  }
  return d;
}

std::array<double, 4> limited(const fluid::JournalPosition& position,
                              const std::array<double, 4>& dq, double g, double clearance,
                              double half_width, double reach) {
  std::array<double, 4> out = dq;
  const double e = std::hypot(position.ex(), position.ey());
  if (e < kNearCentre * clearance) {
    const double size = std::hypot(dq[0], dq[1]);
    const double most = kMostCartesian * clearance * reach;
    if (size > most) {
      for (int k = 0; k < 2; ++k) out[k] *= most / size;
    }
  } else {
    const double rx = position.ex() / e;
    const double ry = position.ey() / e;
    const double radial = dq[0] * rx + dq[1] * ry;
    const double turn =
        std::clamp((-dq[0] * ry + dq[1] * rx) / e, -kMostTurning * reach, kMostTurning * reach);
    double along = 0.0;
    if (radial > 0.0) {
      along = g * -std::expm1(-std::min(radial / g, kMostClosing * reach));
    } else {
      along = std::max(radial, -kMostOpening * g * reach);
    }
    const double e_new = e + along;
    out[0] = e_new * (rx * std::cos(turn) - ry * std::sin(turn)) - position.ex();
    out[1] = e_new * (ry * std::cos(turn) + rx * std::sin(turn)) - position.ey();
  }
  const double tilt = std::hypot(dq[2], dq[3]) * half_width;
  const double most = 0.5 * g * reach;
  if (tilt > most) {
    for (int k = 2; k < 4; ++k) out[k] *= most / tilt;
  }
  return out;
}

bool solve_small(int n, std::array<std::array<double, 4>, 4> a, std::array<double, 4>& b) {
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int r = k + 1; r < n; ++r) {
      if (std::abs(a[r][k]) > std::abs(a[pivot][k])) pivot = r;
    }
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    if (a[k][k] == 0.0 || !std::isfinite(a[k][k])) return false;
    for (int r = k + 1; r < n; ++r) {
      const double f = a[r][k] / a[k][k];
      for (int c = k; c < n; ++c) a[r][c] -= f * a[k][c];
      b[r] -= f * b[k];
    }
  }
  for (int k = n - 1; k >= 0; --k) {
    for (int c = k + 1; c < n; ++c) b[k] -= a[k][c] * b[c];
    b[k] /= a[k][k];
  }
  return true;
}

NewtonStep rigid_step(const BearingModel& model, const LoadTarget& target, const FilmEquilibrium& s,
                      const Field& residual, StepLimits limits, EquilibriumCost& cost) {
  const fluid::FilmScene& scene = model.scene;
  const int n = scene.grid.cells();
  const int m = target.unknowns;
  NewtonStep step;
  auto& [matrix, factor] = film_system();
  fluid::assemble_film(scene, s.flow, fluid::active_set_unknowns(s.film), matrix);
  ++cost.factorizations;
  if (!factor.factorize(matrix)) return step;
  std::vector<double> rhs(static_cast<std::size_t>(n) * (m + 1));
  for (int k = 0; k < n; ++k) rhs[k] = -residual[k];
  for (int l = 0; l < m; ++l) {
    const Field b = fluid::residual_by_position(scene, s.flow, l);
    std::copy(b.begin(), b.end(), rhs.begin() + static_cast<std::ptrdiff_t>(n) * (l + 1));
  }
  factor.solve(rhs.data(), m + 1);
  step.film.assign(rhs.begin(), rhs.begin() + n);
  step.good = true;
  if (m == 0) return step;

  fluid::FilmState predicted = s.film;  // where the film step alone leads to
  fluid::advance(scene, s.oil, step.film, 1.0, predicted);
  Field total = predicted.p;
  for (int k = 0; k < n; ++k) total[k] += s.p_contact[k];
  const fluid::Wrench aim = wanted_change(fluid::wrench(scene, total), target);
  std::array<std::array<double, 4>, 4> stiffness{};
  const FilmGrid& g = scene.grid;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      for (int l = 0; l < m; ++l) {
        const double slope =
            fluid::gap_slope(l, scene.angles.cos_cell[i], scene.angles.sin_cell[i], g.z[j]);
        double dp = s.dp_contact[c] * slope;
        if (predicted.full[c] && s.film.full[c])
          dp -= rhs[static_cast<std::size_t>(n) * (l + 1) + c];
        for (int k = 0; k < m; ++k) stiffness[k][l] += fluid::wrench_weight(scene, k, i, j) * dp;
      }
    }
  }
  std::array<double, 4> dq = aim;
  for (double& x : dq) x *= limits.damping;
  if (!solve_small(m, stiffness, dq)) {
    step.good = false;
    return step;
  }
  for (int k = m; k < 4; ++k) dq[k] = 0.0;
  const double roughness = scene.rough.sigma;
  const double gap = std::max(s.least.h, 0.0) + 3.0 * roughness;
  step.q = limited(s.position, dq, gap, model.clearance, 0.5 * g.width, limits.reach);
  for (int l = 0; l < m; ++l) {
    const double* d = &rhs[static_cast<std::size_t>(n) * (l + 1)];
    for (int k = 0; k < n; ++k) step.film[k] -= step.q[l] * d[k];
  }
  return step;
}

}  // namespace shellback::coupling
