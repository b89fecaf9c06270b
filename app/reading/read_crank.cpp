/// [crank] and its table of cylinder pressure.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/reading/csv_table.hpp"
#include "app/reading/sections.hpp"
#include "bearing/row_gaps.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

constexpr double kTurn = 2.0 * kPi;
constexpr double kSame = 1e-9;           ///< of a turn: angles closer than this are one [-]
constexpr double kSamePressure = 1e-6;   ///< of the largest: as much as tables have [-]
constexpr double kLowestPeak = 5e5;      ///< an engine that hardly compresses has 10 bar [Pa]
constexpr double kHighestPeak = 500e5;   ///< twice what large diesels reach [Pa]
/// A tenth of what large diesels reach: above it no trace in MPa was told as one in bar [Pa].
constexpr double kOnceMegapascals = 25e5;
constexpr double kVacuum = -101325.0;    ///< gauge; standard atmosphere, definition [Pa]
constexpr double kLowCompression = 8.0;  ///< of petrol 8 to 12, diesel 12 to 24 (textbook) [-]
constexpr double kPolytropic = 1.3;      ///< of compression in engines: 1.3 to 1.35 (textbook) [-]
constexpr double kLongestRod = 0.1;      ///< r/l; engines have 0.2 to 0.35 (textbook) [-]
constexpr double kShortestRod = 0.5;     ///< the same [-]
/// Of the largest pressure from a top dead centre: combustion has it within some 20 degrees
/// (textbook), a late one with pilot injections within 30 [rad].
constexpr double kLatestPeak = 0.25 * kPi;
/// Of a piston with its pin over the cube of the bore; engines have 500 to 2500 (textbook), and
/// five times less or more is a unit [kg/m3].
constexpr Range kPistonDensity{100.0, 12500.0};
constexpr const char* kPressureExample = "angle [deg], pressure [bar]";

/// Angles rise, and no two rows are farther apart than the period: where it begins does not matter.
void expect_angles(const CsvTable& table, double period) {
  const std::vector<double>& angle = table.column("angle");
  constexpr double kRadians = 4.0 * kPi * kPi / 180.0;  // two turns in radians, read as degrees
  if (std::abs(angle.back() - angle.front()) < kRadians * (1.0 + 1e-3)) {
    table.fail_header(
        fmt::format("the angles reach from {} to {}, a small part of a turn; check "
                    "their unit in this line (radians given as deg look like this)",
                    table.written(0, "angle"), table.written(angle.size() - 1, "angle")));
  }
  for (std::size_t k = 0; k < angle.size(); ++k) {
    if (k > 0 && !(angle[k] > angle[k - 1])) {
      table.fail(k, "angle",
                 fmt::format("{} does not come after {}; sort the rows by angle and give each once",
                             table.written(k, "angle"), table.written(k - 1, "angle")));
    }
    if (angle[k] - angle.front() > period * (1.0 + kSame)) {
      table.fail(
          k, "angle",
          fmt::format("{} lies more than the period of {:.6g} deg after the first row, {}; "
                      "give one period, or correct load_cycle.period",
                      table.written(k, "angle"), period * 180.0 / kPi, table.written(0, "angle")));
    }
  }
}

void expect_pressures(const CsvTable& table) {
  const std::vector<double>& p = table.column("pressure");
  const auto [low, high] = std::minmax_element(p.begin(), p.end());
  const auto row = [&](auto at) { return static_cast<std::size_t>(at - p.begin()); };
  if (*low < kVacuum) {
    table.fail(row(low), "pressure",
               fmt::format("{} lies below vacuum (-1.013 bar); pressures are counted from ambient; "
                           "check the unit in the first line, too",
                           table.written(row(low), "pressure")));
  }
  if (*high < kLowestPeak || *high > kHighestPeak) {
    table.fail(row(high), "pressure",
               fmt::format("the largest cylinder pressure is {}, which no engine has (5 to 500 "
                           "bar); check the unit in the first line",
                           table.written(row(high), "pressure")));
  }
}

