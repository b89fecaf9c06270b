#include "bearing/over_time/cycle_steps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/round_off.hpp"
#include "core/step_control.hpp"

namespace shellback::bearing {
namespace {

constexpr double kTaken = 1.5;  ///< a step of the period before stands until it errs so much more

}  // namespace

CycleSteps::CycleSteps(FilmSteps& film, const LoadCourse& course, double length,
                       const StepOptions& options)
    : film_(film), length_(length), options_(options), wish_(begin_with(false)) {
  // A spline is smooth: its rows say where to look, and cut no step that is given.
  const LoadInterpolation lines = film.model().input.cycle->interpolation;
  const bool look = lines == LoadInterpolation::linear || !(options.fixed > 0.0);
  for (LoadCorner c : course.corners()) {
    if (!look && !c.jump && std::isfinite(c.slope_change)) continue;
    if (course.repeats() && c.t >= length) c.t -= length;
    corners_.push_back(c);
  }
  for (const double t : film.vessels().switchings()) corners_.push_back({t, true, 0.0});
  for (const double t : film.model().input.cycle->fields_at) {
    corners_.push_back({t, false, INFINITY});  // steps end there, however little is felt
  }
  std::stable_sort(corners_.begin(), corners_.end(),
                   [](const LoadCorner& a, const LoadCorner& b) { return a.t < b.t; });
}

/// A corner in the middle of a step moves the load by an eighth of its change of slope times dt:
/// where that is more than the film's allowed error, the step ends on it. Rows that stand close
/// bend little each, but a pulse of them together: a step ends where what they have bent since its
/// beginning moves the load by as much over the way so far.
double CycleSteps::next_corner(double since, double dt) const {
  const double round = kRoundOff * length_;
  double bend = 0.0;
  for (const LoadCorner& c : corners_) {
    if (c.t <= since + round) continue;
    if (c.t > length_ - round) break;  // the end itself
    const double way = c.t - since;
    if (std::isfinite(c.slope_change)) bend += c.slope_change;
    const bool felt = c.jump || c.slope_change * dt > 8.0 * options_.error;
    if (felt || (way < dt && bend * way > 8.0 * options_.error)) return c.t;
  }
  return length_;
}

double CycleSteps::end_of_step(double since, double dt) const {
  const double round = kRoundOff * length_;
  double end = next_corner(since, dt);
  // No sliver is left: what is less than two steps is halved.
  if (end - since > dt + round && end - since < 2.0 * dt) {
    return since + 0.5 * (end - since);
  }
  end = std::min(end, since + dt);
  return length_ - end < round ? length_ : end;
}

/// The line of a vessel that opens or shuts is a jump, not of load or speed.
bool CycleSteps::switched_at(double since) const {
  const double round = kRoundOff * length_;
  return std::any_of(corners_.begin(), corners_.end(), [&](const LoadCorner& c) {
    return c.jump && c.slope_change == 0.0 && std::abs(c.t - since) < round;
  });
}

/// A given step is whole from the beginning on, but where a vessel's pressure finds its level
/// within microseconds: it would be passed over, and what swings beyond it told as its smallest.
double CycleSteps::begin_with(bool switched) const {
  if (!(options_.fixed > 0.0)) return options_.after_jump;
  return switched ? std::min(options_.after_jump, options_.fixed) : options_.fixed;
}

bool CycleSteps::jump_at(double since) const {
  const double round = kRoundOff * length_;
  return std::any_of(corners_.begin(), corners_.end(), [&](const LoadCorner& c) {
    return c.jump && (std::abs(c.t - since) < round || std::abs(c.t - length_ - since) < round);
  });
}

double CycleSteps::length_for(const FilmStep& step, double dt, bool anew) const {
  if (!step.verdict.good()) return kStepShorter * dt;
  return dt * step_growth(options_.error, step.error, anew);
}

FilmStep CycleSteps::find(double since, const FilmInTime& now, double& end, PeriodEnd& out,
                          EquilibriumCost& cost, const SolveControl& control) {
  const bool anew = now.oil_slope.empty();
  const auto old = std::upper_bound(before_.begin(), before_.end(), since + kStepShorter * wish_);
  const bool chosen = !(options_.fixed > 0.0);
  const bool again = chosen && old != before_.end() && *old - since <= kStepLonger * wish_;
  end = again ? std::min(*old, next_corner(since, *old - since)) : end_of_step(since, wish_);
  double most = again ? kTaken * options_.error : options_.error;
  if (!chosen && !eased_) most = INFINITY;
  while (true) {
    FilmStep step = film_.take(end - since, now, cost, control.stop);
    const bool good = step.verdict.good();
    const bool ended =
        step.verdict.status == Status::interrupted || step.verdict.status == Status::invalid_number;
    if (ended || (good && step.error <= most)) return step;
    if (std::isfinite(most)) most = options_.error;
    const double shorter =
        std::min(length_for(step, end - since, anew), kStepSafety * (end - since));
    if (shorter < options_.shortest) return step;
    ++out.rejected;
    wish_ = shorter;
    end = since + shorter;
  }
}

void CycleSteps::repeat(const CycleSteps& other) {
  ends_ = other.ends_;
  wish_ = other.wish_;
}

void CycleSteps::members(Tape& tape) {
  tape(ends_, before_, wish_, eased_, begun_, since_, end_.accepted, end_.rejected, end_.over);
}

PeriodEnd CycleSteps::pass(FilmInTime& now, EquilibriumCost& cost, const SolveControl& control,
                           const TellStep& tell, const std::function<void()>& landed) {
  if (!std::exchange(brought_back_, false)) {
    end_ = {};
    begun_ = now.t;
    since_ = 0.0;
    before_ = std::move(ends_);
    ends_.clear();
  }
  while (since_ < length_) {
    const double wished = wish_;
    const EquilibriumCost spent = cost;
    const int rejected = end_.rejected;
    const FilmSteps::Supplies supplies = film_.supplies();
    if (jump_at(since_) || now.oil_slope.empty()) {
      now.oil_slope.clear();
      eased_ = options_.fixed > 0.0 && switched_at(since_);
      wish_ = begin_with(eased_);
    }
    double end = 0.0;
    FilmStep step = find(since_, now, end, end_, cost, control);
    if (stopped(control)) step.verdict = {Status::interrupted};
    if (step.verdict.good() && end_.accepted == kMostStepsInTime) {
      step.verdict = {Status::iteration_limit, ending::Plain::steps_too_short};
    }
    if (step.verdict.status == Status::interrupted) {  // as if the step had never been tried
      wish_ = wished;
      cost = spent;
      end_.rejected = rejected;
      film_.put_back(supplies);
    }
    if (!step.verdict.good()) {
      end_.verdict = step.verdict;
      return end_;
    }
    accept(end, now, step, tell);
    landed();
  }
  return end_;
}

void CycleSteps::accept(double end, FilmInTime& now, FilmStep& step, const TellStep& tell) {
  const double dt = end - since_;
  const bool chosen = !(options_.fixed > 0.0);
  const double next = length_for(step, dt, now.oil_slope.empty());
  if (step.error > kTaken * options_.error) ++end_.over;
  // A step that was cut short says nothing against the length that was wished for.
  const bool cut = dt < (1.0 - kRoundOff) * wish_ && !(step.error > options_.error);
  wish_ = chosen || eased_ ? (cut ? std::max(wish_, next) : next) : options_.fixed;
  wish_ = std::min(wish_, chosen ? options_.longest : options_.fixed);
  eased_ = eased_ && wish_ < options_.fixed;
  since_ = end;
  step.after.t = begun_ + since_;
  ends_.push_back(since_);
  ++end_.accepted;
  tell(step, dt);
  now = std::move(step.after);
}

}  // namespace shellback::bearing
