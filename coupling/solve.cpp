#include "coupling/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "coupling/heat_path.hpp"
#include "coupling/nested.hpp"
#include "coupling/position_path.hpp"
#include "coupling/solids.hpp"
#include "coupling/stepped_start.hpp"
#include "rheology/density.hpp"
#include "rheology/heat.hpp"

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

LoadTarget scaled(LoadTarget target, double part) {
  for (double& f : target.force) f *= part;
  return target;
}

/// Elastic film by continuation in the load: from the part of the load that a rigid isoviscous
/// film carries with an elastic opening of no more than a few gaps, in growing steps.
Verdict start_elastic(Solution& s, double T, const SolveControl& control) {
  constexpr double kMostOpening = 6.0;  // elastic opening over the smallest gap at the start [-]
  constexpr double kSmallestPart = 1e-4;
  constexpr double kSmallestRatio = 1.05;  // a step of the load below this is not worth taking
  double part = 1.0;
  while (true) {
    Verdict v =
        cold_rigid_film(s.model, scaled(s.target, part), T, true, s.film, s.cost, control.stop);
    if (!v.good()) return v;
    if (!evaluate(s.model, {}, 1e-3, s.film)) break;
    const Field opening = s.model.solids->compliance(s.film.film.p);
    const double largest = *std::max_element(opening.begin(), opening.end());
    const double gap = std::max(s.film.least.h, 0.0) + s.model.scene.rough.sigma;
    if (s.target.unknowns == 0 || largest < kMostOpening * gap || part < kSmallestPart) break;
    part *= 0.25;
  }
  EquilibriumOptions loose;
  loose.film_tolerance = loose.load_tolerance = loose.elastic_tolerance = 1e-2;
  loose.viscosity_tolerance = 1e-2;
  loose.max_iterations = 40;
  double ratio = 3.0;
  while (true) {
    const bool last = part >= 1.0;
    const FilmEquilibrium before = s.film;
    const Verdict v =
        solve_equilibrium(s.model, scaled(s.target, part), s.heat.growth,
                          last ? EquilibriumOptions{} : loose, s.film, s.cost, control.stop);
    if (v.status == Status::interrupted) return v;
    if (v.good() && last) return v;
    if (!v.good()) {
      const double reached = part / ratio;  // the load of `before`
      ratio = std::sqrt(ratio);
      if (ratio < kSmallestRatio || reached < kSmallestPart) return v;
      s.film = before;
      part = reached;
    }
    part = std::min(1.0, part * ratio);
  }
}

/// First equilibrium at one temperature, from cold, on the model's own grid.
Verdict start_at_once(Solution& s, double T, const SolveControl& control) {
  if (s.model.physics.elastic) return start_elastic(s, T, control);
  Verdict v = cold_rigid_film(s.model, s.target, T, false, s.film, s.cost, control.stop);
  if (!v.good()) return v;
  return solve_equilibrium(s.model, s.target, s.heat.growth, {}, s.film, s.cost, control.stop);
}

/// The same; where it is not found at once, by steps from a light load.
Verdict start(Solution& s, double T, const SolveControl& control) {
  const Verdict v = start_at_once(s, T, control);
  const Methods& by = s.model.input.model.methods;
  const bool other = by.cavitation != CavitationMethod::active_set ||
                     by.elastic != ElasticMethod::newton;  // shown as they are, without our help
  if (v.good() || v.status == Status::interrupted || other) return v;
  if (s.target.unknowns == 0 && s.model.physics.elastic) {
    return follow_position(s.model, s.target, T, {}, s.film, s.cost, control.stop);
  }
  if (v.status != Status::iteration_limit || s.target.unknowns == 0) return v;
  return stepped_start(s, T, control);
}

void set_uniform_temperature(Solution& s, double T) {
  std::fill(s.film.columns.T.begin(), s.film.columns.T.end(), T);
  s.T_film = T;
}

