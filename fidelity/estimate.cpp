#include "fidelity/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/constants.hpp"
#include "coupling/bearing.hpp"
#include "fidelity/bearing_table.hpp"
#include "fidelity/closed_forms.hpp"
#include "fidelity/estimate_heat.hpp"
#include "rheology/density.hpp"
#include "rheology/heat.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::fidelity {
namespace {

using namespace coupling;

/// Load-carrying part of the surface: two halves beside a groove that goes all round.
struct Lands {
  int count = 1;
  double width = 0.0;  ///< of each [m]
};

Lands lands_of(const Case& c) {
  constexpr double kAllRound = 1.999 * kPi;
  for (const Supply& s : c.supplies) {
    if (s.kind == SupplyKind::hole || s.arc < kAllRound) continue;
    const double rest = c.bearing.width - s.length;
    if (rest > 0.0) return {2, 0.5 * rest};
  }
  return {1, c.bearing.width};
}

/// Load and torque of asperities on the nominal film.
struct ContactSum {
  double load = 0.0;    ///< towards the widest gap [N]
  double torque = 0.0;  ///< [N m]
};

class Estimator {
 public:
  explicit Estimator(const Case& c)
      : c_(c),
        lands_(lands_of(c)),
        curve_(lands_.width / (2.0 * c.bearing.radius)),
        oil_(c.oil),
        psi_(c.bearing.radial_clearance / c.bearing.radius),
        omega_(std::abs(c.operation.omega)),
        area_(2.0 * c.bearing.radius * lands_.width * lands_.count) {
    const Physics physics = physics_of(c, Tier::isothermal);
    if (!physics.pressure_dependence) oil_ = rheology::without_pressure_effect(oil_);
    if (!physics.shear_thinning) oil_ = rheology::without_shear_thinning(oil_);
    if (physics.contact && c.surfaces.contact) {
      contact_.emplace(c.surfaces.shell, c.surfaces.shaft, *c.surfaces.contact);
    }
    if (const auto* load = std::get_if<LoadGiven>(&c.operation.position)) {
      load_ = load->force;
      load_angle_ = load->angle;
    } else {
      const auto& given = std::get<EccentricityGiven>(c.operation.position);
      given_eps_ = given.ratio;
      load_angle_ = given.load_angle;
    }
  }

  /// Everything at one film temperature.
  Estimate at(double T) const {
    constexpr int kTurns = 12;  // viscosity and eccentricity; each turn gains two digits
    constexpr double kSettled = 1e-6;
    Estimate e;
    e.T = T;
    e.eps = given_eps_.value_or(0.6);
    for (int turn = 0; turn < kTurns; ++turn) {
      const double before = e.eta;
      set_viscosity(e);
      set_eccentricity(e);
      if (std::abs(e.eta - before) < kSettled * e.eta) break;
    }
    set_results(e);
    return e;
  }

  /// Heat that leaves minus friction power [W]; rises with T.
  double surplus(const Estimate& e, const std::vector<HeatPath>& paths) const {
    const double rho = rheology::density(oil_, e.T, 0.0).rho;
    const double cp = rheology::heat_capacity(oil_, e.T).cp;
    double out = rho * cp * e.side_flow * (e.T - c_.supplies.front().temperature);
    for (const HeatPath& path : paths) out += path.conductance * (e.T - path.outside);
    return out - e.torque * omega_;
  }

 private:
  void set_viscosity(Estimate& e) const {
    const double e2 = std::min(e.eps * e.eps, 0.999);  // the mean rate of a touching film is finite
    e.rate = omega_ * c_.bearing.radius / (c_.bearing.radial_clearance * std::sqrt(1.0 - e2));
    const double p = given_eps_ ? 0.0 : load_ / area_;
    e.eta = rheology::viscosity_slopes(oil_, e.T, p, e.rate).eta;
  }

  double force(double so, double eta) const { return so * area_ * eta * omega_ / (psi_ * psi_); }

  void set_eccentricity(Estimate& e) const {
    if (given_eps_) {
      e.eps = *given_eps_;
      return;
    }
    if (!contact_) {
      e.so = load_ / force(1.0, e.eta);
      e.eps = curve_.eccentricity(e.so);
      return;
    }
    double low = 1e-6;  // of -ln(1 - eps)
    double high = 16.0;
    constexpr int kHalvings = 40;  // to round-off of h_min
    for (int k = 0; k < kHalvings; ++k) {
      const double u = 0.5 * (low + high);
      const double eps = -std::expm1(-u);
      (force(curve_.at(eps).so, e.eta) + contact(eps).load < load_ ? low : high) = u;
    }
    e.eps = -std::expm1(-low);
    e.so = curve_.at(e.eps).so;
  }

