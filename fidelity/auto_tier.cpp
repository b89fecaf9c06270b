#include "fidelity/auto_tier.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>

#include "core/contract.hpp"
#include "coupling/nested.hpp"
#include "coupling/solids.hpp"
#include "fidelity/auto_effects.hpp"
#include "fidelity/auto_nodes.hpp"
#include "fidelity/coarse_solution.hpp"
#include "fidelity/estimate.hpp"
#include "fidelity/frozen_film.hpp"
#include "fidelity/rectangular_holes.hpp"
#include "fidelity/rungs.hpp"
#include "fidelity/solve.hpp"
#include "fidelity/turn_limit.hpp"
#include "fidelity/unknown_heat.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::fidelity {
namespace {

using namespace coupling;

/// Grids of the climb: fine along the axis first, see grid_limit.hpp.
const std::vector<Grid> kLadder{{24, 9}, {40, 25}, {60, 37}, {96, 49}, {192, 97}};
/// Grids on which nothing was found, one after the other, before the usual grid alone is asked: what
/// two do not find, the three between seldom do, and each may cost twenty solves.
constexpr std::size_t kInVain = 2;
/// Where the tolerance asks for it, the climb goes on to the grid that values are meant for.
const std::vector<Grid> kFineRungs{{400, 100}, kFineGrid};
/// Solved as it is (else the fine grid), with the usual bars, where no two grids of the climb
/// settle.
constexpr Grid kUsualGrid{400, 50};

/// Turns of film and heat after which a coarse grid is given up: those that are a step towards the
/// next settle in 10 to 20, others creep on and cost more than a finer grid.
constexpr int kMostTurns = 40;
/// Below this tolerance bars are held to the tolerance over a margin: they are tuned to hold in
/// nine of ten cases each for friction and film, and both have to be within.
constexpr double kTightTolerance = 0.015;
constexpr double kTightMargin = 1.3;
/// Tolerances below this are of the size of what the grids leave to chance: the margin is wider,
/// and the climb goes on to the fine grid.
constexpr double kFineTolerance = 0.005;
constexpr double kFineMargin = 1.5;
/// Bar over tolerance, after three grids, from which the next would not bring it down enough: one
/// grid takes a half to nine tenths off the bar and costs three times the one before [-].
constexpr double kHopeless = 12.0;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string percent(double x) { return fmt::format("{:.2g} %", 100.0 * x); }

class Climb {
 public:
  Climb(const Case& c, const SolveControl& control, const Indicators& numbers)
      : case_(c),
        control_(control),
        numbers_(numbers),
        ladder_(c.model.grid_given ? grid_ladder(c.model.grid) : kLadder),
        rungs_(c.model.grid_given) {
    if (to_the_end()) ladder_.insert(ladder_.end(), kFineRungs.begin(), kFineRungs.end());
  }

  /// Solves rung after rung until the bars meet the tolerance or the ladder ends.
  void run() {
    const bool given = case_.model.grid_given;
    for (std::size_t k = 0; k < ladder_.size(); ++k) {
      const bool fine = !given && k >= kLadder.size();
      if (fine && (rungs_.size() < 2 || no_grid_will_do())) break;
      const bool last = given ? k + 1 == ladder_.size() : ladder_[k] == kFineGrid;
      Rung rung{ladder_[k], solve_on(ladder_[k], last)};
      if (stopped() || !rung.solution.verdict.good()) {
        last_ = std::move(rung.solution);
        if (stopped()) return;
        if (!given && rungs_.empty() && k + 1 >= kInVain) break;
        continue;
      }
      add(std::move(rung), last);
      if (stopped() || hopeless() || last) return;
      if (enough() && !given) return;
    }
    if (!given && rungs_.size() < 2) solve_plainly();
  }

  Result result() const {
    if (stopped()) {
      Result r = coupling::summarize(rungs_.empty() ? last_ : rungs_.finest().solution, tier());
      r.verdict = {Status::interrupted, "stopped by the user", "", ""};
      return r;
    }
    if (plain_) return plain_result();
    const bool sequence = rungs_.size() > 1 || (case_.model.grid_given && !rungs_.empty());
    if (!sequence) return coupling::summarize(last_, tier());  // refused
    Result r = coupling::summarize(rungs_.finest().solution, tier());
    r.quantities = limits();
    finish(r);
    say_what_was_done(r);
    return r;
  }

