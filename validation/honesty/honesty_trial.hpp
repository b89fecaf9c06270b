#pragma once
/// One case: its bars, then their truths.
#include <atomic>

#include "validation/honesty/honesty_options.hpp"
#include "validation/honesty/honesty_record.hpp"

namespace shellback::validation {

/// Solves case `index`; `stop` (may be null) ends it soon, with what has been found till then and
/// the end `over_budget`.
[[nodiscard]] HonestySubject try_bars(const bearing::Case& c, int index,
                                      const HonestyOptions& options, const std::atomic<bool>* stop);

}  // namespace shellback::validation
