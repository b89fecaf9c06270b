#include "rheology/viscosity.hpp"

#include <cmath>
#include <variant>

#include "rheology/pressure.hpp"
#include "rheology/shear.hpp"
#include "rheology/temperature.hpp"

namespace shellback::rheology {
namespace {

LogAndSlopes log_viscosity(const Oil& oil, double T, double p) {
  return std::visit(
      [T, p](const auto& pressure, const auto& temperature) {
        return rheology::log_viscosity(pressure, temperature, T, p);
      },
      oil.pressure, oil.temperature);
}

}  // namespace

double viscosity(const Oil& oil, double T, double p) {
  return std::exp(log_viscosity(oil, T, p).value);
}

ViscositySlopes viscosity_slopes(const Oil& oil, double T, double p, double rate) {
  const LogAndSlopes low = log_viscosity(oil, T, p);
  const ShearFactor f = shear_factor(oil.shear, rate);
  return {std::exp(low.value) * f.value, low.dT, low.dp, f.dlnrate};
}

double pressure_slope(const Oil& oil, double T, double p) { return log_viscosity(oil, T, p).dp; }

Oil without_pressure_effect(Oil oil) {
  if (const auto* houpert = std::get_if<Houpert>(&oil.pressure)) {
    const double eta_at = std::exp(log_viscosity(oil.temperature, houpert->at).value);
    oil.temperature = ReynoldsSlope{eta_at, houpert->at, houpert->beta};
  }
  oil.pressure = NoPressureEffect{};
  return oil;
}

bool thins(const Oil& oil) { return !std::holds_alternative<NoShearThinning>(oil.shear); }

Oil without_shear_thinning(Oil oil) {
  oil.shear = NoShearThinning{};
  return oil;
}

}  // namespace shellback::rheology
