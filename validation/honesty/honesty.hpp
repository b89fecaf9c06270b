#pragma once
/// Are the error bars honest? Cases are solved with bars, then again on a much finer grid with more
/// nodes across the film, in the same tier and with the full physics: does the bar hold the
/// difference, and how many times too long is it? Each case has a process and a budget of its own,
/// so that the measurement comes to an end; what could not be judged is counted.
#include <vector>

#include "validation/honesty/honesty_options.hpp"
#include "validation/honesty/honesty_record.hpp"

namespace shellback::validation {

/// Solves all; ends soon after `stop`, keeping the cases that are finished. Must be called while
/// this process has one thread (validation/honesty/child_pool.hpp).
[[nodiscard]] HonestyRecord measure_honesty(const std::vector<HonestyCase>& cases,
                                            const HonestyOptions& options);

}  // namespace shellback::validation
