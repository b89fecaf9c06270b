#include "bearing/gmres.hpp"

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "core/eigen.hpp"

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
  const LinearOperator* apply = nullptr;
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

/// Inner product in as many partial sums as the machine has lanes: that of SUNDIALS adds one number
/// after the other, and orthogonalisation is little else.
double dot(N_Vector a, N_Vector b) {
  const auto n = N_VGetLength(a);
  using Numbers = Eigen::Map<const Eigen::VectorXd>;
  return Numbers(N_VGetArrayPointer(a), n).dot(Numbers(N_VGetArrayPointer(b), n));
}

/// SPGMR and its vectors, one per thread and used again by every solve of its size: they are
/// eighty, and to make them anew takes longer than what is done with them.
class KrylovSpace {
 public:
  KrylovSpace(sunindextype n, int most) : n_(n), most_(most) {
    SUNContext raw = nullptr;
    require(SUNContext_Create(nullptr, &raw));
    context_.reset(raw);
    rhs_.reset(N_VNew_Serial(n, raw));
    x_.reset(N_VNew_Serial(n, raw));
    rhs_->ops->nvdotprod = dot;
    x_->ops->nvdotprod = dot;  // clones are made with the operations of their model
    solver_.reset(SUNLinSol_SPGMR(x_.get(), SUN_PREC_NONE, most, raw));
    require(SUNLinSolSetATimes(solver_.get(), &operator_, multiply));
    require(SUNLinSolInitialize(solver_.get()));
    require(SUNLinSolSetup(solver_.get(), nullptr));
  }
  /// SPGMR holds the address of the operator.
  KrylovSpace(const KrylovSpace&) = delete;
  KrylovSpace& operator=(const KrylovSpace&) = delete;

  [[nodiscard]] bool serves(sunindextype n, int most) const { return n == n_ && most == most_; }

  KrylovResult solve(const LinearOperator& apply, const std::vector<double>& b, double tolerance) {
    KrylovResult out;
    out.x.assign(b.size(), 0.0);
    std::copy(b.begin(), b.end(), N_VGetArrayPointer(rhs_.get()));
    const double norm = std::sqrt(dot(rhs_.get(), rhs_.get()));
    if (!(norm > 0.0)) return out;
    N_VConst(0.0, x_.get());
    operator_ = {&apply, b};
    // What it answers is told by the residual: one not reached in `most` is a result, too.
    SUNLinSolSolve(solver_.get(), nullptr, x_.get(), rhs_.get(), tolerance * norm);
    const double* found = N_VGetArrayPointer(x_.get());
    std::copy(found, found + n_, out.x.begin());
    out.iterations = SUNLinSolNumIters(solver_.get());
    out.reduction = SUNLinSolResNorm(solver_.get()) / norm;
    return out;
  }

 private:
  sunindextype n_;
  int most_;
  Operator operator_;
  Owned<SUNContext, ContextDeleter> context_;
  Owned<N_Vector, VectorDeleter> rhs_;
  Owned<N_Vector, VectorDeleter> x_;
  Owned<SUNLinearSolver, SolverDeleter> solver_;
};

}  // namespace

KrylovResult gmres(const LinearOperator& apply, const std::vector<double>& b, double tolerance,
                   int most) {
  static thread_local std::unique_ptr<KrylovSpace> space;
  const auto n = static_cast<sunindextype>(b.size());
  if (!space || !space->serves(n, most)) space = std::make_unique<KrylovSpace>(n, most);
  return space->solve(apply, b, tolerance);
}

}  // namespace shellback::bearing
