#pragma once
/// The stability map: every scene by every method, each cell judged.
#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "validation/stress/stress_row.hpp"

namespace shellback::validation {

struct StressMap {
  std::vector<StressRow> rows;
  bool complete = true;                         ///< false: stopped before the end
  [[nodiscard]] bool shipped_is_sound() const;  ///< no fault in the default's cells
  /// Cells of the method by class.
  [[nodiscard]] int count(std::size_t method, StressClass c) const;
  /// Cells of the method whose friction differs by a convention alone.
  [[nodiscard]] int count_conventions(std::size_t method) const;
  /// Solves that were asked beside the cells.
  [[nodiscard]] int count_questions() const;
};

struct StressOptions {
  int at_once = 1;
  double limit_s = 60.0;
  bool only_default = false;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const std::string& what, int done, int of)> tell;  ///< may be empty
};

/// Solves all cells, asks what else there is to be asked about them, and judges the rows.
[[nodiscard]] StressMap stress_map(const std::vector<StressScene>& scenes,
                                   const StressOptions& options);

}  // namespace shellback::validation
