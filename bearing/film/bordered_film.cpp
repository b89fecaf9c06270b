#include "bearing/film/bordered_film.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>

#include "bearing/solids.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

constexpr double kMostClosing = 1.5;       ///< largest ln(gap before / after) in one step [-]
constexpr double kMostOpening = 2.0;       ///< largest opening, in gaps [-]
constexpr double kMostTurning = 0.4;       ///< largest change of the attitude in one step [rad]
constexpr double kMostCartesian = 0.3;     ///< largest step near the centre, in clearances [-]
constexpr double kNearCentre = 0.05;       ///< eccentricity below which steps are Cartesian [-]
constexpr double kMostLog = 2.5;           ///< largest |ln| of the force ratio used [-]
constexpr double kKrylovTolerance = 1e-4;  ///< tighter gains no Newton iteration (methods 2.2)
constexpr double kKrylovInTime = 1e-2;  ///< over a step in time: as many iterations, half as long

/// Storage of the film's linear system, one per thread and used again by every step: fresh pages
/// would cost a good part of a factorisation.
struct Workspace {
  RingMatrix matrix;
  RingFactor factor;
};
Workspace& workspace() {
  static thread_local Workspace w;
  return w;
}

}  // namespace

BorderedFilm::BorderedFilm(const BearingModel& model, const fluid::FilmScene& scene,
                           const FilmEquilibrium& s, int journal, RingFactor& factor,
                           EquilibriumCost& cost)
    : scene_(scene), s_(s), m_(journal), factor_(factor) {
  const int n = scene.grid.cells();
  RingMatrix& matrix = workspace().matrix;
  fluid::assemble_film(scene, s.flow, fluid::active_set_unknowns(s.film), matrix);
  if (!s.elastic.empty()) {
    tau_.assign(n, model.solids->winkler());
    for (std::size_t k = 0; k < s.layer.size(); ++k) tau_[k] += s.layer[k].by_pressure;
    kappa_.resize(n);
    Field soft(n);
    for (int k = 0; k < n; ++k) {
      kappa_[k] = 1.0 / (1.0 - tau_[k] * s.dp_contact[k]);
      soft[k] = free(k) ? kappa_[k] * tau_[k] : 0.0;
    }
    fluid::add_gap_compliance(scene, s.flow, soft, matrix);
  }
  ++cost.factorizations;
  good_ = factor_.factorize(matrix);
  for (int l = 0; good_ && l < m_; ++l) {
    const Field slope = fluid::gap_slopes(scene.grid, scene.angles, l);
    Field a = fluid::residual_by_position(scene, s.flow, l);
    for (double& x : a) x = -x;
    Field b;
    if (!kappa_.empty()) {
      b.resize(n);
      for (int k = 0; k < n; ++k) b[k] = tau_[k] * s.dp_contact[k] * slope[k];
    }
    Answer x = held(a, b);
    for (int k = 0; k < n; ++k) {
      const double touched = s.dp_contact[k] * slope[k];
      x.P[k] += touched;
      if (!x.contact.empty()) x.contact[k] += touched;
    }
    response_.push_back(std::move(x));
  }
}

BorderedFilm::Answer BorderedFilm::held(const Field& a, const Field& b) const {
  const int n = scene_.grid.cells();
  Answer x;
  x.u = a.empty() ? Field(n, 0.0) : a;
  x.P.assign(n, 0.0);
  if (kappa_.empty()) {
    factor_.solve(x.u.data());
    for (int k = 0; k < n; ++k) x.P[k] = free(k) ? x.u[k] : 0.0;
    return x;
  }
  x.d.assign(n, 0.0);
  if (!b.empty()) {
    for (int k = 0; k < n; ++k) x.d[k] = kappa_[k] * b[k];
    const Field moved = fluid::residual_by_gap(scene_, s_.flow, x.d);
    for (int k = 0; k < n; ++k) x.u[k] -= moved[k];
  }
  factor_.solve(x.u.data());
  x.contact.resize(n);
  for (int k = 0; k < n; ++k) {
    const double du = free(k) ? x.u[k] : 0.0;
    x.d[k] += kappa_[k] * tau_[k] * du;
    x.contact[k] = s_.dp_contact[k] * x.d[k];
    x.P[k] = du + x.contact[k];
  }
  return x;
}

void BorderedFilm::move(const std::array<double, 4>& dq, Answer& x) const {
  const auto add = [](double f, const Field& from, Field& to) {
    for (std::size_t k = 0; k < to.size(); ++k) to[k] += f * from[k];
  };
  for (int l = 0; l < m_; ++l) {
    add(dq[l], response_[l].u, x.u);
    add(dq[l], response_[l].d, x.d);
    add(dq[l], response_[l].P, x.P);
    add(dq[l], response_[l].contact, x.contact);
  }
}

