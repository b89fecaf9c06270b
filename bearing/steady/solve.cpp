#include "bearing/steady/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/film/perturbation.hpp"
#include "bearing/steady/branch_endings.hpp"
#include "bearing/steady/nested.hpp"
#include "bearing/steady/tiers.hpp"
#include "core/contract.hpp"
#include "core/stopwatch.hpp"

namespace shellback::bearing {

double equivalent_temperature(const Case& c) {
  const double T_supply = mean_supply_temperature(c);
  std::optional<double> back = c.measured.shell_back_temperature;
  if (!back && c.shell) {
    if (const auto* given = std::get_if<PrescribedBack>(&c.shell->back)) back = given->temperature;
  }
  if (back) return T_supply + c.model.kappa * (*back - T_supply);
  return c.oil_temperature.value_or(T_supply);
}

bool passes_over_supply(const Case& c, Tier tier) {
  if (tier != Tier::isothermal || !c.oil_temperature) return false;
  const double T = equivalent_temperature(c);
  return T == *c.oil_temperature &&
         std::any_of(c.supplies.begin(), c.supplies.end(),
                     [T](const Supply& supply) { return supply.temperature != T; });
}

double price_of_search(const Case& c, Tier tier) {
  constexpr double kSolves = 20.0;  // what a refusal may cost, in solves
  constexpr double kRigid = 30.0, kHeatOrElastic = 52.0;
  const bool rigid = tier == Tier::isothermal && !physics_of(c, tier).elastic;
  const double sides = symmetric_about_mid_width(c) ? 0.5 : 1.0;
  return kSolves * (rigid ? kRigid : kHeatOrElastic) * sides * c.model.grid[0] * c.model.grid[1];
}

namespace {

/// Work after which a search is given up [cells]. Grids coarser than the default one, where
/// continuation has no coarser grid to lean on, may cost as much as that one: seconds.
double most_work(const Case& c, Tier tier, const SolveControl& control) {
  const auto cells = [](const std::array<int, 2>& grid) { return grid[0] * grid[1]; };
  const double coarse = std::max(1.0, double(cells(Model{}.grid)) / cells(c.model.grid));
  return std::min(control.most_work, coarse * price_of_search(c, tier));
}

/// Solves on every grid of the sequence, each from the one before. A coarse grid that fails is left
/// out; where its state is no start for the next, that one starts from cold. The verdict is that of
/// the last grid alone.
void solve_on_sequence(const Case& c, Tier tier, const SolveControl& control,
                       std::shared_ptr<const Solids> solids, Solution& s) {
  const auto grids = grid_ladder(c);
  const double T_start = s.T_film;
  const double whole = s.cost.most_work;
  bool warm = false;
  for (std::size_t level = 0; level < grids.size(); ++level) {
    const bool last = level + 1 == grids.size();
    BearingModel model =
        make_bearing(c, physics_of(c, tier), grids[level], last ? solids : nullptr);
    if (warm) {
      s.film = carry_over(s.model, s.film, model);
      if (model.physics.film_energy) s.heat = carry_over(s.model, s.heat, model);
    }
    s.model = std::move(model);
    s.point = operating_point(s.model);
    s.cost.most_work = last ? whole : s.cost.work + kForStarts * (whole - s.cost.work);
    solve_on_grid(s, tier, {warm, !last, !last}, control);
    if (warm && !s.verdict.good() && s.verdict.status != Status::interrupted) {
      s.T_film = T_start;
      solve_on_grid(s, tier, {false, !last, !last}, control);
    }
    if (s.verdict.status == Status::interrupted) return;
    warm = s.verdict.good();
    if (warm) s.levels.push_back({grids[level], quantities_of(s, tier)});
  }
}

/// Solves the case once more on other cells, for where its branch ends there; interrupted: says so.
void add_limit_of_second_grid(const Case& c, Tier tier, const SolveControl& control, Solution& s) {
  constexpr double kSecond = 1.5;  // cells per axis [-]
  Case second = c;
  auto& [around, along] = second.model.grid;
  around = static_cast<int>(std::lround(kSecond * around));
  along =
      std::min(std::max(3, static_cast<int>(std::lround(kSecond * along))), most_axial_cells(c));
  Solution on;
  on.T_film = s.T_film;
  on.cost = s.cost;
  on.cost.most_work = s.cost.work + most_work(c, tier, control);
  on.model = make_bearing(second, physics_of(second, tier), second.model.grid);
  on.point = operating_point(on.model);
  solve_on_grid(on, tier, {false, true, false}, control);
  s.cost = on.cost;
  if (on.verdict.status == Status::interrupted) {
    s.verdict = on.verdict;
    return;
  }
  const ending::Raised raised = s.limits.back().raised;
  if (on.verdict.good()) on.limits.assign(1, {second.model.grid, raised, 1.0, false, false});
  const bool none = on.verdict.status == Status::no_steady_state;
  if (none && on.limits.empty()) {  // not even the beginning of a branch
    on.limits.assign(1, {second.model.grid, raised, 0.0, true, true});
  }
  s.limits.insert(s.limits.begin(), on.limits.begin(), on.limits.end());
}

/// That a branch ends is a fact of the bearing only if two grids agree on where, within a tenth,
/// and more than that before the load or speed asked for; where an equation has a bound, before it
/// by more than they differ.
void confirm_limit(const Case& c, Tier tier, const SolveControl& control, Solution& s) {
  if (s.verdict.status != Status::no_steady_state || !has_own_limit(s)) return;
  const Limit own = s.limits.back();
  const auto agrees = [&](const Limit& l) {
    const bool alike = l.grid != own.grid && own.proven && l.proven && l.raised == own.raised;
    const bool near = std::abs(l.part / own.part - 1.0) <= kAgree;
    const bool apart = is_apart_from_asked(l.part) && is_apart_from_asked(own.part);
    const double bound = std::max(l.part, own.part) + std::abs(l.part - own.part);
    return alike && ((near && apart) || (l.bound && own.bound && bound < 1.0));
  };
  const auto confirmed = [&] { return std::any_of(s.limits.begin(), s.limits.end(), agrees); };
  if (!confirmed()) add_limit_of_second_grid(c, tier, control, s);
  if (s.verdict.status == Status::interrupted || confirmed()) return;
  s.verdict = limit_not_resolved(s);
}

Solution from_cold(const Case& c, Tier tier, double T, const SolveControl& control,
                   std::shared_ptr<const Solids> solids) {
  const Stopwatch watch;
  Solution s;
  s.T_film = T;
  s.cost.most_work = most_work(c, tier, control);
  solve_on_sequence(c, tier, control, std::move(solids), s);
  confirm_limit(c, tier, control, s);
  if (s.verdict.status == Status::iteration_limit && s.point.layer) {
    s.verdict = {s.verdict.status, ending::Plain::layer_may_flow, s.verdict.place, {s.verdict}};
  }
  if (s.verdict.good() && c.model.coefficients) s.coefficients = coefficients_of(s);
  if (s.coefficients) s.levels.back().quantities = quantities_of(s, tier);
  s.wall_s = watch.seconds();
  return s;
}

}  // namespace

Solution solve_tier(const Case& c, Tier tier, const SolveControl& control,
                    std::shared_ptr<const Solids> solids) {
  if (tier == Tier::estimate || tier == Tier::automatic) {
    throw InputError("model.tier", fmt::format("the tier {} solves no film by itself; take "
                                               "isothermal, lumped, thd or tehd, or "
                                               "fidelity::solve_case",
                                               to_string(tier)));
  }
  const double T =
      tier == Tier::isothermal ? equivalent_temperature(c) : mean_supply_temperature(c);
  return from_cold(c, tier, T, control, std::move(solids));
}

Solution solve_isothermal_at(const Case& c, double T, const SolveControl& control) {
  return from_cold(c, Tier::isothermal, T, control, nullptr);
}

Solution solve_tier_from(const Case& c, Tier tier, const Solution& near,
                         const SolveControl& control, Otherwise otherwise) {
  const Stopwatch watch;
  const bool may_be_cold = otherwise == Otherwise::from_cold;
  const bool is_start = near.verdict.good() && !near.film.film.p.empty();
  EXPECTS(is_start || may_be_cold);
  if (!is_start) return solve_tier(c, tier, control);
  const Physics physics = physics_of(c, tier);
  Solution s;
  s.T_film = tier == Tier::isothermal ? equivalent_temperature(c) : near.T_film;
  s.model = make_bearing(c, physics, c.model.grid, near.model.solids);
  s.point = operating_point(s.model);
  s.film = carry_over(near.model, near.film, s.model);
  if (s.point.load.unknowns < 4) {  // what the case gives is not taken from the near solution
    const auto given = first_position(c, s.model.clearance);
    for (int k = s.point.load.unknowns; k < 4; ++k) s.film.position.q[k] = given.q[k];
  }
  if (physics.film_energy) {
    s.heat = near.model.physics.film_energy ? carry_over(near.model, near.heat, s.model)
                                            : cold_heat(s.model, near.T_film);
    if (physics.thermal_deformation && s.heat.thermal_deformation.empty()) {
      s.heat.thermal_deformation.assign(s.model.domain.grid.cells(), 0.0);
    }
  }
  solve_on_grid(s, tier, {true}, control);
  if (may_be_cold && s.verdict.status != Status::interrupted && !s.verdict.good()) {
    Solution cold = solve_tier(c, tier, control, s.model.solids);
    cold.wall_s = watch.seconds();
    cold.cost.work += s.cost.work;
    return cold;
  }
  // Newton's method from one state alone proves nothing of all others.
  if (s.verdict.status == Status::no_steady_state) s.verdict.status = Status::iteration_limit;
  if (s.verdict.good() && c.model.coefficients) s.coefficients = coefficients_of(s);
  if (s.verdict.good()) s.levels.push_back({c.model.grid, quantities_of(s, tier)});
  s.wall_s = watch.seconds();
  return s;
}

Result solve(const Case& c, const SolveControl& control) {
  if (c.cycle) {
    throw InputError("load_cycle",
                     "this solves steady states alone; take bearing::solve_cycle, or "
                     "fidelity::solve_cycle_case with error bars");
  }
  return summarize(solve_tier(c, c.model.tier, control), c.model.tier);
}

}  // namespace shellback::bearing
