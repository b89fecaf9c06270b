#include "fidelity/journal_path.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/over_time/cycle_endings.hpp"
#include "bearing/over_time/cycle_search.hpp"
#include "core/constants.hpp"
#include "core/eigen.hpp"
#include "core/round_off.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

constexpr int kInstants = 720;  ///< told: every degree of a four-stroke
/// Cycles, or turns of an event's first place, until the journal has come to rest: a light load
/// brings it nearer by a hundredth a cycle.
constexpr int kMostTurns = 1000;

/// Step errors within which the ends of two paths are alike: their steps are chosen anew, and a few
/// errors of a hundred or a thousand are left of each at its end (0.6 and 2 of them in two cycles
/// that went round for ever) [-].
constexpr double kAlike = 10.0;
/// Step errors by which a path begun beside is displaced, so that this is a tenth of it [-].
constexpr double kBeside = 30.0;
/// Largest rate at which paths beside may draw near to be told from one that stays, as they are
/// known to a tenth [-].
constexpr double kSlowestBeside = 0.9;

double gap_left(const Pair& x) { return 1.0 - std::hypot(x[0], x[1]); }

/// Ends of the smooth pieces within the course, and its end.
std::vector<LoadCorner> corners_of(const LoadCourse& course, double length) {
  std::vector<LoadCorner> all;
  for (const LoadCorner& c : course.corners()) {
    if (c.t > kRoundOff * length && c.t < (1.0 - kRoundOff) * length) all.push_back(c);
  }
  all.push_back({length, false, 0.0});
  return all;
}

/// Even instants that are told, without those at corners.
std::vector<double> told_of(const std::vector<LoadCorner>& corners, double length) {
  std::vector<double> all;
  for (int k = 1; k < kInstants; ++k) {
    const double t = length * k / kInstants;
    const bool known = std::any_of(corners.begin(), corners.end(), [&](const LoadCorner& c) {
      return std::abs(c.t - t) <= kRoundOff * length;
    });
    if (!known) all.push_back(t);
  }
  return all;
}

}  // namespace

JournalPath::JournalPath(const Case& c, double tolerance, const SolveControl& control)
    : c_(c),
      control_(control),
      length_(c.cycle->length()),
      tolerance_(tolerance),
      course_(*c.cycle, c.operation.omega),
      motion_(c, course_),
      corners_(corners_of(course_, length_)),
      told_(told_of(corners_, length_)) {}

std::optional<Pair> JournalPath::pass(const Pair& from, bool record) {
  double end = 0.0;  // of the smooth piece: up to it what holds before a jump
  const Motion motion{
      [&](double t, const Pair& x, Pair& v) { return motion_.rate(t, t >= end, x, v); }, gap_left,
      tolerance_, length_ / kFewestSteps};
  SmoothMotion path(motion);
  if (record) instants_ = {motion_.instant(0.0, false, from)};
  const auto tell = [&](double t, bool before_jump) {
    if (!record) return;
    instants_.push_back(motion_.instant(t, before_jump, path.now()));
    instants_.back().dt = t - instants_[instants_.size() - 2].t;
  };
  path.begin(0.0, from);
  std::size_t next = 0;
  for (const LoadCorner& corner : corners_) {
    end = lost_at_ = corner.t;
    path.stop_at(end);
    for (; record && next < told_.size() && told_[next] < end; ++next) {
      if (!path.go_to(told_[next])) return std::nullopt;
      tell(told_[next], true);
    }
    if (!path.go_to(end)) return std::nullopt;
    tell(end, true);
    if (!corner.jump || end >= length_) continue;
    tell(end, false);
    path.begin(end, path.now());
  }
  steps_ = static_cast<int>(path.steps());
  rejected_ = static_cast<int>(path.rejected());
  return path.now();
}

Pair JournalPath::steady_place() {
  constexpr double kAtRest = 1e-6;  // of its speed, over the gap that is left
  const double omega = std::abs(course_.begins().omega);
  began_steady_ = true;
  const Motion motion{[&](double, const Pair& x, Pair& v) { return motion_.rate(0.0, true, x, v); },
                      gap_left, tolerance_, INFINITY};
  SmoothMotion path(motion);
  path.begin(0.0, {0.0, 0.0});
  for (double turns = 1.0; turns <= kMostTurns && omega > 0.0; turns *= 2.0) {
    if (!path.go_to(2.0 * kPi * turns / omega)) break;
    Pair v{};
    const bool known = motion_.rate(0.0, true, path.now(), v);
    if (known && std::hypot(v[0], v[1]) < kAtRest * omega * gap_left(path.now())) return path.now();
  }
  began_steady_ = false;
  return {0.0, 0.0};
}

Verdict JournalPath::lost() const {
  return {Status::iteration_limit,
          ending::NoStep{lost_at_, c_.cycle->crank_speed, true},
          {},
          {{Status::iteration_limit, ending::Plain::steps_too_short}}};
}

double JournalPath::left_beside(const Pair& end) {
  const double by = kBeside * tolerance_ * gap_left(at_);
  Eigen::Matrix2d J;
  for (int k = 0; k < 2; ++k) {
    Pair beside = at_;
    beside[k] += by;
    const auto there = pass(beside, false);
    if (!there) return NAN;
    for (int i = 0; i < 2; ++i) J(i, k) = ((*there)[i] - end[i]) / by;
  }
  if (!(J.eigenvalues().cwiseAbs().maxCoeff() <= kSlowestBeside)) return NAN;
  const Eigen::Vector2d d(end[0] - at_[0], end[1] - at_[1]);
  const Eigen::Vector2d left = (Eigen::Matrix2d::Identity() - J).inverse() * (J * d);
  return left.norm() / gap_left(end);
}

Verdict JournalPath::find(double T) {
  motion_.set_temperature(T);
  cycles_ = 0;
  closure_ = NAN;
  if (!c_.cycle->repeats()) {
    at_ = steady_place();
    cycles_ = 1;
    return pass(at_, true) ? Verdict{} : lost();
  }
  Closure closure;
  while (cycles_ < kMostTurns) {
    if (stopped(control_)) return {Status::interrupted};
    const auto next = pass(at_, false);
    if (!next) return lost();
    ++cycles_;
    const double apart = std::hypot((*next)[0] - at_[0], (*next)[1] - at_[1]) / gap_left(*next);
    closure.add(apart);
    closure_ = closure.left();
    bool closed = closure.closed();
    if (!closed && apart <= kAlike * tolerance_) {
      const double beside = left_beside(*next);
      closed = beside <= std::max(kClosed, kAlike * tolerance_);
      if (!std::isnan(beside)) closure_ = beside;
    }
    at_ = *next;
    if (!closed) continue;
    ++cycles_;
    return pass(at_, true) ? Verdict{} : lost();
  }
  return {Status::iteration_limit, ending::Unsettled{ending::Iteration::cycles, cycles_, closure_}};
}

double JournalPath::asperity_share() const {
  double most = 0.0;
  for (const CycleInstant& i : instants_) {
    const double clearance = c_.bearing.radial_clearance;
    most = std::max(most,
                    motion_.asperity_share(i.t, i.dt > 0.0, {i.ex / clearance, i.ey / clearance}));
  }
  return most;
}

}  // namespace shellback::fidelity
