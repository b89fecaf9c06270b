#include "fidelity/auto_cycle.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bearing/judge/judge_case.hpp"
#include "core/step_control.hpp"
#include "core/stopwatch.hpp"
#include "fidelity/cycle_bars.hpp"
#include "fidelity/estimate_cycle.hpp"
#include "fidelity/grid_sequence.hpp"
#include "fidelity/left_out.hpp"
#include "fidelity/quantities.hpp"
#include "fidelity/tolerance.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

constexpr double kOfSteps = 0.25;  ///< part of the tolerance that the steps in time may take
constexpr int kRounds = 3;         ///< of grids and steps
/// In one round: cells, twice as many in each direction, and steps.
constexpr double kMost = 4.0;
/// The first that holds the supplies is the probe's; from kFirst on that of the first round.
const std::vector<Grid> kCycleGrids{{48, 8}, {60, 10}, {80, 14}, {96, 12}, {200, 25}, kUsualGrid};
constexpr Grid kFirst{96, 12};

/// One number of each of the two.
template <class F>
Bars both(const CycleResult& r, F of) {
  const CycleQuantity* friction = quantity_named(r, "friction_torque");
  const CycleQuantity* h_min = quantity_named(r, "h_min");
  if (friction == nullptr || h_min == nullptr) return {INFINITY, INFINITY};
  return {of(*friction), of(*h_min)};
}

double over_value(double bar, const CycleQuantity& q) {
  const double part = bar / q.quantity.size();
  return std::isfinite(part) ? part : INFINITY;
}

class CycleTierSearch {
 public:
  CycleTierSearch(const Case& c, const SolveControl& control) : case_(c), control_(control) {}

  CycleResult run() {
    if (auto quick = good_estimate()) return *std::move(quick);
    if (!choose_tier()) return chosen(std::move(last_));
    on_.model.tier = tier_;
    on_.model.grid = case_.model.grid_given
                         ? case_.model.grid
                         : holding(std::find(kCycleGrids.begin(), kCycleGrids.end(), kFirst));
    for (int k = 0; k < kRounds; ++k) {
      CycleResult next = solve_cycle_with_bars(on_, control_);
      note(next);
      // The round before stands, also for one that was stopped before its bars were known.
      if (k > 0 && (!next.verdict.good() || stopped(control_))) break;
      last_ = std::move(next);
      if (!last_.verdict.good() || stopped(control_) || within() || !refine()) break;
    }
    return chosen(std::move(last_));
  }

 private:
  [[nodiscard]] std::optional<CycleResult> good_estimate() {
    if (case_.model.grid_given || lack_for(case_, Tier::estimate)) return {};
    CycleResult r = estimate_cycle(case_, control_);
    const Bars bars =
        both(r, [](const CycleQuantity& q) { return over_value(q.quantity.error(), q); });
    if (!r.verdict.good() || bars.larger() > case_.model.tolerance) return {};
    if (!is_laminar(r.warnings)) return {};
    r.choice = AutoChoice{case_.model.tolerance, true, bars.friction, bars.h_min, {"estimate"}};
    return r;
  }

  void note(const CycleResult& r) {
    const char* how = stopped(control_)  ? " (stopped)"
                      : r.verdict.good() ? ""
                                         : " (did not converge)";
    solved_.push_back(fmt::format("{} on {} x {}{}", to_string(r.tier), r.grid[0], r.grid[1], how));
  }

  CycleResult probe(Tier tier) {
    Case c = on_;
    c.model.tier = tier;
    CycleResult r = solve_cycle(c, tier, control_);
    note(r);
    return r;
  }

  /// The first grid that holds the supplies; none: the one that is given, or the finest, whose
  /// refusal tells what they take.
  [[nodiscard]] Grid holding(std::vector<Grid>::const_iterator from) const {
    const auto holds = [this](const Grid& grid) { return holds_supplies(on_, grid); };
    const auto first = std::find_if(from, kCycleGrids.end(), holds);
    return first != kCycleGrids.end() ? *first
           : case_.model.grid_given   ? case_.model.grid
                                      : kCycleGrids.back();
  }

