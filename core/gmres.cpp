#include "core/gmres.hpp"

#include <sunlinsol/sunlinsol_spgmr.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/eigen.hpp"
#include "core/sundials.hpp"

namespace shellback {
namespace {

constexpr const char* kPart = "SUNDIALS SPGMR";

struct Operator {
  const LinearOperator* apply = nullptr;
  std::vector<double> x;
};

int matrix_times(void* data, N_Vector x, N_Vector y) {
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

/// SPGMR and its vectors, one per thread and used again by every solve of its size: to make as many
/// as there may be iterations takes longer than what is done with them.
class KrylovSpace {
 public:
  KrylovSpace(sunindextype n, int most) : n_(n), most_(most) {
    SUNContext raw = context_.get();
    rhs_.reset(N_VNew_Serial(n, raw));
    x_.reset(N_VNew_Serial(n, raw));
    rhs_->ops->nvdotprod = dot;
    x_->ops->nvdotprod = dot;  // clones are made with the operations of their model
    solver_.reset(SUNLinSol_SPGMR(x_.get(), SUN_PREC_NONE, most, raw));
    sundials::require(SUNLinSolSetATimes(solver_.get(), &operator_, matrix_times), kPart);
    sundials::require(SUNLinSolInitialize(solver_.get()), kPart);
    sundials::require(SUNLinSolSetup(solver_.get(), nullptr), kPart);
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
  sundials::Context context_ = sundials::make_context(kPart);
  sundials::Vector rhs_;
  sundials::Vector x_;
  sundials::LinearSolver solver_;
};

}  // namespace

KrylovResult gmres(const LinearOperator& apply, const std::vector<double>& b, double tolerance,
                   int most) {
  static thread_local std::unique_ptr<KrylovSpace> space;
  const auto n = static_cast<sunindextype>(b.size());
  if (!space || !space->serves(n, most)) space = std::make_unique<KrylovSpace>(n, most);
  return space->solve(apply, b, tolerance);
}

}  // namespace shellback
