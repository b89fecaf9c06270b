#include "coupling/solve_level.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "coupling/lumped.hpp"

namespace shellback::coupling {
namespace {

void set_uniform_temperature(Solution& s, double T) {
  std::fill(s.film.columns.T.begin(), s.film.columns.T.end(), T);
  s.T_film = T;
}

Verdict solve_isothermal(Solution& s, bool warm, const SolveControl& control) {
  set_uniform_temperature(s, s.T_film);
  if (!warm) return first_film(s, s.T_film, control);
  return solve_equilibrium(s.model, s.target, {}, {}, s.film, s.cost, control.stop);
}

/// Film and walls at the temperature of the supply, from cold.
Verdict start_resolved(Solution& s, const SolveControl& control) {
  const double T = s.model.input.supplies.front().temperature;
  s.film = cold_start(s.model, T);
  s.heat = cold_heat(s.model, T);
  return first_film(s, T, control);
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
  const Verdict film = level.warm ? Verdict{} : start_resolved(s, control);
  const FilmEquilibrium first = s.film;
  const Verdict v = film.good() ? settle() : film;
  if (v.good() || v.status == Status::interrupted || !may_follow) return v;
  const FilmEquilibrium tried = s.film;
  const HeatState tried_heat = s.heat;
  options.patient = true;
  const bool none_cold = film.status == Status::no_steady_state;  // heated oil may still have one
  const auto cold = [&](Solution& at) { return start_resolved(at, control); };
  if (const auto end = follow_heat(s, level.near, cold, options, control)) {
    s.followed.proven = end->status == Status::no_steady_state;
    // Not found with heat: a load that cold oil does not carry, warm oil does not either. At a
    // given position it may, and what one start shows of heat is no proof.
    const bool open = end->status == Status::iteration_limit;
    return open && none_cold && !given ? film : *end;
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
    s.heat_roots.clear();
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
