#pragma once
/// One case: its bars, then their truths.
#include <atomic>

#include "proof/honesty_options.hpp"
#include "proof/honesty_record.hpp"

namespace shellback::proof {

/// Solves case `index`; `stop` (may be null) ends it soon, with what has been found till then and
/// the end `over_budget`.
[[nodiscard]] HonestySubject try_bars(const coupling::Case& c, int index,
                                      const HonestyOptions& options, const std::atomic<bool>* stop);

}  // namespace shellback::proof
