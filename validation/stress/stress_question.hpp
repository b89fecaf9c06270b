#pragma once
/// What else is asked about a cell of the stability map once its solves have ended.
#include <string>
#include <vector>

#include "validation/stress/stress_row.hpp"

namespace shellback::validation {

/// A solve by the shipped method, to be run and judged as a cell is.
struct StressQuestion {
  QuestionKind question = QuestionKind::finer_grid;
  std::string name;
  StressScene scene;               ///< with the tier that is asked
  std::vector<std::string> words;  ///< KEY=VALUE
};

/// About the step's cells: where the default refuses, a coarser and a finer grid, and tier thd
/// beside a lumped refusal of heat; where a method of full shear converges beside the default, the
/// default with full shear.
[[nodiscard]] std::vector<StressQuestion> questions_about(const StressRow& row, std::size_t step);

}  // namespace shellback::validation
