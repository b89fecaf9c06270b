#include "validation/rivals/film_then_position.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "bearing/film/bordered_film.hpp"
#include "bearing/film/closed_gap.hpp"
#include "bearing/film/film_verdicts.hpp"
#include "core/largest.hpp"
#include "validation/rivals/fischer_burmeister_film.hpp"
#include "validation/rivals/p_theta.hpp"
#include "validation/rivals/swift_stieber.hpp"

namespace shellback::validation {

using namespace bearing;

namespace {

using Stiffness = std::array<std::array<double, 4>, 4>;  ///< dF/dq

constexpr double kShortestReach = 1e-4;  ///< a step shortened this far shows no way on
constexpr double kFirstTry = 1e-3;       ///< of the gap: the move that tells dF/dq [-]
constexpr double kLoadShare = 1e-3;      ///< film residual allowed per load residual [-]
constexpr double kFarthest = 1e-4;       ///< film residual that the first positions need [-]
constexpr double kRelaxedShare = 1e-3;   ///< part of both for the relaxation, whose error is many
                                         ///< times its residual [-]
constexpr double kSharper = 0.1;  ///< film residual over the last one that makes a force surer [-]
constexpr double kSlow = 0.5;     ///< gain that Broyden's updates must bring, or dF/dq is old [-]

/// The oil of the film as it is being solved.
fluid::OilLaw oil_law(const BearingModel& model, const fluid::FilmScene& scene, FilmEquilibrium& s,
                      double tolerance) {
  return [&model, &scene, &s, tolerance](const fluid::FilmState& film, fluid::FilmCoefficients& c) {
    const Field gx = fluid::pressure_gradient_x(scene, film);
    const Field gz = fluid::pressure_gradient_z(scene, film);
    update_columns(model.oil, model.gl, scene.speed, s.shear_gap, scene.supply.cell, film, gx, gz,
                   tolerance, s.columns, c);
  };
}

/// A film solved at rest and, if the method has one, its factorised matrix.
struct RestingFilm {
  Verdict verdict;
  std::optional<RingFactor> factor;
};

class FilmAndPosition {
 public:
  FilmAndPosition(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost)
      : task_(task),
        model_(task.model),
        point_(task.point),
        options_(task.options),
        s_(s),
        cost_(cost) {}

  /// Solves the film of the state at its position and evaluates all that follows.
  [[nodiscard]] RestingFilm settle(double tolerance);
  /// dF/dq by the factorised film; `response` receives dp/dq or dtheta/dq per component.
  [[nodiscard]] Stiffness stiffness_of(const RingFactor& factor,
                                       std::vector<Field>& response) const;
  /// dF/dq by moving the journal; false if a film fails.
  [[nodiscard]] bool probe(double tolerance, Stiffness& stiffness);
  [[nodiscard]] double off() const;

 private:
  [[nodiscard]] RestingFilm relaxed(const fluid::OilLaw& oil, double tolerance);
  [[nodiscard]] RestingFilm factorised(const fluid::OilLaw& oil, double tolerance);

