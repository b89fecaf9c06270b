#pragma once
/// The points that no other point beats in both cost and error.
#include <vector>

namespace shellback::validation {

struct CostError {
  double cost = 0.0;   ///< any unit, the same for all; not finite: no point
  double error = 0.0;  ///< not negative; not finite: no point
};

/// Indices of the front, from the cheapest to the most exact. Errors below `floor` count as
/// `floor`: they are not known any better. A dearer point must be better by more than `worth` of
/// the error: less is chance. Of equal points the first stays.
[[nodiscard]] std::vector<int> pareto_front(const std::vector<CostError>& points,
                                            double floor = 0.0, double worth = 0.01);

}  // namespace shellback::validation
