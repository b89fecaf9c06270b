#include "thermal/wall_skin.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/round_off.hpp"

namespace shellback::thermal {
namespace {

constexpr double kReach = 3.0;  ///< of the skin, in depths that the period reaches (header) [-]
constexpr double kFirst = 0.5;  ///< first interval, of the depth that the shortest step reaches [-]
constexpr int kIntervals = 10;  ///< methods 3.5: 6 to 10 nodes; layers add one each
constexpr double kSliver = 0.3;  ///< of an interval: a node nearer to a layer's end moves onto it

/// Where x goes through the layers, counted in the depths that a period reaches in each.
class Depths {
 public:
  Depths(const std::vector<SkinLayer>& layers, double period) {
    double y = 0.0;
    double x = 0.0;
    for (const SkinLayer& l : layers) {
      EXPECTS(l.thickness > 0.0 && l.conductivity > 0.0 && l.capacity > 0.0);
      const double reach = std::sqrt(l.conductivity / l.capacity * period / kPi);
      y += l.thickness;
      x += l.thickness / reach;
      y_.push_back(y);
      x_.push_back(x);
    }
  }
  [[nodiscard]] double whole() const { return x_.back(); }
  [[nodiscard]] const std::vector<double>& layer_ends() const { return x_; }
  [[nodiscard]] std::size_t layer(double x) const {
    const auto at = std::lower_bound(x_.begin(), x_.end(), x) - x_.begin();
    return std::min(static_cast<std::size_t>(at), x_.size() - 1);
  }
  [[nodiscard]] double depth(double x) const {
    const std::size_t l = layer(x);
    const double x0 = l > 0 ? x_[l - 1] : 0.0;
    const double y0 = l > 0 ? y_[l - 1] : 0.0;
    return y0 + (x - x0) / (x_[l] - x0) * (y_[l] - y0);
  }

 private:
  std::vector<double> x_, y_;  ///< of the layers' ends [-], [m]
};

/// Nodes from 0 to `end`, intervals growing by one ratio from `first`.
std::vector<double> graded(double first, double end) {
  if (first * kIntervals >= end) first = end / kIntervals;
  const auto reach = [&](double r) {
    double sum = 0.0;
    for (int k = 0; k < kIntervals; ++k) sum += first * std::pow(r, k);
    return sum;
  };
  double low = 1.0;
  double high = 2.0;
  while (reach(high) < end) high *= 2.0;
  for (int k = 0; k < 60; ++k) (reach(0.5 * (low + high)) < end ? low : high) = 0.5 * (low + high);
  std::vector<double> x{0.0};
  for (int k = 0; k < kIntervals; ++k) x.push_back(x.back() + first * std::pow(low, k));
  x.back() = end;
  return x;
}

/// Every end of a layer is a node: the nearest one moves there, or one is added. One that is an end
/// stays: a layer however thin keeps its resistance.
void put_layers(const std::vector<double>& ends, std::vector<double>& x) {
  double placed = 0.0;  // the end before, on a node
  for (const double end : ends) {
    const auto next = std::upper_bound(x.begin(), x.end(), end);
    if (next == x.begin() || next == x.end()) continue;
    const auto last = next - 1;
    const double interval = *next - *last;
    const bool is_end = *last <= placed;  // of the layer before, or the surface
    if (end - *last < kSliver * interval && !is_end) {
      *last = end;
    } else if (*next - end < kSliver * interval && next + 1 != x.end()) {
      *next = end;
    } else if (end > *last) {
      x.insert(next, end);
    }
    placed = end;
  }
}

}  // namespace

WallSkin::WallSkin(const std::vector<SkinLayer>& layers, double period, double shortest,
                   double back, double curvature) {
  EXPECTS(!layers.empty() && period > 0.0 && shortest > 0.0 && back >= 0.0);
  const Depths depths(layers, period);
  EXPECTS(1.0 + curvature * depths.depth(depths.whole()) >= -kRoundOff);
  std::vector<double> x =
      graded(kFirst * std::sqrt(kPi * shortest / period), std::min(kReach, depths.whole()));
  put_layers(depths.layer_ends(), x);
  for (const double at : x) y_.push_back(depths.depth(at));
  const bool held = depths.whole() > kReach || std::isinf(back);
  const std::size_t intervals = y_.size() - 1;
  const std::size_t n = held ? intervals : intervals + 1;
  const auto widens = [&](double y) { return std::max(1.0 + curvature * y, 0.0); };
  conductance_.assign(n, back * widens(y_.back()));
  capacity_.assign(n, 0.0);
  for (std::size_t k = 0; k < intervals; ++k) {
    const SkinLayer& l = layers[depths.layer(0.5 * (x[k] + x[k + 1]))];
    const double length = y_[k + 1] - y_[k];
    conductance_[k] = l.conductivity * widens(0.5 * (y_[k] + y_[k + 1])) / length;
    for (const std::size_t at : {k, k + 1}) {
      if (at == n) continue;  // held at 0
      const double wide = widens(0.75 * y_[at] + 0.25 * y_[2 * k + 1 - at]);
      capacity_[at] += 0.5 * length * wide * l.capacity;
    }
  }
}

SkinStep WallSkin::over(double dt) const {
  const std::size_t n = capacity_.size();
  SkinStep s{dt, std::vector<double>(n), std::vector<double>(n)};
  double below = conductance_[n - 1];  // conductance to the depth, through all nodes below
  for (std::size_t k = n; k-- > 0;) {
    s.pivot[k] = capacity_[k] / dt + below + (k > 0 ? conductance_[k - 1] : 0.0);
    if (k > 0) below = conductance_[k - 1] * (1.0 - conductance_[k - 1] / s.pivot[k]);
  }
  s.by_flux[0] = 1.0 / s.pivot[0];
  for (std::size_t k = 1; k < n; ++k) {
    s.by_flux[k] = conductance_[k - 1] * s.by_flux[k - 1] / s.pivot[k];
  }
  return s;
}

void WallSkin::relax(const SkinStep& step, double* T) const {
  const std::size_t n = capacity_.size();
  for (std::size_t k = n; k-- > 0;) {
    T[k] *= capacity_[k] / step.dt;
    if (k + 1 < n) T[k] += conductance_[k] * T[k + 1] / step.pivot[k + 1];
  }
  T[0] /= step.pivot[0];
  for (std::size_t k = 1; k < n; ++k) {
    T[k] = (T[k] + conductance_[k - 1] * T[k - 1]) / step.pivot[k];
  }
}

double WallSkin::heat(const double* T) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < capacity_.size(); ++k) sum += capacity_[k] * T[k];
  return sum;
}

}  // namespace shellback::thermal
