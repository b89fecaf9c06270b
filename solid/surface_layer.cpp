#include "solid/surface_layer.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"

namespace shellback::solid {
namespace {

constexpr double kRound = 1e-14;  ///< of the thickness: where a search for a depth ends [-]
constexpr int kMost = 200;        ///< halvings of such a search, with Newton's steps between

/// The root of a rising f on [low, high]; `value` gives f and its slope.
template <class Function>
double rising_root(double low, double high, double first, double round, const Function& value) {
  double x = std::clamp(first, low, high);
  for (int k = 0; k < kMost && high - low > round; ++k) {
    const auto [f, slope] = value(x);
    (f > 0.0 ? high : low) = x;
    const double next = x - f / slope;
    if (std::abs(next - x) <= round) return std::clamp(next, low, high);
    x = next > low && next < high ? next : 0.5 * (low + high);
  }
  return x;
}

struct ValueAndSlope {
  double value = 0.0;
  double slope = 0.0;
};

/// c and dc/dr.
ValueAndSlope stiffness_of(const SurfaceLayer& l, double r) {
  const double c =
      l.youngs_modulus / l.thickness * std::pow(l.thickness / (l.thickness - r), l.progression);
  return {c, c * l.progression / (l.thickness - r)};
}

/// r_e of (4).
double elastic_depth(const SurfaceLayer& l, double P, double lambda, double before) {
  const double low = lambda * before / (1.0 + lambda);  // nothing presses
  const auto f = [&](double r) {
    const ValueAndSlope c = stiffness_of(l, r);
    const double x = (1.0 + lambda) * r - lambda * before;
    return ValueAndSlope{c.value * x - P, c.slope * x + c.value * (1.0 + lambda)};
  };
  const double linear = (P * l.thickness / l.youngs_modulus + lambda * before) / (1.0 + lambda);
  if (l.progression == 0.0) return linear;
  const double high = l.thickness * (1.0 - kRound);
  return rising_root(low, high, std::min(linear, 0.5 * (low + high)), kRound * l.thickness, f);
}

}  // namespace

double SurfaceLayer::stiffness(double elastic) const { return stiffness_of(*this, elastic).value; }

double SurfaceLayer::yield_depth() const { return elastic_depth(*this, hardness, 0.0, 0.0); }

PressedColumn press(const SurfaceLayer& l, double P, double own, const LayerColumn& before) {
  EXPECTS(own > 0.0 && l.thickness > 0.0 && l.youngs_modulus > 0.0 && l.damping_ratio > 0.0);
  if (std::isnan(P)) return {{P, P}, P};
  const double lambda = l.damping_ratio / own;
  const double pressed = std::max(P, 0.0);
  const double r = elastic_depth(l, pressed, lambda, before.elastic);
  const double yield = l.yield_depth();
  if (r <= yield) {
    const ValueAndSlope c = stiffness_of(l, r);
    const double slope =
        c.slope * ((1.0 + lambda) * r - lambda * before.elastic) + c.value * (1.0 + lambda);
    return {{r, before.plastic}, P > 0.0 ? 1.0 / slope : 0.0};
  }
  const double by_pressure = 1.0 / (lambda * l.stiffness(yield));
  const double flowed = (P - l.hardness) * by_pressure - (yield - before.elastic);
  return {{yield, before.plastic + std::max(flowed, 0.0)}, by_pressure};
}

double layer_loss(const SurfaceLayer& l, double P, const LayerColumn& now,
                  const LayerColumn& rate) {
  const double pressed = std::max(P, 0.0);
  return (pressed - l.stiffness(now.elastic) * now.elastic) * rate.elastic + pressed * rate.plastic;
}

}  // namespace shellback::solid
