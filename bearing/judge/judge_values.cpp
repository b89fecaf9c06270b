#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/judge/judge_parts.hpp"
#include "bearing/judge/value_check.hpp"
#include "bearing/shown.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

/// True for two values or more that rise, and for one.
bool rises(const std::vector<double>& x) {
  return !x.empty() && std::adjacent_find(x.begin(), x.end(),
                                          [](double a, double b) { return !(a < b); }) == x.end();
}

void judge_table_values(const Profile& p, const char* key, const ValueCheck& bearing) {
  const bool once = rises(p.phi) && p.phi.front() >= 0.0 && p.phi.back() < 2.0 * kPi;
  if (!once || !rises(p.z)) {
    bearing.refuse(
        key, "its angles must rise from 0 to below 360 deg and its axial positions must rise");
  } else if (p.height.size() != p.phi.size() * p.z.size()) {
    bearing.refuse(
        key, fmt::format("{} angles by {} axial positions need {} heights, but "
                         "there are {}",
                         p.phi.size(), p.z.size(), p.phi.size() * p.z.size(), p.height.size()));
  }
  for (const double h : p.height) {
    if (!std::isfinite(h)) return bearing.refuse(key, "a height is not a finite number");
  }
}

void judge_bearing_values(const Bearing& b, Findings& to) {
  const ValueCheck bearing("bearing", to);
  bearing.number("diameter", 2.0 * b.radius, "mm", kPositive);
  bearing.number("width", b.width, "mm", kPositive);
  bearing.number("radial_clearance", b.radial_clearance, "um", kPositive);
  bearing.temperature("reference_temperature", b.reference_temperature);
  if (b.profile) judge_table_values(*b.profile, "profile", bearing);
  if (b.shape) judge_table_values(*b.shape, "shape", bearing);
  if (b.wear) judge_table_values(*b.wear, "wear", bearing);
  for (const auto& [key, opening] : {std::pair{"bearing.edge_relief", &b.edge_relief},
                                     std::pair{"bearing.chamfer", &b.chamfer}}) {
    if (!*opening) continue;
    const ValueCheck edge(key, to);
    edge.number("depth", (*opening)->depth, "um", kNotNegative);
    edge.number("length", (*opening)->length, "mm", kPositive);
  }
}

/// Members that another kind has are 0, or those of the rectangle about a round mouth: they would
/// be of no effect.
void judge_members(const Supply& s, double radius, const ValueCheck& supply) {
  const bool round = is_round(s);
  const auto fits = [&](double extent) {
    return extent == 0.0 || std::abs(extent - s.diameter) <= kRoundOff * s.diameter;
  };
  if (round && !(fits(s.arc * radius) && fits(s.length))) {
    supply.refuse(fits(s.length) ? "arc" : "length", "a round mouth has a diameter alone",
                  "leave it at 0, or take another kind");
  }
  if (!round && s.diameter != 0.0) {
    supply.refuse("diameter", "a groove has no diameter", "leave it at 0, or take another kind");
  }
}

void judge_supply(const Supply& s, double radius, const ValueCheck& supply) {
  const ValueRanges& can = kValueRanges;
  supply.number("angle", s.angle, "deg", can.turn);
  judge_members(s, radius, supply);
  supply.number("z", s.z, "mm");
  switch (s.kind) {
    case SupplyKind::hole:
    case SupplyKind::drilling:
      supply.number("diameter", s.diameter, "mm", kPositive);
      break;
    case SupplyKind::axial_groove:
      supply.number("length", s.length, "mm", kPositive);
      supply.number("arc", s.arc, "deg", kNotNegative);
      break;
    case SupplyKind::circumferential_groove:
      supply.number("width", s.length, "mm", kPositive);
      supply.number("extent", s.arc, "deg", can.extent);
      break;
  }
  supply.number("depth", s.depth, "mm", kPositive);
  supply.number("pressure", s.pressure, "bar", can.gauge_pressure);
  supply.temperature("temperature", s.temperature);
  supply.number("carry_over", s.carry_over, "", kUpToOne);
  if (const double* h = std::get_if<double>(&s.heat_transfer)) {
    supply.number("heat_transfer", *h, "W/(m2 K)", can.groove_heat);
  }
}

void judge_list_of_supplies(const Case& c, Findings& to) {
  if (c.supplies.empty()) {
    to.refuse("supply",
              "there is no oil supply; oil leaves a bearing at its sides, and in a film that "
              "conserves mass nothing makes up for it without a supply: the film runs dry. Add a "
              "[[supply]] with kind = \"hole\", \"axial_groove\" or \"circumferential_groove\"" +
                  std::string(c.cycle ? "; if squeezing alone is to draw oil in, at flooded edges, "
                                        "one with pressure = \"0 bar\""
                                      : ""));
  }
  for (std::size_t k = 0; k < c.supplies.size(); ++k) {
    judge_supply(c.supplies[k], c.bearing.radius, ValueCheck(fmt::format("supply.{}", k), to));
  }
}