std::array<std::array<double, 4>, 4> BorderedFilm::stiffness(const std::vector<char>& full) const {
  const FilmGrid& g = scene_.grid;
  std::array<std::array<double, 4>, 4> out{};
  for (int l = 0; l < m_; ++l) {
    Field P = response_[l].P;
    for (int k = 0; k < g.cells(); ++k) {
      if (s_.film.full[k] && !full[k]) P[k] -= response_[l].u[k];  // it will be cavitated
    }
    const fluid::Wrench w = fluid::wrench(scene_, P);
    for (int k = 0; k < 4; ++k) out[k][l] = w[k];
  }
  return out;
}

fluid::Wrench wanted_change(const fluid::Wrench& now, const fluid::Wrench& target) {
  fluid::Wrench d{};
  for (int k = 0; k < 4; ++k) d[k] = target[k] - now[k];
  const std::complex<double> f(now[0], now[1]);
  const std::complex<double> aim(target[0], target[1]);
  if (std::abs(f) > 1e-6 * std::abs(aim)) {
    std::complex<double> ln = std::log(aim / f);
    if ((aim / f).real() > 0.0) {  // forces of like direction
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
    for (int k = 0; k < 2 && size > most; ++k) out[k] *= most / size;
  } else {
    const double rx = position.ex() / e;
    const double ry = position.ey() / e;
    const double radial = dq[0] * rx + dq[1] * ry;
    const double turn =
        std::clamp((-dq[0] * ry + dq[1] * rx) / e, -kMostTurning * reach, kMostTurning * reach);
    const double along = radial > 0.0 ? g * -std::expm1(-std::min(radial / g, kMostClosing * reach))
                                      : std::max(radial, -kMostOpening * g * reach);
    // Differences of the rotated place, without its round-off: State::flight is known beyond it.
    const double sine = std::sin(turn), cosine = std::cos(turn);
    const double less = -2.0 * std::pow(std::sin(0.5 * turn), 2);  // cosine - 1
    out[0] = along * (rx * cosine - ry * sine) + e * (rx * less - ry * sine);
    out[1] = along * (ry * cosine + rx * sine) + e * (ry * less + rx * sine);
  }
  const double tilt = std::hypot(dq[2], dq[3]) * half_width;
  const double most = 0.5 * g * reach;
  for (int k = 2; k < 4 && tilt > most; ++k) out[k] *= most / tilt;
  return out;
}

namespace {

/// Movement of the journal and change of the load's factor.
struct Movement {
  std::array<double, 4> dq{};
  double ln_load = 0.0;
};

/// The border: S dq - (k dq) - F_wanted d(ln load) = aim, and the row of the path with `missing` on
/// its right-hand side.
std::optional<Movement> solve_border(const LoadTarget& load, const FilmEquilibrium& s,
                                     const std::array<std::array<double, 4>, 4>& stiffness,
                                     const fluid::Wrench& aim, double missing) {
  const int m = load.unknowns;
  const int n = m + (load.path ? 1 : 0);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 5, 5> A(n, n);
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5, 1> b(n);
  for (int k = 0; k < m; ++k) {
    for (int l = 0; l < m; ++l) A(k, l) = stiffness[k][l];
    if (k < 2) A(k, k) -= load.inertial_stiffness;
    b(k) = aim[k];
  }
  if (load.path) {
    const PathRow& p = *load.path;
    b(m) = missing;
    for (int k = 0; k < m; ++k) {
      A(k, m) = -load.force[k] * std::exp(s.ln_load);
      A(m, k) = p.along[k] / p.unit[k];
    }
    A(m, m) = p.along_load;
  }
  // Rows of force, moment and path differ by their units: each is taken by its largest entry.
  for (int k = 0; k < n; ++k) {
    const double most = A.row(k).cwiseAbs().maxCoeff();
    if (!(most > 0.0) || !std::isfinite(most)) return std::nullopt;
    A.row(k) /= most;
    b(k) /= most;
  }
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5, 1> x = A.partialPivLu().solve(b);
  if (!x.allFinite()) return std::nullopt;
  Movement out;
  for (int k = 0; k < m; ++k) out.dq[k] = x(k);
  if (load.path) out.ln_load = x(m);
  return out;
}

}  // namespace

CompliantAnswer with_compliance(const BearingModel& model, const FilmEquilibrium& s,
                                const Field& defect, const FilmSolve& solve, double tolerance,
                                KrylovMemory* memory) {
  const double tau = model.solids->winkler();
  const auto beyond_winkler = [&](const BorderedFilm::Answer& x) {
    Field y = model.solids->compliance(x.P);
    for (std::size_t k = 0; k < y.size(); ++k) y[k] -= tau * x.P[k];
    return s.contact_widening ? sum(y, widening(*model.solids, *s.contact_widening, x.contact)) : y;
  };
  const Field rhs = beyond_winkler(solve(defect, false));
  const auto apply = [&](const Field& b) {
    Field y = beyond_winkler(solve(b, true));
    for (std::size_t k = 0; k < y.size(); ++k) y[k] = b[k] - y[k];
    return y;
  };
  const KrylovResult correction = gmres(apply, rhs, tolerance, kMostIterations, memory);
  return {solve(sum(defect, correction.x), false), correction.reduction};
}

namespace {

/// What one step is made of.
struct StepProblem {
  const BearingModel& model;
  const fluid::FilmScene& scene;
  const LoadTarget& load;
  const FilmEquilibrium& s;
  const Residuals& r;
  const BorderedFilm& film;
  EquilibriumCost& cost;
  KrylovMemory* memory;
  Field a;                   ///< right-hand side of (1)
  fluid::Wrench wanted;      ///< force of this state
  BorderedFilm::Answer x{};  ///< the answer
  std::optional<Movement> moved{Movement{}};

  /// Wanted change of a force. Over a finite step the force is that of squeezing, linear in the
  /// journal's movement.
  [[nodiscard]] fluid::Wrench aim_from(const fluid::Wrench& now) const {
    if (!scene.storage.finite()) return wanted_change(now, wanted);
    fluid::Wrench d{};
    for (int k = 0; k < 4; ++k) d[k] = wanted[k] - now[k];
    return d;
  }
  void solve_elastic();
  void solve_rigid(StepLimits limits);
};

void StepProblem::solve_elastic() {
  const int m = load.unknowns;
  const auto stiffness = film.stiffness(s.film.full);
  const fluid::Wrench aim = aim_from(s.force);
  const double missing = load.path ? load.path->missing(s) : 0.0;
  const auto balanced = [&](const Field& b, bool homogeneous) {
    BorderedFilm::Answer y = film.held(homogeneous ? Field{} : a, b);
    if (m == 0) return y;
    const fluid::Wrench now = fluid::wrench(scene, y.P);
    fluid::Wrench rest{};
    for (int k = 0; k < m; ++k) rest[k] = (homogeneous ? 0.0 : aim[k]) - now[k];
    moved = solve_border(load, s, stiffness, rest, homogeneous ? 0.0 : missing);
    if (moved) film.move(moved->dq, y);
    return y;
  };
  const double tolerance = scene.storage.finite() ? kKrylovInTime : kKrylovTolerance;
  CompliantAnswer answer = with_compliance(model, s, r.displacement, balanced, tolerance, memory);
  x = std::move(answer.x);
}

void StepProblem::solve_rigid(StepLimits limits) {
  x = film.held(a, {});
  if (load.unknowns == 0) return;
  fluid::FilmState predicted = s.film;  // where the film step alone leads to
  if (scene.storage.finite()) {
    for (std::size_t k = 0; k < x.P.size(); ++k) predicted.p[k] += x.P[k];
  } else {
    fluid::advance(scene, s.oil, x.u, 1.0, predicted);
  }
  fluid::Wrench aim = aim_from(fluid::wrench(scene, sum(predicted.p, s.p_contact)));
  for (double& f : aim) f *= limits.damping;
  moved = solve_border(load, s, film.stiffness(predicted.full), aim,
                       load.path ? load.path->missing(s) : 0.0);
  if (!moved) return;
  const double gap = gap_with_summits(model, s);
  moved->dq = limited(s.position, moved->dq, gap, model.clearance, 0.5 * model.domain.grid.width,
                      limits.reach);
  film.move(moved->dq, x);
}

}  // namespace

NewtonStep newton_step(const BearingModel& model, const fluid::FilmScene& scene,
                       const LoadTarget& load, const FilmEquilibrium& s, const Residuals& r,
                       StepLimits limits, EquilibriumCost& cost, KrylovMemory* memory) {
  const BorderedFilm film(model, scene, s, load.unknowns, workspace().factor, cost);
  if (!film.good()) return {};
  StepProblem problem{model, scene, load, s, r, film, cost, memory, r.film, load.wanted(s)};
  for (double& v : problem.a) v = -v;
  if (s.elastic.empty()) {
    problem.solve_rigid(limits);
  } else {
    problem.solve_elastic();
  }
  if (!problem.moved) return {};
  return {true, std::move(problem.x.u), problem.moved->dq, problem.moved->ln_load,
          std::move(problem.x.d)};
}

}  // namespace shellback::bearing
