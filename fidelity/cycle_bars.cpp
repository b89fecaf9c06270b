#include "fidelity/cycle_bars.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "bearing/bearing.hpp"
#include "bearing/over_time/cycle_endings.hpp"
#include "bearing/over_time/cycle_search.hpp"
#include "bearing/physics.hpp"
#include "core/contract.hpp"
#include "core/stopwatch.hpp"
#include "fidelity/bar_rules.hpp"
#include "fidelity/edge_error.hpp"
#include "fidelity/grid_error.hpp"
#include "fidelity/grid_sequence.hpp"
#include "fidelity/indicators.hpp"
#include "fidelity/land_error.hpp"
#include "fidelity/light_contact.hpp"
#include "fidelity/quantities.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

/// What the cycle cost on its grid, in cells of Newton iterations.
double work_of(const CycleResult& r) {
  return static_cast<double>(r.cost.newton_iterations) * r.grid[0] * r.grid[1];
}

/// Where the search of other cells or steps begins. The marks of a layer that flows are those of
/// all that it has passed: it begins anew.
const CycleStart* near(const SolvedCycle& found) {
  return found.start && found.start->now.layer.now.empty() ? &*found.start : nullptr;
}

/// The cycle on another grid, begun where `from` has ended; not good where the grid cannot carry
/// the supplies, nor where it takes more than `most_work`.
SolvedCycle on_grid(Case c, Grid grid, const SolvedCycle& from, double most_work,
                    const SolveControl& control) {
  c.model.grid = grid;
  SolveControl bounded = control;
  bounded.most_work = most_work;
  if (holds_supplies(c, grid)) return solve_cycle_from(near(from), c, c.model.tier, bounded);
  SolvedCycle none;
  none.result.verdict.status = Status::iteration_limit;
  return none;
}

/// Other steps than those of `usual`, and what the change tells of the usual ones (1).
double change_steps(const CycleResult& usual, Case& c) {
  if (c.cycle->step) {
    double longest = 0.0;  // corners of the load cut steps short
    for (const CycleInstant& i : usual.instants) longest = std::max(longest, i.dt);
    c.cycle->step = 0.5 * longest;
    return kSafety * 2.0;
  }
  constexpr double kErr = 4.0;  // times as much
  c.model.tolerance *= kErr;
  c.cycle->of_mouth *= std::cbrt(kErr);  // the bound of steps over a drilling's mouth, likewise
  return kSafety / (std::cbrt(kErr) - 1.0);
}

/// The torque's bars times the mean speed are in those of the power.
void widen_bars_of_power(CycleResult& r) {
  double turned = 0.0;  // [rad]
  for (const CycleInstant& i : r.instants) turned += i.dt * std::abs(i.omega);
  const double speed = turned / r.instants.back().t;
  const CycleQuantity& torque = *quantity_named(r, "friction_torque");
  const double of_grid = torque.quantity.error_grid;
  const double of_time = torque.quantity.error_time;
  for (CycleQuantity& q : r.quantities) {
    if (q.quantity.name != "power_loss") continue;
    q.quantity.error_grid = std::max(q.quantity.error_grid, speed * of_grid);
    q.quantity.error_time = std::max(q.quantity.error_time, speed * of_time);
  }
}

