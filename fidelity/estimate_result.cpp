#include <cmath>

#include "core/constants.hpp"
#include "coupling/bearing.hpp"
#include "fidelity/bearing_table.hpp"
#include "fidelity/estimate.hpp"
#include "fidelity/estimate_error.hpp"
#include "fidelity/indicators.hpp"

namespace shellback::fidelity {
namespace {

using namespace coupling;

class Quantities {
 public:
  /// `bar`: relative error of what is left out; the table's is added as that of the grid.
  void add(const char* name, double value, const char* unit, double bar) {
    list_.push_back({name, value, unit, kTableError * std::abs(value), bar * std::abs(value)});
  }
  void add_known(const char* name, double value, const char* unit, double bar) {
    list_.push_back({name, value, unit, 0.0, bar});
  }
  std::vector<Quantity> take() { return std::move(list_); }

 private:
  std::vector<Quantity> list_;
};

std::vector<Quantity> quantities(const Case& c, const Estimate& e, const EstimateBars& bar) {
  Quantities q;
  const double omega = c.operation.omega;
  const double turn = omega < 0.0 ? -1.0 : 1.0;
  const bool given = std::holds_alternative<EccentricityGiven>(c.operation.position);
  q.add("friction_torque", turn * e.torque, "N m", bar.torque);
  if (c.surfaces.contact) {
    q.add("friction_torque_asperity", turn * e.torque_asperity, "N m", bar.contact);
  }
  q.add("power_loss", e.torque * std::abs(omega), "W", bar.torque);
  q.add("eccentricity_ratio", e.eps, "1",
        given ? 0.0 : bar.h_min * (1.0 - e.eps) / std::max(e.eps, 1e-9));
  q.add("attitude_angle", e.attitude * 180.0 / kPi, "deg", bar.attitude);
  q.add("h_min", e.h_min, "m", bar.h_min);
  q.add("p_max", e.p_max, "Pa", bar.p_max);
  if (c.surfaces.contact) q.add("asperity_load_share", e.asperity_share, "1", bar.contact);
  const double x = -e.load * std::cos(e.load_angle);
  const double y = -e.load * std::sin(e.load_angle);
  q.add_known("load_x", x, "N", given ? bar.p_max * std::abs(x) : 0.0);
  q.add_known("load_y", y, "N", given ? bar.p_max * std::abs(y) : 0.0);
  q.add("side_flow", e.side_flow, "m3/s", bar.side_flow);
  q.add_known("T_film_mean", e.T, "K", bar.temperature);
  return q.take();
}

}  // namespace

Result estimate_result(const Case& c) { return estimate_result(c, estimate(c)); }

Result estimate_result(const Case& c, const Estimate& e) {
  const Indicators numbers = indicators(c, e);
  Result r;
  r.tier = Tier::estimate;
  r.title = c.title;
  r.warnings = c.warnings;
  r.assumptions = c.assumptions;
  r.assumptions.push_back(
      "estimate: rigid circular bearing fed at the widest gap, one temperature from a heat balance "
      "in lumps; regime " +
      std::string(to_string(e.regime)));
  r.audit = {NAN, NAN, NAN, NAN};  // there is no field whose balance could be drawn
  if (!e.balanced) {
    r.verdict = {
        Status::no_steady_state,
        "the estimate finds no film temperature at which the friction heat is carried away", "",
        "lower speed or load, feed more oil, or ask a tier that resolves the heat"};
    return r;
  }
  r.quantities = quantities(c, e, estimate_bars(c, e, numbers));
  Physics has = physics_of(c, Tier::isothermal);
  has.elastic = has.flow_factors = false;
  r.effects = effects(numbers, has);
  return r;
}

}  // namespace shellback::fidelity
