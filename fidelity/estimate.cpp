#include "fidelity/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bearing/heat/heat_endings.hpp"
#include "core/round_off.hpp"
#include "fidelity/bearing_table.hpp"
#include "fidelity/estimate_scene.hpp"

namespace shellback::fidelity {
namespace {

using namespace bearing;

/// The highest of the supplies, which stands within the film [Pa].
double supply_pressure(const Case& c) {
  double p = 0.0;
  for (const Supply& s : c.supplies) p = std::max(p, s.pressure);
  return p;
}

/// By the contact's share of the load or, without contact data, film over roughness: conventions
/// (textbook gives lambda 3 to 5 and 1).
Regime regime_of(const Estimate& e, bool contact) {
  const double x = contact ? e.asperity_share : -e.lambda;
  const double hydrodynamic = contact ? 0.01 : -4.0, boundary = contact ? 0.9 : -1.0;
  return x < hydrodynamic ? Regime::hydrodynamic : x > boundary ? Regime::boundary : Regime::mixed;
}

class Estimator {
 public:
  explicit Estimator(const Case& c) : c_(c), scene_(c), curve_(scene_.b()) {
    omega_ = std::abs(c.operation.omega);
    if (const auto* given = std::get_if<EccentricityGiven>(&c.operation.position)) {
      eps_ = std::max(given->ratio, kRoundOff);
      closest_ = given->direction(c.operation.omega);
    } else {
      load_ = std::get<LoadGiven>(c.operation.position).force;
      load_angle_ = std::get<LoadGiven>(c.operation.position).angle;
    }
  }

  /// Everything at one film temperature.
  Estimate at(double T) const {
    const auto beyond_load = [&](double eps) {
      const double eta = viscosity(eps, T);
      return std::log((film(curve_.at(eps), eta) + scene_.contact(eps, eta, omega_).load) / load_);
    };
    return state(eps_ ? *eps_ : load_ > 0.0 ? eccentricity_where(beyond_load) : kRoundOff, T);
  }

  /// Heat that leaves minus friction power [W]; rises with T.
  double surplus(const Estimate& e, const std::vector<HeatPath>& paths) const {
    return scene_.heat_away(e.T, e.side_flow, paths) - e.torque * omega_;
  }

 private:
  double viscosity(double eps, double T) const { return scene_.viscosity(eps, T, load_, omega_); }

  /// What the film carries [N].
  double film(const BearingNumbers& n, double eta) const {
    return n.so * scene_.area() * eta * omega_ / (scene_.psi() * scene_.psi());
  }

  Estimate state(double eps, double T) const {
    const Bearing& b = c_.bearing;
    const BearingNumbers n = curve_.at(eps);
    const ContactSum touching = scene_.contact(eps, viscosity(eps, T), omega_);
    Estimate e;
    e.T = T;
    e.rise = T - mean_supply_temperature(c_);
    e.eta = viscosity(eps, T);
    e.eps = eps;
    const double carried = film(n, e.eta);
    e.load = eps_ ? carried + touching.load : load_;
    e.asperity_share = e.load > 0.0 ? touching.load / e.load : 0.0;
    // The contact acts along the line of centres, the film at its own attitude.
    e.attitude =
        std::atan2(carried * std::sin(n.attitude), carried * std::cos(n.attitude) + touching.load);
    e.h_min = b.radial_clearance * (1.0 - eps);
    e.p_max = std::max(n.pressure * carried / scene_.area(), supply_pressure(c_));
    e.torque_asperity = touching.torque;
    e.torque = scene_.couette(eps, n.couette, e.eta, omega_) +
               e.eta * omega_ * b.radius * b.radius * scene_.width() / scene_.psi() * eps * n.so *
                   std::sin(n.attitude) +
               touching.torque;
    const double turned = std::copysign(e.attitude, c_.operation.omega);
    e.load_angle = closest_ ? *closest_ - turned : load_angle_;
    const double closest = e.load_angle + turned;
    const double own = scene_.has_ring() ? 0.0 : n.side;
    e.side_flow = omega_ * b.radius * b.radial_clearance * scene_.width() * own +
                  pressure_fed_flow(c_, eps, closest, e.eta);
    const double sigma = combined_roughness(c_.surfaces);
    e.lambda = sigma > 0.0 ? e.h_min / sigma : INFINITY;
    e.regime = regime_of(e, scene_.touches());
    return e;
  }

  const Case& c_;
  EstimateScene scene_;
  BearingCurve curve_;
  double omega_ = 0.0;  ///< without sign [rad/s]
  double load_ = 0.0;   ///< 0 where the position is given [N]
  double load_angle_ = 0.0;
  std::optional<double> eps_;      ///< if given
  std::optional<double> closest_;  ///< and where the journal is nearest [rad]
};

}  // namespace

const char* to_string(Regime regime) {
  return regime == Regime::hydrodynamic ? "hydrodynamic"
         : regime == Regime::mixed      ? "mixed"
                                        : "boundary";
}

Estimate estimate(const Case& c) {
  const Estimator estimator(c);
  const HeatWays ways = heat_ways(c);
  const auto surplus = [&](double T) { return estimator.surplus(estimator.at(T), ways.paths); };
  if (surplus(ways.coldest) >= 0.0) return estimator.at(ways.coldest);  // no heat to speak of
  const double span = ways.warmest + kHottestRise - ways.coldest;
  for (double part = 1.0 / 256.0, low = ways.coldest; part <= 1.0; part *= 2.0) {
    const double high = ways.coldest + part * span;
    // The lowest of several balances: that of a bearing which is started cold. To a millikelvin.
    if (surplus(high) >= 0.0) return estimator.at(root_between(surplus, low, high, 1e-3));
    low = high;
  }
  Estimate hottest = estimator.at(ways.coldest + span);
  hottest.balanced = false;
  return hottest;
}

}  // namespace shellback::fidelity
