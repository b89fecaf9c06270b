#include "coupling/thermal_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "coupling/thermal_turn.hpp"

namespace shellback::coupling {
namespace {

constexpr double kSettled = 1e-9;  ///< change per sweep that leaves the balance near round-off [K]
constexpr double kRoughlySettled = 1e-3;  ///< the same where the balance need not close [K]

}  // namespace

FixedPointEnd ThermalTurn::creep(const FixedPointOptions& fixed) {
  constexpr double kStep = 0.3;     // of the way to the map's value
  constexpr double kNear = 0.05;    // change per turn from which acceleration is tried again
  constexpr double kRisen = 1.1;    // friction over that of the best state: it has risen [-]
  constexpr double kRunaway = 1.5;  // the same: it rises for good [-]
  const double before = best_.torque;
  film_ = best_.film;
  heat_ = best_.heat;
  turn_T_ = best_.T;
  turn_growth_ = best_.growth;
  std::vector<double> x = pack();
  std::vector<double> g;
  double near = kNear;
  for (int k = 0; k < fixed.max_iterations; ++k) {
    if (!(*this)(x, g)) {
      if (verdict_.status != Status::iteration_limit) return FixedPointEnd::map_failed;
      if (heated() && torque() > kRisen * before) verdict_ = friction_runaway(before, torque());
      return FixedPointEnd::map_failed;
    }
    const double now = torque();
    const bool spent = cost_.newton_iterations - newton_before_ > options_.most_newton;
    if (spent && !(heated() && now > kRisen * before)) return FixedPointEnd::iteration_limit;
    if ((spent || now > kRunaway * before) && heated() && heat_.residual > kNear) {
      verdict_ = friction_runaway(before, now);
      return FixedPointEnd::map_failed;
    }
    for (std::size_t c = 0; c < x.size(); ++c) x[c] += kStep * (g[c] - x[c]);
    if (heat_.residual > near) continue;
    std::vector<double> y = x;
    FixedPointOptions again = fixed;
    again.max_iterations = std::max(10, fixed.max_iterations / 2);
    if (fixed_point(std::ref(*this), again, y) == FixedPointEnd::converged) {
      return FixedPointEnd::converged;
    }
    near *= 0.1;
    film_ = best_.film;
    heat_ = best_.heat;
    turn_T_ = best_.T;
    turn_growth_ = best_.growth;
    x = pack();
  }
  return FixedPointEnd::iteration_limit;
}

void ThermalTurn::finish(bool converged) {
  constexpr int kMostSweeps = 400;
  constexpr int kMostRounds = 60;
  constexpr double kWalls = 1e-7;      // change per round that leaves their heat balanced [K]
  constexpr double kUnbalanced = 0.1;  // change that the walls must not be left with [K]
  const std::vector<double> after = film_.columns.T;
  film_.columns.T = turn_T_;
  EquilibriumOptions film = options_.film;
  film.follow_load = film.follow_load && converged;
  verdict_ = solve_equilibrium(model_, target_, turn_growth_, film, film_, cost_, control_.stop);
  film_.columns.T = after;
  thermal::FilmEnergy energy = film_energy();
  const double change = options_.close ? balance_walls(energy, kWalls, kMostRounds) : 0.0;
  const double settled = options_.close ? kSettled : kRoughlySettled;
  for (int k = 0; k < kMostSweeps; ++k) {
    if (energy.sweep(film_.columns.T) < settled) break;
  }
  warm_the_walls(energy, {true, true});
  heat_.growth = turn_growth_;  // that of the film
  heat_.balance = energy.balance(film_.columns.T);
  heat_.T_mix = energy.mix_temperatures();
  heat_.backflow_nodes = energy.backflow_nodes();
  heat_.blended_columns = energy.blended_columns();
  if (verdict_.good()) verdict_ = second_law();
  if (verdict_.good() && !(change < kUnbalanced)) {
    verdict_ = {Status::iteration_limit,
                fmt::format("film and walls do not come to balance (last change {:.2g} K)", change),
                "", "try a finer grid or another cooling of shell and shaft"};
  }
}

HeatState cold_heat(const BearingModel& model, double T) {
  HeatState h;
  const FilmGrid& g = model.scene.grid;
  if (model.physics.growth) h.growth.assign(g.cells(), 0.0);
  h.T_shell.assign(g.cells(), T);
  h.T_shaft.assign(g.nz, T);
  return h;
}

Verdict solve_thermal(const BearingModel& model, const LoadTarget& target,
                      const ThermalOptions& options, const SolveControl& control,
                      FilmEquilibrium& film, HeatState& heat, EquilibriumCost& cost,
                      std::vector<HistoryEntry>& history) {
  ThermalTurn turn(model, target, options, control, film, heat, cost, history);
  turn.take_contact_growth();
  std::vector<double> x = turn.pack();
  constexpr double kSlack = 10.0;  // of the change, where it is seen to fall fast [-]
  const FixedPointOptions fixed{options.anderson_depth, 1, options.max_turns, options.tolerance,
                                kSlack};
  const auto at_rest = [&turn](FixedPointEnd e) {
    return e == FixedPointEnd::converged && turn.limited() ? FixedPointEnd::iteration_limit : e;
  };
  FixedPointEnd end = at_rest(fixed_point(std::ref(turn), fixed, x));
  if (end != FixedPointEnd::converged && options.patient && turn.may_go_on())
    end = at_rest(turn.creep(fixed));
  if (end == FixedPointEnd::map_failed && !turn.verdict().good()) {
    turn.give_contact_growth();
    return turn.verdict();
  }
  if (end == FixedPointEnd::converged) turn.take_last_value();
  const bool converged = end == FixedPointEnd::converged;
  if (converged || options.patient) turn.finish(converged);
  turn.give_contact_growth();
  if (end == FixedPointEnd::converged) return turn.verdict();
  return {Status::iteration_limit,
          fmt::format("film and heat did not settle in {} turns (last change {:.1e} of 10 K)",
                      turn.turns(), heat.residual),
          fluid::place_of(model.scene.grid, 0), "try a finer grid or a tighter range of operation"};
}

}  // namespace shellback::coupling