void judge_position(const Operation& o, const ValueCheck& operation) {
  const ValueRanges& can = kValueRanges;
  if (const auto* load = std::get_if<LoadGiven>(&o.position)) {
    operation.number("load", load->force, "N", kPositive);
    operation.number("load_angle", load->angle, "deg", can.turn);
  } else {
    const auto& given = std::get<EccentricityGiven>(o.position);
    operation.number("eccentricity_ratio", given.ratio, "", can.eccentricity_ratio);
    operation.number("attitude_angle", given.attitude, "deg", can.turn);
    operation.number("load_angle", given.load_angle, "deg", can.turn);
  }
}

void judge_operation(const Case& c, Findings& to) {
  const Operation& o = c.operation;
  const ValueCheck operation("operation", to);
  operation.number("speed", o.omega, "rad/s");
  if (!c.cycle) {
    judge_position(o, operation);
  } else if (std::holds_alternative<EccentricityGiven>(o.position)) {
    operation.refuse("eccentricity_ratio", "the load follows a cycle, and the journal with it",
                     "keep one of them");
  }
  if (const auto* tilt = std::get_if<TiltGiven>(&o.alignment)) {
    operation.number("tilt.about_x", tilt->about_x, "deg");
    operation.number("tilt.about_y", tilt->about_y, "deg");
  } else {
    const auto& moment = std::get<MomentGiven>(o.alignment);
    operation.number("moment.about_x", moment.about_x, "N m");
    operation.number("moment.about_y", moment.about_y, "N m");
  }
}

void judge_surface(const solid::RoughSurface& s, const ValueCheck& surface) {
  surface.number("roughness", s.roughness, "um", kNotNegative);
  surface.number("orientation", s.orientation, "", kPositive);
  surface.number("summit_roughness", s.summit_roughness, "um", kNotNegative);
  surface.number("summit_height", s.summit_height, "um");
}

void judge_friction_law(const solid::GenericFriction& f, Findings& to) {
  const ValueCheck law("surfaces.contact.friction_law", to);
  law.number("abrasive", f.abrasive, "", kUpToOne);
  law.number("adhesive", f.adhesive, "", kUpToOne);
  law.number("a", f.a, "", kAboveOne);
  law.number("b", f.b, "", kNotNegative);
  law.number("c", f.c, "", kNotNegative);
  law.number("summit_radius", f.summit_radius, "um", kPositive);
  law.number("orientation", f.orientation, "", kPositive);
  if (f.L_s) law.number("reference_length", *f.L_s, "um", kPositive);
}

void judge_surfaces_values(const Surfaces& s, Findings& to) {
  judge_surface(s.shell, ValueCheck("surfaces.shell", to));
  judge_surface(s.shaft, ValueCheck("surfaces.shaft", to));
  if (!s.contact) return;
  const ValueCheck contact("surfaces.contact", to);
  contact.number("elastic_factor", s.contact->elastic_factor, "", kPositive);
  contact.number("composite_modulus", s.contact->composite_modulus, "GPa", kPositive);
  if (!s.contact->friction_law) {
    contact.number("friction", s.contact->friction, "", kUpToOne);
  }
  contact.number("hardness", s.contact->hardness, "MPa", kNotNegative);
  compare(to, "surfaces.contact.composite_modulus", s.contact->composite_modulus,
          kBearingLimits.composite_modulus,
          fmt::format("the composite modulus is {}", shown(s.contact->composite_modulus, "GPa")),
          "check the unit");
  if (s.contact->hardness > 0.0) {
    compare(to, "surfaces.contact.hardness", s.contact->hardness, kBearingLimits.hardness,
            fmt::format("the hardness is {}", shown(s.contact->hardness, "MPa")), "check the unit");
  }
  if (s.contact->friction_law) judge_friction_law(*s.contact->friction_law, to);
}

void judge_model(const Model& m, Findings& to) {
  const ValueCheck model("model", to);
  model.number("tolerance", m.tolerance, "", kValueRanges.tolerance);
  for (const int cells : m.grid) model.whole_number("grid", cells, kValueRanges.cells);
  model.whole_number("film_nodes", m.film_nodes, kValueRanges.film_nodes);
  model.number("cavitation_pressure", m.cavitation_pressure, "bar", kValueRanges.gauge_pressure);
  model.number("equivalent_temperature.kappa", m.kappa, "", kValueRanges.kappa);
}

void judge_measured(const Measured& m, double clearance, Findings& to) {
  const ValueCheck measured("measured", to);
  if (m.h_min && *m.h_min > 2.0 * clearance) {
    to.suspect("measured.h_min",
               fmt::format("{} is more than the diametral clearance", shown(*m.h_min, "um")),
               "check the unit");
  }
  const auto number = [&](const char* key, const std::optional<double>& value, const char* unit,
                          const Range& range) {
    if (value) measured.number(key, *value, unit, range);
  };
  if (m.shell_back_temperature) {
    measured.temperature("shell_back_temperature", *m.shell_back_temperature);
  }
  number("friction_torque", m.friction_torque, "N m", kNotNegative);
  number("h_min", m.h_min, "um", kNotNegative);
  number("p_max", m.p_max, "MPa", kAnyValue);
  number("side_flow", m.side_flow, "m3/s", kNotNegative);
  number("eccentricity_ratio", m.eccentricity_ratio, "", kNotNegative);
  if (m.T_shell_max) measured.temperature("T_shell_max", *m.T_shell_max);
}

