/// The data that each tier needs; part of judge_case.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bearing/bore_shape.hpp"
#include "bearing/heat/film_heat.hpp"
#include "bearing/judge/judge_case.hpp"
#include "bearing/load_cycle.hpp"
#include "bearing/possible_methods.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

using Lack = std::optional<Finding>;

Finding lack(std::string key, std::string problem, std::string cure) {
  return {Gravity::refused, std::move(key), std::move(problem), std::move(cure)};
}

bool temperature_known(const Case& c) {
  const bool prescribed = c.shell && std::holds_alternative<PrescribedBack>(c.shell->back);
  return c.oil_temperature || c.measured.shell_back_temperature || prescribed ||
         std::holds_alternative<rheology::ConstantViscosity>(c.oil.temperature);
}

/// A single event whose first row has a load and no speed.
bool begins_at_rest(const Case& c) {
  if (!c.cycle || c.cycle->repeats()) return false;
  const LoadCycle& e = *c.cycle;
  const double omega = e.omega.empty() ? c.operation.omega : e.omega.front();
  return omega == 0.0 && std::hypot(e.x.front(), e.y.front()) > 0.0;
}

Lack lack_for_switches(const Case& c, bool thermal) {
  const Switches& on = c.model.switches;
  if (on.elastic_deformation.value_or(false) && !can_be_elastic(c)) {
    return lack(
        "model.elastic_deformation",
        fmt::format("elastic deformation is switched on, but there is no {} to deform",
                    c.shell ? "[shaft]" : "[shell]"),
        c.shell ? "give its material, or switch it off" : "give its layers, or switch it off");
  }
  if (on.thermal_deformation.value_or(false) && !thermal) {
    return lack("model.thermal_deformation",
                "thermal deformation needs the temperatures of shell and shaft, which only the "
                "tiers thd and tehd compute",
                "choose one of them, or switch it off");
  }
  return std::nullopt;
}

Lack lack_for_heat(const Case& c, const std::string& tier) {
  const std::string otherwise = ", or choose the tier lumped or isothermal";
  if (!c.shell) {
    return lack("shell",
                "the tier " + tier + " computes the heat in the shell, but there is no [shell]",
                "give its layers and back" + otherwise);
  }
  if (!heat_leaves(*c.shell)) {
    return lack("shell.back", "it is not said how heat leaves the shell's back",
                "add back = { heat_transfer = \"500 W/(m2 K)\", ambient = \"90 degC\" } or back = "
                "{ temperature = \"98 degC\" }");
  }
  if (!c.shaft) {
    return lack("shaft",
                "the tier " + tier + " computes the heat in the shaft, but there is no [shaft]",
                "give its material" + otherwise);
  }
  return std::nullopt;
}

// Where tier estimate's bars hold torque and smallest film: holes and grooves at all angles, three
// loads (docs/decisions/048).
constexpr double kFarFromLoad = 7.0 / 18.0 * kPi;  ///< of every supply's edge [rad]
/// The same over a cycle, whose bars hold what the film's history is worth: half of the film, and
/// more than a supply 45 degrees from the load [rad].
constexpr double kFarFromLoadInTime = kPi / 4.0;
constexpr double kFarBehindLoad = 5.0 / 6.0 * kPi;  ///< of a short supply that alone feeds [rad]
constexpr double kLong = 0.5;  ///< supplies that fill the film anew wherever they lie [-], of width
/// Off mid-width, over the width, the lands beside a groove all round carry 4 % more than two alike
/// (their load goes with the third power): less than the estimate's bars [-].
constexpr double kOffMiddle = 0.05;

/// Supplies in the film that carries the load, or none before it.
Lack lack_of_feed(const Case& c, double omega, double load_angle, double far) {
  const std::string cure = "take tier isothermal, lumped, thd, tehd or auto";
  const double turn = omega < 0.0 ? -1.0 : 1.0;
  bool fed = false;
  for (const Supply& given : c.supplies) {
    const Supply s = enclosed(given, c.bearing.radius);
    if (s.kind == SupplyKind::drilling || goes_all_round(s)) {
      fed = true;
      continue;
    }
    const double behind = turn * std::remainder(s.angle - load_angle, 2.0 * kPi);
    const double away = std::abs(behind) - 0.5 * s.arc;
    if (away < far) {
      return lack(
          "model.tier",
          fmt::format("a supply lies {:.0f} deg from the load, in the film that carries it, "
                      "and tier estimate knows none there",
                      std::max(0.0, away) * 180.0 / kPi),
          cure);
    }
    const bool before = behind < 0.0 || behind > kFarBehindLoad;
    fed = fed || before || s.length >= kLong * c.bearing.width;
  }
  if (fed) return std::nullopt;
  return lack("model.tier",
              "no supply lies ahead of the film that carries the load, which then is starved: tier "
              "estimate is fed at the widest gap",
              cure);
}

