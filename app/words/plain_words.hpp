#pragma once
/// Endings without data, and iterations that did not settle, of every subject.
#include <fmt/format.h>

#include <cmath>

#include "app/words/told.hpp"

namespace shellback::app::told {

inline constexpr const char* kOutOfTheLaw =
    "between rigid surfaces, with viscosity that rises as exp(alpha p), no pressure in what oil "
    "there is carries the load of that instant (the reduced pressure q = (1 - exp(-alpha p))/alpha "
    "cannot exceed 1/alpha)";

inline constexpr const char* kNoPressure =
    "the film has no steady pressure at this gap: with the pressure-viscosity law chosen, the "
    "reduced pressure would have to exceed its bound 1/alpha (q = (1 - exp(-alpha p))/alpha)";

inline constexpr const char* kNoLightState =
    "no light load, no low supply pressure and no low speed was found under which film and heat "
    "have a common state";

/// Of branches that were sought and not found, or not followed.
inline Told told_of_branch(ending::Plain e, const Told& within) {
  using ending::Plain;
  const std::string of_cool_oil =
      within.reason.empty()
          ? ""
          : fmt::format(" (with oil of the supply's temperature throughout: {})", within.reason);
  switch (e) {
    case Plain::no_light_state:
      return {kNoLightState + of_cool_oil,
              "another grid, finer or coarser, or a nearby operating point first"};
    case Plain::no_slow_state:
      return {
          "at the journal's given place no low supply pressure and no low speed was found at which "
          "film and heat have a common state" +
              of_cool_oil,
          "a smaller eccentricity ratio or tilt, or another grid"};
    case Plain::endless_branch:
      return {"states were found one after the other, and the load has hardly risen",
              kFinerElseTighter};
    case Plain::strayed:
      return {"what was found next to the last state does not continue it", kFinerElseTighter};
    case Plain::layer_may_flow:
      return {within.reason +
                  "; where its elasto-plastic layer is to flow, a steady state is often not found",
              "a load cycle, or an event ([load_cycle]) with a load that stands, shows how the "
              "layer settles; else " +
                  within.cure};
    default:
      return {};
  }
}

/// Of heat that is not carried away, and of temperatures that were not found.
inline Told told_of_heat(ending::Plain e) {
  using ending::Plain;
  switch (e) {
    case Plain::no_oil_leaves:
      return {"no oil is fed that leaves the bearing: its heat cannot be carried away",
              "check the supply"};
    case Plain::no_oil_over_event:
      return {
          "no oil is fed over the event that leaves the bearing, and in one temperature of the "
          "film nothing else takes up its heat",
          "take tier thd, in which walls do"};
    case Plain::estimate_unbalanced:
      return {"the estimate finds no film temperature at which the friction heat is carried away",
              "lower speed or load, feed more oil, or ask a tier that resolves the heat"};
    case Plain::film_unsettled:
      return {"the film's temperatures did not settle", kFinerElseIsothermal};
    case Plain::film_impossible:
      return {"a film temperature leaves what an oil can be", kFinerElseIsothermal};
    default:
      return {};
  }
}

inline Told told(ending::Plain e, const About& a) {
  using ending::Plain;
  switch (e) {
    case Plain::none:
      return {a.verdict.status == Status::interrupted ? "stopped by the user" : "", ""};
    case Plain::not_run:
      return {"not run", ""};
    case Plain::not_reached:
      return {"interrupted before the point was solved", ""};
    case Plain::given_up:
      return {"the search was given up after twenty times the work of a usual solve on this grid",
              "a coarser grid (model.grid) or a nearby operating point first"};
    case Plain::no_oil_leaves:
    case Plain::no_oil_over_event:
    case Plain::estimate_unbalanced:
    case Plain::film_unsettled:
    case Plain::film_impossible:
      return told_of_heat(e);
    case Plain::no_pressure:
      return {kNoPressure, kBeyondBarus};
    case Plain::no_position:
      return {"no position was found in which the film carries the load: each step closes the gap",
              kContactElseLoad};
    case Plain::ran_off:
      return {"the iteration for load and position left the range of numbers", kFinerElseLess};
    case Plain::empty_ring:
      return {
          "a ring of the film is cavitated all round and fed by nothing: its oil only goes "
          "round, and how much of it there is cannot be told",
          "feed more oil, or over more of the width"};
    case Plain::singular_film:
      return {"the film matrix is singular: parts of the film get no oil",
              "feed more oil, or turn the supply away from the load"};
    case Plain::out_of_the_law:
      return {kOutOfTheLaw, ""};
    case Plain::overdrawn:
      return {"a step takes more oil out of a cell than it holds", ""};
    case Plain::singular_response:
      return {"the matrix of the linearised film is singular", "feed more oil"};
    case Plain::unsettled_response:
      return {"the linearised elastic film did not settle (GMRES stopped at its limit)",
              "try a finer grid"};
    case Plain::no_vessel_pressure:
      return {"the pressure in the vessel of a supply is not found",
              "a larger vessel, or a finer grid"};
    case Plain::layer_may_flow:
    case Plain::no_light_state:
    case Plain::no_slow_state:
    case Plain::endless_branch:
    case Plain::strayed:
      return told_of_branch(e, a.within);
    case Plain::steps_too_short:
      return {"the steps in time have become too short", ""};
  }
  return {};
}

/// What a film that is not periodic gains or loses.
inline std::string gathered(const ending::Unsettled& e) {
  constexpr double kTelling = 1e-4;  // as near as a cycle is closed [-]
  if (std::abs(e.gathered) < kTelling) return "";
  if (e.gathered > 0.0) {
    return fmt::format("; in the last one the film gained {:.2g} % of its oil", 100.0 * e.gathered);
  }
  return fmt::format(
      "; in the last one the film lost {:.2g} % of its oil: no supply makes up for "
      "what leaves at the sides, or none lies where the oil comes by",
      -100.0 * e.gathered);
}

inline Told told(const ending::Unsettled& e, const About& a) {
  switch (e.of) {
    case ending::Iteration::cavitation:
      return {fmt::format("the cavitation solve stopped after {} steps at residual {:.1e}", e.steps,
                          e.left),
              "refine the grid or start from a lower load"};
    case ending::Iteration::swift_stieber:
      return {fmt::format("the Swift-Stieber film stopped after {} steps at residual {:.1e}{}",
                          e.steps, e.left,
                          e.hopeless ? "; its pressures left the range of the pressure law" : ""),
              "refine the grid or lower the load"};
    case ending::Iteration::fischer_burmeister:
      return {fmt::format("the Fischer-Burmeister film stopped after {} steps at residual {:.1e}{}",
                          e.steps, e.left, e.hopeless ? ": no step length lessens it" : ""),
              "use the active-set method, or start from a lower load"};
    case ending::Iteration::p_theta:
      return {
          fmt::format("p-theta relaxation: {} sweeps left a residual of {:.1e}", e.steps, e.left),
          "use the active-set method, a coarser grid or a lower load"};
    case ending::Iteration::heat:
      return {fmt::format("film and heat did not settle in {} iterations (last change {:.1e} of 10 "
                          "K)",
                          e.steps, e.left),
              kFinerElseTighter};
    case ending::Iteration::walls:
      return {fmt::format("film and walls do not come to balance (last change {:.2g} K)", e.left),
              "try a finer grid or another cooling of shell and shaft"};
    case ending::Iteration::cycles:
      return {fmt::format("after {} cycles two of them still differ by {:.1e} in smallest film, "
                          "torque, oil or momentum, and this falls too slowly to be within 1e-4 of "
                          "where it leads{}",
                          e.steps, e.left, gathered(e)),
              "where it is about 1e-4, a smaller model.tolerance (it is the choice of steps that "
              "differs); else repeat the load several times in a longer period (oil of a starved "
              "film gathers over more than a hundred short ones), or look at the orbit: it may "
              "repeat itself over several periods, as journals that whirl do"};
    case ending::Iteration::layer_of_cycles:
      return {
          fmt::format("after {} cycles the elasto-plastic layer still flows, by {:.3g} um in the "
                      "last: a state that repeats itself begins when it has ended",
                      e.steps, e.left * 1e6),
          "a harder or a thicker layer, or a lower load; the same load as a single event of so "
          "many pulses (without period) shows how it settles"};
    case ending::Iteration::walls_of_cycles:
      return {fmt::format("after {} cycles the walls still change by {:.2g} K from one to the next",
                          e.steps, e.left),
              "a smaller model.tolerance, a finer grid, a lower load, or tier isothermal"};
    case ending::Iteration::wear:
      return {a.verdict.cause.empty()
                  ? fmt::format("no worn-in shape was found: wear still changes by {:.3g} um where "
                                "the contact pressure is to end at the limit",
                                e.left * 1e6)
                  : "no worn-in shape was found; the film of the last shape tried was not: " +
                        a.within.reason,
              "raise running_in.limit_pressure, or follow the wear in time (until = a time)"};
  }
  return {};
}

}  // namespace shellback::app::told