  const FilmTask& task_;
  const BearingModel& model_;
  const OperatingPoint& point_;
  const EquilibriumOptions& options_;
  FilmEquilibrium& s_;
  EquilibriumCost& cost_;
};

RestingFilm FilmAndPosition::relaxed(const fluid::OilLaw& oil, double tolerance) {
  RelaxationOptions o;
  o.tolerance = tolerance;
  auto film = relax_p_theta(point_.scene, s_.gap, model_.profile, oil, s_.film, o);
  cost_.sweeps += film.value.sweeps;
  if (film.good()) s_.film = std::move(film.value.state);
  return {film.verdict, {}};
}

RestingFilm FilmAndPosition::factorised(const fluid::OilLaw& oil, double tolerance) {
  const CavitationMethod method = model_.input.model.methods.cavitation;
  const auto solve = method == CavitationMethod::fischer_burmeister ? solve_fischer_burmeister
                                                                    : solve_swift_stieber;
  const fluid::ReynoldsOptions o{tolerance, options_.max_iterations};
  auto film = solve(point_.scene, s_.gap, model_.profile, oil, s_.film, o);
  cost_.factorizations += film.value.factorizations;
  cost_.work += static_cast<double>(film.value.factorizations) * model_.domain.grid.cells();
  cost_.newton_iterations += film.value.factorizations;
  if (!film.good()) return {film.verdict, {}};
  s_.film = std::move(film.value.state);
  if (film.value.factorizations > 0) return {{}, std::move(film.value.factor)};
  RingMatrix matrix;  // the film was settled already
  fluid::assemble_film(point_.scene, film.value.flow, fluid::active_set_unknowns(s_.film), matrix);
  RingFactor factor;
  ++cost_.factorizations;
  if (factor.factorize(matrix)) return {{}, std::move(factor)};
  return {singular_film(point_, s_), {}};
}

RestingFilm FilmAndPosition::settle(double tolerance) {
  const fluid::FilmScene& scene = point_.scene;
  if (cost_.spent()) return {{Status::iteration_limit, ending::Plain::given_up}, {}};
  s_.gap = gap_at(model_, s_.position, task_.thermal_deformation);
  s_.least = fluid::smallest_gap(scene.grid, s_.gap, model_.profile, scene.supply);
  if (is_closed(model_, s_)) return {no_film(task_, s_), {}};
  s_.shear_gap = shear_gap(model_, s_.gap.cell);
  const fluid::OilLaw oil = oil_law(model_, scene, s_, 0.3 * options_.viscosity_tolerance);
  const bool relaxing = model_.input.model.methods.cavitation == CavitationMethod::p_theta;
  RestingFilm film = relaxing ? relaxed(oil, tolerance) : factorised(oil, tolerance);
  if (film.verdict.good() && !evaluate(model_, point_, task_.thermal_deformation,
                                       0.3 * options_.viscosity_tolerance, s_)) {
    film.verdict = no_film(task_, s_);
  }
  return film;
}

Stiffness FilmAndPosition::stiffness_of(const RingFactor& factor,
                                        std::vector<Field>& response) const {
  const fluid::FilmScene& scene = point_.scene;
  const FilmGrid& g = scene.grid;
  const bool reynolds = model_.input.model.methods.cavitation == CavitationMethod::swift_stieber;
  Stiffness stiffness{};
  response.clear();
  for (int l = 0; l < point_.load.unknowns; ++l) {
    Field t = fluid::residual_by_position(scene, s_.flow, l);
    for (std::size_t k = 0; k < t.size(); ++k) t[k] = reynolds && !s_.film.full[k] ? 0.0 : -t[k];
    factor.solve(t.data());
    for (int i = 0; i < g.nt; ++i) {
      for (int j = 0; j < g.nz; ++j) {
        const int c = g.index(i, j);
        const double slope =
            fluid::gap_slope(l, scene.angles.cos_cell[i], scene.angles.sin_cell[i], g.z[j]);
        if (reynolds && !s_.film.full[c]) t[c] = 0.0;
        const double dp = s_.dp_contact[c] * slope + (s_.film.full[c] ? t[c] : 0.0);
        for (int k = 0; k < point_.load.unknowns; ++k) {
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
  const double gap = std::max(s_.least.h, 0.0) + model_.domain.rough.sigma;
  bool good = true;
  for (int l = 0; good && l < point_.load.unknowns; ++l) {
    const double reach = l < 2 ? 1.0 : 2.0 / model_.domain.grid.width;
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
  if (point_.load.unknowns == 0) return 0.0;
  const double arm = 0.5 * model_.domain.grid.width;
  double most = 0.0;
  for (int k = 0; k < point_.load.unknowns; ++k) {
    const double unit = k < 2 ? point_.load.scale() : point_.load.scale() * arm;
    most = larger(most, std::abs(s_.force[k] - point_.load.force[k]) / unit);
  }
  return most;
}

/// dF/dq dq = b; false if singular.
bool solve_small(int m, const Stiffness& stiffness, std::array<double, 4>& b) {
  Eigen::MatrixXd A(m, m);
  Eigen::VectorXd x(m);
  for (int k = 0; k < m; ++k) {
    for (int l = 0; l < m; ++l) A(k, l) = stiffness[k][l];
    x(k) = b[k];
  }
  x = A.partialPivLu().solve(x);
  std::copy(x.begin(), x.end(), b.begin());
  return x.allFinite();
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

/// Film residual of a result. A loose one asked for is tightened for the relaxation.
double sharpest(const BearingModel& model, const EquilibriumOptions& options) {
  constexpr double kRoundOff = 1e-11;  // below which relaxation need not go
  if (model.input.model.methods.cavitation != CavitationMethod::p_theta) {
    return options.film_tolerance;
  }
  return std::max(std::min(options.film_tolerance, kRoundOff),
                  kRelaxedShare * options.film_tolerance);
}

/// The search itself; see the head of the header.
class PositionSearch {
 public:
  PositionSearch(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost)
      : stop_(task.stop),
        model_(task.model),
        point_(task.point),
        options_(task.options),
        s_(s),
        cost_(cost),
        pair_(task, s, cost),
        sharp_(sharpest(task.model, task.options)) {}

  Verdict run();

 private:
  [[nodiscard]] double film_tolerance() const;
  /// True if film and load are met, sharpening the film if it was solved loosely.
  [[nodiscard]] bool met(RestingFilm& now, double tolerance);
  /// Keeps the state as the best one; learns from the step that led there.
  void accept(bool has_matrix);
  /// Goes back to the best state, its film solved again.
  [[nodiscard]] RestingFilm retreat();
  /// dF/dq at the present state; false if there is none.
  [[nodiscard]] bool learn(const RestingFilm& now);
  /// Moves the journal, and the film by its response; false if dF/dq is singular.
  [[nodiscard]] bool move(bool has_matrix);
  [[nodiscard]] Verdict lost() const;

  const std::atomic<bool>* stop_;
  const BearingModel& model_;
  const OperatingPoint& point_;
  const EquilibriumOptions& options_;
  FilmEquilibrium& s_;
  EquilibriumCost& cost_;
  FilmAndPosition pair_;
  double sharp_;  ///< film residual that the result must have [-]
  Stiffness stiffness_{};
  std::vector<Field> response_;
  fluid::FilmState film_;  ///< of the best position so far
  fluid::JournalPosition position_;
  fluid::Wrench force_{};
  double best_ = INFINITY;            ///< load residual there [-]
  double best_tolerance_ = INFINITY;  ///< film residual with which it was found [-]
  double reach_ = 1.0;
  bool known_ = false;  ///< dF/dq
  Verdict failure_;     ///< of the last film that was not found
};

double PositionSearch::film_tolerance() const {
  if (point_.load.unknowns == 0) return sharp_;
  const bool relaxing = model_.input.model.methods.cavitation == CavitationMethod::p_theta;
  const double part = relaxing ? kRelaxedShare : 1.0;
  return std::max(sharp_, part * std::min(kFarthest, kLoadShare * best_));
}

bool PositionSearch::met(RestingFilm& now, double tolerance) {
  const auto within = [&] { return now.verdict.good() && pair_.off() <= options_.load_tolerance; };
  if (!within() || tolerance <= sharp_) return within();
  now = pair_.settle(sharp_);
  return within();
}

void PositionSearch::accept(bool has_matrix) {
  const double off = pair_.off();
  if (known_ && !has_matrix) {
    std::array<double, 4> dq{};
    fluid::Wrench change{};
    for (int k = 0; k < 4; ++k) dq[k] = s_.position.q[k] - position_.q[k];
    for (int k = 0; k < 4; ++k) change[k] = s_.force[k] - force_[k];
    broyden(point_.load.unknowns, dq, change, stiffness_);
    known_ = off < kSlow * best_;
  }
  best_ = off;
  film_ = s_.film;
  position_ = s_.position;
  force_ = s_.force;
  reach_ = std::min(1.0, 2.0 * reach_);
}

RestingFilm PositionSearch::retreat() {
  reach_ *= 0.5;
  ++cost_.rejected_steps;
  s_.film = film_;
  s_.position = position_;
  known_ = false;
  return pair_.settle(film_tolerance());
}

bool PositionSearch::learn(const RestingFilm& now) {
  if (now.factor) {
    stiffness_ = pair_.stiffness_of(*now.factor, response_);
  } else if (!known_) {
    if (!pair_.probe(film_tolerance(), stiffness_)) return false;
    force_ = s_.force;
  }
  known_ = true;
  return true;
}

bool PositionSearch::move(bool has_matrix) {
  std::array<double, 4> dq = wanted_change(s_.force, point_.load.force);
  if (!solve_small(point_.load.unknowns, stiffness_, dq)) return false;
  for (int k = point_.load.unknowns; k < 4; ++k) dq[k] = 0.0;
  const double gap = std::max(s_.least.h, 0.0) + 3.0 * model_.domain.rough.sigma;
  dq = limited(s_.position, dq, gap, model_.clearance, 0.5 * model_.domain.grid.width, reach_);
  for (int k = 0; k < 4; ++k) s_.position.q[k] += reach_ * dq[k];
  if (!has_matrix) return true;
  Field t(s_.film.p.size(), 0.0);
  for (int l = 0; l < point_.load.unknowns; ++l) {
    for (std::size_t k = 0; k < t.size(); ++k) t[k] += reach_ * dq[l] * response_[l][k];
  }
  fluid::advance(point_.scene, s_.oil, t, 1.0, s_.film);
  return true;
}

Verdict PositionSearch::lost() const {
  if (!failure_.good() && reach_ < kShortestReach) return failure_;
  return {Status::iteration_limit, ending::PositionUnsettled{best_, s_.least.h}};
}

Verdict PositionSearch::run() {
  for (int it = 0; it <= options_.max_iterations; ++it) {
    if (stop_ && stop_->load()) return {Status::interrupted};
    const double tolerance = film_tolerance();
    RestingFilm now = pair_.settle(tolerance);
    if (met(now, tolerance)) return {};
    if (!now.verdict.good()) failure_ = now.verdict;
    if (it == 0 && !now.verdict.good()) return failure_;
    // A force of a loosely solved film may be good by chance: a sharper one counts as better.
    const bool better = pair_.off() < best_ || tolerance < kSharper * best_tolerance_;
    if (now.verdict.good() && better) {
      best_tolerance_ = tolerance;
      accept(now.factor.has_value());
    } else {
      now = retreat();
      if (!now.verdict.good()) return now.verdict;
      if (reach_ < kShortestReach) break;
    }
    if (!learn(now) || !move(now.factor.has_value())) break;
  }
  return lost();
}

}  // namespace

Verdict film_then_position(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost) {
  return PositionSearch(task, s, cost).run();
}

}  // namespace shellback::validation