  /// False: no tier is found on the coarse grid; `last_` tells why.
  bool choose_tier() {
    on_.model.grid = holding(kCycleGrids.begin());
    std::vector<Tier> tiers = possible_tiers(case_);
    CycleResult rich;
    while (!tiers.empty()) {
      rich = probe(tiers.back());
      last_ = rich;
      if (rich.verdict.good() || stopped(control_)) break;
      if (unjudged_.empty()) unjudged_ = {{rich.tier, rich.grid, rich.verdict}};
      tiers.pop_back();
    }
    if (!rich.verdict.good()) return false;
    tier_ = tiers.back();
    for (const Tier tier : tiers) {
      if (tier == tier_) break;
      const CycleResult cheap = probe(tier);
      if (stopped(control_)) return false;
      if (!cheap.verdict.good()) continue;
      const auto change = [&](const CycleQuantity& q) {
        const double rich_value = value_of(rich, q.quantity.name);
        return kModelSafety * over_value(q.quantity.value - rich_value, q);
      };
      const Bars left = both(cheap, [&](const CycleQuantity& q) { return std::abs(change(q)); });
      if (left.larger() > (1.0 - kOfSteps - kWorthAGrid) * case_.model.tolerance) continue;
      tier_ = tier;
      left_out_ = left;
      for (const CycleQuantity& q : cheap.quantities) {
        const double whole = q.quantity.value - value_of(rich, q.quantity.name);
        left_.push_back({q.quantity.name, kModelSafety * std::abs(whole), q.quantity.size()});
      }
      break;
    }
    if (!unjudged_.empty()) left_out_ = {INFINITY, INFINITY};  // by nothing richer
    chosen_ = true;
    return true;
  }

  [[nodiscard]] Bars of_grid() const {
    return both(last_, [](const CycleQuantity& q) { return over_value(q.quantity.error_grid, q); });
  }
  [[nodiscard]] Bars of_steps() const {
    return both(last_, [](const CycleQuantity& q) { return over_value(q.quantity.error_time, q); });
  }
  /// What shorter steps leave.
  [[nodiscard]] Bars without_steps() const {
    const Bars grid = of_grid();
    return {grid.friction + left_out_.friction, grid.h_min + left_out_.h_min};
  }
  [[nodiscard]] bool within() const { return bars_of(last_).larger() <= case_.model.tolerance; }

  /// Cells that bring one bar within what is left of the tolerance, over those that there are.
  [[nodiscard]] double more_cells(const char* name, double bar, double left_out) const {
    const double physics = std::isfinite(left_out) ? left_out : 0.0;
    const double wanted = (1.0 - kOfSteps) * case_.model.tolerance - physics;
    const double order = quantity_named(last_, name)->quantity.order;
    const double p = std::isfinite(order) && order > 0.0 ? order : 1.0;
    const double more = std::pow(bar / wanted, 2.0 / p);
    return std::isfinite(more) ? std::clamp(more, 1.0, kMost) : kMost;
  }

  /// Finer grid and shorter steps for the next round; false: nothing is left to refine.
  bool refine() {
    constexpr double kMargin = 1.2;  // of cells, as an order is only observed
    const Grid before = on_.model.grid;
    const double steps = of_steps().larger();
    const double allowed = kOfSteps * case_.model.tolerance;
    // The bar goes with the length of a step (decision 058), the error of one with its third power.
    const double power = kStepOrder;
    const double least = std::pow(kMost, -kStepOrder);
    const bool shorter = !case_.cycle->step && steps > allowed;
    const bool finest = case_.model.grid_given || before == kUsualGrid;
    if (finest && without_steps().larger() > case_.model.tolerance) return false;
    if (shorter) on_.model.tolerance *= std::clamp(std::pow(allowed / steps, power), least, 1.0);
    const Bars grid = of_grid();
    const double more = std::max(more_cells("friction_torque", grid.friction, left_out_.friction),
                                 more_cells("h_min", grid.h_min, left_out_.h_min));
    if (!case_.model.grid_given && more > 1.0) {
      const double by = std::sqrt(kMargin * more);
      for (int k = 0; k < 2; ++k) {
        const int cells = static_cast<int>(std::lround(by * on_.model.grid[k]));
        on_.model.grid[k] = std::min(cells, kUsualGrid[k]);
      }
    }
    return shorter || on_.model.grid != before;
  }

