#include "app/words/note_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "app/words/effect_words.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/plain_note_words.hpp"
#include "app/words/temperature_words.hpp"
#include "bearing/film/fed_flow.hpp"
#include "bearing/told_ranges.hpp"

namespace shellback::app {

std::string known_within(double part) {
  if (!std::isfinite(part)) return "without a bar";
  return part < 0.995 ? fmt::format("within {:.2g} %", 100.0 * part)
                      : fmt::format("within {:.0f} %", 100.0 * part);
}

namespace {

using namespace bearing;

std::string tier_on_grid(Tier tier, const std::array<int, 2>& grid, const char* how) {
  return fmt::format("tier {} {} {} x {} cells", to_string(tier), how, grid[0], grid[1]);
}

std::string not_found(const note::NothingRicher& n) {
  return fmt::format("{} ({})", tier_on_grid(n.tier, n.grid, "was not found on"), reason_of(n.why));
}

std::string text_of(const std::string& words) { return words; }

std::string text_of(note::Plain n) { return plain_words(n); }

std::string listed(const std::vector<EffectKind>& effects) {
  std::vector<std::string> names;
  for (const EffectKind effect : effects) names.emplace_back(name_of(effect));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string text_of(const note::BarsFromFinerGrid& n) {
  return fmt::format(
      "the error bars are made with a finer grid, {} x {} cells: no coarser one gave a solution, "
      "or summits make most of the friction, and coarse grids may then stand on another branch",
      n.grid[0], n.grid[1]);
}

std::string text_of(const note::RicherNotFound& n) {
  return fmt::format(
      "the richer physics ({}) gave no solution on the coarse grid: the model bars are unknown",
      listed(n.effects));
}

std::string text_of(const note::EffectsNotJudged& n) {
  return fmt::format(
      "the case has no data (shell, shaft) to judge what is left out by leaving out {}; the error "
      "bars do not hold it",
      listed(n.effects));
}

std::string text_of(const note::ScalarsOfFinerGrid& n) {
  return fmt::format(
      "scalars are those of {} x {} cells, {} what auto solved: {}; fields, history and audit are "
      "those of {} x {} cells",
      n.scalars[0], n.scalars[1], n.fields == n.scalars ? "the last of" : "extrapolated from",
      fmt::join(n.solved, ", "), n.fields[0], n.fields[1]);
}

const char* text_of(note::ToleranceNotMet::Why why) {
  switch (why) {
    case note::ToleranceNotMet::Why::no_walls:
      return "the case has no data of shell and shaft, so that the heat is only known in lumps";
    case note::ToleranceNotMet::Why::grid_given:
      return "the grid is given: without model.grid it is chosen for the tolerance";
    case note::ToleranceNotMet::Why::grid_limit:
      return "model.grid = [400, 50] or finer is solved as it is";
    case note::ToleranceNotMet::Why::not_laminar:
      return "both of a laminar film, which this one is not";
    case note::ToleranceNotMet::Why::cycle_grid:
      break;
  }
  return "a finer model.grid or another tolerance";
}

std::string text_of(const note::ToleranceNotMet& n) {
  return fmt::format(
      "the tolerance of {:.2g} % is not met: the {}friction torque is known {}, the smallest film "
      "{}; {}",
      100.0 * n.tolerance, n.of_cycle ? "mean " : "", known_within(n.friction),
      known_within(n.h_min), text_of(n.why));
}

std::string text_of(const note::ColdClearance& n) {
  return fmt::format(
      "the clearance is that at bearing.reference_temperature: at the film's temperature shell and "
      "shaft may differ by some {:.0f} % of it (thermal deformation, which tier tehd has in)",
      100.0 * n.part);
}

std::string text_of(const note::ShaftSwing& n) {
  if (n.over_event) {
    return fmt::format(
        "the shaft's surface has one temperature around: as it turns it would swing by about +- "
        "{:.2g} K",
        n.T);
  }
  return fmt::format(
      "the shaft's surface is at its mean over the cycle: as it turns, and over the cycle, it "
      "would swing by about +- {:.2g} K{}",
      n.T,
      n.standing > n.T
          ? fmt::format("; one side of it, which meets more of the heat as the journal "
                        "does not turn evenly, would stay warmer, by up to +- {:.2g} K",
                        n.standing)
          : "");
}

std::string text_of(const note::LongEvent& n) {
  return fmt::format(
      "heat goes some {:.2g} mm into the walls while this event lasts, deeper than a quarter of "
      "the bearing's radius, or of its width where the shaft goes on beyond it ({:.2g} mm), from "
      "where on what goes sideways counts, which is left "
      "out: "
      "walls are told too warm, by a twentieth of their rise and more, and their growth with them; "
      "over so long a time run --transient follows the bodies",
      1e3 * n.reach, 1e3 * n.straight);
}

std::string text_of(const note::CyclesWander& n) {
  return fmt::format(
      "the cycles do not repeat more nearly than {:.1g} of smallest film and torque, and go no "
      "farther apart: fronts of oil come back a little otherwise each time; one of them is told, "
      "and the bars of time have the difference",
      n.closure);
}

std::string text_of(const note::JointPulls& n) {
  return fmt::format(
      "shell and housing stay joined, however warm: as warm as they are the joint would pull with "
      "about {:.2g} MPa, so that the press fit must give more; loose, heat would move the bore by "
      "about {:.3g} um where joined it is {:.3g} um",
      1e-6 * n.pressure, 1e6 * n.loose, 1e6 * n.joined);
}

std::string text_of(const note::LoadMissed& n) {
  return fmt::format(
      "the step that is given (load_cycle.step) passes over load: between {:.4g} and {:.4g} ms its "
      "mean is {:.0f} % of its largest away from that of both ends; give a shorter one, or none",
      1e3 * n.from, 1e3 * n.to, 100.0 * n.part);
}

std::string text_of(const note::EstimateOfFilm& n) {
  return "estimate: rigid circular bearing fed at the widest gap, one temperature from a heat "
         "balance in lumps; regime " +
         n.regime;
}

std::string text_of(const note::EstimateWithoutMass& n) {
  return fmt::format("estimate: the journal's mass of {:.3g} kg is left out", n.mass);
}

std::string text_of(const note::ColdSpot& n) {
  return "the film temperature falls to " + told_temperature(n.T) +
         " at one place, below everything around it: model.film_nodes does not resolve it there";
}

std::string text_of(const note::CavitatedDamping& n) {
  return fmt::format(
      "{:.0f} % of the damping comes from oil that comes and goes in the cavitated film: K and C "
      "hold for motions much slower than the rotation, and are a rough guide at half its speed",
      100.0 * n.share);
}

/// Where the heat balance is met elsewhere too, the user must know which root this is.
std::string text_of(const note::OtherRoots& n) {
  std::string all;
  for (const auto& root : n.roots) {
    all += fmt::format("{}{:.1f} degC ({}{})", all.empty() ? "" : ", ", root.T - kZeroCelsius,
                       root.stable ? "stable" : "unstable", root.taken ? ", this solution" : "");
  }
  return fmt::format(
      "the heat balance is met at {} temperatures: {}; given is the lowest stable one, to which "
      "the bearing comes from cold; once warmer than an unstable one it goes on to the next",
      n.roots.size(), all);
}

std::string cells(long n) { return n == 1 ? "one cell" : fmt::format("{} cells", n); }

std::string text_of(const note::FactorsContinued& n) {
  return fmt::format(
      "in {} of the solved part the gap is below {:.3g} um, the smallest of {} (h/sigma = {:.3g}): "
      "they are continued there",
      cells(n.cells), 1e6 * n.h,
      n.measured ? "the measured flow factors" : "the fitted flow factors of Patir and Cheng", n.H);
}

std::string text_of(const note::ShearBeyondLaw& n) {
  return fmt::format(
      "the oil is sheared at up to {:.2g} 1/s (sliding speed over film), and its law is told to "
      "hold up to {:.2g} 1/s (oil.valid.shear_rate)",
      n.rate, n.limit);
}

std::string text_of(const note::BeyondOilRange& n) {
  const std::string from =
      std::isnan(n.T_low) ? "up" : told_temperature(n.T_low);  // to the highest
  return fmt::format(
      "film temperatures of {} to {} leave the oil's range of {} to {}: its viscosity is "
      "extrapolated",
      from, told_temperature(n.T_high), told_temperature(n.T_min), told_temperature(n.T_max));
}

std::string text_of(const note::BeyondContactLaw& n) {
  return fmt::format(
      "the surfaces interpenetrate by up to {:.3g} um (at {}), {:.0f} times their summit "
      "roughness, in {} of the solved part: beyond {:.3g} um the whole surface would be in "
      "contact, and the contact law no longer describes it: contact pressure, friction and film "
      "are no prediction there",
      -n.h * 1e6, words_of(n.place), -n.h / n.sigma, cells(n.cells), -n.least * 1e6);
}

std::string text_of(const note::EdgeNotResolved& n) {
  return fmt::format(
      "the smallest film is not resolved: at a side edge the gap, continued from the last cells, "
      "falls to {:.3g} um, while no cell has less than {:.3g} um: more cells along in model.grid, "
      "graded towards the edges (model.axial_spacing)",
      1e6 * n.edge, 1e6 * n.cell);
}

std::string text_of(const note::ShapeBetweenCells& n) {
  return fmt::format(
      "the grid does not resolve the shape of the bore: at {} it lies {:.3g} um beside what the "
      "cells see, and the smallest film is {:.3g} um: more cells there in model.grid, graded "
      "towards the edges if it is theirs (model.axial_spacing)",
      words_of(n.place), 1e6 * n.missed, 1e6 * n.h_min);
}

std::string text_of(const note::ProfileBetweenCells& n) {
  return fmt::format(
      "the grid does not resolve the profile of the bore: {:.0f} % of its volume lies between the "
      "middles of the cells: more cells in model.grid, or a profile whose steps lie on their faces",
      100.0 * n.part);
}

std::string text_of(const note::ContactLeftOut& n) {
  return fmt::format(
      "the smallest film is {:.2g} combined roughnesses, where summits carry part of the load "
      "(below 3), and contact is left out: give surfaces.contact",
      n.lambda);
}

std::string text_of(const note::NotLaminar& n) {
  return fmt::format(
      "the film is not laminar: its Reynolds number {:.4g} is beyond 41.2 sqrt(R/c) = {:.4g}, "
      "where "
      "Taylor vortices and turbulence begin: friction and temperatures are no prediction",
      n.reynolds, n.limit);
}

std::string text_of(const note::LayerBeyondHardness& n) {
  return fmt::format(
      "film pressures of up to {:.4g} MPa press the layer of {} beyond its hardness, {:.4g} MPa, "
      "and "
      "it is taken as elastic: that it flows there is left out (elasto_plastic = true of the "
      "layer)",
      1e-6 * n.p_max, n.name, 1e-6 * n.hardness);
}

std::string text_of(const note::FilmInertia& n) {
  if (n.squeezed) {
    return fmt::format(
        "inertia of the film that the journal squeezes matters, and is not modelled: rho v c/eta "
        "reaches {:.2g}, viscous forces are no longer much larger (the oil adds mass to the "
        "journal)",
        n.reduced);
  }
  return fmt::format(
      "inertia of the film matters, and is not modelled: rho omega c^2/eta is {:.2g}, viscous "
      "forces are no longer much larger",
      n.reduced);
}

std::string text_of(const note::FedFlow& n) {
  return fmt::format(
      "oil is pressed out of a supply with {:.3g} m/s (at {}): its head, {:.3g} bar, is {:.2g} of "
      "the pressure that drives it{}; a film without inertia leaves that out and feeds too much "
      "there",
      n.velocity, words_of(n.place), 1e-5 * n.head, n.part,
      n.reynolds > bearing::kTurbulentFlow
          ? fmt::format(", and its Reynolds number, {:.3g}, is beyond the {:.0f} "
                        "from which flow between plates becomes turbulent",
                        n.reynolds, bearing::kTurbulentFlow)
          : "");
}

std::string text_of(const note::OilSheared& n) {
  return fmt::format(
      "the viscous shear stress comes to {:.3g} MPa where the film's pressure is {:.4g} MPa (at "
      "{}), "
      "{:.2g} times what oils bear (about {:.0f} MPa and {:.0f} % of the pressure): they slip or "
      "flow there instead, with less friction than is told",
      1e-6 * n.stress, 1e-6 * n.pressure, words_of(n.place), n.part, 1e-6 * bearing::kShearAtRest,
      100.0 * bearing::kShearByPressure);
}

std::string text_of(const note::HeldAtHardness& n) {
  return fmt::format(
      "the contact pressure is held at the hardness of {:.4g} MPa in {} of the solved part: "
      "summits flow there by up to {:.3g} um (at {})",
      n.hardness * 1e-6, cells(n.cells), n.flow * 1e6, words_of(n.place));
}

std::string text_of(const note::VesselEmpty& n) {
  return fmt::format(
      "for {:.3g} % of the time a vessel stands at the cavitation pressure: no oil flows from it",
      100.0 * n.part);
}

std::string text_of(const note::MouthWidened& n) {
  return fmt::format(
      "supply.{}: its mouth of {:.4g} mm is finer than the grid and taken as {:.4g} mm wide; flow "
      "and film are those of the wider one: a finer model.grid",
      n.supply, n.diameter * 1e3, n.taken * 1e3);
}

std::string text_of(const note::LandUnseen& n) {
  return fmt::format(
      "supply.{}: its land of {:.4g} mm to a side edge is in no cell of this grid: what leaves "
      "there "
      "is throttled by half a cell instead; a finer model.grid along the bearing",
      n.supply, n.land * 1e3);
}

std::string text_of(const note::SuppliesJoined& n) {
  return fmt::format(
      "supply.{} and supply.{} stand side by side without a cell of film: what flows from the one "
      "to the other is in neither's flow nor in the pump's power, and their oil is mixed; a land "
      "between them needs a finer model.grid",
      n.first, n.second);
}

std::string text_of(const note::SupplyTakesBack& n) {
  constexpr double kLitreMinutes = 6e4;
  return fmt::format(
      "supply.{}: {:.3g} l/min are pressed back into it, of {:.3g} l/min that the others feed",
      n.supply, n.flow * kLitreMinutes, n.fed * kLitreMinutes);
}

std::string text_of(const note::HardlySliding& n) {
  return fmt::format(
      "the surfaces slide at {:.3g} mm/s: summits give way elastically before they slide, and "
      "{:.0f} "
      "% of their friction is there; that at the point of sliding is told as breakaway_torque by "
      "an "
      "event that begins at rest ([load_cycle])",
      n.speed * 1e3, 100.0 * n.part);
}

std::string text_of(const note::LayerPressed& n) {
  return fmt::format(
      "the largest pressure {} shell.layers.{} by {:.3g} % of its thickness: laws of small "
      "strain err{}; check its youngs_modulus",
      n.sheared ? "shears" : "compresses", n.layer, 100.0 * n.strain,
      n.strain > 0.5 ? ", the numbers are no prediction" : "");
}

std::string text_of(const note::WornThrough& n) {
  return fmt::format(
      "the wear of {:.3g} um has gone through the shell's first layer ({:.3g} um): below it lies "
      "another material, and what is told here is that of the first",
      1e6 * n.depth, 1e6 * n.thickness);
}

std::string text_of(const note::WornBeyondClearance& n) {
  return fmt::format(
      "the wear of {:.3g} um is more than the radial clearance of {:.3g} um: check its "
      "coefficient, "
      "hardness and summits, or take a shorter time",
      1e6 * n.depth, 1e6 * n.clearance);
}

std::string text_of(const note::WearLedOn& n) {
  return fmt::format(
      "depth and volume of the wear are those of the cells ({:.4g} um); the shape, in the profile, "
      "too, is led on to the side edges by a straight line, to {:.4g} um",
      1e6 * n.depth, 1e6 * n.edge);
}

std::string text_of(const note::StatesEnd& n) {
  return fmt::format(
      "from {:.4g} s on no state is found near those before: what follows is another one, found "
      "from cold, and the torque goes from {:.4g} to {:.4g} N m{}{}",
      n.t, n.torque_before, n.torque,
      n.times > 1 ? fmt::format("; so it does {} times in all", n.times) : "",
      n.flows ? "; what an elasto-plastic layer had flowed by then begins anew" : "");
}

std::string text_of(const note::LiningTooHot& n) {
  return fmt::format("the shell's surface reaches {:.1f} degC, and {} serves up to {:.0f} degC",
                     n.T - kZeroCelsius, n.material, n.limit - kZeroCelsius);
}

std::string text_of(const note::OtherSteadyState& n) {
  return fmt::format(
      "the bearing came to rest with a torque of {:.4g} N m and a film of up to {:.1f} degC; the "
      "steady state solved for itself has {:.4g} N m and {:.1f} degC: there are two, and which one "
      "it keeps depends on where it comes from",
      n.torque, n.T_film_max - kZeroCelsius, n.steady_torque, n.steady_T_film_max - kZeroCelsius);
}

std::string text_of(const note::LayerFlown& n) {
  return fmt::format(
      "the elasto-plastic layer has flowed by {:.3g} um of its {:.3g} um: columns beside each "
      "other shear by then{}; check load, hardness and thickness",
      1e6 * n.depth, 1e6 * n.thickness,
      n.depth > n.thickness ? ", and none can lose more than it has: the numbers are no prediction"
                            : "");
}

std::string text_of(const note::NoCoefficients& n) {
  return "stiffness and damping are not given: " + reason_of(n.why);
}

std::string text_of(const note::NothingRicher& n) {
  return "what richer physics would change is not known: " + not_found(n);
}

std::string text_of(const note::TierTaken& n) {
  const std::string left_out =
      n.unjudged.empty()
          ? fmt::format(
                "the physics that it leaves out is worth at most {:.2g} % of the mean "
                "torque and {:.2g} % of the smallest film",
                100.0 * n.friction, 100.0 * n.h_min)
          : "the physics that it leaves out is not known: " + not_found(n.unjudged.front());
  return fmt::format("tier auto took {}; {}; solved on the way: {}",
                     tier_on_grid(n.tier, n.grid, "on"), left_out, fmt::join(n.solved, ", "));
}

}  // namespace

std::string words_of(const Note& note) {
  return std::visit([](const auto& n) { return text_of(n); }, note);
}

std::vector<std::string> words_of(const std::vector<Note>& notes) {
  std::vector<std::string> all;
  for (const Note& note : notes) all.push_back(words_of(note));
  return all;
}

}  // namespace shellback::app
