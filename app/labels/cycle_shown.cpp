#include "app/labels/cycle_shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "app/labels/table_parts.hpp"
#include "app/words/note_words.hpp"
#include "bearing/quantities.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

using bearing::CycleInstant;
using bearing::CycleQuantity;
using bearing::CycleResult;

/// A member of an instant that is followed.
struct Member {
  const char* name;
  const char* unit;
  const char* long_name;
  double CycleInstant::*value;
};
constexpr std::array kMembers{
    Member{"h_min", "m", "smallest film", &CycleInstant::h_min},
    Member{"h_min_angle", "rad", "where the film is smallest", &CycleInstant::h_min_angle},
    Member{"eccentricity_x", "1", "journal position over the cold clearance, X", &CycleInstant::ex},
    Member{"eccentricity_y", "1", "journal position over the cold clearance, Y", &CycleInstant::ey},
    Member{"velocity_x", "m/s", "velocity of the journal, X", &CycleInstant::vx},
    Member{"velocity_y", "m/s", "velocity of the journal, Y", &CycleInstant::vy},
    Member{"tilt_x", "rad", "tilt of the journal about X", &CycleInstant::tilt_x},
    Member{"tilt_y", "rad", "tilt of the journal about Y", &CycleInstant::tilt_y},
    Member{"p_max", "Pa", "largest film pressure, gauge", &CycleInstant::p_max},
    Member{"p_asperity_max", "Pa", "largest contact pressure", &CycleInstant::p_asperity_max},
    Member{"friction_torque", "N m", "friction torque on the journal", &CycleInstant::torque},
    Member{"friction_torque_asperity", "N m", "part of it from asperities",
           &CycleInstant::torque_asperity},
    Member{"friction_torque_abrasive", "N m", "of that abrasive", &CycleInstant::torque_abrasive},
    Member{"friction_torque_adhesive", "N m", "of that adhesive", &CycleInstant::torque_adhesive},
    Member{"friction_torque_micro_hydrodynamic", "N m", "of that micro-hydrodynamic",
           &CycleInstant::torque_micro_hydrodynamic},
    Member{"breakaway_torque", "N m", "torque at which a journal at rest begins to turn",
           &CycleInstant::breakaway},
    Member{"power_loss", "W",
           "friction torque times speed, and the work of the load on the moving journal",
           &CycleInstant::power},
    Member{"load_x", "N", "load on the journal, X", &CycleInstant::load_x},
    Member{"load_y", "N", "load on the journal, Y", &CycleInstant::load_y},
    Member{"speed", "rad/s", "speed of the journal against the shell", &CycleInstant::omega},
    Member{"supply_flow", "m3/s", "supply flow, mean over the step that ends there",
           &CycleInstant::supply_flow},
    Member{"side_flow", "m3/s", "side flow, mean over the step that ends there",
           &CycleInstant::side_flow},
    Member{"oil", "kg", "oil in the gap, without the pockets of grooves and holes",
           &CycleInstant::oil},
    Member{"p_vessel", "Pa", "smallest pressure of the supplies' vessels, gauge",
           &CycleInstant::p_vessel},
    Member{"T_film_max", "K", "largest film temperature", &CycleInstant::T_film_max},
    Member{"T_shell_max", "K", "largest shell surface temperature", &CycleInstant::T_shell_max},
    Member{"heat_to_shell", "W", "heat into the shell, mean over the step that ends there",
           &CycleInstant::heat_to_shell},
    Member{"heat_to_shaft", "W", "heat into the shaft, mean over the step that ends there",
           &CycleInstant::heat_to_shaft},
    Member{"step", "s", "length of the time step that led there", &CycleInstant::dt}};

std::vector<double> column(const CycleResult& cycle, double CycleInstant::*value, double factor) {
  std::vector<double> all;
  for (const CycleInstant& i : cycle.instants) all.push_back(factor * (i.*value));
  return all;
}

