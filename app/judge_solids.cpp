#include <fmt/format.h>

#include "app/judge_case.hpp"
#include "core/contract.hpp"
#include "coupling/possible_methods.hpp"

namespace shellback::app {
namespace {

using namespace coupling;

/// Usual range of one property of engineering solids, polymers to ceramics.
struct Usual {
  const char* key;
  double solid::Material::*member;
  double least;
  double most;
  const char* unit;
  const Kind& kind;
};
const Usual kUsual[] = {
    {"conductivity", &solid::Material::conductivity, 0.05, 1000.0, "W/(m K)", kConductivity},
    {"density", &solid::Material::density, 500.0, 25000.0, "kg/m3", kDensity},
    {"heat_capacity", &solid::Material::heat_capacity, 50.0, 5000.0, "J/(kg K)", kHeatCapacity},
    {"youngs_modulus", &solid::Material::youngs_modulus, 1e6, 1.2e12, "GPa", kPressure},
    {"expansion", &solid::Material::expansion, 0.0, 5e-4, "1/K", kPerKelvin},
};

void judge_material(Case& subject, const solid::Material& material, const std::string& path,
                    const Reader& reader) {
  for (const Usual& usual : kUsual) {
    const double value = material.*usual.member;
    if (value >= usual.least && value <= usual.most) continue;
    warn(subject, reader, path + "." + usual.key,
         fmt::format("{} is unusual for a solid; check the unit",
                     show(value, usual.unit, usual.kind)));
  }
}

void judge_shell(Case& subject, const Shell& shell, const Reader& reader) {
  const double R = subject.bearing.radius;
  double thickness = 0.0;
  for (std::size_t k = 0; k < shell.layers.size(); ++k) {
    const std::string path = fmt::format("shell.layers.{}", k);
    thickness += shell.layers[k].thickness;
    judge_material(subject, shell.layers[k].material, path + ".material", reader);
    if (thickness > 5.0 * R) {  // no bush's wall is thicker than some radii
      refuse(reader, path + ".thickness",
             fmt::format("the layers are {} thick on a bore of radius {}; check the unit",
                         show(thickness, "mm", kLength), show(R, "mm", kLength)));
    }
  }
  if (!shell.housing) return;
  judge_material(subject, shell.housing->material, "shell.housing.material", reader);
  const double inner = R + thickness;
  if (shell.housing->outer_radius <= inner) {
    refuse(reader, "shell.housing.outer_diameter",
           fmt::format("{} does not enclose the shell, whose back has a diameter of {}",
                       show(2.0 * shell.housing->outer_radius, "mm", kLength),
                       show(2.0 * inner, "mm", kLength)));
  }
  if (shell.housing->outer_radius > 50.0 * R) {  // beyond, a full space does as well
    refuse(reader, "shell.housing.outer_diameter",
           "it is more than 50 times the bearing's diameter; check the unit");
  }
}

/// What the tier lacks in the case: key and problem; an empty key if nothing.
struct Lack {
  std::string key;
  std::string problem;
};

bool temperature_known(const Case& subject) {
  const bool prescribed =
      subject.shell && std::holds_alternative<PrescribedBack>(subject.shell->back);
  return subject.oil_temperature || subject.measured.shell_back_temperature || prescribed ||
         std::holds_alternative<rheology::ConstantViscosity>(subject.oil.temperature);
}

bool heat_leaves(const Shell& shell) {
  const auto* back = std::get_if<ConvectiveBack>(&shell.back);
  return back == nullptr || back->heat_transfer > 0.0;
}

Lack lack_for_switches(const Case& subject, bool thermal) {
  const Switches& on = subject.model.switches;
  if (on.elastic_deformation.value_or(false) && !subject.shell) {
    return {"model.elastic_deformation",
            "elastic deformation is switched on, but there is no [shell] to deform; give its "
            "layers, or switch it off"};
  }
  if (on.thermal_deformation.value_or(false) && !thermal) {
    return {"model.thermal_deformation",
            "thermal deformation needs the temperatures of shell and shaft, which only the "
            "tiers thd and tehd compute; choose one of them, or switch it off"};
  }
  return {};
}

Lack lack_for(const Case& subject, Tier tier) {
  const bool thermal = tier == Tier::thd || tier == Tier::tehd;
  const std::string name = to_string(tier);
  const std::string otherwise = " or choose the tier lumped or isothermal";
  if (thermal && !subject.shell) {
    return {"shell", "the tier " + name +
                         " computes the heat in the shell, but there is no [shell]; give its "
                         "layers and back," +
                         otherwise};
  }
  if (thermal && !heat_leaves(*subject.shell)) {
    return {"shell.back",
            "it is not said how heat leaves the shell's back; add back = { "
            "heat_transfer = \"500 W/(m2 K)\", ambient = \"90 degC\" } or back = { "
            "temperature = \"98 degC\" }"};
  }
  if (thermal && !subject.shaft) {
    return {"shaft", "the tier " + name +
                         " computes the heat in the shaft, but there is no [shaft]; give its "
                         "material," +
                         otherwise};
  }
  if (tier == Tier::isothermal && !temperature_known(subject)) {
    return {"oil.temperature",
            "the tier isothermal needs the film's temperature; give oil.temperature, or a "
            "measured shell-back temperature (measured.shell_back_temperature or "
            "shell.back.temperature), or a constant viscosity"};
  }
  const Lack lack = lack_for_switches(subject, thermal || tier == Tier::automatic);
  if (!lack.key.empty()) return lack;
  const std::string methods = impossible_methods(subject, physics_of(subject, tier));
  return methods.empty() ? Lack{} : Lack{"model.methods", methods};
}

}  // namespace

void judge_solids(Case& subject, const Reader& reader) {
  if (subject.shell) {
    const Shell shell = *subject.shell;
    judge_shell(subject, shell, reader);
  }
  if (subject.shaft) {
    const solid::Material material = subject.shaft->material;
    judge_material(subject, material, "shaft.material", reader);
    if (subject.shaft->overhang > 100.0 * subject.bearing.radius) {  // a fin is infinite by then
      refuse(reader, "shaft.overhang", "it is more than 50 diameters; check the unit");
    }
  }
}

void expect_possible(const Case& subject, Tier tier, const Reader& reader) {
  const Lack lack = lack_for(subject, tier);
  if (!lack.key.empty()) refuse(reader, lack.key, lack.problem);
}

std::vector<Tier> possible_tiers(const Case& subject) {
  std::vector<Tier> tiers;
  for (const Tier tier : {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd}) {
    if (lack_for(subject, tier).key.empty()) tiers.push_back(tier);
  }
  return tiers;
}

}  // namespace shellback::app
