#include <algorithm>
#include <cmath>

#include "bearing/told_ranges.hpp"
#include "core/constants.hpp"
#include "core/round_off.hpp"
#include "fidelity/bearing_table.hpp"
#include "fidelity/estimate.hpp"
#include "fidelity/estimate_bars.hpp"

namespace shellback::fidelity {
namespace {

using namespace bearing;

std::vector<Quantity> quantities(const Case& c, const Estimate& e, const EstimateBars& bars) {
  const double omega = c.operation.omega;
  const bool given = std::holds_alternative<EccentricityGiven>(c.operation.position);
  const bool rough = c.surfaces.contact.has_value();
  const double eccentricity = given ? 0.0 : bars.eccentricity / std::max(e.eps, kRoundOff);
  std::vector<Quantity> list;
  const auto add = [&](const char* name, double value, const char* unit, double relative) {
    const double size = std::abs(value);
    list.push_back({name, value, unit, kTableError * size, relative * size});
  };
  const auto add_torque = [&](const char* name, double value, double relative) {
    add(name, std::copysign(value, omega), "N m", relative);
  };
  add_torque("friction_torque", e.torque, bars.torque);
  if (rough) add_torque("friction_torque_asperity", e.torque_asperity, kMostBar);
  add("power_loss", e.torque * std::abs(omega), "W", bars.torque);
  add("eccentricity_ratio", e.eps, "1", eccentricity);
  add("attitude_angle", e.attitude * 180.0 / kPi, "deg", bars.angle);
  add("h_min", e.h_min, "m", bars.film);
  add("p_max", e.p_max, "Pa", bars.peak);
  if (rough) add("asperity_load_share", e.asperity_share, "1", kMostBar);
  const double x = -e.load * std::cos(e.load_angle), y = -e.load * std::sin(e.load_angle);
  const double turned = bars.angle * e.attitude;  // of a given place the load's direction [rad]
  const auto bar = [&](double along, double across) {
    return given ? bars.peak * std::abs(along) + turned * std::abs(across) : 0.0;
  };
  list.push_back({"load_x", x, "N", 0.0, bar(x, y)});
  list.push_back({"load_y", y, "N", 0.0, bar(y, x)});
  add("side_flow", e.side_flow, "m3/s", bars.flow);
  list.push_back({"T_film_mean", e.T, "K", 0.0, bars.temperature});
  return list;
}

}  // namespace

Result estimate_result(const Case& c) {
  const Estimate e = estimate(c);
  const EstimateBars bars = estimate_bars(c, e);
  Result r;
  r.tier = Tier::estimate;
  r.title = c.title;
  r.warnings.assign(c.warnings.begin(), c.warnings.end());
  r.assumptions.assign(c.assumptions.begin(), c.assumptions.end());
  r.assumptions.push_back(note::EstimateOfFilm{to_string(e.regime)});
  r.audit = {NAN, NAN, NAN, NAN};  // there is no field whose balance could be drawn
  if (!e.balanced) {
    r.verdict = {Status::no_steady_state, ending::Plain::estimate_unbalanced};
    return r;
  }
  for (Note& w : oil_range_warnings(c.oil, e.T, e.T, e.p_max)) r.warnings.push_back(std::move(w));
  add_turbulence(c, c.operation.omega * c.bearing.radius, e.T, r.warnings);
  add_contact_left_out(c, e.h_min, r.warnings);
  r.quantities = quantities(c, e, bars);
  r.effects = bars.effects;
  return r;
}

}  // namespace shellback::fidelity
