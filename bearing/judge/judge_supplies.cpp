#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/judge/judge_parts.hpp"
#include "bearing/judge/value_check.hpp"
#include "bearing/over_time/cycle_numbers.hpp"
#include "bearing/shown.hpp"
#include "core/constants.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

std::string key_of_length(const Supply& s, const std::string& path) {
  switch (s.kind) {
    case SupplyKind::hole:
    case SupplyKind::drilling:
      return path + ".diameter";
    case SupplyKind::axial_groove:
      return path + ".length";
    case SupplyKind::circumferential_groove:
      break;
  }
  return path + ".width";
}

/// Refuses a supply that reaches over the bearing's edge.
void judge_axial(const Supply& s, const Bearing& b, const std::string& path, Findings& to) {
  const double half = 0.5 * b.width;
  const bool line = s.kind == SupplyKind::axial_groove && s.arc == 0.0;
  const std::string key = key_of_length(s, path);
  const double reach = std::abs(s.z) + 0.5 * s.length;
  if (s.length > b.width * (1.0 + kRoundOff)) {
    to.refuse(key,
              fmt::format("{} is more than the bearing's width of {}", shown(s.length, "mm"),
                          shown(b.width, "mm")),
              "leave a land at either side edge");
  } else if (reach > half * (1.0 + kRoundOff)) {
    to.refuse(s.z != 0.0 ? path + ".z" : key,
              fmt::format("the supply reaches to {} from mid-width, over the bearing's edge at {}",
                          shown(reach, "mm"), shown(half, "mm")),
              fmt::format("set its middle within {} of mid-width, or make it shorter",
                          shown(std::max(0.0, half - 0.5 * s.length), "mm")));
  } else if (line || reach < half * (1.0 - kRoundOff)) {
    return;
  } else if (s.pressure == 0.0 && s.length >= b.width * (1.0 - kRoundOff) && !is_round(s)) {
    return;  // open to the sides, where the pressure is its own: the groove of a stern tube
  } else if (s.length >= b.width * (1.0 - kRoundOff)) {
    const bool hole = is_round(s);
    to.refuse(key,
              fmt::format(
                  "the {} is as wide as the bearing and so open to the sides, where ambient "
                  "pressure rules: it cannot hold its supply pressure. Make it {}",
                  hole ? "hole" : "groove",
                  hole ? "smaller" : "shorter; only a line (arc = \"0 deg\") may span the width"));
  } else {
    to.refuse(key,
              "the supply touches the bearing's edge, where ambient pressure rules: it cannot hold "
              "its supply pressure",
              "leave a land");
  }
}

/// A line of given pressure that ends in the film: the flow round its ends goes with the root of
/// the distance, which no grid follows (plain bearing, 16 of 20 mm, 100 x 13 cells: side flow 2.7
/// bars off).
void judge_line(const Supply& s, const Bearing& b, const std::string& path, Findings& to) {
  const bool line = s.kind == SupplyKind::axial_groove && s.arc == 0.0;
  if (!line || s.length >= b.width * (1.0 - kRoundOff)) return;
  to.suspect(path + ".arc",
             "the groove is a line whose ends lie in the film: cells follow the flow round them "
             "slowly, and grids may agree on it too early",
             "give the arc that it has");
}

/// Refuses a supply that reaches round more than the bearing.
void judge_round(const Supply& s, const std::string& path, Findings& to) {
  if (s.arc < 2.0 * kPi || s.kind == SupplyKind::circumferential_groove) return;
  if (is_round(s)) {
    to.refuse(path + ".diameter", "the hole is larger than the bearing's circumference");
  } else {
    to.refuse(path + ".arc",
              "the groove runs all round; that is kind = \"circumferential_groove\"");
  }
}