/// A trace covers its period. Unlike a load, no pressure stays for long in a cylinder whose piston
/// moves: also between two rows that are alike the line must be said to be meant.
void expect_no_gap(const Section& section, const CsvTable& table, double period) {
  for (const bearing::RowGap& gap : bearing::row_gaps(table.column("angle"), period)) {
    const bool last = gap.to == 0;
    const std::string problem = fmt::format(
        "from {} to {}{} no row tells the pressure, {:.3g} times as far as rows stand apart "
        "elsewhere; add the rows{}; a straight line that is meant has a row half way",
        table.written(gap.from, "angle"), table.written(gap.to, "angle"),
        last ? " of the next period" : "", gap.times,
        last ? fmt::format(", or correct load_cycle.period (taken: {:.6g} deg)",
                           period * 180.0 / kPi)
             : "");
    if (gap.times > bearing::kLineToRefuse) table.fail(gap.from, "angle", problem);
    section.warn("pressure", problem);
  }
}

/// n of p V^n = const between 80 and 60 degrees before the dead centre nearest to the largest
/// pressure, where valves are shut and nothing burns yet; V above a dead volume of an eighth, and n
/// with it, is no smaller than in engines that compress more [-].
double exponent_of_compression(const bearing::Crank& crank, double peak) {
  const double dead_centre = kTurn * std::round(peak / kTurn);
  const auto volume = [&](double theta) {
    const double top = 0.5 * crank.stroke + crank.rod_length;
    const double swept = top - bearing::crank_motion(crank, theta, 1.0).piston;
    return 1.0 / (kLowCompression - 1.0) + swept / crank.stroke;
  };
  const auto pressure = [&](double theta) {
    return bearing::cylinder_pressure(crank, dead_centre + theta) - kVacuum;
  };
  const double begin = -kTurn * 80.0 / 360.0;
  const double end = -kTurn * 60.0 / 360.0;
  return std::log(pressure(end) / pressure(begin)) / std::log(volume(begin) / volume(end));
}

/// Gas that is shut in and compressed gains more than in proportion to its density (n > 1; n = 1:
/// isothermal). Gauge pressures in a tenth of their unit do not, beside the ambient pressure that
/// is added to them.
void expect_gas(const CsvTable& table, const bearing::Crank& crank) {
  const std::vector<double>& p = table.column("pressure");
  const auto row = static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin());
  if (p[row] > kOnceMegapascals) return;
  const double n = exponent_of_compression(crank, table.column("angle")[row]);
  if (!(n < 1.0)) return;
  table.fail(row, "pressure",
             fmt::format("the largest cylinder pressure is {}, and from 80 to 60 deg before the dead "
                         "centre pressure rises less than that of gas which is shut in (p V^n with "
                         "n = {:.2g}, where no compression is below 1); check the unit in the "
                         "first line (psi or MPa given as bar look like this); for what is no "
                         "engine give forces in load_cycle.file",
                         table.written(row, "pressure"), n));
}

/// Gauge pressures in a wrong unit lose what ambient pressure adds to them: the trace spans less
/// than its own compression. What a compressor or an engine that hardly compresses has is told.
void expect_compression(const Section& section, const CsvTable& table) {
  const std::vector<double>& p = table.column("pressure");
  const auto [low, high] = std::minmax_element(p.begin(), p.end());
  const double span = (*high - kVacuum) / (*low - kVacuum);
  const double compressed = std::pow(kLowCompression, kPolytropic);
  if (!(span < compressed)) return;
  const auto row = static_cast<std::size_t>(high - p.begin());
  section.warn(
      "pressure",
      fmt::format("the largest cylinder pressure, {} ({}), is {:.3g} times the smallest (both "
                  "absolute), less than the {:.3g} times that compression to an eighth makes "
                  "without any combustion; unless this is a compressor, check the unit in the "
                  "first line (psi or MPa given as bar look like this)",
                  table.written(row, "pressure"), table.place(row, "pressure"), span, compressed));
}