bool known(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

bool has_crank(const CycleResult& cycle) { return cycle.crank_speed > 0.0; }

bool is_measured(const bearing::Measured& measured, const CycleResult& cycle) {
  return std::any_of(cycle.quantities.begin(), cycle.quantities.end(), [&](const auto& q) {
    return measured_value(measured, q.quantity).has_value();
  });
}

double shown_instant(const CycleResult& cycle, double t) {
  return has_crank(cycle) ? t * cycle.crank_speed * 180.0 / kPi : t;
}

std::string told_unit(const CycleResult& cycle) { return has_crank(cycle) ? "deg" : "s"; }

CycleSeries instants_told(const CycleResult& cycle) {
  CycleSeries series{has_crank(cycle) ? "angle" : "time",
                     told_unit(cycle),
                     has_crank(cycle) ? "crank angle" : "time within the cycle",
                     {}};
  for (const CycleInstant& i : cycle.instants) series.values.push_back(shown_instant(cycle, i.t));
  return series;
}

std::vector<CycleSeries> followed(const bearing::Case& c, const CycleResult& cycle) {
  std::vector<CycleSeries> all;
  for (const Member& m : kMembers) {
    const bool position = m.value == &CycleInstant::ex || m.value == &CycleInstant::ey;
    const double factor = position ? 1.0 / c.bearing.radial_clearance : 1.0;
    CycleSeries series{m.name, m.unit, m.long_name, column(cycle, m.value, factor)};
    if (series.values.empty() || known(series.values)) all.push_back(std::move(series));
  }
  return all;
}

std::vector<CycleInstant> instants_of(const std::vector<double>& t,
                                      const std::vector<CycleSeries>& all) {
  std::vector<CycleInstant> instants(t.size());
  for (std::size_t k = 0; k < t.size(); ++k) instants[k].t = t[k];
  for (const CycleSeries& series : all) {
    const auto m = std::find_if(kMembers.begin(), kMembers.end(),
                                [&](const Member& member) { return series.name == member.name; });
    if (m == kMembers.end() || series.values.size() != t.size()) continue;
    for (std::size_t k = 0; k < t.size(); ++k) instants[k].*(m->value) = series.values[k];
  }
  return instants;
}

std::string cycle_label(const CycleQuantity& q) {
  const std::string& name = q.quantity.name;
  if (bearing::find_quantity(name) == nullptr) {
    for (const auto& [ending, words] :
         {std::pair{"_mean", ", mean"}, std::pair{"_max", ", largest"},
          std::pair{"_min", ", smallest"}}) {
      const std::string stem = name.substr(0, name.rfind('_'));
      if (name.ends_with(ending) && bearing::find_quantity(stem) != nullptr) {
        return quantity_label(stem) + words;
      }
    }
  }
  const std::string label = quantity_label(name);
  const bool said = label.starts_with(' ') || label.find("mean") != std::string::npos;
  const bool mean = !std::isfinite(q.at) && !said;  // a part is a mean as its whole above it
  return mean ? label + ", mean" : label;
}

DisplayUnit cycle_unit(const CycleQuantity& q) {
  return display_unit(q.quantity.name, q.quantity.unit, std::abs(q.quantity.value));
}

std::vector<AuditFigure> audit_of(const CycleResult& cycle) {
  const double none = cycle.instants.empty() ? std::numeric_limits<double>::quiet_NaN() : 1.0;
  const bearing::CycleAudit& a = cycle.audit;
  std::vector<AuditFigure> all{{"mass", none * a.mass},
                               {"content", none * a.content},
                               {"impulse", none * a.impulse},
                               {"load", none * a.load},
                               {"moment", none * a.moment}};
  if (!std::isfinite(a.energy)) return all;
  all.push_back({"energy", a.energy});
  all.push_back({"work", a.work});
  all.push_back({"walls", a.walls, "K"});
  return all;
}

std::string audit_words(const CycleResult& cycle) {
  std::string words;
  for (const AuditFigure& a : audit_of(cycle)) {
    if (!words.empty()) words += "  ";
    words += a.name + " " + audit_figure(a.value);
    if (a.unit != "1") words += " " + a.unit;
  }
  return words;
}

std::string meaning_of_the_rest(const CycleResult& cycle) {
  if (cycle.instants.empty()) return "No instant was found.";
  return fmt::format("The numbers are of what was found, up to {} {} of the cycle that ran last.",
                     figures(shown_instant(cycle, cycle.instants.back().t)), told_unit(cycle));
}

std::string choice_words(const bearing::AutoChoice& k) {
  return fmt::format("chosen by auto for {:.3g} %: {}; mean friction torque {}, smallest film {}",
                     100.0 * k.tolerance, k.met ? "met" : "NOT MET", known_within(k.bar_friction),
                     known_within(k.bar_h_min));
}

std::string how_it_ran(const bearing::Case& c, const CycleResult& cycle) {
  const std::string steps =
      fmt::format("; {} steps, {} rejected", cycle.steps, cycle.rejected_steps);
  const bool timed = std::isfinite(cycle.period) && cycle.period > 0.0;
  const std::string length = timed ? duration_words(cycle.period) : "";
  const bool closed = std::isfinite(cycle.closure);
  if (c.cycle && !c.cycle->repeats() && timed) return "an event of " + length + steps;
  std::string words = fmt::format("{} cycle{}", cycle.cycles, cycle.cycles == 1 ? "" : "s");
  if (closed) words += fmt::format(", the last is periodic within {:.1e}", cycle.closure);
  if (cycle.growth < 1.0) {
    constexpr double kAtOnce = 0.05;
    words += cycle.growth < kAtOnce
                 ? ", displaced, journal and oil come back at once"
                 : fmt::format(", displaced, journal and oil come back by {:.2g} % in each",
                               100.0 * (1.0 - cycle.growth));
  }
  words += steps;
  return timed ? words + "; period " + length : words;
}

}  // namespace shellback::app
