#pragma once
/// Means and extremes over the instants of a cycle, and the quantities that tell them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "bearing/over_time/cycle.hpp"

namespace shellback::bearing {

/// Mean over time of `of` each instant, straight between them; not a number where there is none.
template <class Of>
[[nodiscard]] double mean_over(const std::vector<CycleInstant>& all, const Of& of) {
  double sum = 0.0;
  for (std::size_t k = 1; k < all.size(); ++k)
    sum += 0.5 * all[k].dt * (of(all[k]) + of(all[k - 1]));
  return all.back().t > 0.0 ? sum / all.back().t : std::numeric_limits<double>::quiet_NaN();
}
[[nodiscard]] inline double mean_of(const std::vector<CycleInstant>& all,
                                    double CycleInstant::*value) {
  return mean_over(all, [value](const CycleInstant& i) { return i.*value; });
}
/// The same of its magnitude at the instants.
[[nodiscard]] inline double mean_magnitude_of(const std::vector<CycleInstant>& all,
                                              double CycleInstant::*value) {
  return mean_over(all, [value](const CycleInstant& i) { return std::abs(i.*value); });
}

enum class Extreme { smallest, largest };

/// The instant at which a value is smallest or largest.
[[nodiscard]] inline const CycleInstant& extreme(const std::vector<CycleInstant>& all,
                                                 double CycleInstant::*value, Extreme which) {
  const auto less = [&](const CycleInstant& a, const CycleInstant& b) {
    return a.*value < b.*value;
  };
  return which == Extreme::smallest ? *std::min_element(all.begin(), all.end(), less)
                                    : *std::max_element(all.begin(), all.end(), less);
}

/// Largest velocity of the journal [m/s].
[[nodiscard]] inline double fastest_motion(const std::vector<CycleInstant>& all) {
  double most = 0.0;
  for (const CycleInstant& i : all) most = std::max(most, std::hypot(i.vx, i.vy));
  return most;
}

/// In the unit in which quantities of that name are told (quantities.hpp).
[[nodiscard]] inline CycleQuantity quantity_of(
    const char* name, double value, double at = std::numeric_limits<double>::quiet_NaN()) {
  CycleQuantity q;
  q.quantity.name = name;
  q.quantity.value = value;
  q.quantity.unit = std::string(find_quantity(name)->unit);
  q.at = at;
  return q;
}
[[nodiscard]] inline CycleQuantity extreme_of(const char* name,
                                              const std::vector<CycleInstant>& all,
                                              double CycleInstant::*value, Extreme which) {
  const CycleInstant& i = extreme(all, value, which);
  return quantity_of(name, i.*value, i.t);
}
/// The mean, and that of its magnitude.
[[nodiscard]] inline CycleQuantity mean_quantity(const char* name,
                                                 const std::vector<CycleInstant>& all,
                                                 double CycleInstant::*value) {
  CycleQuantity q = quantity_of(name, mean_of(all, value));
  q.quantity.magnitude = mean_magnitude_of(all, value);
  return q;
}

}  // namespace shellback::bearing