/// `finer`: of a finer grid, if there are not two coarser ones; may be null.
void put_grid_bars(const Case& c, const std::vector<CycleResult>& coarse_to_fine,
                   const CycleResult* finer, CycleResult& r) {
  const auto size = [](const std::array<int, 2>& g) { return 1.0 / std::sqrt(g[0] * g[1]); };
  const std::vector<Quantity> all = quantities_of(r);
  const LandError lands = land_error(c);
  std::vector<BarOfSize> bars;
  for (CycleQuantity& q : r.quantities) {
    if (given_by_case(c, r.tier, q.quantity.name)) {
      q.quantity.error_grid = 0.0;
      continue;
    }
    std::vector<GridValue> values;
    const auto add = [&](const CycleResult& on) {
      values.push_back({size(on.grid), value_of(on, q.quantity.name), 0.0});
    };
    for (const CycleResult& on : coarse_to_fine) add(on);
    add(r);
    if (finer != nullptr) add(*finer);
    const GridBar bar = grid_bar(values, size(r.grid));
    q.quantity.error_grid = bar.bar;
    if (q.quantity.name == "h_min") {
      q.quantity.error_grid += edge_error(r.fields.grid, r.fields.h_min, r.fields.in_supply);
    }
    q.quantity.order = bar.order;
    const double natural = natural_size(q.quantity, mean_supply_temperature(c), all);
    q.quantity.error_grid =
        larger(q.quantity.error_grid, open_by_lands(lands, q.quantity.name) * natural);
    bars.push_back({&q.quantity.error_grid, natural, is_part_of_friction(q.quantity.name)});
  }
  share_bars(bars);
}

double& bar_of_grid(CycleQuantity& q) { return q.quantity.error_grid; }
double& bar_of_time(CycleQuantity& q) { return q.quantity.error_time; }

void add_between_instants(CycleResult& r) {
  for (CycleQuantity& q : r.quantities) {
    for (const auto& [name, value] :
         {std::pair{"h_min", &CycleInstant::h_min}, std::pair{"p_max", &CycleInstant::p_max},
          std::pair{"p_asperity_max", &CycleInstant::p_asperity_max}}) {
      if (q.quantity.name == name)
        q.quantity.error_time += beyond_instants(r.instants, value, q.at);
    }
  }
}

void put_time_bars(const CycleResult& usual, const CycleResult& other, double part,
                   CycleResult& r) {
  for (CycleQuantity& q : r.quantities) {
    const CycleQuantity* same = quantity_named(usual, q.quantity.name);
    if (same == nullptr) continue;
    const double change = value_of(other, q.quantity.name) - same->quantity.value;
    const double size = std::max(same->quantity.size(), q.quantity.size());
    if (size > 0.0) q.quantity.error_time = part * std::abs(change) / size * q.quantity.size();
    if (size == 0.0) q.quantity.error_time = 0.0;
  }
}

/// As those of the grid: a quantity that two steps happen to agree on is no better known than all.
void share_time_bars(const Case& c, CycleResult& r) {
  const std::vector<Quantity> all = quantities_of(r);
  std::vector<BarOfSize> bars;
  for (CycleQuantity& q : r.quantities) {
    if (given_by_case(c, r.tier, q.quantity.name)) continue;
    bars.push_back({&q.quantity.error_time,
                    natural_size(q.quantity, mean_supply_temperature(c), all),
                    is_part_of_friction(q.quantity.name)});
  }
  share_bars(bars);
}

/// Walls that the bodies would still change: by so much are temperatures, and the heat that goes
/// into the bodies or, since it is made in any case, leaves with the oil, not known (2); all else
/// follows the viscosity, by what the mean change is worth of it at most.
void add_unsettled_walls(const Case& c, CycleResult& r) {
  const CycleAudit& a = r.audit;
  if (!std::isfinite(a.walls)) return;
  const double T = value_of(r, "T_film_mean");
  const double thinner =
      std::abs(rheology::viscosity_slopes(c.oil, T, 0.0, 0.0).dln_dT) * a.walls_mean;
  for (CycleQuantity& q : r.quantities) {
    const bool heat = q.quantity.name.starts_with("heat_");
    if (q.quantity.unit != "K" && !heat) q.quantity.error_time += thinner * q.quantity.size();
    if (q.quantity.unit == "K") q.quantity.error_time += a.walls;
    // What one wall would still take, the other may give it through the film.
    if (q.quantity.name == "heat_to_shell" || q.quantity.name == "heat_to_shaft")
      q.quantity.error_time += std::abs(a.to_shell) + std::abs(a.to_shaft);
    if (q.quantity.name == "heat_by_oil")
      q.quantity.error_time += std::abs(a.to_shell + a.to_shaft);
  }
}

}  // namespace