/// Mean film temperature from the heat balance of the whole bearing: all friction heat leaves with
/// the oil, which is as warm as the film, rho cp Q (T - T_supply) = P. Secant on T.
Verdict solve_lumped(Solution& s, bool warm, const SolveControl& control) {
  constexpr int kMostTurns = 60;
  constexpr double kSettled = 1e-7;  // [K]
  const double T_supply = s.model.input.supplies.front().temperature;
  double T = warm ? s.T_film : T_supply;
  double before_T = T;
  double before_gap = 0.0;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    set_uniform_temperature(s, T);
    Verdict v = turn == 0 && !warm
                    ? start(s, T, control)
                    : solve_equilibrium(s.model, s.target, {}, {}, s.film, s.cost, control.stop);
    if (!v.good()) return v;
    const Friction f = friction_of(s.model, s.film);
    const double power = std::abs((f.viscous + f.asperity) * s.model.input.operation.omega) +
                         pump_power(s.model, s.film);
    const double flow = fluid::oil_flows(s.model.scene, s.film.flow).side;
    const double cp = rheology::heat_capacity(s.model.oil, 0.5 * (T + T_supply)).cp;
    if (!(flow > 0.0)) {
      return {Status::no_steady_state, "no oil leaves the bearing: its heat cannot be carried away",
              "", "check the supply"};
    }
    const double gap = T_supply + power / (flow * cp) - T;  // zero at the balance
    s.history.push_back({"lumped", std::abs(gap), f.viscous + f.asperity, s.film.least.h});
    if (control.progress)
      control.progress({"lumped", turn, std::abs(gap), f.viscous, s.film.least.h});
    if (std::abs(gap) < kSettled) return {};
    const double slope = turn == 0 ? -2.0 : (gap - before_gap) / (T - before_T);
    before_T = T;
    before_gap = gap;
    T -= gap / (slope < 0.0 ? slope : -1.0);
    if (T - T_supply > 400.0) {
      return {
          Status::no_steady_state,
          fmt::format("thermal runaway: the heat balance asks for {:.0f} degC", T - kZeroCelsius),
          "", "lower speed or load, or feed more oil"};
    }
  }
  return {Status::iteration_limit, "the heat balance did not settle", "", "try tier thd"};
}

Verdict solve_isothermal(Solution& s, bool warm, const SolveControl& control) {
  set_uniform_temperature(s, s.T_film);
  if (!warm) return start(s, s.T_film, control);
  return solve_equilibrium(s.model, s.target, {}, {}, s.film, s.cost, control.stop);
}

/// Film and walls at the temperature of the supply, from cold; `briefly`: or not at all.
Verdict start_resolved(Solution& s, bool briefly, const SolveControl& control) {
  const double T = s.model.input.supplies.front().temperature;
  s.film = cold_start(s.model, T);
  s.heat = cold_heat(s.model, T);
  return briefly ? start_at_once(s, T, control) : start(s, T, control);
}

/// How a grid of the ladder is begun.
struct Level {
  bool warm = false;               ///< from the state that is there; else from cold
  const NearPath* near = nullptr;  ///< path of a coarser grid
  bool in_vain = false;            ///< nothing was found on coarser grids: no long search
  double tolerance = 0.0;          ///< of the thermal loop; 0: its own
};

ThermalOptions thermal_options(const Level& level) {
  ThermalOptions options;
  options.tolerance = std::max(options.tolerance, level.tolerance);
  if (level.tolerance > 0.0) {  // a coarse grid is but a start
    options.close = false;
    options.most_newton = 400;
  }
  return options;
}

/// What is left where no path begins: the film of the supply's temperature, if there is one, and
/// heat settled on it with patience.
Verdict settle_patiently(Solution& s, const Verdict& film, const ThermalOptions& options,
                         const SolveControl& control) {
  if (!film.good()) return film;
  Verdict v = solve_thermal(s.model, s.target, options, control, s.film, s.heat, s.cost, s.history);
  const bool closed = s.film.least.h < 0.0 && s.model.scene.rough.sigma <= 0.0;
  if (v.status == Status::no_steady_state && !closed) {  // from one start alone: no proof
    v.status = Status::iteration_limit;
    v.reason =
        "no light load and no low speed was found under which film and heat come to rest; "
        "under the whole load: " +
        v.reason;
  }
  return v;
}

Verdict solve_resolved(Solution& s, const Level& level, const SolveControl& control) {
  ThermalOptions options = thermal_options(level);
  const auto settle = [&] {
    return solve_thermal(s.model, s.target, options, control, s.film, s.heat, s.cost, s.history);
  };
  const bool may_follow = !level.warm && s.target.unknowns > 0;
  options.patient = !may_follow;
  const Verdict film = level.warm ? Verdict{} : start_resolved(s, level.in_vain, control);
  const FilmEquilibrium first = s.film;
  Verdict v = film.good() ? settle() : film;
  if (v.good() || v.status == Status::interrupted || !may_follow) return v;
  options.patient = true;
  if (!level.in_vain) {
    const auto cold = [&](Solution& at) { return start_resolved(at, false, control); };
    if (const auto end = follow_heat(s, level.near, cold, options, control)) {
      // Not found with heat: what the film of the supply's temperature showed still stands.
      const bool open = end->status == Status::iteration_limit;
      return open && film.status == Status::no_steady_state ? film : *end;
    }
  }
  if (control.stop && control.stop->load()) {
    return {Status::interrupted, "stopped by the user", "", ""};
  }
  s.film = first;
  s.heat = cold_heat(s.model, s.model.input.supplies.front().temperature);
  return settle_patiently(s, film, options, control);
}

