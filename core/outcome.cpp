#include "core/outcome.hpp"

namespace shellback {

const char* to_string(Status status) {
  switch (status) {
    case Status::converged:
      return "converged";
    case Status::iteration_limit:
      return "iteration limit";
    case Status::no_steady_state:
      return "no steady state";
    case Status::invalid_number:
      return "invalid number";
    case Status::interrupted:
      return "interrupted";
  }
  return "unknown";
}

}  // namespace shellback