void widen_bars_of_light_contact(const Case& c, CycleResult& r, BarOf bar) {
  if (!physics_of(c, r.tier).contact) return;
  CycleQuantity torque = *quantity_named(r, "friction_torque"), film = *quantity_named(r, "h_min");
  const double all = torque.quantity.size();
  if (!(quantity_named(r, "friction_torque_asperity")->quantity.size() < kLight * all)) return;
  const solid::AsperityContact contact = *contact_of(c);
  const double now = contact.at(film.quantity.value).p;
  const double more = left_open_by_film(contact, film.quantity.value, bar(film));
  const Bearing& b = c.bearing;  // where nothing presses now: at most all over, as it rubs at rest
  const double everywhere =
      contact.friction().at_rest() * more * 2.0 * b.radius * b.width * b.radius;
  for (CycleQuantity& q : r.quantities) {
    double open = 0.0;
    if (q.quantity.name == "p_asperity_max") open = more;
    if (q.quantity.name == "friction_torque_asperity") {
      open = std::min(now > 0.0 ? q.quantity.size() * more / now : everywhere, all + bar(torque));
    }
    if (open > bar(q)) bar(q) = open;
  }
}

void bound_parts_of_friction(CycleResult& r) {
  std::vector<Quantity*> list;
  for (CycleQuantity& q : r.quantities) list.push_back(&q.quantity);
  bound_parts_of_friction(list);
}

double beyond_instants(const std::vector<CycleInstant>& all, double CycleInstant::*value,
                       double at) {
  for (std::size_t k = 1; k + 1 < all.size(); ++k) {
    if (all[k].t != at) continue;
    const double before = all[k].t - all[k - 1].t, behind = all[k + 1].t - all[k].t;
    if (!(before > 0.0) || !(behind > 0.0)) return 0.0;  // at a jump
    const double first = (all[k].*value - all[k - 1].*value) / before;
    const double second = (all[k + 1].*value - all[k].*value) / behind;
    const double slope = (first * behind + second * before) / (before + behind);
    const double bend = (second - first) / (before + behind);
    return bend != 0.0 ? slope * slope / (4.0 * std::abs(bend)) : 0.0;
  }
  return 0.0;
}

namespace {

/// A grid may take so many times the work of the result: a finer one has three times its cells and
/// steps, a coarser one that takes more has no cycle that closes.
constexpr double kMoreWork = 4.0;

/// The cycle on other grids.
struct Beside {
  std::vector<CycleResult> coarse;  ///< from the coarsest on
  SolvedCycle nearest;              ///< the last of them; none: the cycle itself
  std::optional<CycleResult> finer;
  [[nodiscard]] bool known() const { return !coarse.empty() || finer; }
};

/// On the two nearest coarser grids; where fewer have the cycle, on a finer one, too: two values
/// alone that happen to agree tell of no error.
Beside solve_beside(const Case& c, const SolvedCycle& own, const SolveControl& control) {
  Beside b;
  b.nearest = own;
  const double most = kMoreWork * work_of(own.result);
  for (const Grid& grid : nearest_coarse_grids(c)) {
    SolvedCycle on = on_grid(c, grid, own, most, control);
    if (stopped(control)) return b;
    if (!on.result.verdict.good()) continue;
    b.coarse.push_back(on.result);
    b.nearest = std::move(on);
  }
  const std::optional<Grid> fine = finer_grid(c);
  if (b.coarse.size() > 1 || !fine) return b;
  CycleResult on = on_grid(c, *fine, own, most, control).result;
  if (on.verdict.good() && !stopped(control)) b.finer = std::move(on);
  return b;
}

/// In the periodic state as much oil leaves as is fed: what a cycle that is nearly periodic still
/// gathers or loses, neither flow is known better than.
void add_gathered_oil(CycleResult& r) {
  const double gathered = std::abs(value_of(r, "supply_flow") - value_of(r, "side_flow"));
  for (CycleQuantity& q : r.quantities) {
    if (!q.quantity.name.ends_with("_flow")) continue;
    q.quantity.error_time = std::max(q.quantity.error_time, gathered);
  }
}

/// Bars of `r`, of the case, from `usual`, on its grid or a coarser one, and that in other steps.
/// False: these are not found, and no bar of time is known.
bool put_bars_of_steps(const Case& c, const SolvedCycle& usual, double most_work,
                       const SolveControl& control, CycleResult& r) {
  Case changed = c;
  const double part = change_steps(usual.result, changed);
  const CycleResult other = on_grid(changed, usual.result.grid, usual, most_work, control).result;
  const bool known = other.verdict.good();
  if (known) {
    put_time_bars(usual.result, other, part, r);
    share_time_bars(c, r);
  }
  add_between_instants(r);
  add_unsettled_walls(c, r);
  if (c.cycle->repeats()) add_gathered_oil(r);
  if (r.closure > kClosed) {  // one of cycles that differ by chance is told
    for (CycleQuantity& q : r.quantities) q.quantity.error_time += r.closure * q.quantity.size();
  }
  widen_bars_of_power(r);
  if (!c.cycle->step) {
    // The film of one instant is off by what its step may err, whatever other steps give.
    for (CycleQuantity& q : r.quantities) {
      if (q.quantity.name == "h_min")
        q.quantity.error_time += kOfTolerance * c.model.tolerance * std::abs(q.quantity.value);
    }
  }
  widen_bars_of_light_contact(c, r, bar_of_time);
  return known;
}

/// Bars over a cycle hold nothing of the physics left out.
void tell_cold_clearance(const Case& c, CycleResult& r) {
  constexpr double kWorthAWord = 0.05;  // of the clearance
  const CycleQuantity* T = quantity_named(r, "T_film_mean");
  if (T == nullptr || physics_of(c, r.tier).thermal_deformation) return;
  const double part = thermal_opening(c, T->quantity.value);
  if (part > kWorthAWord) r.assumptions.push_back(note::ColdClearance{part});
}

}  // namespace

