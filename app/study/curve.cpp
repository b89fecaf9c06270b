#include "app/study/curve.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "app/study/predictor.hpp"
#include "core/contract.hpp"

namespace shellback::study {

using bearing::Case;
using bearing::Solution;

namespace {

enum Side : unsigned { kFromBelow = 1U, kFromAbove = 2U, kFromCold = 4U };

unsigned side_of(int direction) { return direction > 0 ? kFromBelow : kFromAbove; }

}  // namespace

bool stands_alone(const Case& c) {
  const bearing::Tier tier = c.model.tier;
  return c.cycle || tier == bearing::Tier::estimate || tier == bearing::Tier::automatic;
}

/// The last two solutions of a walk.
struct Curve::Trail {
  Step near;
  std::optional<Step> before;

  void advance(double at, Known solution) {
    before = std::move(near);
    near = {at, std::move(solution)};
  }
};

bool Curve::beside(int k, const Trail& trail) { return std::abs(k - trail.near.at) <= 1.0; }

/// The start of a solve at index `at`: the secant through the trail, or its last solution.
Solution Curve::predicted(const Axis& axis, const Trail& trail, double at) {
  if (!trail.before || !axis.has_between()) return *trail.near.solution;
  const double x = coordinate(axis, trail.near.at);
  const double step = (coordinate(axis, at) - x) / (x - coordinate(axis, trail.before->at));
  return extrapolated(*trail.near.solution, *trail.before->solution, step);
}

Curve::Curve(const Axis& axis, Along case_at, std::vector<SweepPoint*> points,
             const SweepOptions& options, Finished finished, SolveAlone solve_alone,
             FinishedAlone finished_alone)
    : axis_(axis),
      case_at_(std::move(case_at)),
      points_(std::move(points)),
      options_(options),
      finished_(std::move(finished)),
      solve_alone_(std::move(solve_alone)),
      finished_alone_(std::move(finished_alone)),
      failed_from_(points_.size(), 0U),
      solved_(points_.size(), 0) {
  for (int k = 0; k < static_cast<int>(points_.size()); ++k) {
    alone_.push_back(stands_alone(case_at_(k)) ? 1 : 0);
  }
}

/// One try of point k at index `at` of the axis, from the trail or, without one, from cold. Keeps
/// count in the point, and the reason if it fails; then null.
Curve::Known Curve::solve(int k, double at, const Trail* trail) {
  const Case subject = case_at_(at);
  const bearing::Tier tier = subject.model.tier;
  Solution s = trail == nullptr ? solve_tier(subject, tier, control())
                                : solve_tier_from(subject, tier, predicted(axis_, *trail, at),
                                                  control(), bearing::Otherwise::failure);
  SweepPoint& point = *points_[k];
  ++point.tries;
  point.wall_s += s.wall_s;
  point.result.tier = tier;
  if (s.verdict.good()) return std::make_shared<const Solution>(std::move(s));
  // From cold the whole search was made; what lies between points is none of theirs.
  const bool searched = trail == nullptr || (failed_from_[k] & kFromCold) == 0;
  if (searched && at == k) point.result.verdict = s.verdict;
  return nullptr;
}

/// Point k from the trail, if need be by way of points between. Null if that does not lead there.
Curve::Known Curve::reach(int k, const Trail& trail) {
  SweepPoint& point = *points_[k];
  point.start = Start::neighbour;
  if (Known direct = solve(k, k, &trail)) return direct;
  if (!beside(k, trail) || !axis_.has_between()) return nullptr;
  point.start = Start::between;
  try {
    return halve_steps(k, trail);
  } catch (const InputError&) {
    return nullptr;  // the key takes whole numbers only: there is nothing between
  }
}

/// From the trail's end to point k in steps that are halved where they fail.
Curve::Known Curve::halve_steps(int k, Trail trail) {
  constexpr double kShortest = 1.0 / 16.0;  // of the way from point to point
  constexpr int kMostTries = 24;            // half of them for the shortest steps all the way
  double step = 0.5 * (k - trail.near.at);
  for (int n = 0; n < kMostTries && std::abs(step) >= kShortest && !stopped(); ++n) {
    const double left = k - trail.near.at;
    const double at = std::abs(left) <= std::abs(step) ? k : trail.near.at + step;
    Known next = solve(k, at, &trail);
    if (!next) {
      step *= 0.5;
      continue;
    }
    if (at == k) return next;
    trail.advance(at, std::move(next));
  }
  return nullptr;
}

Curve::Known Curve::cold(int k) {
  points_[k]->start = Start::cold;
  failed_from_[k] |= kFromCold;
  return solve(k, k, nullptr);
}

bool Curve::solved(int k) {
  const std::lock_guard lock(guard_);
  return solved_[k] != 0;
}

/// A kept solution is of use only as long as it stands beside a point that is not solved.
void Curve::forget_inner(int k) {
  const int n = static_cast<int>(points_.size());
  if (k < 0 || k >= n) return;
  const bool open = (k > 0 && solved_[k - 1] == 0) || (k + 1 < n && solved_[k + 1] == 0);
  if (!open) kept_.erase(k);
}

/// Puts the end of point k on record.
void Curve::settle(int k, const Known& solution) {
  SweepPoint& point = *points_[k];
  if (solution) {
    const bearing::Tier tier = solution->model.input.model.tier;
    point.result =
        options_.sum_up ? options_.sum_up(*solution, tier, control()) : summarize(*solution, tier);
    point.result.fields = {};
    point.result.history.clear();
    const std::lock_guard lock(guard_);
    solved_[k] = 1;
    kept_[k] = solution;
    for (int j = k - 1; j <= k + 1; ++j) forget_inner(j);
  } else if (stopped()) {
    point.result.verdict = {Status::interrupted, ending::Plain::not_reached};
  }
  finished_(k, solution);
}

/// From the trail's end in one direction through [low, high), up to the first solved point.
void Curve::walk(Trail trail, int direction, int low, int high, bool to_first_failure) {
  for (int k = static_cast<int>(std::lround(trail.near.at)) + direction; k >= low && k < high;
       k += direction) {
    if (stopped() || solved(k) || alone_[k] != 0) return;
    Known found;
    if (can_follow(case_at_(k), trail.near.solution->model.input)) found = reach(k, trail);
    if (!found && beside(k, trail)) failed_from_[k] |= side_of(direction);
    if (!found && !to_first_failure && !stopped() && (failed_from_[k] & kFromCold) == 0) {
      found = cold(k);
    }
    settle(k, found);
    if (found) trail.advance(k, found);
    if (!found && to_first_failure) return;
  }
}

/// The trail that ends at the kept point k and leads in `direction`.
Curve::Trail Curve::trail_at(int k, int direction) {
  const std::lock_guard lock(guard_);
  Trail trail{{static_cast<double>(k), kept_.at(k)}, {}};
  const auto before = kept_.find(k - direction);
  if (before != kept_.end()) trail.before = {static_cast<double>(k - direction), before->second};
  return trail;
}

/// A point that gives its neighbours nothing to start from.
void Curve::solve_alone(int k) {
  SweepPoint& point = *points_[k];
  point.start = Start::cold;
  ++point.tries;
  point.result = solve_alone_(k, case_at_(k), control());
  point.result.fields = {};
  point.result.history.clear();
  point.wall_s = point.result.cost.wall_s;
  const bool good = point.result.verdict.good();
  if (good) {
    const std::lock_guard lock(guard_);
    solved_[k] = 1;
  } else {
    point.result.quantities.clear();
  }
  finished_alone_(k, good);
}

void Curve::solve_piece(int low, int high) {
  for (int k = low; k < high && !stopped(); ++k) {
    if (alone_[k] != 0) solve_alone(k);
  }
  // The ends and the middle differ most: if none of them starts from cold, the piece is better
  // entered from its neighbours.
  std::set<int> anchors;
  for (const int k : {low, high - 1, (low + high) / 2}) {
    if (stopped() || alone_[k] != 0 || !anchors.insert(k).second) continue;
    const Known found = cold(k);
    settle(k, found);
    if (!found) continue;
    walk({{static_cast<double>(k), found}, {}}, +1, low, high, false);
    walk({{static_cast<double>(k), found}, {}}, -1, low, high, false);
    return;
  }
}

/// Walks from every kept solution into the gap beside it. True if a point was won.
bool Curve::enter_gaps() {
  const int n = static_cast<int>(points_.size());
  std::vector<int> borders;
  for (const auto& [k, solution] : kept_) borders.push_back(k);
  const auto count = [&] { return std::count(solved_.begin(), solved_.end(), 1); };
  const auto before = count();
  for (const int k : borders) {
    for (const int direction : {+1, -1}) {
      const int next = k + direction;
      if (next < 0 || next >= n || kept_.count(k) == 0 || stopped()) continue;
      if (solved(next) || (failed_from_[next] & side_of(direction)) != 0) continue;
      walk(trail_at(k, direction), direction, 0, n, true);
    }
  }
  return count() > before;
}

void Curve::mend() {
  const int n = static_cast<int>(points_.size());
  while (enter_gaps()) {
  }
  for (int k = 0; k < n; ++k) {
    if (stopped()) return;
    if (solved(k) || alone_[k] != 0 || (failed_from_[k] & kFromCold) != 0) continue;
    const Known found = cold(k);
    settle(k, found);
    while (found && enter_gaps()) {
    }
  }
}

}  // namespace shellback::study
