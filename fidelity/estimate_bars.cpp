#include "fidelity/estimate_bars.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/physics.hpp"
#include "bearing/told_ranges.hpp"
#include "core/constants.hpp"
#include "fidelity/indicators.hpp"
#include "rheology/heat.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::fidelity {
namespace {

using namespace bearing;

/// How far supplies are from feeding an unloaded film at ambient pressure (docs/decisions/050).
struct SupplyNumbers {
  /// What their pressure would carry, spread half-way to the edges and a quarter of the width
  /// around their own, over the load [-].
  double lift = 0.0;
  /// Side flow over what they can feed, by pressure and by the motion of the journal, times the
  /// part of the clearance that is left, beyond a half: thick films need all their oil [-].
  double starved = 0.0;
  /// By how much more oil would rise if no more of it left than they can feed, at least 1 [-].
  double hotter = 1.0;
};

/// Beyond it a bar of the temperature says nothing more [-].
constexpr double kMostHotter = 10.0;

SupplyNumbers supply_numbers(const Case& c, const Estimate& e) {
  SupplyNumbers n;
  double force = 0.0, fed = 0.0;
  const double B = c.bearing.width, R = c.bearing.radius;
  const double h = c.bearing.radial_clearance * (1.0 + e.eps);  // where it is fed
  for (const Supply& given : c.supplies) {
    const Supply s = enclosed(given, R);
    const double p = std::max(0.0, s.pressure);
    const double along = s.length, around = s.arc * R;
    const bool ring = goes_all_round(s);
    if (ring) {
      force += p * B * 2.0 * R;  // it carries nothing, but holds cavitation off
    } else {
      force += p * 0.5 * (along + B) * (2.0 * R * std::sin(0.5 * around / R) + 0.25 * B);
    }
    const double size = 0.5 * (along + around);
    const double spread = 2.0 * kPi / std::log(std::max(1.5, B / size));  // source in a film
    fed += ring ? INFINITY
                : h * h * h * p / (12.0 * e.eta) * spread +
                      0.5 * std::abs(c.operation.omega) * R * h * along;
  }
  force += std::max(0.0, -c.model.cavitation_pressure) * B * 2.0 * R;  // that the table has not
  if (e.load > 0.0) n.lift = force / e.load;
  n.starved = e.side_flow / fed * (1.0 - e.eps) - 0.5;  // no number: the widest bar
  if (n.starved < 0.0) n.starved = 0.0;
  if (e.side_flow > fed) n.hotter = std::min(e.side_flow / fed, kMostHotter);
  return n;
}

/// Indicator numbers. Source of numbers and limits: methods 7.2 (docs/models.md); names are those
/// of the effects that a solved result reports. Orders of magnitude.
struct Indicators {
  double heating = 0.0;  ///< beta dT, dT of the heat balance [-]
  double elastic = 0.0;  ///< opening of layers and a held ring under p_max over h_min; 0: no shell
  double thermal =
      0.0;  ///< free thermal deformation of the clearance over the clearance [-]; 0: no walls
  double pressure = 0.0;  ///< alpha p_max [-]
  SupplyNumbers supply;
  std::vector<Effect> effects;
};

/// A layer on a stiff back: compressed, sideways held, and pushed aside from where the pressure, a
/// parabola over the width B, is largest, by t^3/(3 G) 8/B^2 of it (textbook: lubrication theory of
/// a thin incompressible layer) [m/Pa].
double layer_compliance(const ShellLayer& layer, double B) {
  const solid::Material& m = layer.material;
  const double t = layer.thickness;
  const double shear = m.shear_modulus();
  return t * solid::confined_compliance(m) + 8.0 * t * t * t / (3.0 * shear * B * B);
}

const solid::Material& body(const Shell& shell) {
  return shell.housing ? shell.housing->material : shell.layers[0].material;
}

Indicators indicators(const Case& c, const Estimate& e) {
  const double U = std::abs(c.operation.omega) * c.bearing.radius;
  const double h = std::max(e.h_min, 1e-9);
  const auto oil = rheology::viscosity_slopes(c.oil, e.T, 0.0, 0.0);
  Indicators n;
  n.supply = supply_numbers(c, e);
  n.heating = -oil.dln_dT * std::abs(e.rise) * n.supply.hotter;
  if (c.shell) n.elastic = bore_compliance(c) * e.p_max / h;
  n.thermal = thermal_opening(c, e.T);
  n.pressure = rheology::pressure_slope(c.oil, e.T, 0.0) * e.p_max;
  const double nahme = -oil.dln_dT * e.eta * U * U / rheology::conductivity(c.oil, e.T, 0.0).k;
  const double lost = 1.0 - rheology::viscosity_slopes(c.oil, e.T, 0.0, U / h).eta / oil.eta;
  const note::NotLaminar film = reynolds_number(c, U, e.T);
  const Physics has = physics_of(c, Tier::isothermal);
  n.effects = {
      {EffectKind::heating, true, n.heating},
      {EffectKind::temperature_across_film, false, nahme},
      {EffectKind::elastic_deformation, false, n.elastic},
      {EffectKind::thermal_deformation, false, n.thermal},
      {EffectKind::viscosity_with_pressure, has.pressure_dependence, n.pressure},
      {EffectKind::shear_thinning, has.shear_thinning, lost},
      {EffectKind::roughness_and_contact, has.contact, e.lambda},
      {EffectKind::turbulence, false, film.reynolds / film.limit},
      {EffectKind::film_inertia, false, reduced_reynolds(c, film)},
  };
  return n;
}

/// A relative bar: what it is at least, and more per unit of each indicator number.
struct BarParts {
  double least, heating, thermal, elastic, pressure, contact, lift, starved;
};
struct AllParts {
  BarParts torque{0.10, 0.30, 0.10, 0.05, 0.15, 0.5, 0.25, 0.05};
  BarParts film{0.10, 0.25, 1.0, 0.5, 0.2, 1.0, 0.4, 0.15};
  BarParts flow{1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
  BarParts angle{0.1, 0.0, 0.5, 0.5, 0.0, 0.0, 0.5, 0.15};
  double peak_lift = 0.8, peak_starved = 0.5;  ///< of the peak, beside twice the film's bar
};
constexpr AllParts kParts{};

double bar(const BarParts& part, const Estimate& e, const Indicators& n) {
  return std::min(kMostBar, part.least + part.heating * n.heating + part.thermal * n.thermal +
                                part.elastic * n.elastic + part.pressure * n.pressure +
                                part.contact * e.asperity_share + part.lift * n.supply.lift +
                                part.starved * n.supply.starved);
}

}  // namespace

double shaft_sag(const Case& c) {
  if (!c.shaft || !c.shaft->span) return 0.0;
  constexpr double kShear = 0.9;  // of the section, a circle (textbook)
  const solid::Material& m = c.shaft->material;
  const double R = c.bearing.radius, half = 0.5 * c.bearing.width;
  const double load = 2.0 * R * c.bearing.width;  // per pressure
  const double middle = 0.25 * load * (*c.shaft->span - half);
  const double section = kPi * R * R;
  const double G = m.shear_modulus();
  return 0.5 * half * half *
         (middle / (m.youngs_modulus * 0.25 * section * R * R) + 2.0 * R / (kShear * G * section));
}

namespace {

/// Of the bore's radius [1/K]. A housing that is clamped at its outer radius b grows inwards alone:
/// u(a) = -alpha a dT (1 + nu)(1 - k^2)/((1 - nu) + (1 + nu) k^2), k = a/b (textbook, plane
/// stress).
double bore_expansion(const Case& c) {
  const double alpha = body(*c.shell).expansion;
  if (!c.shell->housing || c.shell->housing->support != HousingSupport::clamped) return alpha;
  double inner = c.bearing.radius;
  for (const ShellLayer& layer : c.shell->layers) inner += layer.thickness;
  const double nu = c.shell->housing->material.poisson_ratio;
  const double k2 = std::pow(inner / c.shell->housing->outer_radius, 2);
  return -alpha * (1.0 + nu) * (1.0 - k2) / ((1.0 - nu) + (1.0 + nu) * k2);
}

}  // namespace

double thermal_opening(const Case& c, double T) {
  if (!c.shell || !c.shaft) return 0.0;
  const double shaft = c.shaft->material.expansion;
  const double difference = std::abs(bore_expansion(c) - shaft);
  return std::max(difference, 0.3 * shaft) *  // alike: the shaft is the warmer one
         std::abs(T - c.bearing.reference_temperature) * c.bearing.radius /
         c.bearing.radial_clearance;
}

double bore_compliance(const Case& c) {
  double inner = c.bearing.radius, layers = shaft_sag(c);
  for (const ShellLayer& layer : c.shell->layers) {
    inner += layer.thickness;
    layers += layer_compliance(layer, c.bearing.width);
  }
  if (!c.shell->housing) return layers;
  const solid::Material& m = c.shell->housing->material;
  const double a = inner, b = c.shell->housing->outer_radius, nu = m.poisson_ratio;
  return layers + (1.0 + nu) * (b * b - a * a) /
                      (a * m.youngs_modulus * (1.0 / (1.0 - 2.0 * nu) + b * b / (a * a)));
}

EstimateBars estimate_bars(const Case& c, const Estimate& e) {
  Indicators n = indicators(c, e);
  Indicators bounded = n;  // friction feels a larger gap less and less
  bounded.elastic = std::min(n.elastic, 1.0);
  EstimateBars bars;
  bars.torque = bar(kParts.torque, e, bounded);
  bars.film = bar(kParts.film, e, n);
  bars.peak = std::min(kMostBar, 2.0 * bars.film + kParts.peak_lift * n.supply.lift +
                                     kParts.peak_starved * n.supply.starved);
  bars.flow = bar(kParts.flow, e, n);
  bars.angle = bar(kParts.angle, e, n);
  // Of h = gap - e: by h, and by what walls and pressure change in the gap.
  bars.eccentricity = n.thermal + (bars.film + n.elastic) * (1.0 - e.eps);
  bars.temperature = std::max(2.0, std::max(0.5, n.supply.hotter - 1.0) * std::abs(e.rise));
  bars.effects = std::move(n.effects);
  return bars;
}

}  // namespace shellback::fidelity