  ContactSum contact(double eps) const {
    constexpr int kPoints = 180;  // around the bearing
    ContactSum sum;
    if (!contact_) return sum;
    const double patch = c_.bearing.radius * lands_.width * lands_.count * 2.0 * kPi / kPoints;
    for (int k = 0; k < kPoints; ++k) {
      const double phi = 2.0 * kPi * k / kPoints;  // from the smallest gap
      const double h = c_.bearing.radial_clearance * (1.0 - eps * std::cos(phi));
      const double p = contact_->at(h).p;
      sum.load += p * std::cos(phi) * patch;
      sum.torque += contact_->friction() * p * c_.bearing.radius * patch;
    }
    return sum;
  }

  void set_results(Estimate& e) const {
    const Bearing& b = c_.bearing;
    const double eps = std::max(e.eps, 1e-9);
    const BearingNumbers n = curve_.at(eps);
    const ContactSum touching = contact(eps);
    e.so = n.so;
    const double film = force(n.so, e.eta);
    e.load = given_eps_ ? film + touching.load : load_;
    e.load_angle = load_angle_;
    e.asperity_share = e.load > 0.0 ? touching.load / e.load : 0.0;
    // The contact acts along the line of centres, the film at its own attitude.
    e.attitude =
        std::atan2(film * std::sin(n.attitude), film * std::cos(n.attitude) + touching.load);
    e.h_min = b.radial_clearance * (1.0 - eps);
    e.p_max = n.pressure * film / area_;
    const bool filled = c_.model.cavitated_shear == CavitatedShear::filled;
    const double unit = e.eta * omega_ * b.radius * b.radius * lands_.width * lands_.count / psi_;
    e.torque_asperity = touching.torque;
    e.torque = unit * ((filled ? n.couette : 1.0) * couette_torque(eps) +
                       eps * n.so * std::sin(n.attitude)) +
               touching.torque;
    const double turn = c_.operation.omega < 0.0 ? -1.0 : 1.0;
    e.side_flow = omega_ * b.radius * b.radial_clearance * lands_.width * lands_.count * n.side +
                  pressure_fed_flow(c_, eps, load_angle_ + turn * e.attitude, e.eta);
    const double sigma = std::hypot(c_.surfaces.shell.roughness, c_.surfaces.shaft.roughness);
    e.lambda = sigma > 0.0 ? e.h_min / sigma : INFINITY;
    e.rise = e.T - c_.supplies.front().temperature;
    e.regime = regime_of(e);
  }

  Regime regime_of(const Estimate& e) const {
    if (contact_) {
      return e.asperity_share < kHydrodynamicShare ? Regime::hydrodynamic
             : e.asperity_share > kBoundaryShare   ? Regime::boundary
                                                   : Regime::mixed;
    }
    return e.lambda > kHydrodynamicLambda ? Regime::hydrodynamic
           : e.lambda < kBoundaryLambda   ? Regime::boundary
                                          : Regime::mixed;
  }

  const Case& c_;
  Lands lands_;
  BearingCurve curve_;
  rheology::Oil oil_;
  double psi_;
  double omega_;
  double area_;  ///< projected, of the lands [m2]
  std::optional<solid::AsperityContact> contact_;
  double load_ = 0.0;
  double load_angle_ = 0.0;
  std::optional<double> given_eps_;
};

}  // namespace

const char* to_string(Regime regime) {
  switch (regime) {
    case Regime::hydrodynamic:
      return "hydrodynamic";
    case Regime::mixed:
      return "mixed";
    case Regime::boundary:
      return "boundary";
  }
  return "unknown";
}

Estimate estimate(const Case& c) {
  constexpr double kMostRise = 400.0;  // [K]: no oil lives to see it
  constexpr double kSettled = 1e-3;    // [K]
  constexpr int kTurns = 60;
  const Estimator estimator(c);
  const auto k = rheology::conductivity(c.oil, c.supplies.front().temperature, 0.0).k;
  const auto paths = solid_heat_paths(c, k);
  double low = c.supplies.front().temperature;
  for (const HeatPath& path : paths) {
    if (path.conductance > 0.0) low = std::min(low, path.outside);
  }
  double high = c.supplies.front().temperature + kMostRise;
  for (const HeatPath& path : paths) high = std::max(high, path.outside + kMostRise);
  Estimate e = estimator.at(low);
  double f_low = estimator.surplus(e, paths);
  if (f_low >= 0.0) return e;  // no heat to speak of
  Estimate hottest = estimator.at(high);
  double f_high = estimator.surplus(hottest, paths);
  if (f_high < 0.0) {
    hottest.balanced = false;
    return hottest;
  }
  for (int turn = 0; turn < kTurns && high - low > kSettled; ++turn) {
    const double T = turn % 2 == 1
                         ? 0.5 * (low + high)
                         : std::clamp(high - f_high * (high - low) / (f_high - f_low),
                                      low + 0.01 * (high - low), high - 0.01 * (high - low));
    e = estimator.at(T);
    const double f = estimator.surplus(e, paths);
    (f < 0.0 ? low : high) = T;
    (f < 0.0 ? f_low : f_high) = f;
  }
  return e;
}

}  // namespace shellback::fidelity