 private:
  [[nodiscard]] bool stopped() const { return control_.stop != nullptr && control_.stop->load(); }

  /// What all results of the climb tell.
  void finish(Result& r) const {
    if (!choice_.effects.empty()) r.effects = choice_.effects;
    r.levels = levels_;
    r.cost.factorizations = cost_.factorizations;
    r.cost.newton_iterations = cost_.newton_iterations;
    r.cost.setup_s = setup_s_;
    r.choice = AutoChoice{case_.model.tolerance, bars_.within(case_.model.tolerance),
                          bars_.friction, bars_.h_min, solved_};
  }

  /// A grid on which no sequence is needed.
  void solve_plainly() {
    last_ = solve_on(to_the_end() ? kFineGrid : kUsualGrid, true);
    if (stopped() || !last_.verdict.good()) return;
    plain_ = fidelity::summarize(last_, tier(), control_);
    const auto relative = [&](const char* name) {
      for (const Quantity& q : plain_->quantities) {
        if (q.name == name) return q.error_grid / std::abs(q.value);
      }
      return double{INFINITY};
    };
    bars_ = {relative("friction_torque") + model_bar().friction,
             relative("h_min") + model_bar().h_min};
  }

  [[nodiscard]] Result plain_result() const {
    Result r = *plain_;
    finish(r);
    say_what_was_done(r);
    return r;
  }

  /// A full solution that has converged: its film, and what is known by now.
  void add(Rung rung, bool last) {
    if (rungs_.empty() && !last) choose(rung.solution);
    rung.whole = quantities_of(rung.solution, tier());
    levels_.back().quantities = rung.whole;  // of the nodes chosen
    if (!case_.model.grid_given && !last) refine(rung);
    rungs_.push(std::move(rung));
    assess();
  }

  /// True if the bars are as short as the tolerance asks for.
  [[nodiscard]] bool enough() const {
    const double t = case_.model.tolerance;
    const double margin = t < kFineTolerance    ? kFineMargin
                          : t < kTightTolerance ? kTightMargin
                                                : 1.0;
    return bars_.within(t / margin);
  }
  [[nodiscard]] bool to_the_end() const {
    return case_.model.tolerance < kFineTolerance && !case_.model.grid_given;
  }

  /// True if the next grid is not likely to meet the tolerance either.
  [[nodiscard]] bool hopeless() const {
    const bool going_on = rungs_.size() < 3 || case_.model.grid_given || to_the_end();
    return !going_on && bars_.largest() > kHopeless * case_.model.tolerance;
  }

  /// True if what is left open does not depend on the grid and is more than the tolerance.
  [[nodiscard]] bool no_grid_will_do() const {
    const double t = case_.model.tolerance;
    return model_bar().friction + relative_nodes("friction_torque") > t ||
           model_bar().h_min + relative_nodes("h_min") > t;
  }

  /// True if the case says how heat passes through shell and shaft.
  [[nodiscard]] bool has_walls() const {
    if (!case_.shell || !case_.shaft) return false;
    const auto* back = std::get_if<ConvectiveBack>(&case_.shell->back);
    return back == nullptr || back->heat_transfer > 0.0;
  }

  /// The cheapest tier that holds the effects which are still in.
  [[nodiscard]] Tier tier() const {
    const double slope =
        rheology::viscosity_slopes(case_.oil, case_.supplies.front().temperature, 0.0, 0.0).dln_dT;
    if (!has_walls()) return slope == 0.0 ? Tier::isothermal : Tier::lumped;
    const Switches& s = choice_.effects.empty() ? case_.model.switches : choice_.switches;
    const bool bends = s.elastic_deformation.value_or(true) || s.thermal_deformation.value_or(true);
    return bends ? Tier::tehd : Tier::thd;
  }

