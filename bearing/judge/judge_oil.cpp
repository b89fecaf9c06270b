#include <fmt/format.h>

#include <utility>

#include "bearing/case_limits.hpp"
#include "bearing/heat/film_heat.hpp"
#include "bearing/judge/judge_parts.hpp"
#include "bearing/shown.hpp"
#include "bearing/steady/solve.hpp"
#include "core/constants.hpp"
#include "rheology/heat.hpp"
#include "rheology/shear.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {
namespace {

void judge_switches(const Case& c, Findings& to) {
  const Switches& on = c.model.switches;
  const bool barotropic = std::holds_alternative<rheology::NoPressureEffect>(c.oil.pressure);
  if (on.pressure_dependence.value_or(false) && barotropic) {
    to.refuse("model.pressure_dependence",
              "the pressure dependence is switched on, but the oil has no viscosity.pressure law");
  }
  if (on.shear_thinning.value_or(false) && !rheology::thins(c.oil)) {
    to.refuse("model.shear_thinning",
              "shear thinning is switched on, but the oil has no viscosity.shear law");
  }
}

/// Nearer to the pole of Vogel's law than a kelvin, or beyond it.
bool at_pole(const rheology::Oil& oil, double T) {
  const auto* vogel = std::get_if<rheology::Vogel>(&oil.temperature);
  return vogel != nullptr && T - kZeroCelsius + vogel->C <= 1.0;
}

/// Constants of a law are seen to be wrong by what they make of the oil as it comes.
void judge_supplied_viscosity(const rheology::Oil& oil, double T, Findings& to) {
  if (at_pole(oil, T)) return;  // refused by the temperature's key
  const double eta = rheology::viscosity(oil, T, 0.0);
  compare(to, "oil.viscosity.temperature", eta, kBearingLimits.viscosity,
          fmt::format("its constants make the viscosity {} at the supply's {}", shown(eta, "mPa s"),
                      shown(T, "degC")),
          "check their units (Pa s or mPa s? degC or K?)");
}

/// What pressure and shear make of the viscosity of the oil as it comes.
void judge_thickening_and_thinning(const rheology::Oil& oil, double T, Findings& to) {
  if (!std::holds_alternative<rheology::NoPressureEffect>(oil.pressure) && !at_pole(oil, T)) {
    const double slope = rheology::viscosity_slopes(oil, T, 0.0, 0.0).dln_dp;
    compare(to, "oil.viscosity.pressure", slope, kBearingLimits.pressure_slope,
            fmt::format("its constants make the viscosity grow with exp({:.3g} p/GPa) at the "
                        "supply's {}",
                        1e9 * slope, shown(T, "degC")),
            "oils have 10 to 40 1/GPa; check the unit of its constants");
  }
  if (const auto* houpert = std::get_if<rheology::Houpert>(&oil.pressure)) {
    compare(to, "oil.viscosity.pressure.beta", houpert->beta, kBearingLimits.viscosity_slope,
            fmt::format("beta is {:.4g} 1/K", houpert->beta), "oils have 0.02 to 0.06 1/K");
  }
  if (const auto* cross = std::get_if<rheology::Cross>(&oil.shear)) {
    compare(to, "oil.viscosity.shear.K", cross->K, kBearingLimits.thinning_time,
            fmt::format("the oil thins from shear rates of 1/K = {:.3g} 1/s on", 1.0 / cross->K),
            "check its unit, and the sign of its exponent; engine oils have 1e-8 to 1e-5 s");
  }
}

void judge_viscosity(const rheology::Oil& oil, double T_supply, Findings& to) {
  judge_thickening_and_thinning(oil, T_supply, to);
  const auto* cross = std::get_if<rheology::Cross>(&oil.shear);
  if (cross != nullptr && !rheology::stress_is_monotone(*cross)) {
    to.refuse("oil.viscosity.shear",
              "with these r and m the shear stress falls where the shear rate rises, which no oil "
              "does",
              "m (1 - sqrt r) must be less than 1 + sqrt r");
  }
  const auto* constant = std::get_if<rheology::ConstantViscosity>(&oil.temperature);
  const auto* slope = std::get_if<rheology::ReynoldsSlope>(&oil.temperature);
  if (slope != nullptr) {
    compare(
        to, "oil.viscosity.temperature.beta", slope->beta, kBearingLimits.viscosity_slope,
        fmt::format("the viscosity falls by a factor exp(-{:.4g}) with each degree", slope->beta),
        "oils have a beta of 0.02 to 0.06 1/K");
  }
  if (constant == nullptr && slope == nullptr) return judge_supplied_viscosity(oil, T_supply, to);
  const double eta = constant != nullptr ? constant->eta : slope->eta;
  compare(to, "oil.viscosity.temperature.eta", eta, kBearingLimits.viscosity,
          fmt::format("the viscosity is {}", shown(eta, "mPa s")),
          "check its unit (Pa s or mPa s?)");
}

void judge_density(const rheology::Oil& oil, Findings& to) {
  const auto* law = std::get_if<rheology::DowsonHigginson>(&oil.density);
  const double rho =
      law != nullptr ? law->rho0 : std::get<rheology::ConstantDensity>(oil.density).rho;
  compare(to, "oil.density", rho, kBearingLimits.oil_density,
          fmt::format("the oil's density is {:.4g} kg/m3", rho), "check its unit (g/cm3?)");
  if (law == nullptr) return;
  const double modulus = 1.0 / law->rise;
  compare(to, "oil.density.C1", modulus, kBearingLimits.bulk_modulus,
          fmt::format("C1 and C2 give a bulk modulus C1/(C2 - 1) of {}", shown(modulus, "GPa")),
          "check the unit of C1 (Pa, MPa or GPa?)");
  compare(to, "oil.density.expansivity", law->expansivity, kBearingLimits.oil_expansion,
          fmt::format("the oil's expansivity is {:.3g} 1/K", law->expansivity),
          "mineral oils have 6.4e-4 to 7.3e-4 1/K");
}

void judge_heat(const rheology::Oil& oil, double T, Findings& to) {
  const double cp = rheology::heat_capacity(oil, T).cp;
  compare(to, "oil.heat_capacity", cp, kBearingLimits.oil_heat_capacity,
          fmt::format("the oil's heat capacity is {:.4g} J/(kg K)", cp),
          "check its unit (kJ/(kg K)?)");
  const double k = rheology::conductivity(oil, T, 0.0).k;
  compare(to, "oil.conductivity", k, kBearingLimits.oil_conductivity,
          fmt::format("the oil's conductivity is {:.4g} W/(m K)", k), "check its unit");
}

/// Every temperature at which the oil is sure to be used, by key.
std::vector<std::pair<std::string, double>> film_temperatures(const Case& c) {
  std::vector<std::pair<std::string, double>> list;
  if (c.oil_temperature) list.emplace_back("oil.temperature", *c.oil_temperature);
  for (std::size_t k = 0; k < c.supplies.size(); ++k) {
    list.emplace_back(fmt::format("supply.{}.temperature", k), c.supplies[k].temperature);
  }
  if (c.measured.shell_back_temperature) {
    list.emplace_back("measured.shell_back_temperature", *c.measured.shell_back_temperature);
  }
  if (c.shell) {
    if (const auto* back = std::get_if<PrescribedBack>(&c.shell->back)) {
      list.emplace_back("shell.back.temperature", back->temperature);
    }
  }
  return list;
}

void judge_temperatures(const Case& c, Findings& to) {
  const auto& range = c.oil.range;
  for (const auto& [key, T] : film_temperatures(c)) {
    if (at_pole(c.oil, T)) {
      const double C = std::get<rheology::Vogel>(c.oil.temperature).C;
      to.refuse(key, fmt::format("the oil's Vogel law has its pole at -{:.4g} degC", C),
                fmt::format("it cannot be used at {}", shown(T, "degC")));
    } else if (T < range.T_min || T > range.T_max) {
      to.suspect(
          key,
          fmt::format("{} lies outside the range in which the oil's laws hold ({} to {})",
                      shown(T, "degC"), shown(range.T_min, "degC"), shown(range.T_max, "degC")));
    }
  }
  if (c.supplies.empty() || !(c.model.kappa > 0.0)) return;
  const Range& can = kValueRanges.temperature;
  if (const double T = equivalent_temperature(c); !can.holds(T)) {
    to.refuse("model.equivalent_temperature.kappa",
              fmt::format("the film at the equivalent temperature would be at {} (it must {})",
                          shown(T, "degC"), can.words));
  }
}

/// An equivalent temperature without the shell-back temperature that it is made of.
void judge_kappa(const Case& c, Findings& to) {
  const bool prescribed = c.shell && std::holds_alternative<PrescribedBack>(c.shell->back);
  const bool known = c.measured.shell_back_temperature || prescribed;
  if (known || c.model.kappa == Model{}.kappa || c.model.tier != Tier::isothermal) return;
  to.suspect("model.equivalent_temperature.kappa",
             "it is not used: no shell-back temperature is known, and the film has the oil's",
             "give measured.shell_back_temperature or shell.back.temperature");
}

/// A film at an equivalent temperature below that of all oil that enters.
void judge_cold_back(const Case& c, Findings& to) {
  const auto& back = c.measured.shell_back_temperature;
  const double coldest = supply_temperatures(c).first;
  if (!back || *back >= coldest || c.model.kappa <= 0.0) return;
  to.suspect(
      "measured.shell_back_temperature",
      fmt::format("{} is less than the {} of the oil that enters: the film at the equivalent "
                  "temperature would be colder than its oil",
                  shown(*back, "degC"), shown(coldest, "degC")),
      "check both, or where the back was measured");
}

}  // namespace

void judge_oil(const Case& c, Findings& to) {
  judge_switches(c, to);
  judge_viscosity(c.oil, mean_supply_temperature(c), to);
  judge_density(c.oil, to);
  judge_heat(c.oil, mean_supply_temperature(c), to);
  judge_temperatures(c, to);
  judge_cold_back(c, to);
  judge_kappa(c, to);
}

}  // namespace shellback::bearing
