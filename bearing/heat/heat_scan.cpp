#include "bearing/heat/heat_scan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rheology/laws_hold.hpp"

namespace shellback::bearing {
namespace {

constexpr double kViscosityStep = 0.5 * std::numbers::ln2;  ///< ln sqrt(2): see the header [-]
constexpr double kMostStep = 50.0;                          ///< [K]
constexpr int kMostHalvings = 5;  ///< 2^5 parts of a step: 1 % in viscosity
constexpr int kEdgeHalvings = 3;  ///< towards the temperature at which the film ends
constexpr double kDeepDip = 0.5;  ///< of |r| that a dip may lose until it counts as told [-]

/// True if |r| of three neighbours of one sign has a dip that the parabola through them takes much
/// nearer to zero, or past it.
bool dips(const HeatSample& a, const HeatSample& b, const HeatSample& c) {
  if (!a.residual || !b.residual || !c.residual) return false;
  const double sign = *b.residual < 0.0 ? -1.0 : 1.0;
  const double fa = sign * *a.residual;
  const double fb = sign * *b.residual;
  const double fc = sign * *c.residual;
  if (fa <= 0.0 || fc <= 0.0 || fb > fa || fb > fc) return false;
  const double left = (fb - fa) / (b.T - a.T);
  const double right = (fc - fb) / (c.T - b.T);
  const double bend = (right - left) / (c.T - a.T);
  if (!(bend > 0.0)) return false;
  const double slope = left + bend * (b.T - a.T);  // of the parabola at b
  return fb - 0.25 * slope * slope / bend < kDeepDip * fb;
}

/// Temperatures at which the samples do not tell the sign structure yet.
std::vector<double> untold(const std::vector<HeatSample>& s, int halvings) {
  std::vector<double> T;
  const auto halve = [&](std::size_t k) { T.push_back(0.5 * (s[k].T + s[k + 1].T)); };
  for (std::size_t k = 0; k + 1 < s.size(); ++k) {
    const bool edge = s[k].residual.has_value() != s[k + 1].residual.has_value();
    if (edge && halvings < kEdgeHalvings) halve(k);
    if (k > 0 && dips(s[k - 1], s[k], s[k + 1])) {
      halve(k - 1);
      halve(k);
    }
  }
  std::sort(T.begin(), T.end());
  T.erase(std::unique(T.begin(), T.end()), T.end());
  return T;
}

}  // namespace

std::vector<double> scan_temperatures(const rheology::Oil& oil, double low, double high) {
  std::vector<double> temperatures;
  for (double T = low; rheology::laws_hold(oil, T);) {
    temperatures.push_back(T);
    if (T >= high) break;
    const double slope = std::abs(rheology::viscosity_slopes(oil, T, 0.0, 0.0).dln_dT);
    const double step = slope * kMostStep > kViscosityStep ? kViscosityStep / slope : kMostStep;
    T = std::min(high, T + step);
  }
  return temperatures;
}

std::vector<HeatSample> scan_heat_balance(const HeatResidual& residual,
                                          const std::vector<double>& temperatures) {
  std::vector<HeatSample> samples;
  for (const double T : temperatures) samples.push_back({T, residual(T)});
  for (int halvings = 0; halvings < kMostHalvings; ++halvings) {
    const std::vector<double> more = untold(samples, halvings);
    if (more.empty()) break;
    for (const double T : more) samples.push_back({T, residual(T)});
    std::sort(samples.begin(), samples.end(),
              [](const HeatSample& a, const HeatSample& b) { return a.T < b.T; });
  }
  return samples;
}

std::vector<std::size_t> sign_changes(const std::vector<HeatSample>& s) {
  std::vector<std::size_t> lower;
  for (std::size_t k = 0; k + 1 < s.size(); ++k) {
    if (!s[k].residual || !s[k + 1].residual) continue;
    if ((*s[k].residual < 0.0) != (*s[k + 1].residual < 0.0)) lower.push_back(k);
  }
  return lower;
}

}  // namespace shellback::bearing
