#include "fidelity/auto_tier.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/judge/judge_case.hpp"
#include "bearing/solids.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/stopwatch.hpp"
#include "fidelity/auto_probe.hpp"
#include "fidelity/bar_rules.hpp"
#include "fidelity/edge_error.hpp"
#include "fidelity/estimate.hpp"
#include "fidelity/grid_error.hpp"
#include "fidelity/held_film.hpp"
#include "fidelity/land_error.hpp"
#include "fidelity/left_out.hpp"
#include "fidelity/quantities.hpp"
#include "fidelity/solve.hpp"
#include "fidelity/tolerance.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::fidelity {
namespace {

using namespace bearing;

/// Grids of the sequence, fine along the axis first (grid_error.hpp); for fine tolerances go on.
const std::vector<Grid> kSequence{{24, 9}, {40, 25}, {60, 37}, {96, 49}, {192, 97}};
const std::vector<Grid> kFineGrids{{400, 100}, kFineGrid};

/// One full solution, and its film on more cells around under its temperatures and deformation.
struct Level {
  Grid grid{0, 0};
  std::vector<Quantity> whole;   ///< V of grid_error.hpp
  std::vector<Quantity> film{};  ///< F; empty: not solved
};

/// Which cells a circle takes jumps from grid to grid, and friction and film by up to this [-].
constexpr double kHoleNoise = 0.002;

bool has_holes(const Case& c) {
  const auto hole = [](const Supply& s) { return s.kind == SupplyKind::hole; };
  return std::any_of(c.supplies.begin(), c.supplies.end(), hole);
}

/// Part of the rise of the oil in supplies that is open where they take few cells around: which
/// cells those are is chance for one of them [-].
double open_by_supplies(const Case& c, int cells_around) {
  double open = 0.0;
  for (const Supply& s : c.supplies) {
    const double cells = cells_around * s.arc / (2.0 * kPi);
    if (cells > 0.0) open = std::max(open, std::min(1.0, 1.0 / cells));
  }
  return open;
}

/// Cells around of the film that follows a full solution.
int film_cells(const Grid& grid) { return 2 * grid[0]; }

class TierSearch {
 public:
  TierSearch(const Case& c, const SolveControl& control) : case_(c), control_(control) {}

  Result run() {
    if (auto quick = good_estimate()) return *quick;
    solve_grids();
    const bool sequence = levels_.size() > 1;
    Result r = stopped(control_) ? bearing::summarize(finest_, tier())
               : sequence        ? extrapolated()
                                 : on_one_grid();
    if (stopped(control_)) r.verdict = {Status::interrupted};
    return r;
  }

 private:
  [[nodiscard]] std::optional<Result> good_estimate() {
    if (lack_for(case_, Tier::estimate)) return {};
    Result r = estimate_result(case_);
    const Bars bars{relative_bars(r, "friction_torque").total(), relative_bars(r, "h_min").total()};
    if (case_.model.grid_given || !r.verdict.good() || !bars.within(tolerance())) return {};
    solved_ = {"estimate"};
    return chosen(std::move(r), bars);
  }

  [[nodiscard]] double tolerance() const { return case_.model.tolerance; }

  /// The cheapest tier that holds the effects which are still in.
  [[nodiscard]] Tier tier() const {
    const double T = mean_supply_temperature(case_);
    const double slope = rheology::viscosity_slopes(case_.oil, T, 0.0, 0.0).dln_dT;
    if (!knows_its_walls(case_)) return slope == 0.0 ? Tier::isothermal : Tier::lumped;
    const Switches& s = choice_ ? choice_->switches : case_.model.switches;
    const bool bends = s.elastic_deformation.value_or(true) || s.thermal_deformation.value_or(true);
    return bends ? Tier::tehd : Tier::thd;
  }

  void solve_grids() {
    auto grids = kSequence;
    if (case_.model.grid_given) {
      grids.resize(1);  // for the probe only
    } else if (tolerance() < kFineTolerance) {
      grids.insert(grids.end(), kFineGrids.begin(), kFineGrids.end());
    }
    for (std::size_t k = 0; k < grids.size(); ++k) {
      if (k > 1 && levels_.empty()) return;  // what two grids do not find, the next seldom do
      const bool good = solve_on(grids[k]);
      if (good && levels_.empty()) probe();
      if (good) add_level(grids[k]);
      if (stopped(control_) || good_enough()) return;
    }
  }

  /// From the finest solution, or, without one or where that leads to none, from cold; from cold
  /// no more once a grid was not found so, but for the finest. False: it does not converge.
  bool solve_on(const Grid& grid) {
    const Case c = chosen_case(grid);
    const Otherwise otherwise =
        grid == kFineGrid || !cold_fails_ ? Otherwise::from_cold : Otherwise::failure;
    Solution s;
    try {
      s = levels_.empty() ? solve_tier(c, tier(), control_)
                          : solve_tier_from(c, tier(), finest_, control_, otherwise);
    } catch (const InputError&) {
      if (grid == last_resort()) throw;
      return false;  // too coarse for the supplies
    }
    add(s.cost, cost_);
    if (s.model.solids) setup_s_ += s.model.solids->setup_seconds();
    const bool good = s.verdict.good();
    cold_fails_ = cold_fails_ || !good;
    solved_.push_back(fmt::format("{} on {} x {}{}", to_string(tier()), grid[0], grid[1],
                                  good ? "" : " (did not converge)"));
    if (good || levels_.empty()) finest_ = std::move(s);
    return good;
  }

