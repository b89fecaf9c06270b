#include "fidelity/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bearing/bearing.hpp"
#include "fidelity/bearing_table.hpp"
#include "fidelity/closed_forms.hpp"
#include "fidelity/lumped_heat.hpp"
#include "rheology/density.hpp"
#include "rheology/heat.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::fidelity {
namespace {

using namespace bearing;

/// Number and widths [m] of the parts of the surface that carry: two beside a groove all round.
std::pair<int, double> lands_of(const Case& c) {
  for (const Supply& s : c.supplies) {
    const bool all_round = s.kind == SupplyKind::circumferential_groove && s.arc >= 1.999 * kPi;
    if (all_round && s.length < c.bearing.width) return {2, 0.5 * (c.bearing.width - s.length)};
  }
  return {1, c.bearing.width};
}

/// Load and torque of asperities on the nominal film.
struct ContactSum {
  double load = 0.0;    ///< towards the widest gap [N]
  double torque = 0.0;  ///< [N m]
};

/// By the contact's share of the load or, without contact data, film over roughness: conventions
/// (textbook gives lambda 3 to 5 and 1).
Regime regime_of(const Estimate& e, bool contact) {
  const double x = contact ? e.asperity_share : -e.lambda;
  const double hydrodynamic = contact ? 0.01 : -4.0, boundary = contact ? 0.9 : -1.0;
  return x < hydrodynamic ? Regime::hydrodynamic : x > boundary ? Regime::boundary : Regime::mixed;
}

class Estimator {
 public:
  explicit Estimator(const Case& c)
      : c_(c),
        curve_(lands_of(c).second / (2.0 * c.bearing.radius)),
        oil_(c.oil),
        omega_(std::abs(c.operation.omega)),
        width_(lands_of(c).first * lands_of(c).second) {
    const Physics physics = physics_of(c, Tier::isothermal);
    if (!physics.pressure_dependence) oil_ = rheology::without_pressure_effect(oil_);
    if (!physics.shear_thinning) oil_ = rheology::without_shear_thinning(oil_);
    if (physics.contact && c.surfaces.contact) {
      contact_.emplace(c.surfaces.shell, c.surfaces.shaft, *c.surfaces.contact);
    }
    if (const auto* given = std::get_if<EccentricityGiven>(&c.operation.position)) {
      eps_ = std::max(given->ratio, 1e-9);
      load_angle_ = given->load_angle;
    } else {
      load_ = std::get<LoadGiven>(c.operation.position).force;
      load_angle_ = std::get<LoadGiven>(c.operation.position).angle;
    }
  }

  /// Everything at one film temperature.
  Estimate at(double T) const {
    const auto beyond_load = [&](double eps) {
      const double eta = viscosity(eps, T);
      return std::log((film(curve_.at(eps), eta) + contact(eps, eta).load) / load_);
    };
    const double least = 1e-9;  // concentric
    return state(eps_ ? *eps_ : load_ > 0.0 ? eccentricity_where(beyond_load) : least, T);
  }

  /// Heat that leaves minus friction power [W]; rises with T.
  double surplus(const Estimate& e, const std::vector<HeatPath>& paths) const {
    const double rho = rheology::density(oil_, e.T, 0.0).rho;
    const double cp = rheology::heat_capacity(oil_, e.T).cp;
    double out = rho * cp * e.side_flow * e.rise;
    for (const HeatPath& path : paths) out += path.conductance * (e.T - path.outside);
    return out - e.torque * omega_;
  }

 private:
  double area() const { return 2.0 * c_.bearing.radius * width_; }
  double psi() const { return c_.bearing.radial_clearance / c_.bearing.radius; }

  double viscosity(double eps, double T) const {
    const double e2 = std::min(eps * eps, 0.999);  // the mean rate of a touching film is finite
    const double rate = omega_ / (psi() * std::sqrt(1.0 - e2));
    return rheology::viscosity_slopes(oil_, T, load_ / area(), rate).eta;
  }

  /// What the film carries [N].
  double film(const BearingNumbers& n, double eta) const {
    return n.so * area() * eta * omega_ / (psi() * psi());
  }

