// Tables and openings of the bore against the bearing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/case_limits.hpp"
#include "bearing/judge/judge_parts.hpp"
#include "bearing/row_gaps.hpp"
#include "bearing/shown.hpp"
#include "core/constants.hpp"

namespace shellback::bearing {
namespace {

/// Clearances: the pressure of a film that is so much thicker is a hundredth [-].
constexpr double kDeep = 10.0;

/// Of the bore's shape, as film: what belongs to a supply or a chamfer is deeper.
void judge_depth(double depth, const std::string& key, const Bearing& b, Findings& to) {
  if (depth <= kDeep * b.radial_clearance) return;
  to.suspect(key,
             fmt::format("it widens the gap by {}, {:.3g} times the radial clearance",
                         shown(depth, "um"), depth / b.radial_clearance),
             "check the unit; a groove that is fed is a [[supply]]");
}

/// z counts from mid-width, and the last height goes on to the edge. True if all lies within.
bool judge_reach(const Profile& table, const char* key, const Bearing& b, Findings& to) {
  constexpr double kPrinted = 1e-5;  // of the width: what a table of six digits is off [-]
  const std::vector<double>& z = table.z;
  const double edge = 0.5 * b.width;
  const double beyond = std::max(z.back(), -z.front()) - edge;
  const std::string reach =
      fmt::format("its z go from {} to {}", shown(z.front(), "mm"), shown(z.back(), "mm"));
  if (beyond > kPrinted * b.width) {
    to.refuse(
        key,
        fmt::format("{}, the bearing from {} to {}", reach, shown(-edge, "mm"), shown(edge, "mm")),
        "count z from mid-width, check its unit in the header line, leave out what lies "
        "beyond the edges");
    return false;
  }
  const std::size_t last = z.size() - 1;
  const bool lower = last > 0 && z[0] + edge > z[1] - z[0];
  const bool upper = last > 0 && edge - z[last] > z[last] - z[last - 1];
  if (lower || upper) {
    to.suspect(
        key,
        fmt::format("{} and end more than a spacing before {}: there the last height goes on",
                    reach, lower && upper ? "the edges" : "an edge"),
        fmt::format("give heights up to {} and {}", shown(-edge, "mm"), shown(edge, "mm")));
  }
  return true;
}

/// Angles among which straight lines are off cos(2 phi), the lowest lobe, by 7 % of its range.
constexpr std::size_t kLobeNeeds = 12;
constexpr std::size_t kMeasuredAt =
    2 * kLobeNeeds;  ///< angles, as the next lobes need: a machine's
constexpr double kLobeLine = 2.0 * kPi / kLobeNeeds;  ///< longest line that misses none [rad]

/// Whether the heights at two angles are the same as far as bores are measured.
bool same_heights(const Profile& table, std::size_t a, std::size_t b, double range) {
  constexpr double kMeasured = 0.03;  // of the range of heights [-]
  const std::size_t n = table.z.size();
  for (std::size_t j = 0; j < n; ++j) {
    const double off = std::abs(table.height[a * n + j] - table.height[b * n + j]);
    if (off > kMeasured * range) return false;
  }
  return true;
}

/// Whether the heights on both sides of a stretch without any, as far as a line misses no lobe, are
/// those at its ends: there the bore stays.
bool stays(const Profile& table, const RowGap& gap, double range) {
  const std::size_t n = table.phi.size();
  const auto flat = [&](std::size_t from, std::size_t step) {
    for (std::size_t k = (from + step) % n; k != from; k = (k + step) % n) {
      const double away = std::abs(std::remainder(table.phi[k] - table.phi[from], 2.0 * kPi));
      if (away > kLobeLine) return true;
      if (!same_heights(table, from, k, range)) return false;
    }
    return true;
  };
  return flat(gap.from, n - 1) && flat(gap.to, 1);
}

/// A bore measured over a part of its turn, or at a few angles, between which straight lines are
/// meant that are none. A line too short to miss a lobe is none of either, and who gives few angles
/// means lines.
void judge_angles(const Profile& table, const char* key, Findings& to) {
  constexpr double kDegrees = 180.0 / kPi;
  const std::vector<double>& phi = table.phi;
  const auto [low, high] = std::minmax_element(table.height.begin(), table.height.end());
  const double range = *high - *low;
  if (phi.size() > kMeasuredAt && kDegrees * (phi.back() - phi.front()) <= 2.0 * kPi) {
    to.refuse(key,
              fmt::format("all {} angles lie within {:.4g} deg", phi.size(),
                          kDegrees * (phi.back() - phi.front())),
              "radians stand under \"phi [rad]\"; check the header line");
    return;
  }
  for (const RowGap& gap : row_gaps(phi, 2.0 * kPi)) {
    const bool alike = same_heights(table, gap.from, gap.to, range);
    if (gap.length <= kLobeLine || (alike && stays(table, gap, range))) continue;
    const std::string problem = fmt::format(
        "from {:.4g} deg on no height is given for {:.4g} deg, {:.3g} times as far as angles stand "
        "apart elsewhere",
        kDegrees * phi[gap.from], kDegrees * gap.length, gap.times);
    const std::string cure =
        "give heights all the way round, check the unit of phi in the header line; a straight line "
        "that is meant has a point half way";
    if (gap.times > kLineToRefuse && phi.size() > kMeasuredAt && !alike) {
      to.refuse(key, problem, cure);
    } else {
      to.suspect(key, problem, cure);
    }
  }
  bool varies = false;
  for (std::size_t i = 1; i < phi.size(); ++i) {
    varies = varies || !same_heights(table, i, 0, range);
  }
  if (!varies || phi.size() >= kLobeNeeds) return;
  to.suspect(key,
             fmt::format("heights are given at {} angles, between which they go along straight "
                         "lines: a lobed bore is another shape",
                         phi.size()),
             fmt::format("give {} angles or more, unless lines are meant", kLobeNeeds));
}

void judge_table(const Profile& table, const char* key, const Bearing& b, Findings& to) {
  if (!judge_reach(table, key, b, to)) return;
  const auto [low, high] = std::minmax_element(table.height.begin(), table.height.end());
  const bool rough = *high - *low > kBearingLimits.profile_most * b.radius;
  if (*high <= -b.radial_clearance || rough) {
    to.refuse(key,
              fmt::format("heights from {} to {} leave no gap that could be a bearing's",
                          shown(*low, "um"), shown(*high, "um")),
              "check the unit in the header line (positive heights widen the gap)");
    return;
  }
  if (*low <= -b.radial_clearance) {
    to.suspect(key, "the table takes away more than the whole radial clearance somewhere");
  }
  judge_depth(*high, key, b, to);
}

void judge_opening(const std::optional<EdgeOpening>& e, const std::string& key, const Bearing& b,
                   Findings& to) {
  if (!e) return;
  if (e->length > 0.5 * b.width) {
    to.refuse(key + ".length",
              fmt::format(
                  "{} from either edge, together twice that, is more than the bearing is wide ({})",
                  shown(e->length, "mm"), shown(b.width, "mm")),
              "give the length from one edge inwards, at most half the width");
  }
  if (e->depth > kBearingLimits.profile_most * b.radius) {
    to.refuse(key + ".depth",
              fmt::format("{} leaves no gap that could be a bearing's", shown(e->depth, "mm")),
              "check the unit");
  }
}

}  // namespace

void judge_bore(const Bearing& b, Findings& to) {
  if (b.profile) judge_table(*b.profile, "bearing.profile", b, to);
  if (b.shape) {
    judge_table(*b.shape, "bearing.shape", b, to);
    judge_angles(*b.shape, "bearing.shape", to);
  }
  if (b.wear) judge_table(*b.wear, "bearing.wear", b, to);
  judge_opening(b.edge_relief, "bearing.edge_relief", b, to);
  judge_opening(b.chamfer, "bearing.chamfer", b, to);
  if (b.edge_relief) judge_depth(b.edge_relief->depth, "bearing.edge_relief.depth", b, to);
}

}  // namespace shellback::bearing
