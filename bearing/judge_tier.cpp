/// The data that each tier needs; part of judge_case.hpp.
#include <cmath>

#include "bearing/judge_case.hpp"
#include "bearing/possible_methods.hpp"

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

bool heat_leaves(const Shell& shell) {
  const auto* back = std::get_if<ConvectiveBack>(&shell.back);
  return back == nullptr || back->heat_transfer > 0.0;
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
  if (on.elastic_deformation.value_or(false) && !c.shell) {
    return lack("model.elastic_deformation",
                "elastic deformation is switched on, but there is no [shell] to deform",
                "give its layers, or switch it off");
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

}  // namespace

Lack lack_for(const Case& c, Tier tier) {
  if (tier == Tier::estimate && begins_at_rest(c)) {
    return lack(
        "model.tier",
        "the event begins with a load on a journal at rest, which no film carries, and tier "
        "estimate has no contact of a journal at rest",
        "take tier isothermal, lumped, thd, tehd or auto");
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
