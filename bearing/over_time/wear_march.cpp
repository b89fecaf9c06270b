#include "bearing/over_time/wear_march.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/largest.hpp"
#include "core/step_control.hpp"

namespace shellback::bearing {
namespace {

constexpr double kFirstDepth = 0.1;    ///< of the first step, in summit roughnesses [-]
constexpr double kDepthError = 0.001;  ///< of a step, over the depth or the summit roughness [-]
constexpr double kOtherRate = 0.1;     ///< part of the wear rate by which another state differs [-]

/// (e^x - 1)/x and (phi_1(x) - 1)/x, by their series where those lose their digits.
double phi_1(double x) { return std::abs(x) < 1e-8 ? 1.0 + 0.5 * x : std::expm1(x) / x; }
double phi_2(double x) { return std::abs(x) < 1e-5 ? 0.5 + x / 6.0 : (phi_1(x) - 1.0) / x; }

WearPoint point_of(const WornBearing& b, double per_load, Field w) {
  WearLoad load = b.load();
  for (double& x : load.load) x *= per_load;
  for (double& x : load.stiffness) x *= per_load;
  return {std::move(w), std::move(load.load), std::move(load.stiffness)};
}

/// A step of (2) from `now`; what it rests on.
struct WearStep {
  double dt = 0.0;
  Field slope;  ///< of N over time, carried on [m/s2]
};

/// N of another point less that of `now`, cell k.
double change_of_rest(const WearPoint& now, const WearPoint& other, std::size_t k) {
  return other.r[k] - now.r[k] + now.J[k] * (other.w[k] - now.w[k]);
}

/// N in a straight line through the point before, `past` [s] ago; without one it stays.
WearStep step_of(const WearPoint& now, const WearPoint* before, double past, double dt) {
  WearStep step{dt, Field(now.w.size(), 0.0)};
  for (std::size_t k = 0; before != nullptr && k < now.w.size(); ++k) {
    step.slope[k] = -change_of_rest(now, *before, k) / past;
  }
  return step;
}

Field after(const WearPoint& now, const WearStep& step) {
  const double dt = step.dt;
  Field w = now.w;
  for (std::size_t k = 0; k < w.size(); ++k) {
    const double x = -dt * now.J[k];
    w[k] += std::max(0.0, dt * (phi_1(x) * now.r[k] + phi_2(x) * dt * step.slope[k]));
  }
  return w;
}

/// By how much the rate at the end moves the wear of the step.
StepError error_of(const FilmGrid& g, const WearPoint& now, const WearStep& step,
                   const WearPoint& end) {
  StepError error;
  double before = 0.0, behind = 0.0;  // rates of the volume
  for (int k = 0; k < g.cells(); ++k) {
    if (now.r[k] == 0.0 && end.r[k] == 0.0) continue;  // it rests, whatever the line says
    before += now.r[k] * g.area(k);
    behind += end.r[k] * g.area(k);
    const double off = change_of_rest(now, end, k) - step.dt * step.slope[k];
    const double moved = step.dt * phi_2(-step.dt * now.J[k]) * off;
    error.depth = larger(error.depth, std::abs(moved));
    error.volume += moved * g.area(k);
  }
  error.volume = std::abs(g.multiplicity() * error.volume);
  if (before > 0.0) error.carried = behind / before;
  return error;
}

}  // namespace

WearMarch::WearMarch(WornBearing& b, const Case& c, const SolveControl& control,
                     const std::function<void(const RunningInRun&)>& seen, RunningInRun& run)
    : b_(b),
      control_(control),
      seen_(seen),
      run_(run),
      per_load_(c.running_in->wear_coefficient / hardness_of_shell(c)),
      unit_(b.model().contact->sigma()),
      now_(point_of(b, per_load_, b.wear())) {
  take_up(control.kept, *this);
}

double WearMarch::allowed(const Field& w) const {
  return kDepthError * std::max(unit_, largest(w));
}

bool WearMarch::take(double dt, double most, From from) {
  const WearStep step = step_of(now_, before_ ? &*before_ : nullptr, past_, dt);
  Field w = after(now_, step);
  depth_ = largest_difference(w, now_.w);
  found_ = from == From::cold ? b_.wear_from_cold(w, why_)
                              : b_.wear_to(w, std::numeric_limits<double>::infinity(), why_);
  if (!found_) return false;
  WearPoint end = point_of(b_, per_load_, std::move(w));
  error_ = error_of(b_.model().domain.grid, now_, step, end);
  over_ = error_.depth / allowed(end.w);
  const bool jumps = from == From::cold && !(std::abs(error_.carried - 1.0) <= kOtherRate);
  found_ = !jumps || std::isinf(most);
  if (!found_ || !(over_ <= most)) {
    b_.go_back();
    return false;
  }
  before_ = std::exchange(now_, std::move(end));
  past_ = dt;
  t_ += dt;
  failing_ = false;
  note_state(b_, t_, dt, error_, now_.w, run_);
  run_.states.back().anew = jumps;
  if (jumps) {
    before_.reset();
    past_ = 0.0;
  }
  if (seen_) seen_(run_);
  return true;
}

bool WearMarch::advance(double dt) {
  if (take(dt)) return true;
  if (found_ || failing_ || why_.status == Status::interrupted) return false;
  if (take_from_cold(dt, 1.0)) return true;
  failing_ = !found_ && !stopped(control_);  // else it errs too much: a shorter one may be found so
  return false;
}

bool WearMarch::take_from_cold(double dt, double most) {
  const Verdict why = why_;
  if (take(dt, most, From::cold)) return true;
  if (!stopped(control_)) why_ = why;
  return false;
}

bool WearMarch::shorter_may_be_found() const {
  return found_ ? dt_ >= kStepShortest * first_ : depth_ >= allowed(now_.w);
}

bool WearMarch::begin_anew(double dt) {
  if (found_ || run_.states.back().anew) return false;
  return take_from_cold(dt, std::numeric_limits<double>::infinity());
}

void WearMarch::end_too_short() {
  run_.verdict = found_ ? Verdict{Status::iteration_limit, ending::RunningInEnded{t_, over_}}
                        : Verdict{why_.status, ending::RunningInEnded{t_}, why_.place, {why_}};
}

void WearMarch::stop() {
  run_.verdict = {Status::interrupted, ending::RunningInEnded{t_}};
  keep(control_.kept, true, b_, run_, *this);
}

double WearMarch::first_step() const { return kFirstDepth * unit_ / largest(now_.r); }

bool WearMarch::begin(double end) {
  if (largest(now_.r) > 0.0) {
    first_ = dt_ = first_step();
    return true;
  }
  note_state(b_, end, end, {}, now_.w, run_);  // nothing rubs, for however long
  run_.states.back().cycles = 0;               // told with the first state
  if (seen_) seen_(run_);
  return false;
}

void WearMarch::to(double end) {
  if (first_ == 0.0 && !begin(end)) return;
  while (t_ < end) {
    if (stopped(control_)) return stop();
    dt_ = std::min(dt_, end - t_);
    const bool good = advance(dt_);
    const double longer = step_growth(1.0, over_, !(past_ > 0.0 && before_));
    if (!good && !found_ && why_.status == Status::interrupted) return stop();
    if (!good) {
      ++run_.rejected_steps;
      if (!shorter_may_be_found()) {
        if (!begin_anew(dt_)) return stopped(control_) ? stop() : end_too_short();
        if (run_.states.back().anew) dt_ = first_step();
        continue;
      }
    }
    dt_ *= !found_ ? kStepShorter : good ? longer : std::min(longer, kStepSafety);
    keep(control_.kept, false, b_, run_, *this);
  }
}

void WearMarch::through(const std::vector<double>& steps) {
  for (const double dt : steps) {
    if (stopped(control_)) return stop();
    if (!take(dt, std::numeric_limits<double>::infinity()) && !begin_anew(dt)) {
      return stopped(control_) ? stop() : end_too_short();
    }
  }
}

}  // namespace shellback::bearing