/// The same over a cycle or event: where it lasts for a turn of the journal, in which the film has
/// used up the oil that it had, under loads that make the film its smallest.
Lack lack_of_feed_over(const Case& c) {
  const std::vector<double>& t = c.cycle->t;
  const bool spline = c.cycle->interpolation == LoadInterpolation::periodic_spline;
  const bool jumps = std::adjacent_find(t.begin(), t.end(), std::greater_equal<>()) != t.end();
  if (t.size() < 2 || (spline && jumps)) return std::nullopt;  // refused for that
  const LoadCourse course(*c.cycle, c.operation.omega);
  const auto lack_at = [&](const LoadNow& at) {
    return lack_of_feed(c, at.omega, std::atan2(at.y, at.x), kFarFromLoadInTime);
  };
  const LoadStretch starved =
      course.heavy_stretch([&](const LoadNow& from, const LoadNow& to, double) {
        return lack_at({from.x + to.x, from.y + to.y, from.omega + to.omega}).has_value();
      });
  return starved.always || starved.turned >= 2.0 * kPi ? lack_at(starved.last) : std::nullopt;
}

/// Largest departure of the bore from the cylinder of the radial clearance [m].
double off_circle(const Bearing& b) {
  double most = 0.0;
  for (const auto* table : {&b.profile, &b.shape, &b.wear}) {
    if (!*table || (*table)->height.empty()) continue;
    most = std::max(most, largest_magnitude((*table)->height));
  }
  for (const auto* opening : {&b.edge_relief, &b.chamfer}) {
    if (*opening) most = std::max(most, (*opening)->depth);
  }
  return most;
}

/// Where the journal is not aligned in a cylinder.
Lack lack_of_cylinder(const Case& c) {
  // Of the clearance: a tenth of the film at an eccentricity ratio of 0.9, the estimate's own bars.
  // Of a moment, of load times width: the load as far off mid-width.
  constexpr double kOff = 0.01;
  const std::string cure = "take tier isothermal, lumped, thd, tehd or auto";
  const double clearance = c.bearing.radial_clearance;
  if (off_circle(c.bearing) > kOff * clearance) {
    return lack("model.tier",
                "tier estimate knows no bore but the cylinder of the clearance, and the case has a "
                "profile, "
                "a shape, a relief or a chamfer",
                cure);
  }
  const auto* tilt = std::get_if<TiltGiven>(&c.operation.alignment);
  const auto* moment = std::get_if<MomentGiven>(&c.operation.alignment);
  const auto* load = std::get_if<LoadGiven>(&c.operation.position);
  const double arm = load != nullptr && !c.cycle ? load->force * c.bearing.width : 0.0;
  const bool tilted =
      tilt != nullptr
          ? std::hypot(tilt->about_x, tilt->about_y) * 0.5 * c.bearing.width > kOff * clearance
          : std::hypot(moment->about_x, moment->about_y) > kOff * arm;
  if (!tilted) return std::nullopt;
  return lack("model.tier", "the journal is tilted, and tier estimate knows none but aligned ones",
              cure);
}

