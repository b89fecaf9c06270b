#include "bearing/case.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

/// Of the shell's first layer; 0: not known [Pa].
double hardness_of_lining(const Case& c) {
  return c.shell && !c.shell->layers.empty() ? c.shell->layers.front().material.hardness : 0.0;
}

}  // namespace

const char* to_string(Tier tier) {
  switch (tier) {
    case Tier::estimate:
      return "estimate";
    case Tier::isothermal:
      return "isothermal";
    case Tier::lumped:
      return "lumped";
    case Tier::thd:
      return "thd";
    case Tier::tehd:
      return "tehd";
    case Tier::automatic:
      return "auto";
  }
  return "unknown";
}

double mean_supply_temperature(const Case& c) {
  EXPECTS(!c.supplies.empty());
  const double first = c.supplies.front().temperature;
  double beyond = 0.0;  // equal ones are met exactly
  for (const Supply& s : c.supplies) beyond += s.temperature - first;
  return first + beyond / static_cast<double>(c.supplies.size());
}

bool goes_all_round(const Supply& s) {
  return s.kind == SupplyKind::circumferential_groove && s.arc >= 2.0 * kPi * (1.0 - kRoundOff);
}

Supply enclosed(Supply s, double radius) {
  if (is_round(s)) {
    s.arc = s.diameter / radius;
    s.length = s.diameter;
  }
  return s;
}

double combined_roughness(const Surfaces& s) {
  return std::hypot(s.shell.roughness, s.shaft.roughness);
}

bool heat_leaves(const Shell& shell) {
  const auto* back = std::get_if<ConvectiveBack>(&shell.back);
  return back == nullptr || back->heat_transfer > 0.0;
}

double hardness_of_shell(const Case& c) {
  const bool given = c.running_in && c.running_in->hardness > 0.0;
  return given ? c.running_in->hardness : hardness_of_lining(c);
}

double hardness_of_contact(const Case& c) {
  if (c.surfaces.contact->hardness > 0.0) return c.surfaces.contact->hardness;
  const double of_shell = hardness_of_lining(c);
  const double of_shaft = c.shaft ? c.shaft->material.hardness : 0.0;
  return of_shell > 0.0 && of_shaft > 0.0 ? std::min(of_shell, of_shaft)
                                          : std::max(of_shell, of_shaft);
}

}  // namespace shellback::bearing
