#pragma once
/// GSL's errors as what its functions return.
#include <gsl/gsl_errno.h>

namespace shellback {

/// By its own rule GSL ends the program at an error. Switched off once for all threads, and left
/// so: the handler is one for the whole program, and putting a former one back would give it to
/// whatever another thread is just solving.
inline void gsl_errors_are_results() {
  static const auto former = gsl_set_error_handler_off();
  static_cast<void>(former);
}

}  // namespace shellback
