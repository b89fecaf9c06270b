#pragma once
/// What physics has in store along a scene's values, as far as it can be told without solving.
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace shellback::validation {

/// Up to one value there is a steady state, from another on there is none; what lies between is
/// open. Nothing known: all is open.
struct StressExpectation {
  std::size_t steady_before = 0;  ///< steps 0 .. steady_before - 1 have a steady state
  std::size_t none_from = std::numeric_limits<std::size_t>::max();
  std::string words;  ///< as in the file; empty: open throughout

  [[nodiscard]] bool steady(std::size_t step) const { return step < steady_before; }
  [[nodiscard]] bool none(std::size_t step) const { return step >= none_from; }
};

/// Reads "steady", "steady to LABEL", "none from LABEL", or the last two with "; " between, LABEL
/// being one of `labels`. Throws std::invalid_argument with what is wrong, in words.
[[nodiscard]] StressExpectation expectation_from(const std::string& words,
                                                 const std::vector<std::string>& labels);

}  // namespace shellback::validation
