#include "validation/chart/pareto.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::validation {

std::vector<int> pareto_front(const std::vector<CostError>& points, double floor, double worth) {
  const auto error = [&](int k) { return std::max(points[k].error, floor); };
  std::vector<int> order;
  for (int k = 0; k < static_cast<int>(points.size()); ++k) {
    if (std::isfinite(points[k].cost) && std::isfinite(points[k].error)) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : error(a) < error(b);
  });
  std::vector<int> front;
  for (const int k : order) {
    if (front.empty() || error(k) < (1.0 - worth) * error(front.back())) front.push_back(k);
  }
  return front;
}

}  // namespace shellback::validation
