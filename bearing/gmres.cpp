#include "bearing/gmres.hpp"

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace shellback::bearing {
namespace {

struct ContextDeleter {
  void operator()(SUNContext c) const { SUNContext_Free(&c); }
};
struct VectorDeleter {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
struct SolverDeleter {
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
};
template <class T, class D>
using Owned = std::unique_ptr<std::remove_pointer_t<T>, D>;

void require(int flag) {
  if (flag != 0) throw std::runtime_error("SUNDIALS SPGMR could not be set up");
}

struct Operator {
  const LinearOperator* apply;
  std::vector<double> x;
};

int multiply(void* data, N_Vector x, N_Vector y) {
  Operator& a = *static_cast<Operator*>(data);
  const double* from = N_VGetArrayPointer(x);
  a.x.assign(from, from + a.x.size());
  const std::vector<double> product = (*a.apply)(a.x);
  std::copy(product.begin(), product.end(), N_VGetArrayPointer(y));
  return 0;
}

}  // namespace

KrylovResult gmres(const LinearOperator& apply, const std::vector<double>& b, double tolerance,
                   int most) {
  KrylovResult out;
  out.x.assign(b.size(), 0.0);
  SUNContext raw = nullptr;
  require(SUNContext_Create(nullptr, &raw));
  const Owned<SUNContext, ContextDeleter> context(raw);
  const auto n = static_cast<sunindextype>(b.size());
  std::vector<double> right = b;  // SUNDIALS takes no constant vector
  const Owned<N_Vector, VectorDeleter> rhs(N_VMake_Serial(n, right.data(), raw));
  const Owned<N_Vector, VectorDeleter> x(N_VMake_Serial(n, out.x.data(), raw));
  const double norm = std::sqrt(N_VDotProd(rhs.get(), rhs.get()));
  if (!(norm > 0.0)) return out;
  const Owned<SUNLinearSolver, SolverDeleter> solver(
      SUNLinSol_SPGMR(x.get(), SUN_PREC_NONE, most, raw));
  Operator a{&apply, b};
  require(SUNLinSolSetATimes(solver.get(), &a, multiply));
  require(SUNLinSolInitialize(solver.get()));
  require(SUNLinSolSetup(solver.get(), nullptr));
  // What it answers is told by the residual: one that is not reached in `most` is a result, too.
  SUNLinSolSolve(solver.get(), nullptr, x.get(), rhs.get(), tolerance * norm);
  out.iterations = SUNLinSolNumIters(solver.get());
  out.reduction = SUNLinSolResNorm(solver.get()) / norm;
  return out;
}

}  // namespace shellback::bearing
