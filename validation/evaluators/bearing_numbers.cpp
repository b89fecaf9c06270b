#include "validation/evaluators/bearing_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/largest.hpp"
#include "rheology/density.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::validation {
namespace {

/// Mass flow out of the supply lines into the cells that follow them [kg/s]; 0 without lines.
double inlet_flow(const bearing::Solution& s) {
  const fluid::FilmScene& scene = s.point.scene;
  if (!scene.supply.has_lines) return 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < scene.supply.line.size(); ++k) {
    if (scene.supply.line[k] >= 0) sum += s.film.flow.phi[k].m;
  }
  return sum * scene.grid.multiplicity();
}

/// Stiffness and damping in load axes and the whirl threshold, where the case asks for them.
void add_coefficients(const bearing::Solution& s, std::map<std::string, double>& value) {
  if (!s.coefficients || !s.coefficients->verdict.good()) return;
  const bearing::Coefficients& k = *s.coefficients;
  const char* axis[] = {"x", "y"};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      value[std::string("K_") + axis[i] + axis[j]] = k.K_load[i][j];
      value[std::string("B_") + axis[i] + axis[j]] = k.C_load[i][j];
    }
  }
  value["whirl_speed_number"] = k.speed_ratio;
  value["whirl_frequency_ratio"] = k.whirl_ratio;
}

}  // namespace

void add_bearing_numbers(const bearing::Solution& s, std::map<std::string, double>& value) {
  const bearing::Case& c = s.model.input;
  const double R = c.bearing.radius;
  const double L = c.bearing.width;
  const double gap = s.model.clearance;
  const double omega = std::abs(c.operation.omega);
  const double N = omega / (2.0 * kPi);
  const double area = 2.0 * R * L;
  const double eta = rheology::viscosity(s.model.oil, s.T_film, 0.0);
  const double rho = rheology::density(s.model.oil, s.T_film, 0.0).rho;
  const double W = std::hypot(s.film.force[0], s.film.force[1]);
  const double peak = largest(s.film.film.p);
  const double side = fluid::oil_flows(s.point.scene, s.film.flow).side / rho;
  const double inlet = inlet_flow(s) / rho;
  value["sommerfeld"] = std::pow(R / gap, 2) * eta * N * area / W;
  value["load_number"] = W * std::pow(gap / R, 2) / (area * eta * omega);
  value["friction_number"] = value.at("friction_torque") / (W * gap);
  value["side_flow_number"] = side / (R * gap * N * L);
  value["side_flow_per_R3"] = side / (R * R * gap * omega);
  value["mean_over_peak"] = W / (area * peak);
  add_coefficients(s, value);
  if (inlet == 0.0) return;
  value["inlet_flow_number"] = inlet / (R * gap * N * L);
  value["side_flow_share"] = side / inlet;
}

}  // namespace shellback::validation