/// Refuses a channel or a mouth that is none.
void judge_depth(const Supply& s, const Bearing& b, const std::string& path, Findings& to) {
  compare(to, path + ".depth", s.depth, kBearingLimits.channel,
          fmt::format("the supply is {} deep", shown(s.depth, "mm")), "check the unit");
  if (is_round(s)) {
    compare(to, path + ".diameter", s.diameter, kBearingLimits.mouth,
            fmt::format("the mouth is {} wide", shown(s.diameter, "mm")), "check the unit");
  }
  const bool channel = std::holds_alternative<ChannelHeat>(s.heat_transfer);
  if (!channel || s.depth >= b.radial_clearance) return;
  to.refuse(path + ".depth",
            fmt::format("{} is less than the radial clearance of {}: there oil flows as film, and "
                        "no pressure is held",
                        shown(s.depth, "um"), shown(b.radial_clearance, "um")),
            "check the unit; grooves are tenths of a millimetre deep and more");
}

void judge_pressure(const Supply& s, double p_cav, const std::string& path, Findings& to) {
  const std::string key = path + ".pressure";
  if (s.pressure < p_cav) {
    to.refuse(key,
              fmt::format("the supply pressure {} lies below the cavitation pressure {} (both "
                          "gauge): no oil would enter",
                          shown(s.pressure, "bar"), shown(p_cav, "bar")),
              "raise it, or lower model.cavitation_pressure");
  }
  if (s.pressure == p_cav && goes_all_round(s)) {
    to.suspect(
        key,
        "the groove goes all round, so that its pressure alone feeds the film, and that is the "
        "cavitation pressure: no oil enters from it",
        "raise it, or lower model.cavitation_pressure");
  }
  compare(to, key, s.pressure, kBearingLimits.supply_pressure,
          fmt::format("the supply pressure is {}", shown(s.pressure, "bar")), "check the unit");
  if (s.pressure != 0.0 && std::abs(s.pressure) < kBearingLimits.least_pressure) {
    to.suspect(key,
               fmt::format("the supply pressure is {:.4g} Pa, that of a centimetre of oil or less",
                           s.pressure),
               "check the unit (MPa?)");
  }
}

/// A groove in the line of a standing load cuts the film where it presses, unless it presses more.
void judge_line_of_load(const Supply& s, const Case& c, const std::string& path, Findings& to) {
  const auto* load = std::get_if<LoadGiven>(&c.operation.position);
  if (load == nullptr || c.cycle || s.kind != SupplyKind::axial_groove) return;
  const double aside = std::abs(std::remainder(s.angle - load->angle, 2.0 * kPi));
  const double specific = load->force / (2.0 * c.bearing.radius * c.bearing.width);
  const bool most = s.length > 0.5 * c.bearing.width;
  if (!most || aside > 0.5 * s.arc || s.pressure >= specific) return;
  to.suspect(path + ".angle",
             fmt::format("the groove lies where the load presses, fed with less than the {} of the "
                         "load over the bearing's area: little film is left there",
                         shown(specific, "MPa")),
             "put it beside the load or opposite to it");
}