  /// With what the probe has chosen.
  [[nodiscard]] Case chosen_case(const Grid& grid) const {
    Case c = case_;
    c.model.grid = grid;
    c.model.tier = tier();
    if (choice_) c.model.switches = choice_->switches;
    if (nodes_.nodes > 0) c.model.film_nodes = nodes_.nodes;
    return c;
  }

  /// Nodes across the film, then effects.
  void probe() {
    const bool given = case_.model.film_nodes_given || case_.model.grid_given;
    const int asked = case_.model.film_nodes;
    nodes_ = choose_nodes(finest_, tolerance(), given, control_, cost_);
    if (nodes_.nodes > asked) {
      solved_.push_back(fmt::format("{} instead of {} nodes across the film", nodes_.nodes, asked));
    }
    if (tier() == Tier::lumped) heat_ = unknown_heat(finest_, control_.stop, cost_);
    choice_ = choose_effects(finest_, tolerance(), control_.stop, cost_);
  }

  void add_level(const Grid& grid) {
    levels_.push_back({grid, scalars(finest_)});
    if (grid == kFineGrid || case_.model.grid_given) return;
    const Grid finer{film_cells(grid), grid[1]};
    const Solution film = held_film(finest_, finer, {finest_.model.physics}, control_.stop);
    add(film.cost, cost_);
    if (!film.verdict.good()) return;
    levels_.back().film = quantities_of(film, Tier::isothermal);
    solved_.push_back(fmt::format("film on {} x {}", finer[0], finer[1]));
  }

  /// A quantity on the fine grid, from the two finest solutions.
  [[nodiscard]] GridLimit limit(const std::string& name) const {
    const Level &coarse = levels_[levels_.size() - 2], &own = levels_.back();
    const double before = value_in(coarse.whole, name), value = value_in(own.whole, name);
    if (!std::isfinite(before)) return {value, NAN, 0.0};
    if (own.grid == kFineGrid) return film_limit(before, value, coarse.grid[0], own.grid[0]);
    const bool of_film = !is_of_heat(name);
    const auto around = [&](const Level& l) {
      return film_limit(value_in(l.whole, name), of_film ? value_in(l.film, name) : NAN, l.grid[0],
                        film_cells(l.grid));
    };
    GridLimit l = grid_limit(around(coarse), around(own), coarse.grid[1], own.grid[1]);
    if (!of_film ||
        !std::isfinite(value_in(own.film, name))) {  // no film tells what is left around
      l.bar +=
          onward(coarse.grid[0], own.grid[0], kFineGrid[0], kLeastOrder) * std::abs(value - before);
    }
    if (of_film && has_holes(case_)) l.bar += kHoleNoise * std::abs(l.value);
    return l;
  }

  /// What nodes across the film leave open of a quantity.
  [[nodiscard]] double nodes_left(const std::string& name) const {
    const double left = std::abs(value_in(nodes_.left, name));
    return std::isfinite(left) ? left : 0.0;
  }

  /// Of the physics that is left out or not known.
  [[nodiscard]] Bars model_bars() const {
    const Bars left_out = choice_ ? choice_->left_out : Bars{0.0, 0.0};
    return {left_out.friction + heat_.friction, left_out.h_min + heat_.h_min};
  }

  /// Physics left out and `of_grid`, a bar over the value.
  template <class F>
  [[nodiscard]] Bars bars_with(F of_grid) const {
    const double friction = of_grid("friction_torque"), h_min = of_grid("h_min");
    return {(std::isfinite(friction) ? friction : INFINITY) + model_bars().friction,
            (std::isfinite(h_min) ? h_min : INFINITY) + model_bars().h_min};
  }

  /// Against the fine grid, which the tolerance is held to.
  [[nodiscard]] Bars bars() const {
    return bars_with([this](const char* name) {
      const GridLimit l = limit(name);
      return (l.bar + nodes_left(name)) / std::abs(l.value);
    });
  }

  /// True if the bars meet the tolerance, or what is left does not depend on the grid.
  [[nodiscard]] bool good_enough() const {
    if (levels_.size() < 2) return false;
    const Bars on_any_grid = bars_with([this](const char* name) {
      return nodes_left(name) / std::abs(value_in(levels_.back().whole, name));
    });
    return bars().within(tolerance()) || !on_any_grid.within(tolerance());
  }

  /// The grid of the case, or one on which no sequence is needed.
  [[nodiscard]] Grid last_resort() const {
    if (case_.model.grid_given) return case_.model.grid;
    return tolerance() < kFineTolerance ? kFineGrid : kUsualGrid;
  }

