#pragma once
/// One bearing: tier auto at every tolerance, then its truth.
#include <atomic>
#include <vector>

#include "validation/honesty/auto_record.hpp"

namespace shellback::validation {

/// Judges the bearing of `seed`; `stop` (may be null) ends it soon, with what has been found till
/// then and the end `over_budget`.
[[nodiscard]] AutoTrial try_auto(int seed, const std::vector<double>& tolerances,
                                 const std::atomic<bool>* stop);

}  // namespace shellback::validation
