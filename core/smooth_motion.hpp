#pragma once
/// y' = f(t, y) for two unknowns, by SUNDIALS' CVODE (BDF of order 1 to 5, Newton with a dense
/// difference Jacobian): for right sides that are smooth between the instants it is told.
///
/// The error of a step is measured against a size that the caller gives with each state. A state
/// that the caller refuses is tried again with a shorter step.
#include <array>
#include <functional>
#include <limits>
#include <memory>

namespace shellback {

using Pair = std::array<double, 2>;

struct Motion {
  /// f at t; false: y is no possible state.
  std::function<bool(double t, const Pair& y, Pair& rate)> rate;
  /// Size against which errors of y count, positive.
  std::function<double(const Pair& y)> size;
  double tolerance = 1e-5;                                   ///< of a step, over the size [-]
  double longest = std::numeric_limits<double>::infinity();  ///< step [unit of t]
};

class SmoothMotion {
 public:
  /// `motion` must outlive this.
  explicit SmoothMotion(const Motion& motion);
  ~SmoothMotion();
  SmoothMotion(const SmoothMotion&) = delete;
  SmoothMotion& operator=(const SmoothMotion&) = delete;

  /// Begins at (t, y), forgetting what was before: at the start and behind a jump of f.
  void begin(double t, const Pair& y);
  /// No step beyond this t, from here on.
  void stop_at(double t);
  /// The state at `t`, between two steps that of CVODE's own polynomial; false: it does not get
  /// there.
  [[nodiscard]] bool go_to(double t);
  [[nodiscard]] const Pair& now() const;
  /// Steps so far, and those that were tried in vain.
  [[nodiscard]] long steps() const;
  [[nodiscard]] long rejected() const;

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace shellback