/// Combustion and compression have their largest pressure near a top dead centre.
void expect_peak_near_dead_centre(const Section& section, const CsvTable& table) {
  const std::vector<double>& p = table.column("pressure");
  const auto row = static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin());
  const double off = std::remainder(table.column("angle")[row], kTurn);
  if (std::abs(off) <= kLatestPeak) return;
  section.warn("pressure",
               fmt::format("the largest cylinder pressure, {} ({}), stands at {}, {:.3g} deg from "
                           "the nearest top dead centre; angles are counted from the top dead "
                           "centre of combustion (from the bottom one they look like this); shift "
                           "the column",
                           table.written(row, "pressure"), table.place(row, "pressure"),
                           table.written(row, "angle"), std::abs(off) * 180.0 / kPi));
}

/// A trace from any angle on, from -360 deg for example, as one of the period that begins at 0. A
/// last row a period behind the first says that it is the same, and goes.
void turn_into_period(const CsvTable& table, bearing::Crank& crank) {
  std::vector<double>& angle = crank.angle;
  std::vector<double>& p = crank.pressure;
  if (angle.back() - angle.front() >= crank.period * (1.0 - kSame)) {
    const std::size_t last = angle.size() - 1;
    const double jump = p.front() - p.back();
    if (std::abs(jump) > kSamePressure * *std::max_element(p.begin(), p.end())) {
      table.fail(last, "pressure",
                 fmt::format("the pressure is not periodic: from {} here to {} at {} it jumps by "
                             "{:.4g} bar; make the two equal, or take one of the rows out",
                             table.written(last, "pressure"), table.written(0, "pressure"),
                             table.written(0, "angle"), 1e-5 * std::abs(jump)));
    }
    angle.pop_back();
    p.pop_back();
  }
  for (double& x : angle) {
    x -= crank.period * std::floor(x / crank.period + kSame);
    x = std::max(x, 0.0);
  }
  const auto first = std::min_element(angle.begin(), angle.end()) - angle.begin();
  std::rotate(angle.begin(), angle.begin() + first, angle.end());
  std::rotate(p.begin(), p.begin() + first, p.end());
}

/// Four strokes if the table spans, or reaches, more than one turn.
double period_of(const Section& section, const CsvTable& table,
                 const std::optional<double>& period) {
  if (period) return *period;
  const std::vector<double>& angle = table.column("angle");
  const double reach = std::max(angle.back(), angle.back() - angle.front());
  const bool four = reach > kTurn * (1.0 + kSame);
  section.assume(
      fmt::format("the cylinder fires every {} deg of crank angle, since crank.pressure "
                  "{} (load_cycle.period is not given)",
                  four ? 720 : 360, four ? "reaches beyond 360 deg" : "ends there or before"));
  return four ? 2.0 * kTurn : kTurn;
}

void read_pressure(const Section& section, const std::optional<double>& period,
                   bearing::Crank& crank) {
  const CsvTable table(table_beside(section, "pressure"),
                       {{"angle", kAngle}, {"pressure", kPressure}}, kPressureExample);
  if (table.rows() < 2) table.fail_header("a course of pressure has two rows or more");
  crank.angle = table.column("angle");
  crank.pressure = table.column("pressure");
  crank.period = period_of(section, table, period);
  expect_angles(table, crank.period);
  expect_pressures(table);
  expect_no_gap(section, table, crank.period);
  expect_compression(section, table);
  expect_peak_near_dead_centre(section, table);
  turn_into_period(table, crank);
  expect_gas(table, crank);
}

