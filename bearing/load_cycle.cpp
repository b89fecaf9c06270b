#include "bearing/load_cycle.hpp"

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

/// Straight line between two values.
double between(double a, double b, double part) { return a + part * (b - a); }

bool spline_can_be_laid(const LoadCycle& c) {
  const std::size_t n = c.t.size();
  const bool rising = std::adjacent_find(c.t.begin(), c.t.end(),
                                         [](double a, double b) { return !(b > a); }) == c.t.end();
  return c.interpolation == LoadInterpolation::periodic_spline && c.repeats() && n >= 3 && rising &&
         c.t.front() == 0.0 && c.t.back() < c.period && c.x.size() == n && c.y.size() == n &&
         (c.omega.empty() || c.omega.size() == n);
}

}  // namespace

LoadCycle as_lines(const LoadCycle& cycle) {
  if (!spline_can_be_laid(cycle)) return cycle;
  const LoadCourse course(cycle, 0.0);
  LoadCycle lines = cycle;
  lines.interpolation = LoadInterpolation::linear;
  for (auto* column : {&lines.t, &lines.x, &lines.y, &lines.omega}) column->clear();
  for (std::size_t k = 0; k < cycle.t.size(); ++k) {
    const double next = k + 1 < cycle.t.size() ? cycle.t[k + 1] : cycle.period;
    for (std::size_t i = 0; i < kLinesOfSpline; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(kLinesOfSpline);
      const double t = between(cycle.t[k], next, part);
      const LoadNow now = course.at(t);
      lines.t.push_back(t);
      lines.x.push_back(i == 0 ? cycle.x[k] : now.x);
      lines.y.push_back(i == 0 ? cycle.y[k] : now.y);
      if (!cycle.omega.empty()) lines.omega.push_back(now.omega);
    }
  }
  return lines;
}

struct LoadCourse::Splines {
  struct Free {
    void operator()(gsl_spline* s) const { gsl_spline_free(s); }
  };
  using Spline = std::unique_ptr<gsl_spline, Free>;
  Spline x, y, omega;

  /// Periodic through `y` at `t`, whose last value is that of the first.
  static Spline through(const std::vector<double>& t, const std::vector<double>& y) {
    Spline s(gsl_spline_alloc(gsl_interp_cspline_periodic, t.size()));
    gsl_spline_init(s.get(), t.data(), y.data(), t.size());
    return s;
  }
};

LoadCourse::LoadCourse(const LoadCycle& cycle, double omega, double slow) : cycle_(cycle) {
  EXPECTS(cycle_.t.size() >= 2 && cycle_.x.size() == cycle_.t.size() &&
          cycle_.y.size() == cycle_.t.size());
  length_ = cycle_.length();
  if (!cycle_.repeats()) {
    const double first = cycle_.t.front();
    for (double& t : cycle_.t) t -= first;
  }
  if (cycle_.omega.empty()) cycle_.omega.assign(cycle_.t.size(), omega);
  if (cycle_.repeats()) {  // the first row once more, a period later
    cycle_.t.push_back(cycle_.t.front() + cycle_.period);
    for (auto* v : {&cycle_.x, &cycle_.y, &cycle_.omega}) v->push_back(v->front());
  }
  for (std::size_t k = 0; k < cycle_.t.size(); ++k) {
    largest_load_ = std::max(largest_load_, std::hypot(cycle_.x[k], cycle_.y[k]));
    largest_speed_ = std::max(largest_speed_, std::abs(cycle_.omega[k]));
  }
  if (cycle_.interpolation == LoadInterpolation::periodic_spline) {
    splines_ = std::make_shared<const Splines>(Splines{Splines::through(cycle_.t, cycle_.x),
                                                       Splines::through(cycle_.t, cycle_.y),
                                                       Splines::through(cycle_.t, cycle_.omega)});
    for (std::size_t k = 0; k + 1 < cycle_.t.size(); ++k) {
      for (std::size_t i = 1; i < kLinesOfSpline; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(kLinesOfSpline);
        const LoadNow now = at(between(cycle_.t[k], cycle_.t[k + 1], part));
        largest_load_ = std::max(largest_load_, std::hypot(now.x, now.y));
        largest_speed_ = std::max(largest_speed_, std::abs(now.omega));
      }
    }
  }
  find_corners();
  if (slow > 0.0) find_rests(slow);
}

