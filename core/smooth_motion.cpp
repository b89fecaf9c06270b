#include "core/smooth_motion.hpp"

#include <cvode/cvode.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cmath>

#include "core/step_control.hpp"
#include "core/sundials.hpp"

namespace shellback {
namespace {

// What went wrong is reported by the caller, in the user's words.
void stay_silent(int, const char*, const char*, char*, void*) {}

void require(int flag) { sundials::require(flag, "CVODE"); }

Pair pair_of(N_Vector y) {
  const double* at = N_VGetArrayPointer(y);
  return {at[0], at[1]};
}

}  // namespace

struct SmoothMotion::Solver {
  struct FreeCvode {
    void operator()(void* m) const { CVodeFree(&m); }
  };
  const Motion* motion;
  sundials::Context context = sundials::make_context("CVODE");
  sundials::Vector y;
  sundials::Matrix matrix;
  sundials::LinearSolver linear;
  sundials::Owned<void*, FreeCvode> cvode;
  bool begun = false;
  Pair now{};
  double t = 0.0;
  long steps = 0;     ///< of the runs before the last begin()
  long rejected = 0;  ///< the same

  static int rate(double t, N_Vector y, N_Vector out, void* data) {
    const Solver& self = *static_cast<Solver*>(data);
    Pair f{};
    if (!self.motion->rate(t, pair_of(y), f)) return 1;  // CVODE: try a shorter step
    N_VGetArrayPointer(out)[0] = f[0];
    N_VGetArrayPointer(out)[1] = f[1];
    return 0;
  }
  static int weights(N_Vector y, N_Vector out, void* data) {
    const Solver& self = *static_cast<Solver*>(data);
    const double size = self.motion->tolerance * self.motion->size(pair_of(y));
    if (!(size > 0.0)) return -1;
    N_VConst(1.0 / size, out);
    return 0;
  }
  void add_counts() {
    long n = 0, failed = 0, stalled = 0;
    require(CVodeGetNumSteps(cvode.get(), &n));
    require(CVodeGetNumErrTestFails(cvode.get(), &failed));
    require(CVodeGetNumNonlinSolvConvFails(cvode.get(), &stalled));
    steps += n;
    rejected += failed + stalled;
  }
};

SmoothMotion::SmoothMotion(const Motion& motion) : solver_(std::make_unique<Solver>()) {
  Solver& s = *solver_;
  s.motion = &motion;
  SUNContext raw = s.context.get();
  s.y.reset(N_VNew_Serial(2, raw));
  s.matrix.reset(SUNDenseMatrix(2, 2, raw));
  s.linear.reset(SUNLinSol_Dense(s.y.get(), s.matrix.get(), raw));
  s.cvode.reset(CVodeCreate(CV_BDF, raw));
}

SmoothMotion::~SmoothMotion() = default;

void SmoothMotion::begin(double t, const Pair& y) {
  Solver& s = *solver_;
  if (s.begun) s.add_counts();
  s.now = y;
  s.t = t;
  for (int k = 0; k < 2; ++k) N_VGetArrayPointer(s.y.get())[k] = y[k];
  if (s.begun) {
    require(CVodeReInit(s.cvode.get(), t, s.y.get()));
    return;
  }
  s.begun = true;
  void* cvode = s.cvode.get();
  require(CVodeInit(cvode, Solver::rate, t, s.y.get()));
  require(CVodeSetErrHandlerFn(cvode, stay_silent, nullptr));
  require(CVodeSetUserData(cvode, &s));
  require(CVodeWFtolerances(cvode, Solver::weights));
  require(CVodeSetLinearSolver(cvode, s.linear.get(), s.matrix.get()));
  if (std::isfinite(s.motion->longest)) require(CVodeSetMaxStep(cvode, s.motion->longest));
  require(CVodeSetMaxNumSteps(cvode, kMostStepsInTime));
}

void SmoothMotion::stop_at(double t) { require(CVodeSetStopTime(solver_->cvode.get(), t)); }

bool SmoothMotion::go_to(double t) {
  Solver& s = *solver_;
  const int end = CVode(s.cvode.get(), t, s.y.get(), &s.t, CV_NORMAL);
  s.now = pair_of(s.y.get());
  return end >= 0 && std::isfinite(s.now[0]) && std::isfinite(s.now[1]);
}

const Pair& SmoothMotion::now() const { return solver_->now; }

long SmoothMotion::steps() const {
  long n = 0;
  if (solver_->begun) require(CVodeGetNumSteps(solver_->cvode.get(), &n));
  return solver_->steps + n;
}

long SmoothMotion::rejected() const {
  long failed = 0, stalled = 0;
  if (solver_->begun) {
    require(CVodeGetNumErrTestFails(solver_->cvode.get(), &failed));
    require(CVodeGetNumNonlinSolvConvFails(solver_->cvode.get(), &stalled));
  }
  return solver_->rejected + failed + stalled;
}

}  // namespace shellback