void judge_vessel(const Supply& s, const Case& c, const std::string& path, Findings& to) {
  if (!s.vessel) return;
  const std::string key = path + ".vessel_volume";
  if (!c.cycle) {
    to.refuse(key,
              "a vessel belongs to a load cycle: in a steady state its line is open and the "
              "supply's pressure stands",
              "take vessel_volume, vessel_bulk_modulus and open away, or give [load_cycle]");
    return;
  }
  const ValueCheck vessel(path, to);
  vessel.number("vessel_volume", s.vessel->volume, "m3", kPositive);
  compare(to, key, s.vessel->volume, kBearingLimits.vessel_volume,
          fmt::format("the vessel holds {}", shown(s.vessel->volume, "l")), "check its unit");
  compare(to, path + ".vessel_bulk_modulus", s.vessel->bulk_modulus, kBearingLimits.vessel_modulus,
          fmt::format("oil and vessel together have a bulk modulus of {}",
                      shown(s.vessel->bulk_modulus, "MPa")),
          "check its unit; mineral oil without air in a stiff vessel has 1500 MPa");
  const double head = s.pressure - c.model.cavitation_pressure;
  if (!(head > 0.0)) {
    to.refuse(path + ".pressure", "a vessel at the cavitation pressure feeds nothing", "raise it");
  } else {
    compare(to, path + ".pressure", head, kBearingLimits.vessel_head,
            fmt::format("the vessel's pressure is {} above that of cavitation", shown(head, "bar")),
            "check its unit, or raise it");
  }
  const auto shut = [](const Supply& any) { return any.vessel && any.vessel->open.empty(); };
  if (std::all_of(c.supplies.begin(), c.supplies.end(), shut) && c.cycle->repeats()) {
    to.suspect(path + ".open",
               "no line is ever open and the cycle repeats: what leaves the bearing is not made "
               "up for, and the film runs dry over many cycles",
               "give the windows in which it is open, or take load_cycle.period away (an event)");
  }
  double last = 0.0;
  const double length = c.cycle->length();
  const bool by_angle = c.cycle->crank_speed > 0.0;
  const double unit = by_angle ? kPi / 180.0 / c.cycle->crank_speed : 1.0;  // [s]
  for (const auto& [from, till] : s.vessel->open) {
    const bool fits = from >= last && till > from && till <= length * (1.0 + kRoundOff);
    if (!fits) {
      to.refuse(path + ".open",
                fmt::format("the line is open from {:.6g} to {:.6g} {}, which is no window of its "
                            "own within the {:.6g} of the cycle",
                            from / unit, till / unit, by_angle ? "deg" : "s", length / unit),
                "give rising pairs from 0 to the end; a window over the end is two");
      return;
    }
    last = till;
  }
}

/// What a drilling's vessel would take in from grooves that its mouth passes is not counted.
void judge_vessel_of_drilling(const Supply& s, const Case& c, const std::string& path,
                              Findings& to) {
  const bool fed = std::any_of(c.supplies.begin(), c.supplies.end(), [&](const Supply& other) {
    const double along = std::abs(s.z - other.z) - 0.5 * (s.diameter + other.length);
    return other.kind != SupplyKind::drilling && along < 0.0;
  });
  if (!s.vessel || !fed) return;
  to.suspect(path + ".vessel_volume",
             "the mouth passes over a supply of the shell, and what the vessel takes in there is "
             "not counted",
             "let `open` tell when it is fed");
}

/// A drilling comes back to where it began, and needs a cycle to turn in.
void judge_drilling(const Supply& s, const Case& c, const std::string& path, Findings& to) {
  if (s.kind != SupplyKind::drilling) return;
  if (!c.cycle) {
    to.refuse(path + ".kind",
              "a drilling turns with the journal and belongs to a load cycle: a steady film has "
              "none",
              "give [load_cycle], or write \"hole\" for one in the shell");
    return;
  }
  judge_vessel_of_drilling(s, c, path, to);
  if (!c.cycle->repeats()) return;
  constexpr double kRound = 1e-3;  // of a turn: a third of a degree, less than tables resolve
  const double turns =
      cycle_numbers(*c.cycle, c.operation.omega).mean_speed * c.cycle->period / (2.0 * kPi);
  if (std::abs(turns - std::round(turns)) <= kRound) return;
  to.refuse(path + ".kind",
            fmt::format("the journal turns {:.6g} times in a period of {:.6g} s, so that the "
                        "drilling does not stand at its end where it began",
                        turns, c.cycle->period),
            "give a period of whole turns (load_cycle.period, operation.speed), or a supply in the "
            "shell");
}

/// How two supplies of one wall lie.
enum class Beside { apart, touching, overlapping };

