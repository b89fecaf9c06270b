#include "bearing/steady/compare.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/film/solve_equilibrium.hpp"
#include "bearing/friction_split.hpp"

namespace shellback::bearing {
namespace {

Torque torque_of(const Solution& s) {
  if (!s.verdict.good()) return {};
  const Friction f = friction_of(s.model, s.point, s.film);
  return {f.viscous, f.asperity};
}

double oil_mean(const Solution& full) {
  return summarize(full, full.model.input.model.tier).value("T_film_mean");
}

/// Rigid, at given temperatures and thermal deformation taken from the full solution.
Torque rigid_with_heat_of(const Solution& full, bool thermal_deformation,
                          const SolveControl& control) {
  const Case& c = full.model.input;
  Physics physics = full.model.physics;
  physics.elastic = physics.film_energy = physics.thermal_deformation = false;
  Solution s;
  s.model = make_bearing(c, physics, c.model.grid);
  s.model.gl = full.model.gl;  // on which its temperatures stand
  s.point = operating_point(s.model);
  s.film = full.film;
  s.film.elastic.clear();
  const Field& gap_widening = thermal_deformation ? full.heat.thermal_deformation : Field{};
  s.verdict = solve_equilibrium({s.model, s.point, gap_widening, {}, control.stop}, s.film, s.cost);
  if (!s.verdict.good()) {  // the deformed film is no start for the rigid one: begin anew
    const auto T = full.film.columns.T;
    s.film = cold_start(s.model, s.point, oil_mean(full));
    s.film.columns.T = T;
    s.verdict =
        solve_equilibrium({s.model, s.point, gap_widening, {}, control.stop}, s.film, s.cost);
  }
  return torque_of(s);
}

void split_friction(const Solution& isothermal, const Solution& full, const SolveControl& control,
                    FrictionSplit& split) {
  const Torque start = torque_of(isothermal);
  const Torque end = torque_of(full);
  split.from = start.total();
  split.to = end.total();
  // The case's own switches apply to the isothermal film as well: if it is elastic there, all
  // steps are, and "elasticity" has no part.
  const Torque level = torque_of(solve_isothermal_at(full.model.input, oil_mean(full), control));
  const bool elastic_step = full.model.physics.elastic && !isothermal.model.physics.elastic;
  const bool rigid_steps = elastic_step || !full.model.physics.elastic;
  if (!rigid_steps) {
    split.steps = {{"viscosity level", level.viscous - start.viscous},
                   {"viscosity variation and clearance", end.viscous - level.viscous}};
    close_split(start, end, split);
    return;
  }
  const Torque variation = rigid_with_heat_of(full, false, control);
  const Torque clearance =
      full.model.physics.thermal_deformation ? rigid_with_heat_of(full, true, control) : variation;
  split.steps = {{"viscosity level", level.viscous - start.viscous},
                 {"viscosity variation", variation.viscous - level.viscous},
                 {"clearance", clearance.viscous - variation.viscous},
                 {"elasticity", end.viscous - clearance.viscous}};
  close_split(start, end, split);
}

/// The film temperature at which the isothermal torque is `wanted`. Warm-started from T to T.
Calibration calibrate_film(const Case& c, double wanted, double guess,
                           const SolveControl& control) {
  constexpr double kTolerance = 1e-4;  // [K]
  Solution s = solve_isothermal_at(c, guess, control);
  if (!s.verdict.good()) return {};
  const auto torque = [&](double T) {
    std::fill(s.film.columns.T.begin(), s.film.columns.T.end(), T);
    FilmEquilibrium trial = s.film;
    EquilibriumOptions loose;
    loose.load_tolerance = 1e-7;
    const Verdict v = solve_equilibrium({s.model, s.point, {}, loose, control.stop}, trial, s.cost);
    if (!v.good()) return static_cast<double>(NAN);
    s.film = trial;
    return friction_of(s.model, s.point, trial).torque();
  };
  return calibrate(torque, wanted, guess, {0.0, kTolerance});
}

}  // namespace

Comparison compare(const Case& c, const std::vector<Tier>& tiers, const SolveControl& control,
                   const SumUp& sum_up) {
  Comparison out;
  std::optional<Solution> isothermal, full;
  for (const Tier tier : tiers) {
    Case one = c;
    one.model.tier = tier;
    Solution s = solve_tier(one, tier, control);
    out.results.push_back(sum_up(s, tier));
    const bool good = s.verdict.good();
    const bool interrupted = s.verdict.status == Status::interrupted;
    if (good && tier == Tier::isothermal)
      isothermal = std::move(s);
    else if (good && s.model.physics.film_energy)
      full = std::move(s);
    if (interrupted) return out;  // what is finished is kept
  }
  if (isothermal && full) {
    split_friction(*isothermal, *full, control, out.split);
    out.calibration = calibrate_film(c, out.split.to, oil_mean(*full), control);
  }
  return out;
}

}  // namespace shellback::bearing