  Solution solve_on(Grid grid, bool last) {
    Case step = last || case_.model.grid_given ? case_ : with_rectangular_holes(case_);
    step.model.grid = grid;
    if (!choice_.effects.empty()) step.model.switches = choice_.switches;
    if (nodes_.nodes > 0) step.model.film_nodes = nodes_.nodes;
    const bool limited = !last && !case_.model.grid_given && has_walls();
    TurnLimit limit(control_, kMostTurns);
    const SolveControl& control = limited ? limit.control() : control_;
    const Otherwise otherwise = limited ? Otherwise::give_up : Otherwise::from_cold;
    Solution s;
    try {
      s = rungs_.empty()
              ? solve_tier(step, tier(), control)
              : solve_tier_from(step, tier(), rungs_.finest().solution, control, otherwise);
    } catch (const InputError&) {
      if (last) throw;
      s.verdict = {Status::iteration_limit, "the grid is too coarse for the supplies", "", ""};
      return s;
    }
    account(s.cost);
    if (s.model.solids) setup_s_ += s.model.solids->setup_seconds();
    solved_.push_back(fmt::format("{} on {} x {}{}", to_string(tier()), grid[0], grid[1],
                                  s.verdict.good() ? "" : " (did not converge)"));
    if (s.verdict.good()) levels_.push_back({grid, quantities_of(s, tier())});
    return s;
  }

  /// Nodes across the film, then effects.
  void choose(Solution& probe) {
    const bool given = case_.model.film_nodes_given || case_.model.grid_given;
    nodes_ = choose_nodes(probe, tier(), case_.model.tolerance, given, control_);
    account(nodes_.cost);
    const int asked = case_.model.film_nodes;
    if (nodes_.nodes > asked) {
      solved_.push_back(fmt::format("{} instead of {} nodes across the film", nodes_.nodes, asked));
    }
    choice_ = choose_effects(case_, probe, numbers_, case_.model.tolerance, control_.stop);
    account(choice_.cost);
    if (tier() == Tier::lumped) unknown_heat_ = unknown_heat(probe, cost_, control_.stop);
  }

  void refine(Rung& rung) {
    const Grid grid = film_grid(rung.grid);
    const Solution film = frozen_film(rung.solution, grid, {}, control_.stop);
    account(film.cost);
    if (!film.verdict.good()) return;
    rung.refined = quantities_of(film, Tier::isothermal);
    solved_.push_back(fmt::format("film on {} x {}", grid[0], grid[1]));
  }

  void assess() {
    const auto relative = [&](const char* name) {
      const GridLimit l = rungs_.limit(name);
      const double bar = (l.bar + left_open(name, l.value)) / std::abs(l.value);
      return std::isfinite(bar) ? bar : INFINITY;
    };
    bars_ = {relative("friction_torque") + model_bar().friction,
             relative("h_min") + model_bar().h_min};
  }

  [[nodiscard]] Bars model_bar() const {
    return {choice_.bar_friction + unknown_heat_.friction, choice_.bar_h_min + unknown_heat_.h_min};
  }

  /// What the nodes across the film leave open of a quantity.
  [[nodiscard]] double nodes_left(const std::string& name) const {
    constexpr double kSafety = 1.5;  // on finer grids nodes matter up to a third more [-]
    const double nodes = value_in(nodes_.left, name);
    return std::isfinite(nodes) ? kSafety * std::abs(nodes) : 0.0;
  }
  [[nodiscard]] double relative_nodes(const std::string& name) const {
    return nodes_left(name) / std::abs(value_in(rungs_.finest().whole, name));
  }

  /// True if holes are what they are in the finest solution.
  [[nodiscard]] bool round_holes() const {
    return case_.model.grid_given || rungs_.finest().grid == kFineGrid;
  }

  /// What nodes across the film and rectangular holes leave open of a quantity of this value.
  [[nodiscard]] double left_open(const std::string& name, double value) const {
    return nodes_left(name) + (round_holes() ? 0.0 : hole_bar(case_, name) * std::abs(value));
  }

