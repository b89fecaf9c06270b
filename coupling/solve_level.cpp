#include "coupling/solve_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "rheology/density.hpp"
#include "rheology/heat.hpp"

namespace shellback::coupling {
namespace {

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
                    ? first_film(s, T, Search::long_way, control)
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
      control.progress({"lumped", turn, std::abs(gap), f.viscous + f.asperity, s.film.least.h});
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
  if (!warm) return first_film(s, s.T_film, Search::long_way, control);
  return solve_equilibrium(s.model, s.target, {}, {}, s.film, s.cost, control.stop);
}

/// Film and walls at the temperature of the supply, from cold.
Verdict start_resolved(Solution& s, Search search, const SolveControl& control) {
  const double T = s.model.input.supplies.front().temperature;
  s.film = cold_start(s.model, T);
  s.heat = cold_heat(s.model, T);
  return first_film(s, T, search, control);
}

ThermalOptions thermal_options(const Level& level) {
  ThermalOptions options;
  options.tolerance = std::max(options.tolerance, level.tolerance);
  if (level.tolerance > 0.0) {  // a coarse grid is but a start
    options.close = false;
    options.most_newton = 400;
  }
  return options;
}

/// What one start alone shows of heat: no proof, unless smooth surfaces touch.
Verdict without_proof(const Solution& s, Verdict v) {
  const bool closed = s.film.least.h < 0.0 && s.model.scene.rough.sigma <= 0.0;
  if (v.status != Status::no_steady_state || closed) return v;
  v.status = Status::iteration_limit;
  v.reason =
      "no light load and no low speed was found under which film and heat come to rest; "
      "under the whole load: " +
      v.reason;
  return v;
}

/// What is left where no path begins: the film of the supply's temperature, if there is one, and
/// heat settled on it with patience.
Verdict settle_patiently(Solution& s, const Verdict& film, const ThermalOptions& options,
                         const SolveControl& control) {
  if (!film.good()) return film;
  return without_proof(
      s, solve_thermal(s.model, s.target, options, control, s.film, s.heat, s.cost, s.history));
}

Verdict solve_resolved(Solution& s, const Level& level, const SolveControl& control) {
  ThermalOptions options = thermal_options(level);
  const auto settle = [&] {
    return solve_thermal(s.model, s.target, options, control, s.film, s.heat, s.cost, s.history);
  };
  const bool may_follow = !level.warm;
  const bool given = s.target.unknowns == 0;  // no position to run away to
  options.patient = !may_follow || given;
  const Verdict film = level.warm ? Verdict{} : start_resolved(s, level.search, control);
  const FilmEquilibrium first = s.film;
  const Verdict v = film.good() ? settle() : film;
  if (v.good() || v.status == Status::interrupted || !may_follow) return v;
  const FilmEquilibrium tried = s.film;
  const HeatState tried_heat = s.heat;
  options.patient = true;
  const bool none_cold = film.status == Status::no_steady_state;  // heated oil may still have one
  if (level.search == Search::long_way || none_cold) {
    const auto cold = [&](Solution& at) { return start_resolved(at, Search::long_way, control); };
    if (const auto end = follow_heat(s, level.near, cold, options, control)) {
      s.followed.proven = end->status == Status::no_steady_state;
      // Not found with heat: a load that cold oil does not carry, warm oil does not either. At a
      // given position it may, and what one start shows of heat is no proof.
      const bool open = end->status == Status::iteration_limit;
      return open && none_cold && !given ? film : *end;
    }
  }
  if (control.stop && control.stop->load()) {
    return {Status::interrupted, "stopped by the user", "", ""};
  }
  s.film = given ? tried : first;
  s.heat = given ? tried_heat : cold_heat(s.model, s.model.input.supplies.front().temperature);
  return given ? without_proof(s, v) : settle_patiently(s, film, options, control);
}

}  // namespace

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

}  // namespace shellback::coupling