/// Circles, and strips without their corners as far as a circle misses them.
Beside beside(const Supply& a, const Supply& b, double radius) {
  if ((a.kind == SupplyKind::drilling) != (b.kind == SupplyKind::drilling)) return Beside::apart;
  const double apart = radius * std::abs(std::remainder(a.angle - b.angle, 2.0 * kPi));
  const double along = std::abs(a.z - b.z);
  const double reach = 0.5 * ((is_round(a) ? a.length : 0.0) + (is_round(b) ? b.length : 0.0));
  const auto gap = [&](double distance, double of_a, double of_b) {
    return distance - 0.5 * ((is_round(a) ? 0.0 : of_a) + (is_round(b) ? 0.0 : of_b));
  };
  const double x = gap(apart, radius * a.arc, radius * b.arc);
  const double z = gap(along, a.length, b.length);
  if (reach > 0.0) {
    const bool within = std::hypot(std::max(x, 0.0), std::max(z, 0.0)) < reach * (1.0 - kRoundOff);
    return within ? Beside::overlapping : Beside::apart;
  }
  const double slack = kRoundOff * radius;
  // Strips may share an edge; a line on one is within the strip.
  const double least = a.arc == 0.0 || b.arc == 0.0 ? slack : -slack;
  if (x < least && z < -slack) return Beside::overlapping;
  const bool share_edge = std::max(x, z) < slack && std::min(x, z) < -slack;
  return share_edge ? Beside::touching : Beside::apart;
}

void judge_pairs(const std::vector<Supply>& list, double radius, Findings& to) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t j = i + 1; j < list.size(); ++j) {
      const Beside lie = beside(list[i], list[j], radius);
      if (lie == Beside::touching && (list[i].vessel || list[j].vessel)) {
        to.refuse(fmt::format("supply.{}.vessel_volume", list[i].vessel ? i : j),
                  fmt::format("supply.{} touches it, and both are one vessel: no land lets their "
                              "pressures differ",
                              list[i].vessel ? j : i),
                  "move one, or give one supply in place of both");
      }
      if (lie != Beside::overlapping) continue;
      const bool alike =
          list[i].pressure == list[j].pressure && list[i].temperature == list[j].temperature;
      to.refuse(fmt::format("supply.{}", j),
                fmt::format("it overlaps supply.{}{}", i,
                            alike ? "" : ", which has another pressure or temperature"),
                alike ? "leave out the one that lies within the other, or move one" : "move one");
    }
  }
}

void judge_cover(const std::vector<Supply>& list, double width, Findings& to) {
  double covered = 0.0;
  for (const Supply& s : list) {
    const double circle = is_round(s) ? kPi / 4.0 : 1.0;
    covered += circle * s.arc * s.length / (2.0 * kPi * width);
  }
  const std::string share =
      fmt::format("the supplies cover {:.0f} % of the bearing", 100.0 * covered);
  if (covered > kBearingLimits.supply_cover_most) {
    to.refuse("supply", share + ": hardly any film is left");
  } else if (covered > kBearingLimits.supply_cover_usual) {
    to.suspect("supply", share);
  }
}

}  // namespace

void judge_supplies(const Case& c, Findings& to) {
  const double p_cav = c.model.cavitation_pressure;
  if (p_cav > 0.0) {
    to.refuse(
        "model.cavitation_pressure",
        fmt::format("{} gauge lies above ambient pressure, which rules at the bearing's ends: "
                    "the film would be cavitated everywhere. Pressures are gauge unless the "
                    "key says absolute",
                    shown(p_cav, "bar")));
  }
  std::vector<Supply> list;
  for (const Supply& s : c.supplies) list.push_back(enclosed(s, c.bearing.radius));
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string path = fmt::format("supply.{}", k);
    judge_round(list[k], path, to);
    judge_axial(list[k], c.bearing, path, to);
    judge_line(list[k], c.bearing, path, to);
    judge_depth(list[k], c.bearing, path, to);
    judge_pressure(list[k], p_cav, path, to);
    judge_line_of_load(list[k], c, path, to);
    judge_vessel(list[k], c, path, to);
    judge_drilling(list[k], c, path, to);
  }
  judge_pairs(list, c.bearing.radius, to);
  judge_cover(list, c.bearing.width, to);
}

}  // namespace shellback::bearing