/// The estimate's film is one land, or two alike, fed at the widest gap by oil of one temperature.
Lack lack_for_estimate(const Case& c) {
  const std::string cure = "take tier isothermal, lumped, thd, tehd or auto";
  if (auto missing = lack_of_cylinder(c)) return missing;
  if (begins_at_rest(c)) {
    return lack("model.tier",
                "the event begins with a load on a journal at rest, which no film carries, and "
                "tier estimate has no contact of a journal at rest",
                cure);
  }
  if (c.supplies.empty()) return std::nullopt;  // refused for that
  const auto [coldest, hottest] = supply_temperatures(c);
  if (hottest > coldest) {
    return lack("model.tier", "tier estimate knows no supplies of different temperature", cure);
  }
  int rings = 0;
  for (const Supply& s : c.supplies) {
    if (!goes_all_round(s)) continue;
    if (++rings > 1 || std::abs(s.z) > kOffMiddle * c.bearing.width) {
      return lack("model.tier",
                  "tier estimate knows no grooves all round but one, at mid-width: the lands "
                  "beside it are alike",
                  cure);
    }
  }
  if (c.cycle) return lack_of_feed_over(c);
  const auto* load = std::get_if<LoadGiven>(&c.operation.position);
  const auto* place = std::get_if<EccentricityGiven>(&c.operation.position);
  if (load != nullptr) return lack_of_feed(c, c.operation.omega, load->angle, kFarFromLoad);
  // The load stands behind a given place by the attitude of a short bearing (Ocvirk, textbook).
  const double eps = std::clamp(place->ratio, kRoundOff, 1.0);
  const double attitude = std::atan2(kPi * std::sqrt(1.0 - eps * eps), 4.0 * eps);
  return lack_of_feed(
      c, c.operation.omega,
      place->direction(c.operation.omega) - std::copysign(attitude, c.operation.omega),
      kFarFromLoad);
}

/// Between rigid surfaces no journal is displaced by more than the bore lets it.
Lack lack_of_room(const Case& c, Tier tier) {
  const auto* given = std::get_if<EccentricityGiven>(&c.operation.position);
  if (given == nullptr) return std::nullopt;
  constexpr int kAround = 360;
  const double turns = given->direction(c.operation.omega) / (2.0 * kPi);
  const int at = static_cast<int>(std::lround(kAround * (turns - std::floor(turns)))) % kAround;
  const double room = room_around(c.bearing, kAround)[at] / c.bearing.radial_clearance;
  if (given->ratio < room) return std::nullopt;
  const bool elastic =
      tier == Tier::automatic || (tier != Tier::estimate && physics_of(c, tier).elastic);
  if (elastic && can_be_elastic(c)) return std::nullopt;
  return lack("operation.eccentricity_ratio",
              fmt::format("at {:.4g} the journal touches the shell, and the surfaces are rigid; it "
                          "must be less",
                          room),
              "let them be elastic: tier tehd, or model.elastic_deformation = true");
}

}  // namespace

Lack lack_for(const Case& c, Tier tier) {
  if (auto missing = lack_of_room(c, tier)) return missing;
  if (tier == Tier::estimate) {
    if (auto missing = lack_for_estimate(c)) return missing;
  }
  if (tier == Tier::estimate && !c.cycle && c.model.coefficients) {
    return lack("model.coefficients",
                "stiffness and damping (--coefficients) need a solved film, and tier estimate "
                "solves none",
                "take tier isothermal or a richer one");
  }
  if (c.cycle && c.model.coefficients) {
    return lack("model.coefficients",
                "not yet available for load cycles: stiffness and damping, which belong to a "
                "steady position",
                "take model.coefficients (--coefficients) away");
  }
  if (c.cycle && !usual_methods(c)) {
    return lack("model.methods",
                "not yet available for load cycles: another method than the active set for "
                "cavitation and Newton's for elasticity",
                "take model.methods away");
  }
  const bool thermal = tier == Tier::thd || tier == Tier::tehd;
  if (thermal) {
    if (auto missing = lack_for_heat(c, to_string(tier))) return missing;
  }
  if (tier == Tier::isothermal && !temperature_known(c)) {
    return lack("oil.temperature", "the tier isothermal needs the film's temperature",
                "give oil.temperature, or a measured shell-back temperature "
                "(measured.shell_back_temperature or shell.back.temperature), or a constant "
                "viscosity");
  }
  if (auto missing = lack_for_switches(c, thermal || tier == Tier::automatic)) return missing;
  const std::string methods = impossible_methods(c, physics_of(c, tier));
  if (methods.empty()) return std::nullopt;
  return lack("model.methods", methods, "");
}

std::vector<Tier> possible_tiers(const Case& c) {
  std::vector<Tier> tiers;
  for (const Tier tier : {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd}) {
    if (!lack_for(c, tier)) tiers.push_back(tier);
  }
  return tiers;
}

}  // namespace shellback::bearing
