/// How the failures of a turn are judged.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/largest.hpp"
#include "coupling/coldest.hpp"
#include "coupling/thermal_turn.hpp"
#include "coupling/told_temperature.hpp"
#include "fluid/film_numbers.hpp"
#include "rheology/laws_hold.hpp"

namespace shellback::coupling {

bool ThermalTurn::finite() {
  const int nodes = model_.gl.n;
  for (const auto& found : {find_not_a_number(FieldName::film_temperature, film_.columns.T, nodes),
                            find_not_a_number(FieldName::thermal_growth, heat_.growth)}) {
    if (!found) continue;
    verdict_ = fluid::ended_by(model_.scene.grid, *found);
    return false;
  }
  return true;
}

bool ThermalTurn::sound() {
  if (!finite()) return false;
  const auto lowest = std::min_element(film_.columns.T.begin(), film_.columns.T.end());
  const double high = largest(film_.columns.T);
  if (!rheology::laws_hold(model_.oil, *lowest)) {  // extrapolated there, not cooled
    verdict_ = beyond_laws(static_cast<int>(lowest - film_.columns.T.begin()));
    return false;
  }
  const double T_supply = model_.input.supplies.front().temperature;
  if (high - T_supply < options_.runaway) return true;
  verdict_ = runaway(told_rise(high, T_supply) + " and rises");
  return false;
}

Verdict ThermalTurn::beyond_laws(int node) const {
  return {Status::iteration_limit,
          fmt::format("film and heat did not settle: on the way a temperature of {} came up, at "
                      "which the laws of the oil do not hold",
                      told_temperature(film_.columns.T[node])),
          fluid::place_of(model_.scene.grid, node / model_.gl.n),
          "try a finer grid or a tighter range of operation"};
}

std::string ThermalTurn::seizure() const {
  constexpr double kMost = 0.5;  // of the clearance that growth has taken: it seizes [-]
  if (heat_.growth.empty()) return "";
  double sum = 0.0;
  for (const double d : heat_.growth) sum -= d;
  const double taken = sum / static_cast<double>(heat_.growth.size());
  if (!(taken > kMost * model_.clearance)) return "";
  return fmt::format(
      "; the clearance is used up by thermal growth, which takes {:.3g} um of {:.3g} um on average",
      taken * 1e6, model_.clearance * 1e6);
}

Verdict ThermalTurn::runaway(const std::string& what) const {
  const auto hottest = std::max_element(film_.columns.T.begin(), film_.columns.T.end());
  const int cell = static_cast<int>(hottest - film_.columns.T.begin()) / model_.gl.n;
  return {Status::no_steady_state, "thermal runaway: " + what + seizure(),
          fluid::place_of(model_.scene.grid, cell),
          "lower speed or load, feed more or cooler oil, or improve the cooling of the shell"};
}

Verdict ThermalTurn::friction_runaway(double from, double to) const {
  return runaway(
      fmt::format("followed in small steps, the friction torque rose from {:.3g} to {:.3g} N m "
                  "without coming to rest: heat thins the film, or makes the shell bulge, faster "
                  "than it flows off",
                  from, to));
}

void ThermalTurn::name_the_failure() {
  constexpr double kLost = 3.0;  // |ln| of the change of viscosity from which heat is the cause [-]
  if (verdict_.status != Status::iteration_limit) return;
  const double lost = viscosity_change(model_, film_);
  if (!(lost > kLost)) return;
  const double T0 = model_.input.supplies.front().temperature;
  const double T = largest(film_.columns.T);
  verdict_ =
      runaway(fmt::format("{}, its viscosity is {:.1e} times that of the supplied oil, and no "
                          "film is found any more",
                          told_rise(T, T0), std::exp(-lost)));
}

Verdict ThermalTurn::second_law() const {
  constexpr double kRipple = 0.5;  // of the rise: beyond it is no ripple of the polynomials [-]
  constexpr double kMargin = 2.0;  // [K]
  const auto& T = film_.columns.T;
  const auto [low, high] = std::minmax_element(T.begin(), T.end());
  const double coldest = coldest_around(model_);
  if (*low >= coldest - kMargin - kRipple * (*high - coldest)) return {};
  const int cell = static_cast<int>(low - T.begin()) / model_.gl.n;
  return {Status::iteration_limit,
          "the film temperature falls to " + told_temperature(*low) +
              ", below everything around it: the grid does not resolve the heat of the film there",
          fluid::place_of(model_.scene.grid, cell),
          "a finer grid, more model.film_nodes, or methods.across = \"layers\""};
}

double viscosity_change(const BearingModel& model, const FilmEquilibrium& film) {
  const double T0 = model.input.supplies.front().temperature;
  const double T = largest(film.columns.T);
  const double hot = rheology::viscosity(model.oil, T, 0.0);
  return std::abs(std::log(rheology::viscosity(model.oil, T0, 0.0) / hot));
}

}  // namespace shellback::coupling
