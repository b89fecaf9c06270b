#include "app/words/note_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "app/words/ending_words.hpp"
#include "app/words/temperature_words.hpp"

namespace shellback::app {
namespace {

using namespace bearing;

std::string tier_on_grid(Tier tier, const std::array<int, 2>& grid, const char* how) {
  return fmt::format("tier {} {} {} x {} cells", to_string(tier), how, grid[0], grid[1]);
}

std::string not_found(const note::NothingRicher& n) {
  return fmt::format("{} ({})", tier_on_grid(n.tier, n.grid, "was not found on"), reason_of(n.why));
}

std::string told(const std::string& words) { return words; }

std::string told(note::Plain n) {
  return n == note::Plain::orientation_beyond_table
             ? "a roughness orientation lies outside the range 1/9 to 9 of the tabulated flow "
               "factors: the end of the table is used"
             : "film pressures leave the range in which the oil's pressure law is known";
}

std::string told(const note::ColdSpot& n) {
  return "the film temperature falls to " + told_temperature(n.T) +
         " at one place, below everything around it: model.film_nodes does not resolve it there";
}

std::string told(const note::CavitatedDamping& n) {
  return fmt::format(
      "{:.0f} % of the damping comes from oil that comes and goes in the cavitated film: K and C "
      "hold for motions much slower than the rotation, and are a rough guide at half its speed",
      100.0 * n.share);
}

/// Where the heat balance is met elsewhere too, the user must know which root this is.
std::string told(const note::OtherRoots& n) {
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

std::string told(const note::FactorsContinued& n) {
  return fmt::format(
      "in {} cells of the solved part the gap is below {:.3g} um, the smallest of the measured "
      "flow factors (h/sigma = {:.3g}): they are continued there",
      n.cells, 1e6 * n.h, n.H);
}

std::string told(const note::BeyondOilRange& n) {
  const std::string from =
      std::isnan(n.T_low) ? "up" : told_temperature(n.T_low);  // to the highest
  return fmt::format(
      "film temperatures of {} to {} leave the oil's range of {} to {}: its viscosity is "
      "extrapolated",
      from, told_temperature(n.T_high), told_temperature(n.T_min), told_temperature(n.T_max));
}

std::string told(const note::BeyondContactLaw& n) {
  return fmt::format(
      "the surfaces interpenetrate by up to {:.3g} um (at {}), {:.0f} times their summit "
      "roughness, in {} cells of the solved part: beyond {:.3g} um the whole surface would be in "
      "contact, and the contact law no longer describes it: contact pressure, friction and film "
      "are no prediction there",
      -n.h * 1e6, words_of(n.place), -n.h / n.sigma, n.cells, -n.least * 1e6);
}

std::string told(const note::EdgeNotResolved& n) {
  return fmt::format(
      "the smallest film is not resolved: at a side edge the gap, continued from the last cells, "
      "falls to {:.3g} um, while no cell has less than {:.3g} um: more cells along in model.grid, "
      "graded towards the edges (model.axial_spacing)",
      1e6 * n.edge, 1e6 * n.cell);
}

std::string told(const note::NotLaminar& n) {
  return fmt::format(
      "the film is not laminar: its Reynolds number {:.4g} is beyond 41.2 sqrt(R/c) = {:.4g}, "
      "where "
      "Taylor vortices and turbulence begin: friction and temperatures are no prediction",
      n.reynolds, n.limit);
}

std::string told(const note::HeldAtHardness& n) {
  return fmt::format(
      "the contact pressure is held at the hardness of {:.4g} MPa in {} cells of the solved part: "
      "summits flow there by up to {:.3g} um (at {})",
      n.hardness * 1e-6, n.cells, n.flow * 1e6, words_of(n.place));
}

std::string told(const note::VesselEmpty& n) {
  return fmt::format(
      "for {:.3g} % of the time a vessel stands at the cavitation pressure: no oil flows from it",
      100.0 * n.part);
}

std::string told(const note::MouthWidened& n) {
  return fmt::format(
      "supply.{}: the mouth of {:.4g} mm is finer than the grid and taken as {:.4g} mm wide: a "
      "finer "
      "model.grid",
      n.supply, n.diameter * 1e3, n.taken * 1e3);
}

std::string told(const note::NoCoefficients& n) {
  return "stiffness and damping are not given: " + reason_of(n.why);
}

std::string told(const note::NothingRicher& n) {
  return "what richer physics would change is not known: " + not_found(n);
}

std::string told(const note::TierTaken& n) {
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
  return std::visit([](const auto& n) { return told(n); }, note);
}

std::vector<std::string> words_of(const std::vector<Note>& notes) {
  std::vector<std::string> all;
  for (const Note& note : notes) all.push_back(words_of(note));
  return all;
}

}  // namespace shellback::app
