#include "coupling/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/contract.hpp"
#include "coupling/nested.hpp"
#include "coupling/solve_level.hpp"

namespace shellback::coupling {

double equivalent_temperature(const Case& c) {
  const double T_supply = c.supplies.front().temperature;
  std::optional<double> back = c.measured.shell_back_temperature;
  if (!back && c.shell) {
    if (const auto* given = std::get_if<PrescribedBack>(&c.shell->back)) back = given->temperature;
  }
  if (back) return T_supply + c.model.kappa * (*back - T_supply);
  return c.oil_temperature.value_or(T_supply);
}

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Work after which a search is given up [cells]: as many times that of a usual solve on the grid.
/// A usual solve takes as many film iterations, counted on the finest grid, as 90 to 95 % of random
/// bearings need (docs/decisions/022). Grids coarser than the default one, where continuation has
/// no coarser grid to lean on, may cost as much as that one: seconds.
double most_work(const Case& c, Tier tier) {
  constexpr double kSolves = 20.0;  // what a refusal may cost, in solves
  constexpr double kRigid = 30.0, kHeatOrElastic = 52.0;
  const bool rigid = tier == Tier::isothermal && !physics_of(c, tier).elastic;
  const auto cells = [](const std::array<int, 2>& grid) { return grid[0] * grid[1]; };
  const double sides = symmetric_about_mid_width(c) ? 0.5 : 1.0;
  return kSolves * (rigid ? kRigid : kHeatOrElastic) * sides *
         std::max(cells(c.model.grid), cells(Model{}.grid));
}

/// Load at which the path of a film of one temperature and rigid surfaces ended [N]; 0: the last
/// grid did not end so.
double end_of_film(const Solution& s, Tier tier) {
  const bool rigid = tier == Tier::isothermal && !s.model.physics.elastic;
  if (!rigid || s.verdict.status != Status::no_steady_state || s.target.unknowns == 0) return 0.0;
  const double carried = std::hypot(s.film.force[0], s.film.force[1]);
  return carried < s.target.scale() ? carried : 0.0;
}

/// Solves on every grid of the ladder, each from the one before. A coarse grid that fails is left
/// out; where the state of a coarse grid is no start for the next, that one starts from cold, or
/// from where the path of the coarse one ended. The verdict is that of the last grid alone.
void climb(const Case& c, Tier tier, const SolveControl& control,
           std::shared_ptr<const Solids> solids, Solution& s) {
  constexpr double kCoarseTolerance = 3e-3;  // coarse grids only give the start of the next
  const auto ladder = grid_ladder(c.model.grid);
  s.cost.most_work = s.cost.work + most_work(c, tier);
  s.target = load_target(c);
  const double T_start = s.T_film;
  bool warm = false;
  for (std::size_t level = 0; level < ladder.size(); ++level) {
    const bool last = level + 1 == ladder.size();
    Level how{.warm = warm, .tolerance = last ? 0.0 : kCoarseTolerance};
    BearingModel model =
        make_bearing(c, physics_of(c, tier), ladder[level], last ? solids : nullptr);
    std::optional<NearPath> near;
    s.film_end = warm || level == 0 ? 0.0 : end_of_film(s, tier);
    if (warm) {
      s.film = carry_over(s.model, s.film, model);
      if (model.physics.film_energy) s.heat = carry_over(s.model, s.heat, model);
    } else if (s.followed.part > 0.0) {
      near = NearPath{s.followed, carry_over(s.model, s.film, model),
                      carry_over(s.model, s.heat, model)};
    }
    s.model = std::move(model);
    s.followed = {};
    if (near) how.near = &*near;
    const std::size_t turns = s.history.size();
    solve_level(s, tier, how, control);
    const bool at_once = s.history.size() == turns;  // not even one turn of film and heat
    if (warm && (s.verdict.status == Status::iteration_limit ||
                 s.verdict.status == Status::invalid_number ||
                 (s.verdict.status == Status::no_steady_state && at_once))) {
      s.T_film = T_start;
      how.warm = false;
      solve_level(s, tier, how, control);
    }
    if (s.verdict.status == Status::interrupted) return;
    warm = s.verdict.good();
    if (warm) s.levels.push_back({ladder[level], quantities_of(s, tier)});
  }
}

Solution from_cold(const Case& c, Tier tier, const SolveControl& control,
                   std::shared_ptr<const Solids> solids) {
  Solution s;
  s.T_film = tier == Tier::isothermal ? equivalent_temperature(c) : c.supplies.front().temperature;
  climb(c, tier, control, std::move(solids), s);
  return s;
}

}  // namespace

Solution solve_tier(const Case& c, Tier tier, const SolveControl& control,
                    std::shared_ptr<const Solids> solids) {
  const auto begin = std::chrono::steady_clock::now();
  Solution s = from_cold(c, tier, control, std::move(solids));
  s.wall_s = seconds_since(begin);
  return s;
}

Solution solve_isothermal_at(const Case& c, double T, const SolveControl& control) {
  const auto begin = std::chrono::steady_clock::now();
  Solution s;
  s.T_film = T;
  climb(c, Tier::isothermal, control, nullptr, s);
  s.wall_s = seconds_since(begin);
  return s;
}

Solution solve_tier_from(const Case& c, Tier tier, const Solution& near,
                         const SolveControl& control, Otherwise otherwise) {
  const auto begin = std::chrono::steady_clock::now();
  const bool may_be_cold = otherwise == Otherwise::from_cold;
  EXPECTS(near.verdict.good() || may_be_cold);
  if (!near.verdict.good()) return solve_tier(c, tier, control);
  const Physics physics = physics_of(c, tier);
  Solution s;
  s.T_film = tier == Tier::isothermal ? equivalent_temperature(c) : near.T_film;
  s.target = load_target(c);
  s.model = make_bearing(c, physics, c.model.grid, near.model.solids);
  s.film = carry_over(near.model, near.film, s.model);
  if (s.target.unknowns < 4) {  // what the case gives is not taken from the near solution
    const auto given = first_position(c, s.model.clearance);
    for (int k = s.target.unknowns; k < 4; ++k) s.film.position.q[k] = given.q[k];
  }
  if (physics.film_energy) {
    s.heat = near.model.physics.film_energy ? carry_over(near.model, near.heat, s.model)
                                            : cold_heat(s.model, near.T_film);
    if (physics.growth && s.heat.growth.empty()) {
      s.heat.growth.assign(s.model.scene.grid.cells(), 0.0);
    }
  }
  solve_level(s, tier, {.warm = true}, control);
  if (may_be_cold && s.verdict.status != Status::interrupted && !s.verdict.good()) {
    Solution cold = solve_tier(c, tier, control, s.model.solids);
    cold.wall_s = seconds_since(begin);
    return cold;
  }
  if (s.verdict.good()) s.levels.push_back({c.model.grid, quantities_of(s, tier)});
  s.wall_s = seconds_since(begin);
  return s;
}

Result solve(const Case& c, const SolveControl& control) {
  return summarize(solve_tier(c, c.model.tier, control), c.model.tier);
}

}  // namespace shellback::coupling
