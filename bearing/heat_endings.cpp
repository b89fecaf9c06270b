#include "bearing/heat_endings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bearing/told_temperature.hpp"
#include "core/largest.hpp"
#include "fluid/film_numbers.hpp"
#include "rheology/laws_hold.hpp"

namespace shellback::bearing {

Verdict fields_finite(const Solution& s) {
  for (const auto& found :
       {find_not_a_number(FieldName::film_temperature, s.film.columns.T, s.model.gl.n),
        find_not_a_number(FieldName::thermal_deformation, s.heat.thermal_deformation)}) {
    if (found) return fluid::ended_by(s.model.scene.grid, *found);
  }
  return {};
}

Verdict temperatures_possible(const Solution& s) {
  if (Verdict v = fields_finite(s); !v.good()) return v;
  const auto& T = s.film.columns.T;
  const auto [low, high] = std::minmax_element(T.begin(), T.end());
  const double T_supply = s.model.input.supplies.front().temperature;
  const auto place = [&](auto node) {
    return fluid::place_of(s.model.scene.grid, static_cast<int>(node - T.begin()) / s.model.gl.n);
  };
  if (!rheology::laws_hold(s.model.oil, *low)) {
    return {Status::iteration_limit,
            fmt::format("film and heat did not settle: on the way a temperature of {} came up, at "
                        "which the laws of the oil do not hold",
                        told_temperature(*low)),
            place(low), "try a finer grid or a tighter range of operation"};
  }
  if (*high - T_supply > kHottestRise) {
    return {Status::iteration_limit,
            "film and heat did not settle: " + told_rise(*high, T_supply) + " and rises",
            place(high),
            "lower speed or load, feed more or cooler oil, or improve the cooling of the shell"};
  }
  return {};
}

double coldest_around(const BearingModel& model) {
  double coldest = model.solids->surroundings();
  for (const Supply& supply : model.input.supplies) coldest = std::min(coldest, supply.temperature);
  const auto& shaft = model.input.shaft;
  if (shaft && shaft->overhang > 0.0) coldest = std::min(coldest, shaft->ambient);
  return coldest;
}

Verdict colder_than_all_around(const Solution& s) {
  constexpr double kRipple = 0.5;  // of the rise: beyond it is no ripple of the polynomials [-]
  constexpr double kMargin = 2.0;  // [K]
  const auto& T = s.film.columns.T;
  const auto [low, high] = std::minmax_element(T.begin(), T.end());
  const double coldest = coldest_around(s.model);
  if (*low >= coldest - kMargin - kRipple * (*high - coldest)) return {};
  return {Status::iteration_limit,
          "the film temperature falls to " + told_temperature(*low) +
              ", below everything around it: the grid does not resolve the heat of the film there",
          fluid::place_of(s.model.scene.grid, static_cast<int>(low - T.begin()) / s.model.gl.n),
          "a finer grid, more model.film_nodes, or methods.across = \"layers\""};
}

Verdict walls_unbalanced(double change) {
  constexpr double kUnbalanced = 0.1;  // change that the walls must not be left with [K]
  if (change < kUnbalanced) return {};
  return {Status::iteration_limit,
          fmt::format("film and walls do not come to balance (last change {:.2g} K)", change), "",
          "try a finer grid or another cooling of shell and shaft"};
}

Verdict heat_unsettled(int iterations, double residual) {
  return {Status::iteration_limit,
          fmt::format("film and heat did not settle in {} iterations (last change {:.1e} of 10 K)",
                      iterations, residual),
          "", "try a finer grid or a tighter range of operation"};
}

}  // namespace shellback::bearing
