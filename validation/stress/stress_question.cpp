#include "validation/stress/stress_question.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "app/reading/read_case.hpp"
#include "core/contract.hpp"
#include "validation/stress/stress_refusal.hpp"

namespace shellback::validation {
namespace {

using bearing::Tier;

/// Cells each way over those of the cell that is asked about: far enough for another error of the
/// grid (its square root of 2 and more), near enough for the same film.
constexpr double kCoarser = 2.0 / 3.0;
constexpr double kFiner = 1.5;
constexpr int kMostCells =
    80000;  ///< a finer grid has no more: 800 x 100, the finest of the scenes
constexpr const char* kGridKey = "model.grid=";

std::array<int, 2> grid_of(const StressScene& scene, const std::vector<std::string>& words) {
  std::vector<app::Override> changes;
  for (const std::string& word : words) changes.push_back(app::parse_override(word));
  return app::read_case(scene.case_path, changes, {scene.tier}).model.grid;
}

StressQuestion on_grid(QuestionKind question, const StressScene& scene,
                       const std::vector<std::string>& words, std::array<int, 2> grid) {
  StressQuestion q{question, fmt::format("a grid of {}x{}", grid[0], grid[1]), scene, {}};
  for (const std::string& word : words) {
    if (!word.starts_with(kGridKey)) q.words.push_back(word);
  }
  q.words.push_back(fmt::format("{}[{}, {}]", kGridKey, grid[0], grid[1]));
  return q;
}

void ask_other_grids(const StressScene& scene, const std::vector<std::string>& words,
                     std::vector<StressQuestion>& questions) {
  const std::array<int, 2> grid = grid_of(scene, words);
  using Wanted = std::pair<QuestionKind, double>;
  for (const auto& [question, factor] :
       {Wanted{QuestionKind::coarser_grid, kCoarser}, Wanted{QuestionKind::finer_grid, kFiner}}) {
    const std::array<int, 2> other{static_cast<int>(std::lround(factor * grid[0])),
                                   static_cast<int>(std::lround(factor * grid[1]))};
    if (other[0] * other[1] <= kMostCells)
      questions.push_back(on_grid(question, scene, words, other));
  }
}

bool refused(const StressCell& cell) {
  return cell.result == StressClass::no_steady_state || cell.result == StressClass::not_found;
}

/// A result, whatever its audits say.
bool has_result(const StressCell& cell) {
  return cell.answer.converged() && cell.result != StressClass::not_a_number;
}

}  // namespace

std::vector<StressQuestion> questions_about(const StressRow& row, std::size_t step) {
  std::vector<StressQuestion> questions;
  const StressScene& scene = row.scene;
  const StressCell& ours = row.cells.front()[step];
  const auto words = words_of(scene, scene.steps[step], {});
  if (refused(ours)) {
    ask_other_grids(scene, words, questions);
    if (scene.tier == Tier::lumped && ground_of(ours.why) == RefusalGround::heat) {
      questions.push_back({QuestionKind::richer_heat, "tier thd", scene, words});
      questions.back().scene.tier = Tier::thd;
    }
  }
  const auto& methods = stress_methods();
  for (std::size_t m = 1; m < row.cells.size(); ++m) {
    const bool both = has_result(row.cells[m][step]) && has_result(ours);
    if (!methods[m].full_shear || !both) continue;
    questions.push_back({QuestionKind::full_shear, "full shear", scene, words});
    questions.back().words.emplace_back("model.cavitated_shear=full");
  }
  return questions;
}

}  // namespace shellback::validation
