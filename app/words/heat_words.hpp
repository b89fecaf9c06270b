#pragma once
/// Endings of film and heat, steady and over time.
#include <fmt/format.h>

#include <cmath>

#include "app/words/temperature_words.hpp"
#include "app/words/told.hpp"

namespace shellback::app::told {

inline constexpr const char* kFit =
    "a larger bearing.radial_clearance, or the temperature at which it was measured "
    "(bearing.reference_temperature), or a housing that may give way (shell.housing.support)";

inline std::string told_without_clearance(const ending::NoClearance& e) {
  if (e.at == ending::NoClearance::At::start) {
    return fmt::format(
        "thermal deformation closes the bearing before it turns: with shell and shaft at {}, from "
        "where they start, {:.3g} um on the mean of a clearance of {:.3g} um are gone",
        told_temperature(e.T), -1e6 * e.deformation, 1e6 * e.clearance);
  }
  const bool coldest = e.at == ending::NoClearance::At::coldest;
  return fmt::format(
      "thermal deformation {} the bearing before it turns: with everything at {}, "
      "the {} temperature around it, {:.3g} um on the mean of a clearance of "
      "{:.3g} um are gone",
      coldest ? "closes" : "may close", told_temperature(e.T), coldest ? "coldest" : "warmest",
      -1e6 * e.deformation, 1e6 * e.clearance);
}

inline Told told(const ending::AtTemperature& e, const About&) {
  const double degC = e.T - kZeroCelsius;
  switch (e.what) {
    case ending::Thermal::oil_laws:
      return {fmt::format("film and heat did not settle: on the way a temperature of {} came up, "
                          "at which the laws of the oil do not hold",
                          told_temperature(e.T)),
              kFinerElseTighter};
    case ending::Thermal::too_cold:
      return {fmt::format("the film temperature falls to {}, below everything around it: the grid "
                          "does not resolve the heat of the film there",
                          told_temperature(e.T)),
              "a finer grid, more model.film_nodes, or methods.across = \"layers\""};
    case ending::Thermal::unstable_root:
      return {fmt::format("the heat balance is met at {:.1f} degC alone, where it is unstable: a "
                          "film that is a little warmer makes more heat than leaves",
                          degC),
              "lower speed or load, or feed more oil"};
    case ending::Thermal::unsettled_root:
      return {fmt::format("the heat balance did not settle at {:.1f} degC", degC), "try tier thd"};
    case ending::Thermal::unbalanced_cycle:
      return {fmt::format("from the supply's temperature to {} the oil of a mean cycle does not "
                          "carry off the heat that it makes",
                          told_temperature(e.T)),
              "feed more or cooler oil, lower speed or load, or take tier thd"};
  }
  return {};
}

inline Told told(const ending::FilmTooHot& e, const About&) {
  return {"film and heat did not settle: " + told_rise(e.T, e.T_supply) + " and rises", kLessHeat};
}

inline Told told(const ending::NoHeatBalance& e, const About& a) {
  const double sign = e.surplus_low < 0.0 ? -1.0 : 1.0;
  const bool film_ends = std::isfinite(e.T_none);
  const bool runaway = sign > 0.0 && a.verdict.status == Status::no_steady_state;
  std::string reason = fmt::format(
      "{}from {:.1f} to {:.1f} degC the film makes {} heat than its oil carries off, by {:.3g} W "
      "at the one end and {:.3g} W at the other",
      runaway ? "thermal runaway: " : "", e.T_low - kZeroCelsius, e.T_high - kZeroCelsius,
      sign > 0.0 ? "more" : "less", sign * e.surplus_low, sign * e.surplus_high);
  if (film_ends) {
    reason += fmt::format("; at {:.1f} degC there is no film: {}", e.T_none - kZeroCelsius,
                          a.within.reason);
  }
  return {reason, "lower speed or load, or feed more or cooler oil"};
}

inline Told told(const ending::NoClearance& e, const About&) {
  if (e.at != ending::NoClearance::At::tried)
    return {told_without_clearance(e) + "; no state of film and heat was found", kFit};
  return {fmt::format("the walls that were tried leave the film no room: thermal deformation has "
                      "taken {:.3g} um on the mean of a clearance of {:.3g} um",
                      -1e6 * e.deformation, 1e6 * e.clearance),
          "more clearance, less speed or load, or better cooling"};
}

inline Told told(const ending::UnstableOrbit& e, const About&) {
  using Elsewhere = ending::UnstableOrbit::Elsewhere;
  const auto cells = [](std::array<int, 2> grid) {
    return fmt::format("{} x {} cells", grid[0], grid[1]);
  };
  const std::string departs = fmt::format(
      "on {} a journal that is off the orbit that repeats itself departs from it by "
      "{:.2g} % more with every cycle (whirl)",
      cells(e.grid), 100.0 * (e.growth - 1.0));
  const char* cure =
      "a lighter journal, more load or another bore; the same load as a single event over many "
      "turns (without period) shows where the journal goes";
  if (e.elsewhere == Elsewhere::departs) {
    return {fmt::format("no journal keeps to its orbit: {}, and so does one that is a tenth "
                        "heavier on {}",
                        departs, cells(e.other)),
            cure};
  }
  const char* elsewhere = "";
  switch (e.elsewhere) {
    case Elsewhere::not_looked:
    case Elsewhere::departs:
      break;
    case Elsewhere::no_orbit:
      elsewhere = ", and for one that is a tenth heavier no orbit was found on ";
      break;
    case Elsewhere::not_judged:
      elsewhere = ", and whether one that is a tenth heavier does so could not be seen on ";
      break;
    case Elsewhere::keeps_to_it:
      elsewhere = ", and one that is a tenth heavier keeps to its orbit on ";
      break;
  }
  return {fmt::format("not resolved: {}{}", departs,
                      *elsewhere != 0 ? elsewhere + cells(e.other)
                                      : "; it was not looked at on another grid"),
          std::string("a finer grid (it moves the threshold of whirl); else ") + cure};
}

inline Told told(const ending::NoStep& e, const About& a) {
  const std::string when = e.crank_speed > 0.0
                               ? fmt::format("{:.4g} deg", e.t * e.crank_speed * 180.0 / kPi)
                               : fmt::format("{:.4g} s", e.t);
  if (e.estimated) {
    return {fmt::format("the journal's path ends at {} of the cycle: {}", when, a.within.reason),
            "a lower load, a shorter time under it, or rough surfaces with contact data; tier "
            "isothermal or tehd has what the estimate leaves out"};
  }
  std::string cure = a.within.cure;
  const auto add = [&cure](const char* more) {
    cure += (cure.empty() ? "" : "; or ") + std::string(more);
  };
  const auto tells = [&cure](const char* words) { return cure.find(words) != std::string::npos; };
  if (!tells("load")) add("a lower load");
  if (!tells("finer grid")) add("a finer grid");
  if (e.massless)
    add("the journal's mass: without one it may have to leap (load_cycle.journal_mass)");
  if (e.rigid && !tells("elastic")) {
    add("elastic surfaces: rigid ones may not carry the load (model.elastic_deformation)");
  }
  return {fmt::format("no step in time is found at {} of the cycle: {}", when, a.within.reason),
          cure};
}

/// Stopped by the user, with steps too short, or without a film in the state of wear that it has
/// come to.
inline Told told(const ending::RunningInEnded& e, const About& a) {
  if (e.over > 0.0) {
    return {fmt::format("the steps of running-in became too short after {:.4g} s: they err by "
                        "{:.3g} times what is allowed, however short",
                        e.t, e.over),
            "end it before (running_in.until)"};
  }
  if (a.verdict.cause.empty()) {
    return {fmt::format("stopped by the user after {:.4g} s of running-in", e.t), ""};
  }
  return {fmt::format("no film of the worn bearing is found after {:.4g} s of running-in: {}", e.t,
                      a.within.reason),
          a.within.cure};
}

}  // namespace shellback::app::told