/// Time within the rows, of an event held at its ends.
double LoadCourse::within_period(double t) const {
  const double first = cycle_.t.front();
  if (!cycle_.repeats()) return std::clamp(t, first, cycle_.t.back());
  const double since = std::fmod(t - first, cycle_.period);
  return first + (since < 0.0 ? since + cycle_.period : since);
}

LoadNow LoadCourse::at(double t, bool before_jump) const {
  const double at = within_period(before_jump ? t - kRoundOff * length_ : t);
  if (splines_) {
    return {gsl_spline_eval(splines_->x.get(), at, nullptr),
            gsl_spline_eval(splines_->y.get(), at, nullptr),
            gsl_spline_eval(splines_->omega.get(), at, nullptr)};
  }
  const auto& T = cycle_.t;
  // Before an event's first row it stands, whatever follows it at once.
  const bool before = !cycle_.repeats() && (t < T.front() || (before_jump && t <= T.front()));
  if (before) return {cycle_.x.front(), cycle_.y.front(), cycle_.omega.front()};
  const auto above = std::upper_bound(T.begin(), T.end(), at);
  const auto k = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - T.begin(), 1, static_cast<std::ptrdiff_t>(T.size()) - 1));
  const double line = T[k] - T[k - 1];
  const double part = line > 0.0 ? std::clamp((at - T[k - 1]) / line, 0.0, 1.0) : 1.0;
  return {between(cycle_.x[k - 1], cycle_.x[k], part), between(cycle_.y[k - 1], cycle_.y[k], part),
          between(cycle_.omega[k - 1], cycle_.omega[k], part)};
}

double LoadCourse::turned_within(double t) const {
  const auto& T = cycle_.t;
  const auto& w = cycle_.omega;
  if (splines_) return gsl_spline_eval_integ(splines_->omega.get(), T.front(), t, nullptr);
  double sum = 0.0;
  for (std::size_t k = 1; k < T.size() && T[k - 1] < t; ++k) {
    const double line = T[k] - T[k - 1];
    const double part = std::min((t - T[k - 1]) / line, 1.0);
    sum += part * line * 0.5 * (w[k - 1] + between(w[k - 1], w[k], part));
  }
  return sum;
}

LoadStretch LoadCourse::heavy_stretch(
    const std::function<bool(const LoadNow&, const LoadNow&, double)>& holds) const {
  constexpr int kParts = 720;
  constexpr double kHeavy = 0.5;  // of the largest load: under less the film is not its smallest
  const double dt = length_ / kParts;
  const int parts = (repeats() ? 2 : 1) * kParts;
  LoadStretch now, longest;
  now.always = true;
  for (int k = 0; k < parts; ++k) {
    const LoadNow from = at(k % kParts * dt), to = at((k % kParts + 1) * dt, true);
    now.last = {0.5 * (from.x + to.x), 0.5 * (from.y + to.y), 0.5 * (from.omega + to.omega)};
    const bool heavy = std::hypot(now.last.x, now.last.y) > kHeavy * largest_load_;
    const bool in = heavy && holds(from, to, dt);
    now.always = now.always && in;
    now.turned = in ? now.turned + std::abs(now.last.omega) * dt : 0.0;
    if (in && now.turned >= longest.turned) longest = now;
  }
  longest.always = now.always;
  return longest;
}

double LoadCourse::turned(double t) const {
  const double held = cycle_.repeats() ? 0.0 : std::max(t - length_, 0.0) * cycle_.omega.back();
  return turned_within(within_period(t)) - turned_within(within_period(0.0)) + held;
}

