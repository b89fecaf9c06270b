#include "bearing/film/newton.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "bearing/film/bordered_film.hpp"
#include "bearing/film/film_verdicts.hpp"
#include "bearing/solids.hpp"
#include "core/round_off.hpp"
#include "fluid/empty_rings.hpp"
#include "fluid/fischer_burmeister.hpp"
#include "fluid/reduced_pressure.hpp"

namespace shellback::bearing {
namespace {

constexpr double kShortestReach = 1e-5;  ///< a step shortened this far: there is no way on
constexpr double kWorseMerit = 3.0;      ///< a step may worsen the residuals so far [-]
constexpr double kFollowed = 0.03;       ///< film and surfaces have followed the journal [-]
constexpr int kMostHeld = 8;             ///< steps in which the film must have followed the journal
constexpr double kLittleGain = 0.2;  ///< part of the gain asked for: a step that gained little [-]
constexpr double kThinner = 0.25;    ///< and thin its smallest gap so far [-]

/// The iterate that a step begins from, and that a rejected one goes back to.
struct Accepted {
  State u;
  double merit = INFINITY;  ///< of its residuals; INFINITY: the next one is taken as it comes
  double room = -INFINITY;  ///< [m]
  double off = INFINITY;    ///< of its force from the wanted one, in logarithms [-]
  double carried = 0.0;     ///< its force [N]
};

/// Iterations for the oil alone, once all tolerances are met: little oil may pass where much goes
/// round, and what is lost is measured by what passes. The state that loses least is kept: steps
/// for the oil never spoil what is converged.
class Polish {
 public:
  void count() { iterations_ += met() ? 1 : 0; }
  /// `u` is within all tolerances and loses so much oil [kg/s].
  void meet(const State& u, double lost) {
    iterations_ = std::max(iterations_, 1);
    if (!(lost < least_lost_)) return;
    least_lost_ = lost;
    best_ = u;
    here_ = true;
  }
  void leave() { here_ = false; }
  [[nodiscard]] bool met() const { return iterations_ > 0; }
  [[nodiscard]] bool ended() const { return iterations_ > kMostPolish; }
  [[nodiscard]] bool here() const { return here_; }  ///< the evaluated state is the best one
  [[nodiscard]] const State& best() const { return best_; }

 private:
  static constexpr int kMostPolish = 20;  // quadratic: two or three do, or none
  State best_;
  double least_lost_ = INFINITY;  ///< [kg/s]
  bool here_ = false;
  int iterations_ = 0;  ///< since the tolerances were met first
};

/// One Newton iteration after the other; what they share.
class NewtonIteration {
 public:
  NewtonIteration(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost)
      : task_(task),
        model_(task.model),
        point_(task.point),
        options_(task.options),
        s_(s),
        cost_(cost) {}

  Verdict run();

 private:
  void restore(const State& u) { static_cast<State&>(s_) = u; }
  [[nodiscard]] Verdict iterate();
  /// Evaluates the state; true if it has residuals.
  [[nodiscard]] bool evaluate_state();
  [[nodiscard]] bool converged();
  /// Beyond it, or the round-off of what goes round, a converged film is polished [kg/s].
  [[nodiscard]] double oil_that_may_be_lost(const fluid::OilFlows& flows) const;
  [[nodiscard]] bool overdrawn() const;
  /// Good unless the reduced pressure of the converged film exceeds its bound.
  [[nodiscard]] Verdict within_the_law() const;
  /// Nothing moves but the film of a given gap: no step of it is shortened, and while its cells
  /// fill line by line its residual may stand high.
  [[nodiscard]] bool film_alone() const { return rigid() && point_.load.unknowns == 0; }
  /// True if the state may be gone on from.
  [[nodiscard]] bool acceptable() const;
  void accept();
  /// Back to the last accepted state with a quarter of the reach; false if that is too short.
  [[nodiscard]] bool reject();
  /// Takes one step; `ended` is set where there is none.
  void step(Verdict& ended);
  fluid::UpdateReport take(const NewtonStep& step);
  /// The pressures of a given position left the range of the pressure law: the film from its
  /// reduced pressure, or the proof that there is none.
  [[nodiscard]] Verdict reduced_film();
  [[nodiscard]] double merit() const {
    return r_.film_norm + r_.load_norm + std::min(r_.elastic_norm, 1e3);
  }
  [[nodiscard]] bool rigid() const { return s_.elastic.empty(); }

