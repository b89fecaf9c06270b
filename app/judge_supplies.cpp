#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/judge_case.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

using namespace coupling;

constexpr double kMostCover = 0.9;      ///< of the surface; above, hardly any film is left [-]
constexpr double kUsualCover = 0.3;     ///< of the surface [-]
constexpr double kHighPressure = 50e5;  ///< above, the supply is hydrostatic [Pa]
constexpr double kRoundOff = 1e-9;      ///< relative slack when lengths are compared [-]

/// Refuses a supply that reaches over the bearing's edge.
void judge_axial(const Supply& s, const Bearing& b, const std::string& path, const Reader& reader) {
  const double half = 0.5 * b.width;
  const bool line = s.kind == SupplyKind::axial_groove && s.arc == 0.0;
  const std::string key = s.kind == SupplyKind::hole           ? path + ".diameter"
                          : s.kind == SupplyKind::axial_groove ? path + ".length"
                                                               : path + ".width";
  const double reach = std::abs(s.z) + 0.5 * s.length;
  if (s.length > b.width * (1.0 + kRoundOff)) {
    refuse(reader, key,
           fmt::format("{} is more than the bearing's width of {}", show(s.length, "mm", kLength),
                       show(b.width, "mm", kLength)));
  }
  if (reach > half * (1.0 + kRoundOff)) {
    refuse(reader, reader.given(path + ".z") ? path + ".z" : key,
           fmt::format("the supply reaches to {} from mid-width, over the bearing's edge at {}",
                       show(reach, "mm", kLength), show(half, "mm", kLength)));
  }
  if (line || reach < half * (1.0 - kRoundOff)) return;
  if (s.length >= b.width * (1.0 - kRoundOff)) {
    const bool hole = s.kind == SupplyKind::hole;
    refuse(reader, key,
           fmt::format(
               "the {} is as wide as the bearing and so open to the sides, where ambient "
               "pressure rules: it cannot hold its supply pressure. Make it {}",
               hole ? "hole" : "groove",
               hole ? "smaller" : "shorter; only a line (arc = \"0 deg\") may span the width"));
  }
  refuse(reader, key,
         "the supply touches the bearing's edge, where ambient pressure rules: it "
         "cannot hold its supply pressure; leave a land");
}

void judge_pressure(Case& subject, const Supply& s, const std::string& path, const Reader& reader) {
  const double p_cav = subject.model.cavitation_pressure;
  const std::string key =
      path + (reader.given(path + ".pressure") ? ".pressure" : ".pressure_absolute");
  if (s.pressure < p_cav) {
    refuse(reader, key,
           fmt::format("the supply pressure {} lies below the cavitation pressure {} (both "
                       "gauge): no oil would enter; raise it, or lower "
                       "model.cavitation_pressure",
                       show(s.pressure, "bar", kPressure), show(p_cav, "bar", kPressure)));
  }
  if (s.pressure > kHighPressure) {
    warn(subject, reader, key,
         fmt::format("a supply pressure of {} is unusual for a hydrodynamic bearing",
                     show(s.pressure, "bar", kPressure)));
  }
}

/// Distance between two angles on the circle [rad].
double apart(double a, double b) {
  const double d = std::abs(a - b);
  return std::min(d, 2.0 * kPi - d);
}

bool overlap(const Supply& a, const Supply& b) {
  const bool round = apart(a.angle, b.angle) < 0.5 * (a.arc + b.arc) * (1.0 - kRoundOff);
  const bool along = std::abs(a.z - b.z) < 0.5 * (a.length + b.length) * (1.0 - kRoundOff);
  return round && along;
}

void judge_pairs(Case& subject, const Reader& reader) {
  const auto& list = subject.supplies;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t j = i + 1; j < list.size(); ++j) {
      if (!overlap(list[i], list[j])) continue;
      const std::string key = fmt::format("supply.{}", j);
      const std::string problem = fmt::format("it overlaps supply.{}", i);
      if (list[i].pressure != list[j].pressure || list[i].temperature != list[j].temperature) {
        refuse(reader, key, problem + ", which has another pressure or temperature; move one");
      }
      warn(subject, reader, key, problem);
    }
  }
}

void judge_cover(Case& subject, const Reader& reader) {
  const Bearing& b = subject.bearing;
  double covered = 0.0;
  for (const Supply& s : subject.supplies) {
    const double circle = s.kind == SupplyKind::hole ? kPi / 4.0 : 1.0;
    covered += circle * s.arc * s.length / (2.0 * kPi * b.width);
  }
  const std::string share =
      fmt::format("the supplies cover {:.0f} % of the bearing", 100.0 * covered);
  if (covered > kMostCover) refuse(reader, "supply", share + ": hardly any film is left");
  if (covered > kUsualCover) warn(subject, reader, "supply", share);
}

}  // namespace

void judge_supplies(Case& subject, const Reader& reader) {
  const double p_cav = subject.model.cavitation_pressure;
  if (p_cav > 0.0) {
    refuse(reader,
           reader.given("model.cavitation_pressure") ? "model.cavitation_pressure"
                                                     : "model.cavitation_pressure_absolute",
           fmt::format("{} gauge lies above ambient pressure, which rules at the bearing's ends: "
                       "the film would be cavitated everywhere. Pressures are gauge unless the "
                       "key says absolute",
                       show(p_cav, "bar", kPressure)));
  }
  for (std::size_t k = 0; k < subject.supplies.size(); ++k) {
    const std::string path = fmt::format("supply.{}", k);
    judge_axial(subject.supplies[k], subject.bearing, path, reader);
    judge_pressure(subject, subject.supplies[k], path, reader);
  }
  judge_pairs(subject, reader);
  judge_cover(subject, reader);
}

}  // namespace shellback::app
