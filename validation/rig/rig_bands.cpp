#include "validation/rig/rig_bands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellback::validation {
namespace {

/// Adds a relative change to the effect of the same end of the same unknown.
void add(std::vector<RigEffect>& effects, const RigUnknown* unknown, int end, double change) {
  auto at = std::find_if(effects.begin(), effects.end(),
                         [&](const RigEffect& e) { return e.unknown == unknown && e.end == end; });
  if (at == effects.end()) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    at = effects.insert(at, {unknown, end, kInfinity, -kInfinity, 0});
  }
  if (std::isnan(change)) {
    ++at->missing;
    return;
  }
  at->low = std::min(at->low, change);
  at->high = std::max(at->high, change);
}

/// Torque of the course as taken, through the same speeds, when it first ran at this one.
double taken(const RigStudy& study, const RigCourse& course, double rpm) {
  const auto alike = [&](const RigCourse& c) {
    return c.unknown == nullptr && c.peak == course.peak && c.rpm == course.rpm;
  };
  const auto as_taken = std::find_if(study.courses.begin(), study.courses.end(), alike);
  if (as_taken == study.courses.end()) return NAN;
  for (std::size_t k = 0; k <= as_taken->highest(); ++k) {
    if (as_taken->rpm[k] == rpm) return as_taken->torque(k);
  }
  return NAN;
}

}  // namespace

std::vector<RigBand> rig_bands(const RigStudy& study, double peak) {
  std::vector<RigBand> bands;
  for (const double rpm : study.plan.few_rpm) {
    const RigPoint* as_taken = study.point(peak, rpm, OilModel::full);
    if (as_taken == nullptr) continue;
    RigBand band{rpm, as_taken->torque(), as_taken->torque()};
    for (const RigPoint& p : study.points) {
      if (p.unknown == nullptr || p.peak != peak || p.rpm != rpm || !p.good()) continue;
      band.low = std::min(band.low, p.torque());
      band.high = std::max(band.high, p.torque());
    }
    bands.push_back(band);
  }
  return bands;
}

std::vector<RigEffect> rig_effects(const RigStudy& study) {
  std::vector<RigEffect> effects;
  for (const RigPoint& p : study.points) {
    if (p.unknown == nullptr) continue;
    const RigPoint* as_taken = study.point(p.peak, p.rpm, OilModel::full);
    add(effects, p.unknown, p.end, p.torque() / as_taken->torque() - 1.0);
  }
  for (const RigCourse& c : study.courses) {
    if (c.unknown == nullptr) continue;
    for (std::size_t k = 0; k <= c.highest(); ++k) {
      add(effects, c.unknown, c.end, c.torque(k) / taken(study, c, c.rpm[k]) - 1.0);
    }
  }
  return effects;
}

}  // namespace shellback::validation