  CycleResult chosen(CycleResult r) const {
    if (stopped(control_)) r.verdict = {Status::interrupted};
    const Bars known = bars_of(r);
    if (r.verdict.good()) {
      const bool met = known.larger() <= case_.model.tolerance && is_laminar(r.warnings);
      r.choice = AutoChoice{case_.model.tolerance, met, known.friction, known.h_min, solved_};
    }
    if (stopped(control_) && !chosen_) return r;
    for (CycleQuantity& q : r.quantities) {
      if (!unjudged_.empty() || left_.empty()) continue;  // nothing richer: no bar
      q.quantity.error_model = left_of(q.quantity);
    }
    bound_parts_of_friction(r);
    r.assumptions.push_back(
        note::TierTaken{r.tier, r.grid, left_out_.friction, left_out_.h_min, unjudged_, solved_});
    if (!knows_its_walls(case_)) {
      r.assumptions.emplace_back(note::Plain::walls_not_judged);
    }
    if (!unjudged_.empty()) {
      r.warnings.push_back(unjudged_.front());
    } else if (r.verdict.good() && !r.choice->met) {
      using Why = note::ToleranceNotMet::Why;
      const Why why = !is_laminar(r.warnings)  ? Why::not_laminar
                      : case_.model.grid_given ? Why::grid_given
                                               : Why::cycle_grid;
      r.warnings.push_back(
          note::ToleranceNotMet{case_.model.tolerance, known.friction, known.h_min, why, true});
    }
    return r;
  }

  /// What the physics left out may change of a quantity: as much as on the coarse grid, or as large
  /// a part of what is there, whichever is more. Not-a-number: not known.
  [[nodiscard]] double left_of(const Quantity& q) const {
    for (const Left& l : left_) {
      if (l.name != q.name) continue;
      const bool of_size = one_sign(q) && l.size > 0.0;
      const double bar = of_size ? std::max(l.bar, l.bar / l.size * q.size()) : l.bar;
      const double most = furthest(case_, q);
      return bar > most ? most : bar;
    }
    return left_.empty() ? 0.0 : double{NAN};
  }

  /// The sum of all bars that are told; not known where nothing richer judges.
  [[nodiscard]] Bars bars_of(const CycleResult& r) const {
    if (!unjudged_.empty()) return {INFINITY, INFINITY};
    return both(r, [this](const CycleQuantity& q) {
      return over_value(q.quantity.error_grid + q.quantity.error_time + left_of(q.quantity), q);
    });
  }

  /// What a quantity of the coarse grid lacks by the physics left out, and how large it is there.
  struct Left {
    std::string name;
    double bar = 0.0;
    double size = 0.0;
  };

  const Case& case_;
  const SolveControl& control_;
  Case on_ = case_;  ///< with what is tried: grid, tolerance, tier
  Tier tier_ = Tier::isothermal;
  Bars left_out_{0.0, 0.0};                    ///< by the tier that was chosen
  std::vector<Left> left_;                     ///< every quantity of it; empty: nothing is left out
  std::vector<note::NothingRicher> unjudged_;  ///< the richest tier, where it judges nothing
  CycleResult last_;
  bool chosen_ = false;  ///< the tier, from those that were tried
  std::vector<std::string> solved_;
};

}  // namespace

CycleResult solve_auto_cycle(const Case& c, const SolveControl& control) {
  const Stopwatch watch;
  CycleResult r = CycleTierSearch(c, control).run();
  r.cost.wall_s = watch.seconds();
  r.cost.bars_s = 0.0;  // part of it
  return r;
}

CycleResult solve_cycle_case(const Case& c, const SolveControl& control) {
  if (c.model.tier == Tier::estimate) return estimate_cycle(c, control);
  return c.model.tier == Tier::automatic ? solve_auto_cycle(c, control)
                                         : solve_cycle_with_bars(c, control);
}

}  // namespace shellback::fidelity
