#include "core/fixed_point.hpp"

#include <kinsol/kinsol.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "core/largest.hpp"
#include "core/sundials.hpp"

namespace shellback {
namespace {

using Map = std::function<bool(const std::vector<double>&, std::vector<double>&)>;

struct Call {
  const Map* map;
  const FixedPointOptions* options;
  std::vector<double> x, g;
  double change = 0.0;  ///< largest |G(x) - x| of the last call
  double rate = 1.0;    ///< change over the one before
  int calls = 0;
  bool near = false;  ///< the change is within the tolerance, or G(x) is by the rate of changes
  bool lost = false;  ///< KINSOL came with an x that is not a number, or out of reach
  std::exception_ptr thrown{};  ///< by the map: KINSOL's own frames are not to be unwound

  /// Takes note of the change of this call.
  void judge(double now) {
    const double rate_now = calls++ > 0 && change > 0.0 ? now / change : 1.0;
    const double rho = std::max(rate, rate_now);
    rate = rate_now;
    change = now;
    near = now <= options->tolerance ||
           (options->slack > 1.0 && rho < 1.0 && now <= options->slack * options->tolerance &&
            rho / (1.0 - rho) * now <= options->tolerance);
  }
};

int value_of_map(Call& call, N_Vector x, N_Vector g) {
  const double* from = N_VGetArrayPointer(x);
  call.x.assign(from, from + call.x.size());
  const auto finite = [](double v) { return std::isfinite(v); };
  call.lost = !std::all_of(call.x.begin(), call.x.end(), finite) ||
              (call.calls > 0 && largest_difference(call.x, call.g) > call.options->reach);
  if (call.lost) return -1;
  if (!(*call.map)(call.x, call.g)) return -1;
  const double change = largest_difference(call.g, call.x);
  if (std::isnan(change)) return -1;
  call.judge(change);
  std::copy(call.g.begin(), call.g.end(), N_VGetArrayPointer(g));
  return call.near ? -1 : 0;  // KINSOL has no other way to be told that this is enough
}

int evaluate(N_Vector x, N_Vector g, void* data) {
  Call& call = *static_cast<Call*>(data);
  try {
    return value_of_map(call, x, g);
  } catch (...) {
    call.thrown = std::current_exception();
    return -1;
  }
}

// The outcome is reported by the caller, in the user's words: KINSOL itself stays silent.
void stay_silent(int, const char*, const char*, char*, void*) {}

struct FreeKinsol {
  void operator()(void* m) const { KINFree(&m); }
};

void require(int flag) { sundials::require(flag, "KINSOL"); }

}  // namespace

FixedPointEnd fixed_point(const Map& map, const FixedPointOptions& o, std::vector<double>& x) {
  const sundials::Context context = sundials::make_context("KINSOL");
  SUNContext raw = context.get();
  const auto n = static_cast<sunindextype>(x.size());
  const sundials::Vector u(N_VMake_Serial(n, x.data(), raw));
  sundials::work_in_lanes(u.get());
  const sundials::Vector scale(N_VClone(u.get()));
  N_VConst(1.0, scale.get());
  const sundials::Owned<void*, FreeKinsol> solver(KINCreate(raw));
  Call call{&map, &o, x, x};
  require(KINSetErrHandlerFn(solver.get(), stay_silent, nullptr));
  require(KINSetMAA(solver.get(), o.depth));
  require(KINInit(solver.get(), evaluate, u.get()));
  require(KINSetUserData(solver.get(), &call));
  // Its norm is that of its own step, not |G(x) - x|: evaluate() ends it.
  require(KINSetFuncNormTol(solver.get(), std::numeric_limits<double>::min()));
  require(KINSetNumMaxIters(solver.get(), o.max_iterations));
  // Where changes repeat, KINSOL's least squares divide by nothing and the next x is not a number,
  // or far away: it begins anew at the map's value. So it does where its step has come to nothing.
  // Begun anew in the same way it would go the same way round: each time it takes twice as many
  // plain steps first.
  long used = 0;
  const long most = std::max(o.max_iterations, 1);
  for (long delay = o.delay;; delay = std::clamp(2 * delay, 1L, most)) {
    require(KINSetDelayAA(solver.get(), delay));
    const int end = KINSol(solver.get(), u.get(), KIN_FP, scale.get(), scale.get());
    if (call.thrown) std::rethrow_exception(call.thrown);
    if (call.near) return FixedPointEnd::converged;
    const bool anew = call.lost && call.calls > 0;
    if (anew) std::copy(call.g.begin(), call.g.end(), x.begin());
    if (end < 0 && !anew) {
      return end == KIN_MAXITER_REACHED ? FixedPointEnd::iteration_limit
                                        : FixedPointEnd::map_failed;
    }
    long now = 0;
    require(KINGetNumNonlinSolvIters(solver.get(), &now));
    used += std::max(now, 1L);
    if (used >= o.max_iterations) return FixedPointEnd::iteration_limit;
    require(KINSetNumMaxIters(solver.get(), o.max_iterations - used));
  }
}

}  // namespace shellback
