#pragma once
/// A row of the stability map: one scene in one tier, by methods and values, with what else was
/// asked about its cells.
#include <string>
#include <vector>

#include "validation/stress/stress_cell.hpp"
#include "validation/stress/stress_methods.hpp"
#include "validation/stress/stress_scenes.hpp"

namespace shellback::validation {

/// What the shipped method is asked beside a cell.
enum class QuestionKind {
  coarser_grid,  ///< the same case on fewer cells
  finer_grid,    ///< the same case on more cells
  richer_heat,   ///< the same film with heat resolved: tier thd beside lumped
  full_shear,    ///< the same case with the cavitated film sheared in full, as Swift-Stieber has it
};

/// Its answer.
struct StressWitness {
  QuestionKind question = QuestionKind::finer_grid;
  std::string name;  ///< "72x12 cells", "tier thd"
  StressCell cell;
};

/// One scene in one tier.
struct StressRow {
  StressScene scene;
  std::vector<std::vector<StressCell>> cells{};     ///< by method (of stress_methods), by step
  std::vector<std::vector<StressWitness>> asked{};  ///< by step
};

/// KEY=VALUE words of a cell: with the scene's case and tier all that `shellback run` needs.
[[nodiscard]] std::vector<std::string> words_of(const StressScene& scene, const StressStep& step,
                                                const StressMethodWords& method);

}  // namespace shellback::validation
