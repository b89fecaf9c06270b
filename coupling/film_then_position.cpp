#include "coupling/film_then_position.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "coupling/equilibrium_step.hpp"
#include "fluid/fischer_burmeister.hpp"
#include "fluid/p_theta.hpp"
#include "fluid/swift_stieber.hpp"

namespace shellback::coupling {
namespace {

using Stiffness = std::array<std::array<double, 4>, 4>;  ///< dF/dq

constexpr double kShortestReach = 1e-4;  ///< a step shortened this far shows no way on
constexpr double kFirstTry = 1e-3;       ///< of the gap: the move that tells dF/dq [-]
constexpr double kLoadShare = 1e-2;      ///< film residual allowed per load residual [-]

/// The oil of the film as it is being solved.
fluid::OilLaw oil_law(const BearingModel& model, FilmEquilibrium& s, double tolerance) {
  return [&model, &s, tolerance](const fluid::FilmState& film, fluid::FilmCoefficients& c) {
    const Field gx = fluid::pressure_gradient_x(model.scene, film);
    const Field gz = fluid::pressure_gradient_z(model.scene, film);
    update_columns(model.oil, model.gl, model.scene.speed, s.shear_gap, film, gx, gz, tolerance,
                   s.columns, c);
  };
}

/// A film solved at rest and, if the method has one, its factorised matrix.
struct RestingFilm {
  Verdict verdict;
  std::optional<RingFactor> factor;
};

class FilmAndPosition {
 public:
  FilmAndPosition(const BearingModel& model, const LoadTarget& target, const Field& growth,
                  const EquilibriumOptions& options, FilmEquilibrium& s, EquilibriumCost& cost)
      : model_(model), target_(target), growth_(growth), options_(options), s_(s), cost_(cost) {}

  /// Solves the film of the state at its position and evaluates all that follows.
  [[nodiscard]] RestingFilm settle(double tolerance);
  /// dF/dq by the factorised film; `response` receives dp/dq or dtheta/dq per component.
  [[nodiscard]] Stiffness stiffness_of(const RingFactor& factor,
                                       std::vector<Field>& response) const;
  /// dF/dq by moving the journal; false if a film fails.
  [[nodiscard]] bool probe(double tolerance, Stiffness& stiffness);
  [[nodiscard]] double off() const;
  [[nodiscard]] Verdict closed_gap() const;

 private:
  [[nodiscard]] RestingFilm relaxed(const fluid::OilLaw& oil, double tolerance);
  [[nodiscard]] RestingFilm factorised(const fluid::OilLaw& oil, double tolerance);

