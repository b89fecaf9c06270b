#include "validation/stress/stress_cell.hpp"

#include <fmt/format.h>

namespace shellback::validation {
namespace {

/// The class of what a child told.
StressClass class_of(const StressAnswer& a) {
  if (!a.faults.empty()) return a.not_a_number ? StressClass::not_a_number : StressClass::wrong;
  if (a.converged()) return StressClass::converged;
  if (a.status == shellback::to_string(Status::no_steady_state)) {
    return StressClass::no_steady_state;
  }
  if (a.status == shellback::to_string(Status::invalid_number)) return StressClass::not_a_number;
  if (a.status == kRefusedInput) return StressClass::refused_input;
  return StressClass::not_found;
}

}  // namespace

const char* to_string(StressClass c) {
  switch (c) {
    case StressClass::converged:
      return "converged and audited";
    case StressClass::no_steady_state:
      return "refused: no steady state";
    case StressClass::refused_input:
      return "refused: input";
    case StressClass::not_found:
      return "refused: not found";
    case StressClass::by_convention:
      return "differs by convention";
    case StressClass::missed:
      return "not found, but there is one";
    case StressClass::wrong_refusal:
      return "wrong refusal";
    case StressClass::wrong:
      return "wrong";
    case StressClass::not_a_number:
      return "not a number";
    case StressClass::crashed:
      return "crash";
    case StressClass::timed_out:
      return "hang";
    case StressClass::not_run:
      break;
  }
  return "not run";
}

bool is_fault(StressClass c) {
  return c == StressClass::wrong_refusal || c == StressClass::wrong ||
         c == StressClass::not_a_number || c == StressClass::crashed || c == StressClass::timed_out;
}

StressCell judge_end(const ChildEnd& end) {
  StressCell cell;
  cell.seconds = end.seconds;
  cell.why = end.answer;
  switch (end.how) {
    case ChildEnd::How::timed_out:
      cell.result = StressClass::timed_out;
      cell.why = fmt::format("no end after {:.0f} s", end.seconds);
      return cell;
    case ChildEnd::How::crashed:
    case ChildEnd::How::threw:
      cell.result = StressClass::crashed;
      return cell;
    case ChildEnd::How::answered:
      break;
  }
  try {
    cell.answer = answer_from(end.answer);
  } catch (const std::exception& error) {
    cell.result = StressClass::crashed;
    cell.why = fmt::format("the answer cannot be read: {}", error.what());
    return cell;
  }
  cell.result = class_of(cell.answer);
  const auto& faults = cell.answer.faults;
  cell.why = faults.empty() ? cell.answer.reason : fmt::format("{}", fmt::join(faults, "; "));
  return cell;
}

}  // namespace shellback::validation