  ContactSum contact(double eps, double eta) const {
    constexpr int kPoints = 180;  // around
    ContactSum sum;
    if (!contact_) return sum;
    const double patch = c_.bearing.radius * width_ * 2.0 * kPi / kPoints;
    for (int k = 0; k < kPoints; ++k) {
      const double phi = 2.0 * kPi * k / kPoints;  // from the smallest gap
      const double h = c_.bearing.radial_clearance * (1.0 - eps * std::cos(phi));
      const double p = contact_->at(h).p;
      sum.load += p * std::cos(phi) * patch;
      const auto place = contact_->place(h, p, eta, omega_ * c_.bearing.radius);
      sum.torque += contact_->friction().stress(place).sum() * c_.bearing.radius * patch;
    }
    return sum;
  }

  Estimate state(double eps, double T) const {
    const Bearing& b = c_.bearing;
    const BearingNumbers n = curve_.at(eps);
    const ContactSum touching = contact(eps, viscosity(eps, T));
    Estimate e;
    e.T = T;
    e.rise = T - c_.supplies.front().temperature;
    e.eta = viscosity(eps, T);
    e.eps = eps;
    const double carried = film(n, e.eta);
    e.load = eps_ ? carried + touching.load : load_;
    e.load_angle = load_angle_;
    e.asperity_share = e.load > 0.0 ? touching.load / e.load : 0.0;
    // The contact acts along the line of centres, the film at its own attitude.
    e.attitude =
        std::atan2(carried * std::sin(n.attitude), carried * std::cos(n.attitude) + touching.load);
    e.h_min = b.radial_clearance * (1.0 - eps);
    e.p_max = n.pressure * carried / area();
    const bool filled = c_.model.cavitated_shear == CavitatedShear::filled;
    const double couette = (filled ? n.couette : 1.0) * couette_torque(eps);
    e.torque_asperity = touching.torque;
    e.torque = e.eta * omega_ * b.radius * b.radius * width_ / psi() *
                   (couette + eps * n.so * std::sin(n.attitude)) +
               touching.torque;
    const double closest = load_angle_ + std::copysign(e.attitude, c_.operation.omega);
    e.side_flow = omega_ * b.radius * b.radial_clearance * width_ * n.side +
                  pressure_fed_flow(c_, eps, closest, e.eta);
    const double sigma = std::hypot(c_.surfaces.shell.roughness, c_.surfaces.shaft.roughness);
    e.lambda = sigma > 0.0 ? e.h_min / sigma : INFINITY;
    e.regime = regime_of(e, contact_.has_value());
    return e;
  }

  const Case& c_;
  BearingCurve curve_;
  rheology::Oil oil_;
  double omega_;  ///< without sign [rad/s]
  double width_;  ///< of all lands [m]
  std::optional<solid::AsperityContact> contact_;
  double load_ = 0.0;  ///< 0 where the position is given [N]
  double load_angle_ = 0.0;
  std::optional<double> eps_;  ///< if given
};

}  // namespace

const char* to_string(Regime regime) {
  return regime == Regime::hydrodynamic ? "hydrodynamic"
         : regime == Regime::mixed      ? "mixed"
                                        : "boundary";
}

Estimate estimate(const Case& c) {
  const Estimator estimator(c);
  const double T_supply = c.supplies.front().temperature;
  const auto paths = solid_heat_paths(c, rheology::conductivity(c.oil, T_supply, 0.0).k);
  double coldest = T_supply, warmest = T_supply;
  for (const HeatPath& path : paths) {
    if (path.conductance > 0.0) coldest = std::min(coldest, path.outside);
    warmest = std::max(warmest, path.outside);
  }
  const auto surplus = [&](double T) { return estimator.surplus(estimator.at(T), paths); };
  if (surplus(coldest) >= 0.0) return estimator.at(coldest);  // no heat to speak of
  constexpr double kMostRise = 400.0;  // of the film above all that cools it [K]
  const double span = warmest + kMostRise - coldest;
  for (double part = 1.0 / 256.0, low = coldest; part <= 1.0; part *= 2.0) {
    const double high = coldest + part * span;
    // The lowest of several balances: that of a bearing which is started cold. To a millikelvin.
    if (surplus(high) >= 0.0) return estimator.at(bracketed_root(surplus, low, high, 1e-3));
    low = high;
  }
  Estimate hottest = estimator.at(coldest + span);
  hottest.balanced = false;
  return hottest;
}

}  // namespace shellback::fidelity