  /// On it, with the bars of every tier.
  Result on_one_grid() {
    levels_.clear();  // from cold
    if (!solve_on(last_resort())) {
      return bearing::summarize(finest_, tier());
    }
    // Where no probe has stood nothing was left out, and the heat is as little known.
    if (!choice_ && tier() == Tier::lumped) heat_ = unknown_heat(finest_, control_.stop, cost_);
    Result r = fidelity::summarize(finest_, tier(), control_);
    const Bars bars = bars_with([&](const char* name) { return relative_bars(r, name).grid; });
    return chosen(std::move(r), bars);
  }

  /// Bar of the friction torque over itself: the heat that temperatures rise by is known no better,
  /// whatever two grids agree on by chance [-].
  [[nodiscard]] double bar_of_heat() const {
    const GridLimit torque = limit("friction_torque");
    return (torque.bar + torque.beyond) / std::abs(torque.value);
  }

  Result extrapolated() {
    Result r = bearing::summarize(finest_, tier());
    r.levels.clear();
    for (const Level& level : levels_) r.levels.push_back({level.grid, level.whole});
    const std::vector<Quantity> here = r.quantities;
    const double of_heat = bar_of_heat();
    // Lands are cut otherwise on each of these grids; holes have few rows on all of them.
    const LandError holes{0.0, 0.0,
                          land_error(finest_.model.domain.grid, finest_.model.supply).holes};
    Judged judged;
    std::vector<BarOfSize> bars_of_grid;
    for (Quantity& q : r.quantities) {
      const GridLimit l = limit(q.name);
      const double size = natural_size(q, mean_supply_temperature(case_), here);
      q.value = l.value;
      q.error_grid = l.bar + l.beyond + nodes_left(q.name);
      if (is_of_heat(q.name)) q.error_grid = std::fmax(q.error_grid, of_heat * size);
      q.error_grid = std::fmax(q.error_grid, open_by_lands(holes, q.name) * size);
      if (q.name == "T_supply_mixed") {
        q.error_grid += open_by_supplies(case_, levels_.back().grid[0]) * size;
      }
      if (choice_ && heat_.friction == 0.0) q.error_model = choice_->left_of(q.name) * size;
      const bool torque = q.name == "friction_torque" || q.name == "power_loss";
      if (torque) q.error_model = model_bars().friction * std::abs(q.value);
      if (q.name == "h_min") {
        q.error_model = model_bars().h_min * std::abs(q.value);
        q.error_grid += edge_error(finest_);  // of no grid, as `beyond`
      }
      if (given_by_case(case_, r.tier, q.name)) continue;
      judged.emplace_back(&q, size);
      bars_of_grid.push_back({&q.error_grid, size, is_part_of_friction(q.name) || is_of_motion(q)});
    }
    share_bars(bars_of_grid);
    share_bars_of_coefficients(judged);
    widen_bars_of_light_contact(finest_.model, r);
    open_bar_of_layer(case_, r);
    bound_bars(case_, r);
    r.assumptions.push_back(note::ScalarsOfFinerGrid{kFineGrid, r.grid, solved_});
    return chosen(std::move(r), bars());
  }

  /// With what was found on the way, and why the tolerance is not met.
  Result chosen(Result r, const Bars& bars) const {
    if (choice_) r.effects = choice_->effects;
    r.cost.factorizations = cost_.factorizations;
    r.cost.newton_iterations = cost_.newton_iterations;
    r.cost.setup_s = setup_s_;
    const bool laminar = is_laminar(r.warnings);
    r.choice = AutoChoice{tolerance(), laminar && bars.within(tolerance()), bars.friction,
                          bars.h_min, solved_};
    if (!nodes_.known) {
      r.warnings.emplace_back(note::Plain::nodes_not_judged);
    }
    if (r.choice->met) return r;
    const bool heat = heat_.friction + heat_.h_min > 0.5 * tolerance();
    using Why = note::ToleranceNotMet::Why;
    r.warnings.push_back(note::ToleranceNotMet{tolerance(), bars.friction, bars.h_min,
                                               !laminar                 ? Why::not_laminar
                                               : heat                   ? Why::no_walls
                                               : case_.model.grid_given ? Why::grid_given
                                                                        : Why::grid_limit});
    return r;
  }

  const Case& case_;
  const SolveControl& control_;
  Solution finest_;  ///< or, before one converges, the last
  std::vector<Level> levels_;
  NodeChoice nodes_;
  std::optional<EffectChoice> choice_;
  Bars heat_{0.0, 0.0};
  EquilibriumCost cost_;
  double setup_s_ = 0.0;
  std::vector<std::string> solved_;
  bool cold_fails_ = false;  ///< a grid was not found from cold
};

}  // namespace

Result solve_auto(const Case& c, const SolveControl& control) {
  const Stopwatch watch;
  Result r = TierSearch(c, control).run();
  r.cost.wall_s = watch.seconds();
  return r;
}

}  // namespace shellback::fidelity
