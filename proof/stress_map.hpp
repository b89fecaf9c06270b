#pragma once
/// The stability map: every scene by every method, each cell judged.
#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "proof/child_pool.hpp"
#include "proof/stress_answer.hpp"
#include "proof/stress_methods.hpp"
#include "proof/stress_scenes.hpp"

namespace shellback::proof {

/// How a cell ended. The first three are as it should be: a result, or a refusal that says that
/// there is none. `not_found` is honest, but leaves open whether there is one.
enum class StressClass {
  converged,        ///< and audited
  no_steady_state,  ///< refused by name: physics has none
  refused_input,    ///< refused before the solve
  not_found,        ///< refused by name: the iteration ended without
  wrong,            ///< converged to something that cannot be
  not_a_number,
  crashed,
  timed_out,
  not_run,  ///< the method does not apply here, or the work was stopped
};
[[nodiscard]] const char* to_string(StressClass c);

/// True for what must not happen to the shipped method.
[[nodiscard]] bool is_fault(StressClass c);

struct StressCell {
  StressClass result = StressClass::not_run;
  std::string why;      ///< reason of a refusal or a fault, in words
  StressAnswer answer;  ///< what the child told, if it did
  double seconds = 0.0;
};

/// One scene in one tier.
struct StressRow {
  StressScene scene;
  std::vector<std::vector<StressCell>> cells;  ///< by method (of stress_methods), by step
};

struct StressMap {
  std::vector<StressRow> rows;
  bool complete = true;                         ///< false: stopped before the end
  [[nodiscard]] bool shipped_is_sound() const;  ///< no fault in the default's cells
  /// Cells of the method by class.
  [[nodiscard]] int count(std::size_t method, StressClass c) const;
};

struct StressOptions {
  int at_once = 1;
  double limit_s = 60.0;
  bool only_default = false;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const std::string& what, int done, int of)> tell;  ///< may be empty
};

/// The class of one child's end, by itself.
[[nodiscard]] StressCell judge_end(const ChildEnd& end);

/// What a cell cannot tell by itself: quantities that break the scene's trend along the default's
/// cells, and other methods' results that differ from the default's by more than is allowed.
void judge_row(StressRow& row);

[[nodiscard]] StressMap stress_map(const std::vector<StressScene>& scenes,
                                   const StressOptions& options);

/// KEY=VALUE words of a cell: with the scene's case and tier all that `shellback run` needs.
[[nodiscard]] std::vector<std::string> words_of(const StressScene& scene, const StressStep& step,
                                                const StressMethodWords& method);

}  // namespace shellback::proof
