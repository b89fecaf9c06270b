#include "fidelity/solve.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"
#include "core/stopwatch.hpp"
#include "fidelity/bar_rules.hpp"
#include "fidelity/edge_error.hpp"
#include "fidelity/grid_error.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

bool nodes_matter(const BearingModel& m) { return m.physics.film_energy || rheology::thins(m.oil); }

/// `limit` if it can be one of the quantity, else not known.
double limit_of(const Case& c, const Quantity& q, double limit) {
  const bool turned = one_sign(q) && limit * q.value < 0.0;
  return turned || !bounds_of(c, q.name).holds(limit) ? NAN : limit;
}

/// The heat by which temperatures rise is known no better than the torque, whatever grids agree on
/// by chance.
void share_bar_of_heat(const Judged& judged, const Result& result) {
  const Quantity* torque = quantity_in(result.quantities, "friction_torque");
  if (torque == nullptr || !std::isfinite(torque->error_grid)) return;
  for (const auto& [q, size] : judged) {
    const double bar = torque->error_grid / torque->size() * size;
    if (is_of_heat(q->name) && q->error_grid < bar) q->error_grid = bar;
  }
}

/// What all grids of the sequence give the supplies alike; 0 where they do not.
CellsOfSupplies given_alike(const Solution& s, const std::vector<LevelRecord>& levels) {
  CellsOfSupplies own = cells_of_supplies(s.model.domain.grid, s.model.supply);
  for (const LevelRecord& l : levels) {
    const CellsOfSupplies other = cells_of_supplies(s.model.input, l.grid);
    if (other.lands != own.lands) own.lands = 0;
    if (other.holes != own.holes) own.holes = 0;
  }
  return own;
}

/// What two and four more nodes across the film change on the coarse grid, whichever is more: steep
/// layers at walls far warmer than the feed show little of what they lack by two (decision 089).
std::vector<Quantity> change_by_nodes(const Solution& coarse, const SolveControl& control) {
  constexpr double kNodeSafety = 1.25;  // against 15 nodes
  std::vector<Quantity> out;
  const auto here = scalars(coarse);
  std::optional<Solution> finer = coarse;
  for (int step = 0; step < 2; ++step) {
    finer = with_more_nodes(*finer, control);
    if (!finer) break;
    const auto moved = change(here, scalars(*finer));
    if (out.empty()) out = moved;
    for (Quantity& q : out) q.value = larger(std::abs(q.value), std::abs(value_in(moved, q.name)));
  }
  for (Quantity& q : out) q.value *= kNodeSafety;
  return out;
}

/// Bars of the grid with the orders observed; not-a-number where the value of the result's own grid
/// is not there.
void put_grid_bars(const BarRecord& record, Result& result) {
  // Iteration leaves this part of the natural size open: the outer loop ends at changes of 3e-4 of
  // 10 K per step, the viscosity changes by a few per cent per kelvin.
  constexpr double kIteration = 1e-4;  // [-]
  constexpr double kHolesAlike = 2.0;  // where no grid tells what rows of a hole are worth
  const Case& c = record.coarse->model.input;
  const bool heated = record.coarse->model.physics.film_energy || result.tier == Tier::lumped;
  const Field& theta = record.coarse->film.film.theta;
  const bool torn = *std::min_element(theta.begin(), theta.end()) < 1.0 - kRoundOff;
  Judged judged;
  std::vector<BarOfSize> bars;
  for (Quantity& q : result.quantities) {
    q.error_grid = 0.0;
    if (given_by_case(c, result.tier, q.name)) continue;
    if (is_round_off(c, q, result.quantities)) {
      q.error_grid = std::abs(q.value);
      continue;
    }
    const double size = natural_size(q, mean_supply_temperature(c), result.quantities);
    std::vector<GridValue> values;
    for (const LevelRecord& level : record.levels) {
      const double value = value_in(level.quantities, q.name);
      if (std::isfinite(value)) values.push_back({cell_size(level.grid), value, kIteration * size});
    }
    const GridBar bar = grid_bar(values, cell_size(record.grid));
    const double nodes = std::abs(value_in(record.node_change, q.name));
    q.error_nodes = std::isfinite(nodes) ? nodes : 0.0;
    q.error_grid = (record.alike.holes > 0 ? kHolesAlike : 1.0) * bar.bar + q.error_nodes;
    if (q.name == "h_min") q.error_grid += record.edge;
    q.error_grid = larger(q.error_grid, open_by_lands(record.lands, q.name) * size);
    q.error_grid =
        larger(q.error_grid, open_past_lands(record.alike.lands, heated, torn, q.name) * size);
    q.order = bar.order;
    const bool known = q.error_grid < size;  // at all: else it leads anywhere
    q.limit = known ? limit_of(c, q, bar.limit) : NAN;
    judged.emplace_back(&q, size);
    bars.push_back({&q.error_grid, size, is_part_of_friction(q.name) || is_of_motion(q)});
  }
  share_bars(bars);
  share_bars_of_coefficients(judged);
  share_bar_of_heat(judged, result);
  share_bars_of_place_and_flow(c, result);
}