/// A hardness of the shell's surface beside that of its first layer's material.
void judge_hardness(const Case& c, const char* key, double hardness, Findings& to) {
  const ShellLayer* first = c.shell && !c.shell->layers.empty() ? &c.shell->layers[0] : nullptr;
  const double own = first != nullptr ? first->material.hardness : 0.0;
  if (!(hardness > 0.0) || !(own > 0.0)) return;
  const double apart = hardness / own;
  if (std::max(apart, 1.0 / apart) <= kBearingLimits.modulus_apart) return;
  to.suspect(key,
             fmt::format("it is {}, and the hardness of the shell's first layer ({}) {}",
                         shown(hardness, "MPa"), first->material.name, shown(own, "MPa")),
             "leave it out for that of the layer, or check which of the two is meant");
}

/// Pressure that contact cannot have wears nothing.
void judge_limit_pressure(const Case& c, const ValueCheck& wear) {
  const double limit = c.running_in->limit_pressure;
  const double shell = hardness_of_shell(c);
  const double contact = c.surfaces.contact ? hardness_of_contact(c) : 0.0;
  for (const auto& [H, what] :
       {std::pair{shell, "the hardness of the shell"},
        std::pair{contact,
                  "the hardness at which contact pressure ends (surfaces.contact.hardness, "
                  "or that of the softer surface)"}}) {
    if (!(H > 0.0 && limit >= H)) continue;
    return wear.refuse("limit_pressure",
                       fmt::format("{} is no less than {}, {}: nothing would wear",
                                   shown(limit, "MPa"), what, shown(H, "MPa")),
                       "check the unit; worn-in bearings bear some MPa");
  }
}

/// Wear without contact, or of a surface whose hardness nobody knows, is none.
void judge_running_in(const Case& c, Findings& to) {
  const RunningIn& r = *c.running_in;
  const ValueCheck wear("running_in", to);
  wear.number("wear_coefficient", r.wear_coefficient, "", kPositive);
  if (r.duration) wear.number("until", *r.duration, "s", kPositive);
  wear.number("hardness", r.hardness, "MPa", kNotNegative);
  wear.number("limit_pressure", r.limit_pressure, "MPa", r.duration ? kNotNegative : kPositive);
  compare(to, "running_in.wear_coefficient", r.wear_coefficient, kBearingLimits.wear_coefficient,
          fmt::format("C of Archard's C/H is {:.3g}", r.wear_coefficient),
          "it has no unit; give C itself, not C/H");
  if (const double H = hardness_of_shell(c); H > 0.0) {
    compare(to, "running_in.hardness", H, kBearingLimits.hardness,
            fmt::format("the hardness of the shell's surface is {:.4g} MPa", 1e-6 * H),
            "check the unit");
  }
  judge_hardness(c, "running_in.hardness", r.hardness, to);
  judge_limit_pressure(c, wear);
  if (r.worn) {
    judge_surface(*r.worn, ValueCheck("running_in.worn", to));
    wear.number("worn_after", r.worn_after, "um", kPositive);
    compare(to, "running_in.worn_after", r.worn_after / c.bearing.radial_clearance,
            kBearingLimits.worn_after,
            fmt::format("the surface is worn after {}", shown(r.worn_after, "um")),
            "check the unit; it is about the height of the summits");
  }
  if (!(hardness_of_shell(c) > 0.0)) {
    wear.refuse("hardness", "the hardness of the shell's surface is not known",
                "give running_in.hardness, or the hardness of the first layer's material");
  }
  if (!c.surfaces.contact || !c.model.switches.asperity_contact.value_or(true)) {
    wear.refuse("wear_coefficient", "nothing wears without asperity contact",
                "give [surfaces] contact, and leave model.asperity_contact on");
  }
  if (c.cycle && c.cycle->repeats() && r.duration && *r.duration < c.cycle->period) {
    wear.refuse("until",
                fmt::format("{:.4g} s is shorter than the load cycle of {:.4g} s, over whose mean "
                            "the shell wears",
                            *r.duration, c.cycle->period),
                "check the unit");
  }
}

}  // namespace

void judge_values(const Case& c, Findings& to) {
  judge_bearing_values(c.bearing, to);
  judge_operation(c, to);
  if (c.cycle) judge_cycle_values(*c.cycle, to);
  judge_law_values(c.oil, to);
  if (c.oil_temperature) ValueCheck("oil", to).temperature("temperature", *c.oil_temperature);
  judge_list_of_supplies(c, to);
  judge_model(c.model, to);
  judge_solid_values(c, to);
  judge_surfaces_values(c.surfaces, to);
  judge_measured(c.measured, c.bearing.radial_clearance, to);
  if (c.surfaces.contact) {
    judge_hardness(c, "surfaces.contact.hardness", c.surfaces.contact->hardness, to);
  }
  if (c.running_in) judge_running_in(c, to);
}

}  // namespace shellback::bearing