void expect_piston(const Section& section, const bearing::Crank& crank) {
  const double density = crank.piston_mass / std::pow(crank.bore, 3);
  if (kPistonDensity.low <= density && density <= kPistonDensity.high) return;
  section.warn("piston_mass",
               fmt::format("{:.4g} kg for a bore of {:.4g} mm are {:.3g} kg for each cube of the "
                           "bore in dm3, where pistons with pin and upper rod have 0.5 to 2.5; "
                           "check the units of both",
                           crank.piston_mass, 1e3 * crank.bore, 1e-3 * density));
}

bool is_period(double period) {
  return std::abs(period - kTurn) < kSame * kTurn || std::abs(period - 2.0 * kTurn) < kSame * kTurn;
}

/// What only main bearings know of: the throw's counterweight and the share of one bearing.
void read_throw(const Section& section, bearing::CrankFrame frame, bearing::Crank& crank) {
  if (frame == bearing::CrankFrame::rod) {
    for (const char* key : {"counterweight", "share"}) {
      if (!section.has(key)) continue;
      section.fail(key, fmt::format("{} belongs to a main bearing, not to the big end; take it "
                                    "out, or write load_cycle.frame = \"block\"",
                                    key));
    }
    return;
  }
  if (section.has("counterweight")) {
    crank.counterweight = section.quantity("counterweight", kMassMoment, kNotNegative);
  } else {
    section.assume("the crank has no counterweight (crank.counterweight is not given)");
  }
  if (!section.has("share")) {
    section.assume("two main bearings share the load of the throw (crank.share is not given)");
    return;
  }
  crank.share = section.quantity("share", kNumber.such_as("0.5"), kPositive);
  if (crank.share > 1.0) section.fail("share", "a bearing carries at most the whole throw: 1");
}

}  // namespace

bearing::Crank read_crank(const Section& section, const std::optional<double>& period,
                          bearing::CrankFrame frame) {
  section.only({"stroke", "rod_length", "bore", "piston_mass", "rod_mass", "pressure",
                "counterweight", "share"},
               "[crank]");
  if (period && !is_period(*period)) {
    throw error_at(section.reader().place("load_cycle.period"), "load_cycle.period",
                   "a cylinder fires every 360 deg (two strokes) or 720 deg (four)");
  }
  bearing::Crank crank;
  crank.stroke = section.quantity("stroke", kLength.such_as("80 mm"), kPositive);
  crank.rod_length = section.quantity("rod_length", kLength.such_as("140 mm"), kPositive);
  crank.piston_mass = section.quantity("piston_mass", kMass, kNotNegative);
  crank.rod_mass = section.quantity("rod_mass", kMass, kNotNegative);
  read_throw(section, frame, crank);
  const double ratio = 0.5 * crank.stroke / crank.rod_length;
  if (ratio >= 1.0) {
    section.fail("rod_length",
                 "a rod shorter than half the stroke lets no crank turn; check the units of both");
  }
  if (ratio > kShortestRod || ratio < kLongestRod) {
    section.warn("rod_length", fmt::format("half the stroke is {:.3g} of the rod's length, where "
                                           "engines have 0.2 to 0.35; check the units of both",
                                           ratio));
  }
  section.assume(
      "the crank turns at constant speed; friction of piston and piston pin, and weight, are left "
      "out ([crank])");
  if (section.has("pressure")) {
    crank.bore = section.quantity("bore", kLength.such_as("80 mm"), kPositive);
    read_pressure(section, period, crank);
    expect_piston(section, crank);
  } else {
    if (section.has("bore")) {
      section.fail("bore",
                   "it turns cylinder pressure into a force, and there is none; give "
                   "crank.pressure, the table, or take the bore out");
    }
    if (crank.piston_mass <= 0.0 && crank.rod_mass <= 0.0 && crank.counterweight <= 0.0) {
      section.fail("piston_mass",
                   "no gas and no mass load the bearing; give crank.pressure, or the masses");
    }
    section.assume("there is no gas in the cylinder (crank.pressure is not given)");
    crank.period = period.value_or(kTurn);
  }
  return crank;
}

}  // namespace shellback::app