/// Every row is a corner of straight lines; rows at one time are a jump. A spline, which is smooth,
/// is judged as if it were lines between its rows: what it does within a long step is seen there.
void LoadCourse::find_corners() {
  const auto& T = cycle_.t;
  const std::size_t n = T.size();
  const auto slope = [&](std::size_t k) {  // of the line that begins in row k
    const double dt = T[k + 1] - T[k];
    const auto of = [&](const std::vector<double>& v, double unit) {
      return unit > 0.0 ? (v[k + 1] - v[k]) / dt / unit : 0.0;
    };
    return std::array{of(cycle_.x, largest_load_), of(cycle_.y, largest_load_),
                      of(cycle_.omega, largest_speed_)};
  };
  for (std::size_t k = 0; k + 1 < n; ++k) {
    if (T[k + 1] <= T[k]) {
      corners_.push_back({T[k], true, INFINITY});
      continue;
    }
    const bool jumped = k > 0 && T[k] <= T[k - 1];
    const bool first = k == 0;
    if (jumped || (first && !cycle_.repeats())) continue;
    const std::size_t last = first ? n - 2 : k - 1;
    if (T[last + 1] <= T[last]) continue;  // the jump is at the end of the period
    const auto a = slope(last);
    const auto b = slope(k);
    corners_.push_back({T[k], false, std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2])});
  }
}

void LoadCourse::find_rests(double slow) {
  std::vector<double> times = cycle_.t, speeds = cycle_.omega;
  if (splines_) {
    times.clear();
    speeds.clear();
    for (std::size_t k = 0; k + 1 < cycle_.t.size(); ++k) {
      for (std::size_t i = 0; i < kLinesOfSpline; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(kLinesOfSpline);
        times.push_back(between(cycle_.t[k], cycle_.t[k + 1], part));
        speeds.push_back(at(times.back()).omega);
      }
    }
    times.push_back(cycle_.t.back());
    speeds.push_back(speeds.front());
  }
  // Between its corners friction turns as tanh 3x: straight lines between these miss 0.6 % of it.
  constexpr double kParts[]{1.0 / 12, 1.0 / 6, 0.25, 1.0 / 3, 0.5, 2.0 / 3};
  constexpr double kBrief = 1e-3;  // of the whole: what friction misses there shows in no mean
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const double a = speeds[k];
    const double b = speeds[k + 1];
    std::vector<double> looked{-slow, 0.0, slow};
    if (2.0 * slow * (times[k + 1] - times[k]) > kBrief * length_ * std::abs(b - a)) {
      for (const double part : kParts) looked.insert(looked.end(), {-part * slow, part * slow});
    }
    for (const double at : looked) {
      if (a == b || (a - at) * (b - at) > 0.0) continue;
      const double t = between(times[k], times[k + 1], (at - a) / (b - a));
      // Behind the last row the next period may have begun.
      corners_.push_back({repeats() && t >= length_ ? t - length_ : t, false, INFINITY});
    }
  }
  std::stable_sort(corners_.begin(), corners_.end(),
                   [](const LoadCorner& a, const LoadCorner& b) { return a.t < b.t; });
}

std::array<double, 2> LoadCourse::impulse() const {
  constexpr double kPieces = 4000.0;  // over the whole: a spline is then known to 1e-9
  std::vector<double> ends{0.0, length_};
  for (const LoadCorner& c : corners_) {
    if (c.t > 0.0 && c.t < length_) ends.push_back(c.t);
  }
  std::sort(ends.begin(), ends.end());
  std::array<double, 2> sum{};
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const double line = ends[k] - ends[k - 1];
    const int n = 1 + static_cast<int>(kPieces * line / length_);
    for (int i = 0; i < n; ++i) {
      const double dt = line / n;
      const double t = ends[k - 1] + i * dt;
      const LoadNow a = at(t);
      const LoadNow m = at(t + 0.5 * dt);
      const LoadNow b = at(t + dt, true);
      sum[0] += dt / 6.0 * (a.x + 4.0 * m.x + b.x);
      sum[1] += dt / 6.0 * (a.y + 4.0 * m.y + b.y);
    }
  }
  return sum;
}

}  // namespace shellback::bearing