  const FilmTask& task_;
  const BearingModel& model_;
  const OperatingPoint& point_;
  const EquilibriumOptions& options_;
  FilmEquilibrium& s_;
  EquilibriumCost& cost_;
  Residuals r_;
  Accepted accepted_;
  double damping_ = 1.0;  ///< part of the wanted change of force that is asked for [-]
  double reach_ = 1.0;    ///< part of the longest step
  double viscosity_tolerance_ = kWayPoint;
  Polish polish_;
  int refilled_ = 0;     ///< steps that had emptied whole rings
  int held_ = 0;         ///< steps for which the journal has been held
  int worst_cell_ = -1;  ///< whose pressure left the range of the pressure law
};

bool NewtonIteration::evaluate_state() {
  if (!evaluate(model_, point_, task_.thermal_deformation, viscosity_tolerance_, s_)) return false;
  r_ = residuals_of(model_, point_, s_);
  return r_.finite();
}

bool NewtonIteration::converged() {
  polish_.count();
  const bool met = r_.within(options_) && s_.columns.mismatch <= options_.viscosity_tolerance &&
                   fluid::complementary(point_.scene, s_.film);
  if (!met) return false;
  if (point_.scene.storage.finite()) {  // in time the oil is carried as what flowed
    polish_.meet(s_, 0.0);
    return true;
  }
  const auto flows = fluid::oil_flows(point_.scene, s_.flow);
  const double lost = std::abs(flows.supply - flows.side - flows.stored);
  polish_.meet(s_, lost);
  return !(lost > oil_that_may_be_lost(flows)) || polish_.ended();
}

double NewtonIteration::oil_that_may_be_lost(const fluid::OilFlows& flows) const {
  constexpr double kLost = 1e-9;  // of what passes, at the usual film tolerance [-]
  const double passes = std::max(std::abs(flows.supply), std::abs(flows.side));
  const double coarser =
      std::max(1.0, options_.film_tolerance / EquilibriumOptions{}.film_tolerance);
  const double round = std::numeric_limits<double>::epsilon() * fluid::flow_scale(s_.flow);
  return std::max(kLost * coarser * passes, round);
}

/// A step in time may leave a cell with less than no oil: solved, but no film.
bool NewtonIteration::overdrawn() const {
  if (!point_.scene.storage.finite() || !r_.within(options_)) return false;
  return *std::min_element(s_.film.theta.begin(), s_.film.theta.end()) < -kRoundOff;
}

bool NewtonIteration::acceptable() const {
  if (film_alone()) return true;
  const bool follows = std::max(r_.film_norm, r_.elastic_norm) < kFollowed;
  return (follows || merit() < kWorseMerit * accepted_.merit) &&
         room(model_, s_) > kThinner * accepted_.room;
}

/// How far a force is from the wanted one, in logarithms, forces as complex numbers.
double distance(const fluid::Wrench& force, const fluid::Wrench& wanted) {
  const std::complex<double> now(force[0], force[1]);
  const std::complex<double> aim(wanted[0], wanted[1]);
  return std::abs(now) > 0.0 && std::abs(aim) > 0.0 ? std::abs(std::log(aim / now)) : INFINITY;
}

void NewtonIteration::accept() {
  // Where cavitation moves with the journal the predicted force misleads: ask for less.
  const double off = distance(s_.force, point_.load.wanted(s_));
  const bool little = off > kFollowed && off > (1.0 - kLittleGain * damping_) * accepted_.off;
  damping_ = little ? std::max(0.1, 0.5 * damping_) : std::min(1.0, 2.0 * damping_);
  accepted_ = {s_, merit(), room(model_, s_), off, std::hypot(s_.force[0], s_.force[1])};
  worst_cell_ = -1;
  reach_ = std::min(1.0, 2.0 * reach_);
}

bool NewtonIteration::reject() {
  restore(accepted_.u);
  reach_ *= 0.25;  // it is doubled once the state that is gone back to is accepted again
  ++cost_.rejected_steps;
  const bool evaluated = evaluate_state();  // a search that ends here tells what it last accepted
  return evaluated && reach_ >= kShortestReach;
}

fluid::UpdateReport NewtonIteration::take(const NewtonStep& step) {
  const double fraction = rigid() ? 1.0 : reach_;
  for (int k = 0; k < 4; ++k) s_.position.q[k] += fraction * step.q[k];
  for (int k = 0; k < 2; ++k) s_.flight[k] += fraction * step.q[k];
  s_.ln_load += fraction * step.ln_load;
  const Field before = s_.film.p;
  const std::vector<char> full = s_.film.full;
  const auto report = fluid::advance(point_.scene, s_.oil, step.film, fraction, s_.film);
  if (rigid()) return report;
  // The displacement follows the pressures as they come out of cavitation and of the pressure law,
  // not as the linear step has them.
  Field beyond(before.size());
  for (std::size_t k = 0; k < before.size(); ++k) {
    const bool free = full[k] && model_.supply.cell[k] < 0;
    beyond[k] = s_.film.p[k] - before[k] - (free ? fraction * step.film[k] : 0.0);
  }
  const Field more = model_.solids->compliance(beyond);
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double by_layer = s_.layer.empty() ? 0.0 : s_.layer[k].by_pressure * beyond[k];
    s_.elastic[k] += fraction * step.elastic[k] + more[k] + by_layer;
  }
  return report;
}

Verdict NewtonIteration::reduced_film() {
  const auto oil = [&](const fluid::FilmState& film, fluid::FilmCoefficients& c) {
    const Field none(film.p.size(), 0.0);
    update_columns(model_.oil, model_.gl, point_.scene.speed, s_.shear_gap, model_.supply.cell,
                   film, none, none, kWayPoint, s_.columns, c);
  };
  auto film = fluid::film_by_reduced_pressure(point_.scene, s_.gap, model_.profile, oil, s_.film);
  if (film.good()) {
    s_.film = std::move(film.value);
    accepted_.merit = INFINITY;
  }
  return film.verdict;
}

void NewtonIteration::step(Verdict& ended) {
  constexpr int kMostRefills = 5;  // a ring that stays empty is one
  polish_.leave();
  viscosity_tolerance_ = std::max(0.3 * options_.viscosity_tolerance,
                                  std::min(1e-2 * (r_.film_norm + r_.load_norm), kWayPoint));
  ++cost_.newton_iterations;
  cost_.work += model_.domain.grid.cells();
  LoadTarget now = point_.load;
  if (held_ > 0 && !point_.scene.storage.finite()) {
    now.unknowns = 0;
    now.path.reset();
    now.inertial_stiffness = 0.0;
  }
  const NewtonStep step =
      fluid::steady_ring_is_empty(point_.scene, s_.film)
          ? NewtonStep{}
          : newton_step(model_, point_.scene, now, s_, r_, {reach_, damping_}, cost_, task_.memory);
  if (!step.good) {
    const bool filled =
        refilled_++ < kMostRefills && fluid::refill_empty_rings(point_.scene, s_.film);
    accepted_.merit = INFINITY;
    if (!filled) ended = singular_film(point_, s_);
    return;
  }
  const auto report = take(step);
  // A rigid film of that gap has no pressure; an elastic one gives way, the step was only long.
  if (report.beyond_barus == 0 || !rigid()) return;
  worst_cell_ = report.worst_cell;
  const bool barus = std::holds_alternative<rheology::Barus>(model_.oil.pressure);
  if (point_.load.unknowns == 0) {
    if (barus) ended = reduced_film();  // other laws: the step was held to 0.99 of theirs
  } else if (!reject()) {
    ended = limit_load(model_, point_, accepted_.carried, worst_cell_);
  }
}

Verdict NewtonIteration::within_the_law() const {
  const int cell = beyond_reduced_pressure(model_, point_, s_);
  if (cell < 0) return {};
  if (point_.load.unknowns > 0) return limit_load(model_, point_, accepted_.carried, cell);
  return {Status::no_steady_state, ending::Plain::no_pressure,
          fluid::place_of(model_.domain.grid, cell)};
}

Verdict NewtonIteration::iterate() {
  const int most = options_.max_iterations + (film_alone() ? model_.domain.grid.nt : 0);
  for (int it = 0; it <= most; ++it) {
    if (task_.stop && task_.stop->load()) return {Status::interrupted};
    if (cost_.spent()) return {Status::iteration_limit, ending::Plain::given_up};
    const bool possible = evaluate_state();
    if (possible && it >= options_.least_iterations && converged()) return {};
    if (possible && overdrawn()) {
      return {Status::iteration_limit, ending::Plain::overdrawn};
    }
    if (possible && acceptable()) {
      accept();
      held_ = 0;
    } else if (possible && held_ < kMostHeld && room(model_, s_) > kThinner * accepted_.room) {
      ++held_;  // cavitation has moved: the film follows first
    } else {
      held_ = 0;
      const Verdict none = possible ? Verdict{} : no_film(task_, s_);
      if (it == 0) return none;
      if (!reject()) {
        return none.status == Status::invalid_number ? none
               : rigid() && worst_cell_ >= 0
                   ? limit_load(model_, point_, accepted_.carried, worst_cell_)
                   : stuck(model_, s_, r_, it);
      }
    }
    if (it == most) break;
    Verdict ended;
    step(ended);
    if (!ended.good()) return ended;
  }
  return stuck(model_, s_, r_, most);
}

Verdict NewtonIteration::run() {
  const Verdict v = iterate();
  if (v.status == Status::interrupted || !polish_.met()) return v;
  if (!polish_.here()) {
    restore(polish_.best());
    if (!evaluate_state()) return v;
  }
  return within_the_law();
}

}  // namespace

Verdict newton(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost) {
  return NewtonIteration(task, s, cost).run();
}

}  // namespace shellback::bearing
