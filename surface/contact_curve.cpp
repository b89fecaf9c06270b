#include "surface/contact_curve.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/constants.hpp"
#include "solid/asperity_contact.hpp"
#include "surface/hertz_ellipse.hpp"

namespace shellback::surface {
namespace {

/// Summits from the highest down, so that sums may stop at the first that does not reach.
std::vector<Summit> sorted(std::vector<Summit> summits) {
  std::sort(summits.begin(), summits.end(),
            [](const Summit& a, const Summit& b) { return a.height > b.height; });
  return summits;
}

double hertz_factor_of(const Curvature& c) {
  return hertz_factor(c.mean() + c.deviation(), c.mean() - c.deviation());
}

/// The surface that faces another one like it is turned over about the motion: its oblique lays
/// cross those of the first.
Curvature turned_over(const Curvature& c) { return {c.xx, c.yy, -c.xy}; }

/// Sum over pairs, per area squared [-].
double pair_pressure(const std::vector<Summit>& s, double h, double area) {
  double sum = 0.0;
  for (const Summit& a : s) {
    if (a.height + s.front().height <= h) break;
    for (const Summit& b : s) {
      const double w = a.height + b.height - h;
      if (w <= 0.0) break;
      const Curvature both = a.curvature + turned_over(b.curvature);
      const double spread =
          std::sqrt(both.determinant() / (a.curvature.determinant() * b.curvature.determinant()));
      sum += spread * hertz_factor_of(both) * w * w * std::sqrt(w);
    }
  }
  return 16.0 * kPi / 15.0 * sum / (area * area);
}

double plane_pressure(const std::vector<Summit>& s, double h, double area) {
  double sum = 0.0;
  for (const Summit& a : s) {
    const double w = a.height - h;
    if (w <= 0.0) break;
    sum += hertz_factor_of(a.curvature) * std::sqrt(w) * w;
  }
  return 4.0 / 3.0 * sum / area;
}

}  // namespace

bool scattered(const SummitStatistics& one, double Rq) {
  return one.roughness > 0.0 && one.roughness >= kAlikeSummits * Rq;
}

double elastic_factor(const SummitStatistics& one) {
  const double s = std::sqrt(2.0) * one.roughness, x = s * one.radius * one.density;
  return 16.0 * std::sqrt(2.0) * kPi / 15.0 * x * x * std::sqrt(s / one.radius);
}

std::vector<ContactRow> contact_curve(const HeightMap& map, const std::vector<Summit>& summits,
                                      const SummitStatistics& one, const std::vector<double>& h) {
  const std::vector<Summit> s = sorted(summits);
  std::vector<double> heights = map.z;
  std::sort(heights.begin(), heights.end());
  const double area = static_cast<double>(map.nx - 2) * map.dx * (map.ny - 2) * map.dy;
  const double pair_sigma = std::sqrt(2.0) * one.roughness;
  const double K = elastic_factor(one), x = pair_sigma * one.radius * one.density;
  double squares = 0.0;
  for (const double z : map.z) squares += z * z;
  const double Rq = std::sqrt(squares / static_cast<double>(map.z.size()));
  const bool usable = scattered(one, Rq);
  std::vector<ContactRow> rows;
  for (const double gap : h) {
    ContactRow row;
    row.h = gap;
    const double H = (gap - 2.0 * one.height) / pair_sigma;
    constexpr double kDeep = -100.0, kFar = 30.0;  // ends of the quadrature; F is zero beyond kFar
    const bool known = usable && H >= kDeep;
    row.pair_formula = known ? (H < kFar ? K * solid::gt_integral(2.5, H) : 0.0) : kNone;
    row.pair_contact_ratio =
        known ? (H < kFar ? kPi * kPi * x * x * solid::gt_integral(2.0, H) : 0.0) : kNone;
    row.pair_summits = s.empty() ? kNone : pair_pressure(s, gap, area);
    row.plane_summits = s.empty() ? kNone : plane_pressure(s, gap, area);
    const auto above = heights.end() - std::upper_bound(heights.begin(), heights.end(), gap);
    row.bearing_area = static_cast<double>(above) / static_cast<double>(heights.size());
    rows.push_back(row);
  }
  return rows;
}

}  // namespace shellback::surface
