#include "core/gmres.hpp"

#include <sunlinsol/sunlinsol_spgmr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/eigen.hpp"
#include "core/sundials.hpp"

namespace shellback {
namespace {

constexpr const char* kPart = "SUNDIALS SPGMR";
constexpr std::size_t kMostPairs = 24;  ///< of a memory [-]
constexpr double kNews = 0.1;           ///< part of an answer that must be new [-]

using Numbers = Eigen::Map<Eigen::VectorXd>;
using GivenNumbers = Eigen::Map<const Eigen::VectorXd>;

Numbers numbers(std::vector<double>& x) { return {x.data(), static_cast<Eigen::Index>(x.size())}; }
GivenNumbers numbers(const std::vector<double>& x) {
  return {x.data(), static_cast<Eigen::Index>(x.size())};
}
Numbers numbers(N_Vector x) { return {N_VGetArrayPointer(x), N_VGetLength(x)}; }

struct Operator {
  const LinearOperator* apply = nullptr;
  KrylovMemory* memory = nullptr;
  std::vector<double> x;
  std::vector<std::vector<double>> asked, answered;  ///< with a memory
};

int matrix_times(void* data, N_Vector x, N_Vector y) {
  Operator& a = *static_cast<Operator*>(data);
  numbers(a.x) = numbers(x);
  std::vector<double> product = (*a.apply)(a.x);
  numbers(y) = numbers(product);
  if (a.memory) {
    a.asked.push_back(a.x);
    a.answered.push_back(std::move(product));
  }
  return 0;
}

int precondition(void* data, N_Vector r, N_Vector z, double /*tolerance*/, int /*side*/) {
  const Operator& a = *static_cast<Operator*>(data);
  numbers(z) = numbers(r);
  a.memory->apply(N_VGetArrayPointer(z), static_cast<std::size_t>(N_VGetLength(z)));
  return 0;
}

/// SPGMR and its vectors, one per thread and used again by every solve of its size: to make as many
/// as there may be iterations takes longer than what is done with them.
class KrylovSpace {
 public:
  KrylovSpace(sunindextype n, int most) : n_(n), most_(most) {
    SUNContext raw = context_.get();
    rhs_ = make_vector();
    x_ = make_vector();
    solver_.reset(SUNLinSol_SPGMR(x_.get(), SUN_PREC_NONE, most, raw));
    sundials::require(SUNLinSolSetATimes(solver_.get(), &operator_, matrix_times), kPart);
    sundials::require(SUNLinSolSetPreconditioner(solver_.get(), &operator_, nullptr, precondition),
                      kPart);
    sundials::require(SUNLinSolInitialize(solver_.get()), kPart);
    sundials::require(SUNLinSolSetup(solver_.get(), nullptr), kPart);
  }
  /// SPGMR holds the address of the operator.
  KrylovSpace(const KrylovSpace&) = delete;
  KrylovSpace& operator=(const KrylovSpace&) = delete;

  [[nodiscard]] bool serves(sunindextype n, int most) const { return n == n_ && most == most_; }

  KrylovResult solve(const LinearOperator& apply, const std::vector<double>& b, double tolerance,
                     KrylovMemory* memory) {
    KrylovResult out;
    out.x.assign(b.size(), 0.0);
    numbers(rhs_.get()) = numbers(b);
    const double norm = numbers(b).norm();
    if (!(norm > 0.0)) return out;
    N_VConst(0.0, x_.get());
    operator_ = {&apply, memory, b, {}, {}};
    const int side = memory && !memory->empty() ? SUN_PREC_RIGHT : SUN_PREC_NONE;
    sundials::require(SUNLinSol_SPGMRSetPrecType(solver_.get(), side), kPart);
    // What it answers is told by the residual: one not reached in `most` is a result, too.
    SUNLinSolSolve(solver_.get(), nullptr, x_.get(), rhs_.get(), tolerance * norm);
    numbers(out.x) = numbers(x_.get());
    out.iterations = SUNLinSolNumIters(solver_.get());
    out.reduction = SUNLinSolResNorm(solver_.get()) / norm;
    for (std::size_t k = 0; k < operator_.asked.size(); ++k) {
      memory->learn(std::move(operator_.asked[k]), std::move(operator_.answered[k]));
    }
    return out;
  }

 private:
  /// Clones are made with the operations of their model.
  [[nodiscard]] sundials::Vector make_vector() const {
    sundials::Vector x(N_VNew_Serial(n_, context_.get()));
    sundials::work_in_lanes(x.get());
    return x;
  }

  sunindextype n_;
  int most_;
  Operator operator_;
  sundials::Context context_ = sundials::make_context(kPart);
  sundials::Vector rhs_;
  sundials::Vector x_;
  sundials::LinearSolver solver_;
};

}  // namespace

void KrylovMemory::learn(std::vector<double> v, std::vector<double> w) {
  if (pairs_.size() == kMostPairs) return;
  Numbers asked = numbers(v), answer = numbers(w);
  const double whole = answer.norm();
  for (const Pair& p : pairs_) {
    const double part = numbers(p.answer).dot(answer);
    answer -= part * numbers(p.answer);
    asked -= part * (numbers(p.answer) + numbers(p.beyond));
  }
  const double rest = answer.norm();
  if (!(rest > kNews * whole) || !std::isfinite(rest)) return;
  answer /= rest;
  asked = asked / rest - answer;
  pairs_.push_back({std::move(w), std::move(v)});
}

void KrylovMemory::apply(double* r, std::size_t n) const {
  Numbers field(r, static_cast<Eigen::Index>(n));
  std::array<double, kMostPairs> along{};
  for (std::size_t k = 0; k < pairs_.size(); ++k) along[k] = numbers(pairs_[k].answer).dot(field);
  for (std::size_t k = 0; k < pairs_.size(); ++k) field += along[k] * numbers(pairs_[k].beyond);
}

KrylovResult gmres(const LinearOperator& apply, const std::vector<double>& b, double tolerance,
                   int most, KrylovMemory* memory) {
  static thread_local std::unique_ptr<KrylovSpace> space;
  const auto n = static_cast<sunindextype>(b.size());
  if (!space || !space->serves(n, most)) space = std::make_unique<KrylovSpace>(n, most);
  return space->solve(apply, b, tolerance, memory);
}

}  // namespace shellback
