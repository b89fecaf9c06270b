#include <fmt/format.h>

#include "bearing/judge/judge_parts.hpp"
#include "bearing/judge/value_check.hpp"

namespace shellback::bearing {
namespace {

void judge_material_values(const solid::Material& m, const std::string& path, Findings& to) {
  const ValueCheck material(path + ".material", to);
  material.number("conductivity", m.conductivity, "W/(m K)", kPositive);
  material.number("density", m.density, "kg/m3", kPositive);
  material.number("heat_capacity", m.heat_capacity, "J/(kg K)", kPositive);
  material.number("youngs_modulus", m.youngs_modulus, "GPa", kPositive);
  material.number("poisson_ratio", m.poisson_ratio, "", kValueRanges.poisson_ratio);
  material.number("expansion", m.expansion, "1/K", kNotNegative);
  material.number("hardness", m.hardness, "MPa", kNotNegative);
  if (m.limit_temperature != 0.0) {
    material.temperature("limit_temperature", m.limit_temperature);
  }
  material.number("progression_rate", m.progression, "", kNotNegative);
  material.number("damping_ratio", m.damping_ratio, "s", kNotNegative);
}

/// No heat transfer at all is a back that is not given; the tiers that need one ask for it.
void judge_back(const Shell& s, Findings& to) {
  const ValueCheck back("shell.back", to);
  if (const auto* given = std::get_if<PrescribedBack>(&s.back)) {
    back.temperature("temperature", given->temperature);
  } else if (const auto& air = std::get<ConvectiveBack>(s.back); air.heat_transfer != 0.0) {
    back.number("heat_transfer", air.heat_transfer, "W/(m2 K)", kValueRanges.wall_heat);
    back.temperature("ambient", air.ambient);
  }
}

void judge_shell_values(const Shell& s, Findings& to) {
  const ValueCheck shell("shell", to);
  if (s.layers.empty()) {
    shell.refuse("layers", "the shell has no layers",
                 "give them from the bore outwards: layers = [ { material = \"AlSn20\", thickness "
                 "= \"0.3 mm\" } ]");
  }
  for (std::size_t k = 0; k < s.layers.size(); ++k) {
    const std::string path = fmt::format("shell.layers.{}", k);
    judge_material_values(s.layers[k].material, path, to);
    ValueCheck(path, to).number("thickness", s.layers[k].thickness, "mm", kPositive);
  }
  if (s.housing) {
    judge_material_values(s.housing->material, "shell.housing", to);
    if (s.housing->joint_conductance != 0.0) {  // else a perfect joint
      shell.number("housing.joint_conductance", s.housing->joint_conductance, "W/(m2 K)",
                   kValueRanges.joint);
    }
    shell.number("housing.outer_diameter", 2.0 * s.housing->outer_radius, "mm", kPositive);
  }
  judge_back(s, to);
  shell.number("end_heat_transfer", s.end_heat_transfer, "W/(m2 K)", kValueRanges.wall_heat);
}

}  // namespace

void judge_solid_values(const Case& c, Findings& to) {
  if (c.shell) judge_shell_values(*c.shell, to);
  if (!c.shaft) return;
  judge_material_values(c.shaft->material, "shaft", to);
  const ValueCheck shaft("shaft", to);
  shaft.number("overhang", c.shaft->overhang, "mm", kNotNegative);
  if (c.shaft->elastic_overhang) {
    shaft.number("elastic_overhang", *c.shaft->elastic_overhang, "mm", kNotNegative);
  }
  if (c.shaft->span) shaft.number("span", *c.shaft->span, "mm", kPositive);
  if (c.shaft->overhang <= 0.0) return;
  shaft.number("heat_transfer", c.shaft->heat_transfer, "W/(m2 K)", kValueRanges.wall_heat);
  shaft.temperature("ambient", c.shaft->ambient);
}

}  // namespace shellback::bearing
