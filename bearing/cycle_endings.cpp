#include "bearing/cycle_endings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bearing/told_temperature.hpp"
#include "core/constants.hpp"

namespace shellback::bearing {

void Closure::add(double difference) {
  before = last;
  last = difference;
}

bool Closure::closed() const {
  constexpr double kEnough = 1e-4;   // of smallest film and torque
  constexpr double kSlowest = 0.99;  // slower is not seen from noise
  const double rho = std::isfinite(before) ? std::min(last / before, kSlowest) : 0.0;
  return last * std::max(1.0, rho / (1.0 - rho)) <= kEnough;
}

Verdict not_closed(int cycles, double closure) {
  return {Status::iteration_limit,
          fmt::format("after {} cycles two of them still differ by {:.1e} in smallest film or "
                      "torque (1e-4 is asked for)",
                      cycles, closure),
          "",
          "repeat the load several times in a longer period (oil of a starved film gathers over "
          "more than 40 short ones), or look at the orbit: it may repeat itself over several "
          "periods, as journals that whirl do"};
}

Verdict walls_not_found(int cycles, double change) {
  return {Status::iteration_limit,
          fmt::format("after {} cycles the walls still change by {:.2g} K from one to the next",
                      cycles, change),
          "", "a finer grid, a lower load, or tier isothermal"};
}

Verdict at_instant(Verdict v, double t, double crank_speed) {
  const std::string when = crank_speed > 0.0
                               ? fmt::format("{:.4g} deg", t * crank_speed * 180.0 / kPi)
                               : fmt::format("{:.4g} s", t);
  const bool defect = v.status == Status::invalid_number;  // to be reported, nothing physical
  if (v.status == Status::interrupted || defect) return v;
  v.status = Status::iteration_limit;
  v.reason = fmt::format("no step in time is found at {} of the cycle: {}", when, v.reason);
  v.cure =
      "give load_cycle.journal_mass (a journal without mass may have to leap), elastic "
      "deformation, a lower load, or a finer grid";
  return v;
}

Verdict no_clearance(double thermal_deformation, double clearance) {
  return {Status::iteration_limit,
          fmt::format("the walls that were tried leave the film no room: thermal deformation has "
                      "taken {:.3g} um on the mean of a clearance of {:.3g} um",
                      -1e6 * thermal_deformation, 1e6 * clearance),
          "", "more clearance, less speed or load, or better cooling"};
}

Verdict no_lumped_balance(double hottest) {
  return {Status::iteration_limit,
          fmt::format("from the supply's temperature to {} the oil of a mean cycle does not carry "
                      "off the heat that it makes",
                      told_temperature(hottest)),
          "", "feed more or cooler oil, lower speed or load, or take tier thd"};
}

}  // namespace shellback::bearing