  const BearingModel& model_;
  const LoadTarget& target_;
  const Field& growth_;
  const EquilibriumOptions& options_;
  FilmEquilibrium& s_;
  EquilibriumCost& cost_;
};

Verdict FilmAndPosition::closed_gap() const {
  return {
      Status::no_steady_state,
      fmt::format("smooth surfaces touch at the start: smallest gap {:.3g} um", s_.least.h * 1e6),
      "", "give roughness and contact data, or lower the eccentricity or the tilt"};
}

RestingFilm FilmAndPosition::relaxed(const fluid::OilLaw& oil, double tolerance) {
  fluid::RelaxationOptions o;
  o.tolerance = tolerance;
  auto film = fluid::relax_p_theta(model_.scene, s_.gap, model_.step, oil, s_.film, o);
  cost_.sweeps += film.value.sweeps;
  if (film.good()) s_.film = std::move(film.value.state);
  return {film.verdict, {}};
}

RestingFilm FilmAndPosition::factorised(const fluid::OilLaw& oil, double tolerance) {
  const bool smooth = model_.input.model.methods.cavitation == CavitationMethod::fischer_burmeister;
  const auto solve = smooth ? fluid::solve_fischer_burmeister : fluid::solve_swift_stieber;
  const fluid::ReynoldsOptions o{tolerance, options_.max_iterations};
  auto film = solve(model_.scene, s_.gap, model_.step, oil, s_.film, o);
  cost_.factorizations += film.value.factorizations;
  cost_.newton_iterations += film.value.factorizations;
  if (!film.good()) return {film.verdict, {}};
  s_.film = std::move(film.value.state);
  if (film.value.factorizations > 0) return {{}, std::move(film.value.factor)};
  RingMatrix matrix;  // the film was settled already
  fluid::assemble_film(model_.scene, film.value.flow, fluid::active_set_unknowns(s_.film), matrix);
  RingFactor factor;
  ++cost_.factorizations;
  if (factor.factorize(matrix)) return {{}, std::move(factor)};
  return {{Status::iteration_limit, "the film matrix is singular: parts of the film get no oil", "",
           "feed more oil, or turn the supply away from the load"},
          {}};
}

RestingFilm FilmAndPosition::settle(double tolerance) {
  const fluid::FilmScene& scene = model_.scene;
  s_.gap = fluid::film_gap(scene.grid, scene.angles, model_.clearance, s_.position, growth_,
                           model_.step);
  s_.least = fluid::smallest_gap(scene.grid, s_.gap, model_.step);
  if (scene.rough.sigma <= 0.0 && !(s_.least.h > 0.0)) return {closed_gap(), {}};
  s_.shear_gap = shear_gap(model_, s_.gap.cell);
  const fluid::OilLaw oil = oil_law(model_, s_, 0.3 * options_.viscosity_tolerance);
  const bool relaxing = model_.input.model.methods.cavitation == CavitationMethod::p_theta;
  RestingFilm film = relaxing ? relaxed(oil, tolerance) : factorised(oil, tolerance);
  if (film.verdict.good() && !evaluate(model_, growth_, 0.3 * options_.viscosity_tolerance, s_)) {
    film.verdict = closed_gap();
  }
  return film;
}

Stiffness FilmAndPosition::stiffness_of(const RingFactor& factor,
                                        std::vector<Field>& response) const {
  const fluid::FilmScene& scene = model_.scene;
  const FilmGrid& g = scene.grid;
  const bool reynolds = model_.input.model.methods.cavitation == CavitationMethod::swift_stieber;
  Stiffness stiffness{};
  response.clear();
  for (int l = 0; l < target_.unknowns; ++l) {
    Field t = fluid::outflow_by_position(scene, s_.flow, l);
    for (std::size_t k = 0; k < t.size(); ++k) t[k] = reynolds && !s_.film.full[k] ? 0.0 : -t[k];
    factor.solve(t.data());
    for (int i = 0; i < g.nt; ++i) {
      for (int j = 0; j < g.nz; ++j) {
        const int c = g.index(i, j);
        const double slope =
            fluid::gap_slope(l, scene.angles.cos_cell[i], scene.angles.sin_cell[i], g.z[j]);
        if (reynolds && !s_.film.full[c]) t[c] = 0.0;
        const double dp = s_.dp_contact[c] * slope + (s_.film.full[c] ? t[c] : 0.0);
        for (int k = 0; k < target_.unknowns; ++k) {
          stiffness[k][l] += fluid::wrench_weight(scene, k, i, j) * dp;
        }
      }
    }
    response.push_back(std::move(t));
  }
  return stiffness;
}

bool FilmAndPosition::probe(double tolerance, Stiffness& stiffness) {
  const fluid::FilmState film = s_.film;
  const fluid::JournalPosition position = s_.position;
  const fluid::Wrench force = s_.force;
  const double gap = std::max(s_.least.h, 0.0) + model_.scene.rough.sigma;
  bool good = true;
  for (int l = 0; good && l < target_.unknowns; ++l) {
    const double reach = l < 2 ? 1.0 : 2.0 / model_.scene.grid.width;
    const double move = -kFirstTry * gap * reach * (position.q[l] >= 0.0 ? 1.0 : -1.0);
    s_.position.q[l] += move;
    good = settle(std::min(tolerance, 1e-2 * kFirstTry)).verdict.good();
    for (int k = 0; k < 4; ++k) stiffness[k][l] = (s_.force[k] - force[k]) / move;
    s_.position = position;
    s_.film = film;
  }
  return good && settle(tolerance).verdict.good();
}

double FilmAndPosition::off() const {
  if (target_.unknowns == 0) return 0.0;
  const double arm = 0.5 * model_.scene.grid.width;
  double most = 0.0;
  for (int k = 0; k < target_.unknowns; ++k) {
    const double unit = k < 2 ? target_.scale() : target_.scale() * arm;
    most = std::max(most, std::abs(s_.force[k] - target_.force[k]) / unit);
  }
  return most;
}

/// Broyden's update: the stiffness that would have foretold the change of force seen.
void broyden(int m, const std::array<double, 4>& dq, const fluid::Wrench& change,
             Stiffness& stiffness) {
  double square = 0.0;
  for (int l = 0; l < m; ++l) square += dq[l] * dq[l];
  for (int k = 0; k < m; ++k) {
    double miss = change[k];
    for (int l = 0; l < m; ++l) miss -= stiffness[k][l] * dq[l];
    for (int l = 0; l < m; ++l) stiffness[k][l] += miss * dq[l] / square;
  }
}

}  // namespace

Verdict film_then_position(const BearingModel& model, const LoadTarget& target, const Field& growth,
                           const EquilibriumOptions& options, FilmEquilibrium& s,
                           EquilibriumCost& cost, const std::atomic<bool>* stop) {
  constexpr double kFarthest = 1e-3;  // film residual that the first positions need [-]
  constexpr double kSlow = 0.5;       // Broyden's updates have to gain this, or dF/dq is old [-]
  FilmAndPosition pair(model, target, growth, options, s, cost);
  Stiffness stiffness{};
  std::vector<Field> response;
  fluid::FilmState film = s.film;  // of the last position that was good
  fluid::JournalPosition position = s.position;
  fluid::Wrench force{};
  double best = INFINITY;
  double reach = 1.0;
  bool known = false;
  Verdict last;
  for (int it = 0; it <= options.max_iterations; ++it) {
    if (stop && stop->load()) return {Status::interrupted, "stopped by the user", "", ""};
    double tolerance =
        target.unknowns == 0 || !std::isfinite(best)
            ? options.film_tolerance
            : std::max(options.film_tolerance, std::min(kFarthest, kLoadShare * best));
    if (target.unknowns > 0 && it == 0) tolerance = std::max(options.film_tolerance, kFarthest);
    RestingFilm now = pair.settle(tolerance);
    double off = pair.off();
    if (now.verdict.good() && off <= options.load_tolerance) {
      if (tolerance <= options.film_tolerance) return {};
      now = pair.settle(options.film_tolerance);
      off = pair.off();
      if (now.verdict.good() && off <= options.load_tolerance) return {};
    }
    if (!now.verdict.good() || !(off < best || off <= options.load_tolerance)) {
      if (!now.verdict.good()) last = now.verdict;
      if (it == 0) return last;
      reach *= 0.5;
      ++cost.rejected_steps;
      s.film = film;
      s.position = position;
      known = false;
      if (reach < kShortestReach) break;
      now = pair.settle(std::max(options.film_tolerance, std::min(kFarthest, kLoadShare * best)));
      if (!now.verdict.good()) return now.verdict;
    } else {
      if (known && now.factor == std::nullopt) {
        std::array<double, 4> dq{};
        fluid::Wrench change{};
        for (int k = 0; k < 4; ++k) dq[k] = s.position.q[k] - position.q[k];
        for (int k = 0; k < 4; ++k) change[k] = s.force[k] - force[k];
        broyden(target.unknowns, dq, change, stiffness);
        known = off < kSlow * best;
      }
      best = off;
      film = s.film;
      position = s.position;
      force = s.force;
      reach = std::min(1.0, 2.0 * reach);
    }
    if (now.factor) {
      stiffness = pair.stiffness_of(*now.factor, response);
    } else if (!known) {
      if (!pair.probe(kLoadShare * std::min(best, kFarthest), stiffness)) break;
      force = s.force;
    }
    known = true;
    std::array<double, 4> dq = wanted_change(s.force, target);
    if (!solve_small(target.unknowns, stiffness, dq)) break;
    for (int k = target.unknowns; k < 4; ++k) dq[k] = 0.0;
    const double gap = std::max(s.least.h, 0.0) + 3.0 * model.scene.rough.sigma;
    dq = limited(s.position, dq, gap, model.clearance, 0.5 * model.scene.grid.width, reach);
    if (reach < 1.0) {
      for (double& x : dq) x *= reach;
    }
    for (int k = 0; k < 4; ++k) s.position.q[k] += dq[k];
    if (!now.factor) continue;
    Field t(s.film.p.size(), 0.0);
    for (int l = 0; l < target.unknowns; ++l) {
      for (std::size_t k = 0; k < t.size(); ++k) t[k] += dq[l] * response[l][k];
    }
    fluid::advance(model.scene, s.oil, t, 1.0, s.film);
  }
  if (!last.good() && reach < kShortestReach) return last;
  return {Status::iteration_limit,
          fmt::format("the journal found no position for its load (load residual {:.1e}, smallest "
                      "gap {:.3g} um)",
                      best, s.least.h * 1e6),
          "", "use the active-set method, a finer grid or a lower load"};
}

}  // namespace shellback::coupling