/// What the full physics would change on the fine grid: as much as on the coarse one, absolutely
/// or, where that means something, relatively, whichever is more, and what each effect there may
/// change more or less by, also where effects undo one another. NaN: not known.
double model_bar(const BarRecord& record, const std::vector<Quantity>& coarse, const Quantity& q) {
  const double whole = std::abs(value_in(record.model.change, q.name));
  // The smallest film goes to the edges where the middle opens: it is as sure as that.
  const char* film = q.name == "h_min" ? "h_min_mid" : q.name.c_str();
  const double apart = (kModelSafety - 1.0) * std::fmax(value_in(record.model.one_by_one, q.name),
                                                        value_in(record.model.one_by_one, film));
  const double change = std::max(kModelSafety * whole, whole + apart);
  const double size = std::abs(value_in(coarse, q.name));
  return one_sign(q) && size > 0.0 ? std::max(change, change / size * std::abs(q.value)) : change;
}

void put_notes(const BarRecord& record, Result& result) {
  const ModelError& m = record.model;
  if (!record.coarse) {
    result.warnings.emplace_back(note::Plain::bars_unknown);
    return;
  }
  const Grid& used = record.levels.back().grid;
  if (used != record.grid) result.assumptions.emplace_back(note::BarsFromFinerGrid{used});
  if (!m.failed.empty() && !m.complete) {
    result.warnings.emplace_back(note::RicherNotFound{m.failed});
  }
  if (m.richest && m.unknown.empty()) result.assumptions.emplace_back(note::Plain::nothing_richer);
  if (!m.unknown.empty()) result.assumptions.emplace_back(note::EffectsNotJudged{m.unknown});
}

}  // namespace

BarRecord measure_bars(const Solution& s, Tier tier, const SolveControl& control, WantedBars bars,
                       KeptSolids* kept) {
  const Stopwatch watch;
  Solution own = s;
  own.model.input.model.tier = tier;
  BarRecord record;
  record.grid = own.model.input.model.grid;
  record.edge = edge_error(own);
  record.lands = land_error(own.model.domain.grid, own.model.supply);
  GridSequence sequence = grid_sequence(own, control, kept);
  record.coarse = std::move(sequence.coarse);
  record.levels = std::move(sequence.levels);
  if (record.coarse && !stopped(control)) {
    record.alike = given_alike(own, record.levels);
    if (nodes_matter(s.model)) record.node_change = change_by_nodes(*record.coarse, control);
    if (bars == WantedBars::grid_and_model) record.model = model_error(*record.coarse, control);
  }
  record.wall_s = watch.seconds();
  return record;
}

void put_bars(const BarRecord& record, Result& result) {
  if (record.coarse) {
    put_grid_bars(record, result);
    widen_bars_of_light_contact(record.coarse->model, result);
    const auto coarse = scalars(*record.coarse);
    for (Quantity& q : result.quantities) q.error_model = model_bar(record, coarse, q);
    open_bar_of_layer(record.coarse->model.input, result);
    bound_bars(record.coarse->model.input, result);
  }
  for (Effect& e : result.effects) {
    for (const EffectChange& change : record.model.effects) {
      if (change.effect != e.kind) continue;
      e.change_in_friction = change.friction;
      e.change_in_h_min = change.h_min;
    }
  }
  put_notes(record, result);
}

Result summarize(const Solution& s, Tier tier, const SolveControl& control, WantedBars bars,
                 KeptSolids* kept) {
  Result result = bearing::summarize(s, tier);
  if (!s.verdict.good()) return result;
  const BarRecord record = measure_bars(s, tier, control, bars, kept);
  if (stopped(control)) {
    result.warnings.emplace_back(note::Plain::bars_interrupted);
  } else {
    put_bars(record, result);
  }
  result.cost.bars_s = record.wall_s;
  return result;
}

Result solve(const Case& c, const SolveControl& control) {
  if (c.cycle) {
    throw InputError("load_cycle",
                     "this solves steady states alone; take fidelity::solve_cycle_case");
  }
  return summarize(solve_tier(c, c.model.tier, control), c.model.tier, control);
}

}  // namespace shellback::fidelity
