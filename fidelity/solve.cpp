#include "fidelity/solve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "fidelity/grid_error.hpp"
#include "fidelity/richer_physics.hpp"

namespace shellback::fidelity {

using namespace coupling;

namespace {

constexpr int kMoreNodes = 2;  ///< across the film, to see what the nodes leave open [-]
/// Iteration leaves this part of the natural size open [-]: the outer loop ends at changes of
/// 1e-4 of 10 K per turn, the viscosity changes by a few per cent per kelvin.
constexpr double kIteration = 1e-4;
/// The coarse difference of the physics times this is the bar [-]; see docs/decisions/011.
constexpr double kModelSafety = 1.75;

double cell_size(const std::array<int, 2>& grid) { return 1.0 / std::sqrt(grid[0] * grid[1]); }

bool nodes_matter(const BearingModel& m) {
  return m.physics.film_energy || !std::holds_alternative<rheology::NoShearThinning>(m.oil.shear);
}

void measure_nodes(BarRecord& record, const SolveControl& control) {
  Case richer = record.coarse->input;
  richer.model.film_nodes += kMoreNodes;
  const auto more = solve_changed(richer, record.coarse->tier, *record.coarse, control);
  if (!more) return;
  for (const Quantity& q : record.coarse->quantities) {
    record.node_change.push_back(
        {q.name, value_in(more->quantities, q.name) - q.value, q.unit, NAN, NAN});
  }
}

bool stopped(const SolveControl& control) {
  return control.stop != nullptr && control.stop->load();
}

/// The bar of the result's grid with the order observed; NaN where its own value is not there.
GridBar grid_bar_of(const BarRecord& record, const Quantity& q, double size) {
  std::vector<GridValue> values;
  double own = NAN;  // cell size
  for (const LevelRecord& level : record.levels) {
    const double value = value_in(level.quantities, q.name);
    if (level.grid == record.grid) own = cell_size(level.grid);
    if (std::isfinite(value)) values.push_back({cell_size(level.grid), value, kIteration * size});
  }
  const bool finest = values.empty() || values.back().h == own;
  GridBar bar = finest || values.size() < 2
                    ? grid_bar(values)
                    : grid_bar_below(values[values.size() - 2], values.back());
  const double nodes = value_in(record.node_change, q.name);
  if (std::isfinite(nodes)) bar.bar += std::abs(nodes);
  return bar;
}

void put_words(const BarRecord& record, Result& result) {
  const ModelError& m = record.model;
  if (!record.coarse) {
    result.warnings.push_back(
        "neither a coarser grid nor a finer one gave a solution: the error bars are unknown");
    return;
  }
  if (record.levels.back().grid != record.grid) {
    const auto [nt, nz] = record.levels.back().grid;
    result.assumptions.push_back(fmt::format(
        "no coarser grid gave a solution: the error bars are made with a finer one, {} x {} cells",
        nt, nz));
  }
  if (!m.failed.empty() && !m.complete) {
    result.warnings.push_back(fmt::format(
        "the richer physics ({}) gave no solution on the coarse grid: the model bars are unknown",
        fmt::join(m.failed, ", ")));
  }
  if (m.richest && m.unknown.empty()) {
    result.assumptions.push_back(
        "nothing richer than this physics is there to judge it by: no model bars");
  }
  if (!m.unknown.empty()) {
    result.assumptions.push_back(
        fmt::format("the case has no data (shell, shaft) to judge what is left out by leaving out "
                    "{}; the error bars do not hold it",
                    fmt::join(m.unknown, ", ")));
  }
}

}  // namespace

BarRecord measure_bars(const Solution& s, Tier tier, const SolveControl& control, WantedBars bars,
                       KeptSolids* kept) {
  const auto begin = std::chrono::steady_clock::now();
  BarRecord record;
  record.grid = s.model.input.model.grid;
  Levels levels = levels_around(s, tier, control, kept);
  record.coarse = std::move(levels.coarse);
  record.levels = std::move(levels.all);
  if (record.coarse && !stopped(control)) {
    if (nodes_matter(s.model)) measure_nodes(record, control);
    if (bars == WantedBars::grid_and_model) record.model = model_error(*record.coarse, control);
  }
  record.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return record;
}

namespace {

/// True for quantities of one sign, of which a relative change means something.
bool one_sign(const Quantity& q) {
  if (q.name == "thermal_opening_mean") return false;
  const auto units = {"N m", "m", "Pa", "1", "m3/s"};
  return std::any_of(units.begin(), units.end(), [&](const char* u) { return q.unit == u; });
}

/// What the full physics would change on the fine grid: as much as on the coarse one, absolutely
/// or, where that means something, relatively, whichever is more.
double model_change(const BarRecord& record, const Quantity& q) {
  const double change = std::abs(value_in(record.model.change, q.name));
  if (!record.coarse || !std::isfinite(change) || !one_sign(q)) return change;
  const double coarse = std::abs(value_in(record.coarse->quantities, q.name));
  return coarse > 0.0 ? std::max(change, change / coarse * std::abs(q.value)) : change;
}

/// Bars of the grid for all quantities, none shorter than its share of the usual one.
void put_grid_bars(const BarRecord& record, Result& result) {
  const Case& c = record.coarse->input;
  const double T_supply = c.supplies.front().temperature;
  std::vector<double> sizes;
  std::vector<double> relative;
  for (Quantity& q : result.quantities) {
    sizes.push_back(natural_size(q, T_supply, result.quantities));
    const bool given = given_by_case(c, result.tier, q.name);
    const GridBar bar = grid_bar_of(record, q, sizes.back());
    q.error_grid = given ? 0.0 : bar.bar;
    q.order = given ? NAN : bar.order;
    if (!given && sizes.back() > 0.0) relative.push_back(q.error_grid / sizes.back());
  }
  std::erase_if(relative, [](double x) { return !std::isfinite(x); });
  if (relative.empty()) return;
  const auto middle = relative.begin() + static_cast<long>(relative.size() / 2);
  std::nth_element(relative.begin(), middle, relative.end());
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    Quantity& q = result.quantities[k];
    if (given_by_case(c, result.tier, q.name) || !std::isfinite(q.error_grid)) continue;
    q.error_grid = std::max(q.error_grid, kShare * *middle * sizes[k]);
  }
}

}  // namespace

void put_bars(const BarRecord& record, Result& result) {
  if (record.coarse) put_grid_bars(record, result);
  for (Quantity& q : result.quantities) {
    const double change = model_change(record, q);
    if (std::isfinite(change)) q.error_model = kModelSafety * change;
  }
  for (Effect& e : result.effects) {
    for (const EffectChange& change : record.model.effects) {
      if (change.effect != e.name) continue;
      e.change_in_friction = change.friction;
      e.change_in_h_min = change.h_min;
    }
  }
  put_words(record, result);
}

Result summarize(const Solution& s, Tier tier, const SolveControl& control, WantedBars bars,
                 KeptSolids* kept) {
  Result result = coupling::summarize(s, tier);
  if (!s.verdict.good()) return result;
  const BarRecord record = measure_bars(s, tier, control, bars, kept);
  if (stopped(control)) {
    result.warnings.push_back("interrupted before the error bars were known");
  } else {
    put_bars(record, result);
  }
  result.cost.bars_s = record.wall_s;
  return result;
}

Result solve(const Case& c, const SolveControl& control) {
  return summarize(solve_tier(c, c.model.tier, control), c.model.tier, control);
}

}  // namespace shellback::fidelity
