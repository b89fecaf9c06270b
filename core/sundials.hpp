#pragma once
/// What SUNDIALS hands out, owned.
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace shellback::sundials {

struct ContextDeleter {
  void operator()(SUNContext c) const { SUNContext_Free(&c); }
};
struct VectorDeleter {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
struct LinearDeleter {
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
};
struct MatrixDeleter {
  void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
};
template <class T, class D>
using Owned = std::unique_ptr<std::remove_pointer_t<T>, D>;
using Context = Owned<SUNContext, ContextDeleter>;
using Vector = Owned<N_Vector, VectorDeleter>;
using Matrix = Owned<SUNMatrix, MatrixDeleter>;
using LinearSolver = Owned<SUNLinearSolver, LinearDeleter>;

/// Throws where `part` could not be set up: an internal failure.
inline void require(int flag, const char* part) {
  if (flag < 0) throw std::runtime_error(std::string(part) + " could not be set up");
}

/// The operations of `x`, and of all that are cloned from it, in as many lanes as the machine has:
/// those of SUNDIALS take one number after the other.
void work_in_lanes(N_Vector x);

[[nodiscard]] inline Context make_context(const char* part) {
  SUNContext raw = nullptr;
  require(SUNContext_Create(nullptr, &raw) == 0 ? 0 : -1, part);
  return Context(raw);
}

}  // namespace shellback::sundials