  [[nodiscard]] std::vector<Quantity> limits() const {
    std::vector<Quantity> list = rungs_.finest().whole;
    for (Quantity& q : list) {
      const GridLimit l = rungs_.limit(q.name);
      q.value = l.value;
      q.error_grid = full_bar(l) + left_open(q.name, l.value);
      if (q.name == "friction_torque" || q.name == "power_loss") {
        q.error_model = model_bar().friction * std::abs(q.value);
      }
      if (q.name == "h_min") q.error_model = model_bar().h_min * std::abs(q.value);
    }
    return list;
  }

  void say_what_was_done(Result& r) const {
    const double tolerance = case_.model.tolerance;
    if (!case_.model.grid_given && !plain_) {
      r.assumptions.push_back(fmt::format(
          "scalars are those of {} x {} cells, {} what auto solved: {}; fields, history and audit "
          "are those of {} x {} cells",
          kFineGrid[0], kFineGrid[1], r.grid == kFineGrid ? "the last of" : "extrapolated from",
          fmt::join(solved_, ", "), r.grid[0], r.grid[1]));
    }
    if (!plain_ && !round_holes() && hole_bar(case_, "h_min") > 0.0) {
      r.assumptions.push_back(
          "holes were solved as rectangles that feed alike; bars of friction, films and oil flows "
          "hold what that changes");
    }
    if (!plain_ && !nodes_.known) {
      r.warnings.push_back(
          "more nodes across the film gave no solution on the coarse grid: the bars do not hold "
          "what " +
          std::to_string(nodes_.nodes) + " leave open");
    }
    if (bars_.within(tolerance)) return;
    r.warnings.push_back(fmt::format(
        "the tolerance of {} is not met: the friction torque is known within {}, the "
        "smallest film within {}; {}",
        percent(tolerance), percent(bars_.friction), percent(bars_.h_min), why_not_met()));
  }

  [[nodiscard]] const char* why_not_met() const {
    if (unknown_heat_.friction + unknown_heat_.h_min > 0.5 * case_.model.tolerance) {
      return "the case has no data of shell and shaft, so that the heat is only known in lumps";
    }
    if (!plain_ && no_grid_will_do()) {
      return "no grid mends what the nodes across the film (model.film_nodes) and the effects left "
             "out leave open";
    }
    if (case_.model.grid_given) return "the grid is given in the case";
    if (plain_) return "no two coarse grids gave a solution to lead on from";
    return "coarse grids tell too little; model.grid = [400, 50] or finer is solved as it is";
  }

  void account(const EquilibriumCost& cost) {
    cost_.factorizations += cost.factorizations;
    cost_.newton_iterations += cost.newton_iterations;
  }

  const Case& case_;
  const SolveControl& control_;
  Indicators numbers_;
  std::vector<Grid> ladder_;
  Rungs rungs_;
  Solution last_;  ///< one that did not converge, or the plain one
  std::optional<Result> plain_;
  NodeChoice nodes_;
  EffectChoice choice_;
  Bars unknown_heat_{0.0, 0.0};
  Bars bars_;
  EquilibriumCost cost_;
  double setup_s_ = 0.0;
  std::vector<LevelRecord> levels_;
  std::vector<std::string> solved_;
};

/// The estimate, if its bars meet the tolerance.
std::optional<Result> good_estimate(const Case& c, const Estimate& e) {
  if (c.model.grid_given) return {};
  Result r = estimate_result(c, e);
  if (!r.verdict.good()) return {};
  Bars bars;
  for (const Quantity& q : r.quantities) {
    if (q.name == "friction_torque") bars.friction = q.error() / std::abs(q.value);
    if (q.name == "h_min") bars.h_min = q.error() / std::abs(q.value);
  }
  if (!bars.within(c.model.tolerance)) return {};
  r.choice = AutoChoice{c.model.tolerance, true, bars.friction, bars.h_min, {"estimate"}};
  return r;
}

}  // namespace

Result solve_auto(const Case& c, const SolveControl& control) {
  const auto begin = std::chrono::steady_clock::now();
  const Estimate rough = estimate(c);
  if (auto enough = good_estimate(c, rough)) {
    enough->cost.wall_s = seconds_since(begin);
    return *enough;
  }
  Climb climb(c, control, indicators(c, rough));
  climb.run();
  Result r = climb.result();
  r.cost.wall_s = seconds_since(begin);
  return r;
}

}  // namespace shellback::fidelity
