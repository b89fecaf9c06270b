#include "fidelity/estimate_error.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::fidelity {

namespace {

// Parts of the bars per unit of indicator, chosen so that random bearings lie within in about 9 of
// 10 (docs/auto-tier.md); each effect left out has its own.
constexpr double kSupply = 0.10;        ///< the supply's place and size, cases with one temperature
constexpr double kFrictionHeat = 0.30;  ///< friction per beta dT
constexpr double kFilmHeat = 0.25;      ///< film per beta dT
constexpr double kFilmGrowth = 1.0;     ///< film per relative change of the clearance
constexpr double kFilmElastic = 0.5;    ///< film per opening over film
constexpr double kPressureFriction = 0.15;  ///< friction per alpha p_max
constexpr double kMost = 2.0;               ///< beyond this a bar says nothing more

}  // namespace

EstimateBars estimate_bars(const coupling::Case&, const Estimate& e, const Indicators& n) {
  EstimateBars b;
  const double contact = e.asperity_share;
  b.torque = std::min(kMost, kSupply + kFrictionHeat * n.heating + 0.1 * n.thermal +
                                 kPressureFriction * n.pressure + 0.05 * std::min(n.elastic, 1.0) +
                                 0.5 * contact);
  b.h_min = std::min(kMost, kSupply + kFilmHeat * n.heating + kFilmGrowth * n.thermal +
                                kFilmElastic * n.elastic + 0.2 * n.pressure + contact);
  b.p_max = std::min(kMost, 2.0 * b.h_min);
  b.side_flow = std::min(kMost, 0.3 + n.thermal);
  b.attitude = std::min(kMost, 0.1 + 0.5 * n.thermal + 0.5 * n.elastic);
  b.contact = kMost;
  b.temperature = std::max(2.0, 0.5 * std::abs(e.rise));
  return b;
}

}  // namespace shellback::fidelity