std::optional<CycleResult> cycle_with_bars_of_steps(const Case& c, const SolveControl& control) {
  try {
    const SolvedCycle own = solve_cycle_from(nullptr, c, c.model.tier, control);
    CycleResult r = own.result;
    if (r.verdict.good() && put_bars_of_steps(c, own, kMoreWork * work_of(r), control, r)) return r;
  } catch (const InputError&) {  // the grid is not that of the case that was judged
  }
  return std::nullopt;
}

CycleResult solve_cycle_with_bars(const Case& c, const SolveControl& control) {
  const SolvedCycle own = solve_cycle_from(nullptr, c, c.model.tier, control);
  CycleResult r = own.result;
  if (!r.verdict.good()) return r;
  tell_cold_clearance(c, r);
  const Stopwatch watch;
  const Beside beside = solve_beside(c, own, control);
  if (!beside.known() || stopped(control)) {
    r.warnings.push_back(stopped(control) ? note::Plain::bars_interrupted
                                          : note::Plain::cycle_bars_unknown);
    r.cost.bars_s = watch.seconds();
    return r;
  }
  put_grid_bars(c, beside.coarse, beside.finer ? &*beside.finer : nullptr, r);
  widen_bars_of_light_contact(c, r, bar_of_grid);
  for (CycleQuantity& q : r.quantities) {
    if (q.quantity.name != "layer_depth") continue;
    if (layer_may_have_flowed(c, q.quantity, quantity_named(r, "p_max")->quantity)) {
      q.quantity.error_grid = std::numeric_limits<double>::quiet_NaN();
    }
  }
  if (!put_bars_of_steps(c, beside.nearest, kMoreWork * work_of(r), control, r)) {
    r.warnings.push_back(stopped(control) ? note::Plain::bars_interrupted
                                          : note::Plain::time_bars_unknown);
  }
  for (CycleQuantity& q : r.quantities) {
    const double most = furthest(c, q.quantity);
    if (q.quantity.error_grid > most) q.quantity.error_grid = most;
    if (q.quantity.error_time > most) q.quantity.error_time = most;
  }
  bound_parts_of_friction(r);
  r.cost.bars_s = watch.seconds();
  return r;
}

}  // namespace shellback::fidelity
