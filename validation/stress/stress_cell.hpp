#pragma once
/// A cell of the stability map: how one solve ended, judged by itself.
#include <string>

#include "validation/honesty/child_pool.hpp"
#include "validation/stress/stress_answer.hpp"

namespace shellback::validation {

/// How a cell ended. The first five are as it may be: a result, a refusal that nothing contradicts,
/// or a difference that is one of convention. `missed` is a refusal that claims nothing, where
/// there is something to be found. From `wrong_refusal` on: what must not happen.
enum class StressClass {
  converged,        ///< and audited
  no_steady_state,  ///< refused by name: physics has none, and nobody found one
  refused_input,    ///< refused before the solve
  not_found,        ///< refused by name: the iteration ended without, and nobody found one
  by_convention,    ///< converged; differs by a rule of its own only (full shear of cavitated film)
  missed,           ///< not found, though there is a steady state
  wrong_refusal,    ///< refused as having none, though there is a steady state
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
  bool convention = false;  ///< a difference of its friction is one of convention
};

/// The class of one child's end, by itself.
[[nodiscard]] StressCell judge_end(const ChildEnd& end);

}  // namespace shellback::validation
