/// [load_cycle]: a table of loads over time or crank angle, or the load of a big end.
#include <fmt/format.h>

#include <cmath>

#include "app/reading/did_you_mean.hpp"
#include "app/reading/load_table.hpp"
#include "app/reading/sections.hpp"
#include "bearing/over_time/cycle_numbers.hpp"
#include "bearing/shown.hpp"

namespace shellback::app {
namespace {

using namespace bearing;

/// A length of the cycle: crank angle [rad] or time [s].
struct Extent {
  double value = 0.0;
  bool angle = false;
};

Extent read_extent(const Section& section, const std::string& key) {
  if (!section.is_text(key)) {
    section.fail(key, "a crank angle or a time is wanted, in quotes with its unit (deg, ms)");
  }
  const std::string text = section.text(key);
  Extent extent;
  try {
    extent.value = parse_quantity(text, kTime);
  } catch (const UnitError&) {
    try {
      extent = {parse_quantity(text, kAngle), true};
    } catch (const UnitError&) {
      section.fail(key, fmt::format("{} is neither a crank angle nor a time; write for example {} "
                                    "= \"1 deg\" or {} = \"0.1 ms\"",
                                    in_quotes(text), key, key));
    }
  }
  if (!(extent.value > 0.0)) {
    section.fail(key, fmt::format("{} is not possible (it must be positive)", in_quotes(text)));
  }
  return extent;
}

std::optional<Extent> maybe_extent(const Section& section, const std::string& key) {
  if (!section.has(key)) return std::nullopt;
  return read_extent(section, key);
}

/// The crank's speed, which turns `what` into time; `other` is how to do without. Fails if it
/// stands still.
double crank_speed(const Section& file, double omega, const std::string& what,
                   const std::string& other = "tell the cycle in time (ms)") {
  if (omega != 0.0) return std::abs(omega);
  throw error_at(file.reader().place("operation.speed"), "operation.speed",
                 fmt::format("{}, which the speed of the crank turns into time, but the speed is "
                             "zero; give the crank's speed, or {}",
                             what, other));
}

LoadInterpolation read_interpolation(const Section& section, bool periodic) {
  if (!section.has("interpolation")) return LoadInterpolation::linear;
  const auto chosen = section.choice<LoadInterpolation>(
      "interpolation", {{"linear", LoadInterpolation::linear},
                        {"periodic_spline", LoadInterpolation::periodic_spline}});
  if (chosen == LoadInterpolation::periodic_spline && !periodic) {
    section.fail("interpolation",
                 "a periodic spline needs a period; add for example period = \"720 deg\", or write "
                 "\"linear\"");
  }
  return chosen;
}

void read_mass_step_and_instants(const Section& file, const Section& section, double omega,
                                 LoadCycle& c) {
  c.journal_mass = section.maybe_quantity("journal_mass", kMass, kNotNegative).value_or(0.0);
  const auto step = maybe_extent(section, "step");
  for (const std::string& at :
       section.has("fields_at") ? section.texts("fields_at") : std::vector<std::string>{}) {
    c.fields_at.push_back(read_instant(section, "fields_at", at, omega));
  }
  if (!step) return;
  c.step = step->angle ? step->value / crank_speed(file, omega, "load_cycle.step is a crank angle")
                       : step->value;
}

/// By which every load is multiplied.
double read_factor(const Section& section) {
  const double factor = section.maybe_quantity("factor", kNumber.such_as("1.0")).value_or(1.0);
  if (factor > 0.0) return factor;
  section.fail("factor", "the loads are multiplied by it: give a number above 0");
}

LoadCycle cycle_of_table(const Section& file, const Section& section, double omega) {
  const auto period = maybe_extent(section, "period");
  const LoadInterpolation interpolation = read_interpolation(section, period.has_value());
  LoadTable table(table_beside(section, "file"));
  const bool angle = table.told_in_angle();
  if (period && period->angle != angle) {
    section.fail("period",
                 fmt::format("the period is {}, but the table has a column {}; give both in crank "
                             "angle or both in time",
                             period->angle ? "a crank angle" : "a time", angle ? "angle" : "time"));
  }
  const double speed =
      angle ? crank_speed(file, omega, "the load's table is told in crank angle") : 0.0;
  // Divided as instants and windows are: what is told at the period's end lies on it.
  const double by = angle ? speed : 1.0;
  LoadCycle c = table.cycle(by, period ? period->value / by : kInfinite, interpolation);
  for (const std::string& doubt : table.doubts()) section.warn("file", doubt);
  c.crank_speed = speed;
  read_mass_step_and_instants(file, section, omega, c);
  table.expect_mass(c);
  return c;
}

LoadCycle cycle_of_crank(const Section& file, const std::optional<Section>& section,
                         CrankFrame frame, double omega) {
  std::optional<double> period;
  if (section) {
    for (const char* key : {"file", "interpolation"}) {
      if (!section->has(key)) continue;
      section->fail(key, "the load comes from [crank]; take one of the two out");
    }
    if (const auto given = maybe_extent(*section, "period")) {
      if (!given->angle) section->fail("period", "with [crank] the period is 360 deg or 720 deg");
      period = given->value;
    }
  }
  const Section crank_section = file.section("crank");
  const Crank crank = read_crank(crank_section, period, frame);
  static_cast<void>(crank_speed(file, omega, "[crank] tells the load by the crank's angle",
                                "a table of the load over time (load_cycle.file)"));
  LoadCycle c = crank_load(crank, omega, frame);
  if (section) read_mass_step_and_instants(file, *section, omega, c);
  if (c.journal_mass <= 0.0 && vanishing_load(c)) {
    crank_section.fail(
        "", fmt::format("the load of the {} vanishes or passes through zero, and nothing tells "
                        "where a journal without mass then is; give rod_mass, or "
                        "load_cycle.journal_mass",
                        frame == CrankFrame::rod ? "big end" : "main bearing"));
  }
  return c;
}

/// None: the shell stands still, and the load comes from a table.
std::optional<CrankFrame> read_frame(const Section& file, const std::optional<Section>& section) {
  using Frame = std::optional<CrankFrame>;
  const bool crank = file.has("crank");
  if (!section || !section->has("frame")) return crank ? Frame(CrankFrame::rod) : std::nullopt;
  const auto frame = section->choice<Frame>(
      "frame", {{"shell", std::nullopt}, {"rod", CrankFrame::rod}, {"block", CrankFrame::block}});
  if (frame && !crank) {
    section->fail("frame", fmt::format("in the frame of a {} load and speed come from [crank], "
                                       "which is not given; add it, or write \"shell\"",
                                       *frame == CrankFrame::rod ? "rod" : "block"));
  }
  if (!frame && crank) {
    section->fail("frame",
                  "[crank] gives the load of a big end in the frame of the rod, or of a main "
                  "bearing in that of the block; write \"rod\" or \"block\", or take [crank] out");
  }
  return frame;
}

/// Loads are what the table or the crank says: the weight of what moves with the journal is none of
/// them. Told where it would count.
void tell_weight(const Section& file, double omega, const LoadCycle& c) {
  constexpr double kGravity = 9.80665;  // [m/s2]
  constexpr double kCounts = 0.01;      // of the largest load: the usual tolerance [-]
  const double weight = kGravity * c.journal_mass;
  if (weight <= kCounts * cycle_numbers(c, omega).largest) return;
  file.reader().assumptions.push_back(
      fmt::format("the weight of load_cycle.journal_mass, {}, is no part of the load",
                  bearing::shown(weight, "N")));
}

}  // namespace

double read_instant(const Section& section, const std::string& key, const std::string& text,
                    double omega) {
  try {
    return parse_quantity(text, kTime);
  } catch (const UnitError&) {
  }
  try {
    const double angle = parse_quantity(text, kAngle);
    if (omega != 0.0) return angle / std::abs(omega);
  } catch (const UnitError&) {
    section.fail(key, fmt::format("{} is neither a crank angle nor a time; write for example "
                                  "{} = [\"0 deg\", \"360 deg\"]",
                                  in_quotes(text), key));
  }
  section.fail(key, "the speed is zero and turns no crank angle into time; give times (ms)");
}

std::optional<LoadCycle> read_load_cycle(const Section& file, double omega) {
  if (!file.has("load_cycle") && !file.has("crank")) return std::nullopt;
  const auto section = file.maybe_section("load_cycle");
  if (section) {
    section->only(
        {"file", "period", "interpolation", "journal_mass", "frame", "step", "factor", "fields_at"},
        "[load_cycle]");
  }
  const auto frame = read_frame(file, section);
  LoadCycle c =
      frame ? cycle_of_crank(file, section, *frame, omega) : cycle_of_table(file, *section, omega);
  const double factor = section ? read_factor(*section) : 1.0;
  for (double& x : c.x) x *= factor;
  for (double& y : c.y) y *= factor;
  tell_weight(file, omega, c);
  return c;
}

}  // namespace shellback::app