/// Solves on the model's grid, from the state that is there or from cold.
void solve_level(Solution& s, Tier tier, const Level& level, const SolveControl& control) {
  if (!level.warm) {
    s.film = cold_start(s.model, s.T_film);
    s.heat = {};
  }
  switch (tier) {
    case Tier::isothermal:
      s.verdict = solve_isothermal(s, level.warm, control);
      break;
    case Tier::lumped:
      s.verdict = solve_lumped(s, level.warm, control);
      break;
    case Tier::thd:
    case Tier::tehd:
      s.verdict = solve_resolved(s, level, control);
      break;
    case Tier::estimate:
    case Tier::automatic:
      EXPECTS(false);  // fidelity/ has turned these into one of the others
  }
  s.coefficients.reset();
  if (s.verdict.good() && s.model.input.model.coefficients) s.coefficients = coefficients_of(s);
}

/// True if film and heat were followed to an end so far below the load that no finer grid is needed
/// to tell that it is not carried.
bool ends_far_below(const Solution& s) {
  constexpr double kFarBelow = 0.6;  // grids differ by less in what they carry [-]
  const double part = s.followed.part;
  return s.verdict.status == Status::no_steady_state && part > 0.0 && part < kFarBelow;
}

/// Solves on every grid of the ladder, each from the one before. A coarse grid that fails is left
/// out; where the state of a coarse grid is no start for the next, that one starts from cold.
void climb(const Case& c, Tier tier, const SolveControl& control,
           std::shared_ptr<const Solids> solids, Solution& s) {
  constexpr double kCoarseTolerance = 3e-3;  // coarse grids only give the start of the next
  constexpr int kInVain = 2;                 // such grids after which finer ones are not searched
  const auto ladder = grid_ladder(c.model.grid);
  s.target = load_target(c);
  const double T_start = s.T_film;
  bool warm = false;
  int in_vain = 0;  // grids, one after the other, on which nothing was found
  std::string why;  // told by the last one that was searched
  for (std::size_t level = 0; level < ladder.size(); ++level) {
    const bool last = level + 1 == ladder.size();
    Level how{warm, nullptr, in_vain >= kInVain, last ? 0.0 : kCoarseTolerance};
    BearingModel model =
        make_bearing(c, physics_of(c, tier), ladder[level], last ? solids : nullptr);
    std::optional<NearPath> near;
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
                 (s.verdict.status == Status::no_steady_state && at_once))) {
      s.T_film = T_start;
      how.warm = false;
      solve_level(s, tier, how, control);
    }
    if (s.verdict.status == Status::interrupted || ends_far_below(s)) return;
    warm = s.verdict.good();
    const bool nothing = s.verdict.status == Status::iteration_limit && s.followed.part <= 0.0;
    if (nothing && how.in_vain) {
      s.verdict.reason += "; on coarser grids: " + why;
    } else {
      why = s.verdict.reason;
    }
    in_vain = nothing ? in_vain + 1 : 0;
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

constexpr int kMostNodes = 9;  ///< across the film, where they had to be raised

/// True if more nodes across the film may make of the failure a solution.
bool wants_nodes(const Solution& s) {
  const Model& by = s.model.input.model;
  return s.verdict.status == Status::iteration_limit && s.cost.unresolved > 0 &&
         by.methods.across == AcrossFilm::lobatto && by.film_nodes < kMostNodes;
}

/// What was spent before counts too.
void add(const EquilibriumCost& before, EquilibriumCost& cost) {
  cost.factorizations += before.factorizations;
  cost.newton_iterations += before.newton_iterations;
  cost.krylov_iterations += before.krylov_iterations;
  cost.fallback_steps += before.fallback_steps;
  cost.rejected_steps += before.rejected_steps;
}

}  // namespace

Solution solve_tier(const Case& c, Tier tier, const SolveControl& control,
                    std::shared_ptr<const Solids> solids) {
  const auto begin = std::chrono::steady_clock::now();
  Solution s = from_cold(c, tier, control, std::move(solids));
  Case finer = c;
  while (wants_nodes(s)) {
    const bool nothing = s.levels.empty() && s.followed.part <= 0.0;  // on no grid
    finer.model.film_nodes = nothing ? kMostNodes : finer.model.film_nodes + 2;
    Solution again = from_cold(finer, tier, control, s.model.solids);
    add(s.cost, again.cost);
    s = std::move(again);
    s.asked_nodes = c.model.film_nodes;
  }
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
