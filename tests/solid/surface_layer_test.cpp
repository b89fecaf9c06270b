/// One column of an elasto-plastic layer: loading, holding, unloading in closed form.
#include "solid/surface_layer.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "core/constants.hpp"

using namespace shellback;
using namespace shellback::solid;

namespace {

/// Table 3 of Offner and Knaus.
SurfaceLayer polymer(double progression) { return {20e-6, 2e9, 120e6, progression, 1e-4}; }

/// SDIRK2 (Alexander), as the film takes it through time.
LayerColumn hold(const SurfaceLayer& l, double P, double time, int steps, LayerColumn now) {
  const double g = 1.0 - std::sqrt(0.5);
  const double dt = time / steps;
  for (int k = 0; k < steps; ++k) {
    const LayerColumn a = press(l, P, g * dt, now).now;
    const double f = (1.0 - g) / g;
    const LayerColumn star{now.elastic + f * (a.elastic - now.elastic),
                           now.plastic + f * (a.plastic - now.plastic)};
    now = press(l, P, g * dt, star).now;
  }
  return now;
}

/// r_e after a time under P from rest; (2) is linear for N = 0 and, of P s - (P + E) r, for N = 1.
double loaded(const SurfaceLayer& l, double P, double time) {
  if (l.progression == 0.0) {
    return P * l.thickness / l.youngs_modulus * -std::expm1(-time / l.damping_ratio);
  }
  const double rate = (l.youngs_modulus + P) / (l.youngs_modulus * l.damping_ratio);
  return P * l.thickness / (l.youngs_modulus + P) * -std::expm1(-rate * time);
}

}  // namespace

TEST_CASE("AColumnIsLoadedHeldAndUnloadedInClosedForm") {
  constexpr int kSteps = 4000;  // of second order: errors of (dt/delta)^2/12 = 1e-7 and less
  for (const double progression : {0.0, 1.0}) {
    const SurfaceLayer l = polymer(progression);
    CAPTURE(progression);
    const double P = 80e6;  // below the hardness
    const double time = 3.0 * l.damping_ratio;
    const LayerColumn on = hold(l, P, time, kSteps, {});
    CHECK(on.elastic == Approx(loaded(l, P, time)).epsilon(1e-6));
    CHECK(on.plastic == 0.0);
    const LayerColumn off = hold(l, 0.0, time, kSteps, on);  // P = 0: r falls as exp(-t/delta)
    CHECK(off.elastic == Approx(on.elastic * std::exp(-3.0)).epsilon(1e-6));
    CHECK(off.plastic == 0.0);
  }
}

TEST_CASE("AColumnAboveItsHardnessFlowsAtAConstantRate") {
  for (const double progression : {0.0, 1.0}) {
    const SurfaceLayer l = polymer(progression);
    const double P = 150e6;
    const double yield = l.yield_depth();
    CHECK(l.stiffness(yield) * yield == Approx(l.hardness).epsilon(1e-12));
    const double time = 2.0 * l.damping_ratio;
    const double rate = (P - l.hardness) / (l.damping_ratio * l.stiffness(yield));
    const LayerColumn held = hold(l, P, time, 7, {yield, 0.0});
    CHECK(held.elastic == Approx(yield).epsilon(1e-12));
    CHECK(held.plastic == Approx(rate * time).epsilon(1e-12));  // linear: exact in any step
    const LayerColumn off = hold(l, 0.0, 40.0 * l.damping_ratio, 4000, held);
    CHECK(off.elastic < 1e-9 * yield);
    CHECK(off.plastic == held.plastic);  // it stays
  }
}

TEST_CASE("ALayerAtRestHoldsTheStaticDepth") {
  const SurfaceLayer l = polymer(1.0);
  const double P = 100e6;  // c r = E r/(s - r): r = s P/(E + P)
  const double long_step = 1e6 * l.damping_ratio;
  CHECK(press(l, P, long_step, {}).now.elastic ==
        Approx(l.thickness * P / (l.youngs_modulus + P)).epsilon(2e-6));  // lambda = 1e-6
}

TEST_CASE("TheTangentOfAColumnIsItsSlope") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 200; ++k) {
    const SurfaceLayer l = polymer(3.0 * part(random));
    const LayerColumn before{l.yield_depth() * part(random), 1e-6 * part(random)};
    const double own = l.damping_ratio * std::pow(10.0, 4.0 * part(random) - 2.0);
    const double P = 2.0 * l.hardness * part(random) + 1e3;
    const double d = 1e-6 * P;
    const PressedColumn low = press(l, P - d, own, before);
    const PressedColumn high = press(l, P + d, own, before);
    const PressedColumn at = press(l, P, own, before);
    CHECK(at.by_pressure >= 0.0);
    const bool kink = (low.now.plastic > before.plastic) != (high.now.plastic > before.plastic);
    if (kink) continue;
    // Central differences: rounding of the depths over the change of 1e-6.
    CHECK((high.now.sum() - low.now.sum()) / (2.0 * d) == Approx(at.by_pressure).epsilon(1e-4));
  }
}

TEST_CASE("WhatLoadingLosesIsWorkLessWhatIsStored") {
  // Under a load that stands P r is given and c r^2/2 stored, N = 0; above the hardness all is
  // lost.
  const SurfaceLayer l = polymer(0.0);
  const double c = l.youngs_modulus / l.thickness;
  for (const double P : {80e6, 150e6}) {
    LayerColumn now{P > l.hardness ? l.yield_depth() : 0.0, 0.0};
    const LayerColumn first = now;
    double lost = 0.0;
    const double own = 1e-3 * l.damping_ratio;
    for (int k = 0; k < 3000; ++k) {
      const LayerColumn next = press(l, P, own, now).now;
      const LayerColumn rate{(next.elastic - now.elastic) / own,
                             (next.plastic - now.plastic) / own};
      lost += own * layer_loss(l, P, next, rate);
      now = next;
    }
    const double stored = 0.5 * c * (now.elastic * now.elastic - first.elastic * first.elastic);
    const double given = P * (now.sum() - first.sum());
    CHECK(lost == Approx(given - stored).epsilon(2e-3));  // first order: a thousandth a step
  }
}

TEST_CASE("ALayerNeverGivesMoreThanItWasGiven") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const SurfaceLayer l = polymer(1.0);
  LayerColumn now;
  double given = 0.0;
  double lost = 0.0;
  for (int k = 0; k < 5000; ++k) {
    const double P = 2.0 * l.hardness * part(random) - 0.2 * l.hardness;
    const double own = l.damping_ratio * std::pow(10.0, 3.0 * part(random) - 2.0);
    const LayerColumn next = press(l, P, own, now).now;
    const LayerColumn rate{(next.elastic - now.elastic) / own, (next.plastic - now.plastic) / own};
    const double loss = own * layer_loss(l, P, next, rate);
    CHECK(loss >= -1e-12 * std::abs(l.hardness * l.thickness));
    CHECK(next.plastic >= now.plastic);
    given += std::max(P, 0.0) * (next.sum() - now.sum());
    lost += loss;
    now = next;
  }
  const double E = l.youngs_modulus;  // stored: int E r/(s - r) dr
  const double stored = E * (-l.thickness * std::log1p(-now.elastic / l.thickness) - now.elastic);
  // Backward Euler loses more than the damper: c r_e at the end of each stage is no integral.
  CHECK(given >= stored);
  CHECK(lost > 0.0);
}
