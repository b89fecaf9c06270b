#include "app/check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "app/derived.hpp"
#include "app/indicators.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/reading/units.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/heat_words.hpp"
#include "app/words/note_words.hpp"
#include "bearing/heat/heat_endings.hpp"
#include "bearing/judge/judge_case.hpp"
#include "bearing/over_time/cycle_numbers.hpp"
#include "bearing/told_ranges.hpp"
#include "core/constants.hpp"
#include "core/make_grid.hpp"
#include "core/round_off.hpp"
#include "fidelity/estimate.hpp"
#include "fidelity/estimate_bars.hpp"
#include "fidelity/estimate_cycle.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::app {
namespace {

using namespace bearing;

void line(std::ostream& out, const char* name, const std::string& value,
          const std::string& note = "") {
  out << fmt::format("  {:<28} {:>14}{}{}\n", name, value, note.empty() ? "" : "   ", note);
}

void print_operation(std::ostream& out, const Case& subject, const Derived& d) {
  const std::string estimate = d.load_given ? "" : "estimate";
  out << "\nDerived\n";
  line(out, "surface speed", fmt::format("{:.4g} m/s", d.speed));
  line(out, "clearance over radius", fmt::format("{:.4g}", d.clearance_ratio));
  line(out, "width over diameter",
       fmt::format("{:.4g}", 0.5 * subject.bearing.width / subject.bearing.radius));
  if (d.rigid_film) {
    line(out, "specific load", show(d.specific_load, "MPa", kPressure), estimate);
  }
  line(out, "film temperature", show(d.T, "degC", kTemperature), d.T_source);
  line(out, "viscosity there", show(d.eta, "mPa s", kViscosity));
  if (d.rigid_film) {
    line(out, "Sommerfeld number So", fmt::format("{:.4g}", d.so),
         "p psi^2/(eta omega)" +
             (d.so > 0.0 ? fmt::format("; S = {:.4g}", 1.0 / (2.0 * kPi * d.so)) : ""));
  }
  line(out, "Reynolds number", fmt::format("{:.4g}", d.reynolds),
       fmt::format("laminar below 41.2 sqrt(R/c) = {:.4g}", d.reynolds_limit));
}

void print_expected(std::ostream& out, const Derived& d) {
  out << "\nExpected (closed formulas: rigid, aligned, one temperature, the whole width without "
         "supplies)\n";
  line(out, "friction torque", show(d.petroff_torque, "N m", kTorque),
       "Petroff: concentric journal; eccentric ones take more");
  line(out, "friction power", show(d.petroff_power, "W", kPower), "Petroff");
  line(out, "heating per pass", show(d.heat_per_pass, "K", kTemperatureDifference),
       "if all heat stays in the oil");
  line(out, "eccentricity ratio", fmt::format("{:.3g}", d.eccentricity_ratio),
       d.load_given ? "estimate" : "given");
  line(out, "smallest film", show(d.h_min, "um", kLength),
       d.load_given    ? "estimate"
       : d.h_min > 0.0 ? "given, without deformation"
                       : "given: only their deformation keeps the surfaces apart");
  if (d.rigid_film) line(out, "peak pressure", show(d.p_max, "MPa", kPressure), "estimate");
  if (d.lambda) {
    line(out, "film over roughness", fmt::format("{:.3g}", *d.lambda),
         *d.lambda < 4.0 ? "mixed friction is likely" : "full film");
  }
}

void print_indicators(std::ostream& out, const std::vector<Indicator>& list) {
  out << "\nEffects (orders of magnitude)\n";
  for (const Indicator& i : list) {
    const char* mark = i.weight == Weight::important ? "!!"
                       : i.weight == Weight::between ? "! "
                                                     : "  ";
    out << fmt::format("{} {:<30} {:>9.2g}   {} [{}]\n", mark, i.effect, i.value, i.advice,
                       i.formula);
  }
}

void print_list(std::ostream& out, const char* title, const std::vector<std::string>& list) {
  out << "\n" << title << (list.empty() ? ": none\n" : "\n");
  for (const std::string& entry : list) out << "  - " << entry << "\n";
}

/// "; beyond the oil's laws, which hold from 0 degC to 150 degC"; within: nothing.
std::string beyond_laws(const rheology::ValidityRange& range, double T) {
  if (T >= range.T_min && T <= range.T_max) return "";
  return fmt::format("; beyond the oil's laws, which hold from {} to {}",
                     show(range.T_min, "degC", kTemperature),
                     show(range.T_max, "degC", kTemperature));
}

void print_estimate(std::ostream& out, const Case& subject) {
  const auto lack = lack_for(subject, Tier::estimate);
  if (lack && (lack->key == "model.tier" || lack->key == "operation.eccentricity_ratio")) {
    out << "\nEstimate: none, " << lack->problem << "\n";
    return;
  }
  const fidelity::Estimate e = fidelity::estimate(subject);
  out << "\nEstimate (table of the finite bearing, heat in lumps; tier estimate)\n";
  if (!e.balanced) {
    const double T = bearing::mean_supply_temperature(subject);
    const bool thins = rheology::viscosity_slopes(subject.oil, T, 0.0, 0.0).dln_dT < 0.0;
    out << "  no film temperature carries the friction heat away: "
        << (thins
                ? "thermal runaway is likely\n"
                : "hardly any oil leaves the bearing, and the film is hotter than any oil bears\n");
    return;
  }
  line(out, "regime", to_string(e.regime),
       subject.surfaces.contact
           ? fmt::format("asperities carry {:.2g} % of the load", 100.0 * e.asperity_share)
       : std::isfinite(e.lambda) ? fmt::format("film over roughness {:.3g}", e.lambda)
                                 : "smooth surfaces");
  line(out, "film temperature", show(e.T, "degC", kTemperature),
       fmt::format("{:.3g} K above the supply{}", e.rise, beyond_laws(subject.oil.range, e.T)));
  const fidelity::EstimateBars bars = fidelity::estimate_bars(subject, e);
  const auto within = [](double part) { return "+-" + figures(100.0 * part, 2) + " %"; };
  line(out, "friction torque", show(e.torque, "N m", kTorque), within(bars.torque));
  line(out, "smallest film", show(e.h_min, "um", kLength),
       fmt::format("{}; eccentricity ratio {:.3g}", within(bars.film), e.eps));
  line(out, "peak pressure", show(e.p_max, "MPa", kPressure), within(bars.peak));
}

/// The whole cycle by mobility, if the tier serves it.
void print_cycle_estimate(std::ostream& out, const Case& subject) {
  if (lack_for(subject, Tier::estimate)) return;
  const CycleResult r = fidelity::estimate_cycle(subject);
  out << "\nEstimate of the cycle (mobility, heat in lumps; tier estimate)\n";
  if (!r.verdict.good()) {
    out << "  none: " << reason_of(r.verdict) << "\n";
    return;
  }
  line(out, "film temperature", show(value_of(r, "T_film_mean"), "degC", kTemperature));
  line(out, "friction torque, mean", show(value_of(r, "friction_torque"), "N m", kTorque));
  line(out, "smallest film", show(value_of(r, "h_min"), "um", kLength));
  line(out, "largest pressure", show(value_of(r, "p_max"), "MPa", kPressure));
}

std::string in_degrees(double angle) { return fmt::format("{:.5g} deg", angle * 180.0 / kPi); }

/// An instant of the cycle, told as the cycle is.
std::string instant_told(const LoadCycle& cycle, double t) {
  return cycle.crank_speed > 0.0 ? in_degrees(t * cycle.crank_speed) : duration_words(t);
}

std::string load_words(double force) {
  constexpr double kMany = 1e4;  // N; five digits are read more easily in kN
  return force >= kMany ? show(force, "kN", kForce) : show(force, "N", kForce);
}

bool turns_back(const CycleNumbers& n) {
  return n.mean_sliding > std::abs(n.mean_speed) + kRoundOff * n.largest_speed;
}

void print_cycle(std::ostream& out, const Case& subject) {
  const LoadCycle& cycle = *subject.cycle;
  const CycleNumbers n = cycle_numbers(cycle, subject.operation.omega);
  const double area = 2.0 * subject.bearing.radius * subject.bearing.width;
  out << "\nLoad cycle\n";
  line(out, cycle.repeats() ? "period" : "single event of", instant_told(cycle, n.length),
       cycle.crank_speed > 0.0 ? fmt::format("of crank angle, {:.4g} ms", 1e3 * n.length) : "");
  line(out, "rows", fmt::format("{}", cycle.t.size()),
       cycle.interpolation == LoadInterpolation::linear ? "straight lines between them"
                                                        : "a periodic spline through them");
  const bool vanishes = n.smallest < kVanishingLoad * n.largest;
  line(out, "largest load", load_words(n.largest),
       fmt::format("at {}, acting towards {}", instant_told(cycle, n.at), in_degrees(n.angle)));
  line(out, "mean load", load_words(n.mean),
       vanishes ? "it vanishes in between" : "smallest " + load_words(n.smallest));
  line(out, "peak specific load", show(n.largest / area, "MPa", kPressure));
  const bool swings = std::abs(n.mean_speed) < kRoundOff * n.largest_speed;
  line(out, "mean speed", show(swings ? 0.0 : n.mean_speed, "rpm", kSpeed),
       fmt::format("of the journal against the shell; at most {}",
                   show(n.largest_speed, "rpm", kSpeed)));
  if (turns_back(n)) {
    line(out, "mean speed without its sign", show(n.mean_sliding, "rpm", kSpeed),
         "the journal turns back");
  }
  line(out, "journal mass", fmt::format("{:.4g} kg", cycle.journal_mass),
       cycle.journal_mass > 0.0 ? "" : "a journal without inertia");
  line(out, "step", cycle.step ? instant_told(cycle, *cycle.step) : "chosen",
       cycle.step ? "" : "by model.tolerance");
}

/// What closed formulas tell of one steady load.
void print_steady(std::ostream& out, const Case& subject) {
  const Derived d = derive(subject);
  print_operation(out, subject, d);
  print_expected(out, d);
  if (!subject.cycle) print_estimate(out, subject);
  print_indicators(out, indicators(subject, d));
}

/// The largest load at the mean speed, that of a swinging journal without its sign, as if both
/// would stay.
Case at_largest_load(const Case& subject) {
  Case steady = subject;
  const CycleNumbers n = cycle_numbers(*subject.cycle, subject.operation.omega);
  steady.operation.position = largest_load(*subject.cycle);
  steady.operation.omega = std::copysign(n.mean_sliding, n.mean_speed);
  return steady;
}

/// Closed rings differ little from one grid to another: a coarse one will do.
std::optional<ending::NoClearance> closed_at_rest(const Case& subject) {
  const FilmGrid grid = make_grid(subject.bearing.radius, subject.bearing.width, 16, 9, false);
  const Solids solids(subject, grid, {.elastic = false, .heat = true, .thermal_deformation = true});
  return bearing::closed_at_rest(subject, solids, grid);
}

/// What the case's tier will warn of, whatever its film comes to; auto may choose any tier up to
/// the richest.
std::vector<std::string> warnings_of(const Case& subject) {
  std::vector<std::string> told = subject.warnings;
  Tier tier = subject.model.tier;
  if (tier == Tier::estimate) return told;  // it takes the surfaces as smooth
  const std::vector<Tier> possible = possible_tiers(subject);
  if (tier == Tier::automatic && !possible.empty()) tier = possible.back();
  const Physics physics = physics_of(subject, tier);
  for (const Note& note : input_warnings(subject, physics)) told.push_back(words_of(note));
  if (!physics.thermal_deformation) return told;
  if (const auto closed = closed_at_rest(subject)) {
    told.push_back(told::told_without_clearance(*closed));
  }
  return told;
}

std::string tier_names(const std::vector<Tier>& tiers) {
  std::string names;
  for (const Tier tier : tiers) names += (names.empty() ? "" : ", ") + std::string(to_string(tier));
  return names;
}

}  // namespace

void print_check(std::ostream& out, const Case& subject, WholeCycle cycle) {
  out << (subject.title.empty() ? subject.path : subject.title) << "\n";
  out << fmt::format("  {}: the case can be solved; tier {}, data for {}\n", subject.path,
                     to_string(subject.model.tier), tier_names(possible_tiers(subject)));
  if (subject.cycle) {
    print_cycle(out, subject);
    if (cycle == WholeCycle::estimated) print_cycle_estimate(out, subject);
    const Case steady = at_largest_load(subject);
    if (steady.operation.omega != 0.0) {
      const bool back = turns_back(cycle_numbers(*subject.cycle, subject.operation.omega));
      out << "\nBelow: as if the largest load and the mean speed"
          << (back ? " without its sign" : "")
          << " would stay. A film that is squeezed carries more.\n";
      print_steady(out, steady);
    }
  } else {
    print_steady(out, subject);
  }
  print_list(out, "Warnings", warnings_of(subject));
  print_list(out, "Assumptions", subject.assumptions);
}

}  // namespace shellback::app
