#pragma once
/// Wear in time: the march of a worn bearing by (1), (2) of running_in.hpp.
#include <functional>
#include <optional>

#include "bearing/over_time/running_in_states.hpp"

namespace shellback::bearing {

/// Wear, what wears it and how much less it will with more of it, at one time.
struct WearPoint {
  Field w;  ///< [m]
  Field r;  ///< (1) [m/s]
  Field J;  ///< (2) [1/s]
};

/// (1) up to a time; steps as long as their error allows.
class WearMarch {
 public:
  /// On from what `control` has kept, if it has. All but the case must outlive it.
  WearMarch(WornBearing& b, const Case& c, const SolveControl& control,
            const std::function<void(const RunningInRun&)>& seen, RunningInRun& run);

  /// Up to a time [s].
  void to(double end);
  /// In these steps [s], whatever they err.
  void through(const std::vector<double>& steps);
  void members(Tape& tape) { tape(unit_, t_, dt_, first_, past_, before_, failing_); }

 private:
  enum class From { last, cold };
  /// Tries a step; false, and back where it began, if it is not found or errs too much for `most`
  /// times what is allowed, or if, from cold, another state is found and `most` is finite.
  bool take(double dt, double most = 1.0, From from = From::last);
  /// The same; where none is found for the first time, from cold, too: the last film may have been
  /// no start.
  bool advance(double dt);
  /// The same from cold; where it is not found, for the reason of before.
  bool take_from_cold(double dt, double most);
  /// Error of a step's wear [m].
  [[nodiscard]] double allowed(const Field& w) const;
  /// A step that wears a tenth of a summit where it wears most [s].
  [[nodiscard]] double first_step() const;
  /// The first step's length; false if nothing rubs, for however long.
  bool begin(double end);
  /// Depths are allowed to err by more than a step wears that is not found: for its length it is
  /// not.
  [[nodiscard]] bool shorter_may_be_found() const;
  /// Where the states that were followed end: goes on, dt later, from the one found from cold.
  /// False: there is none, or the last one was found so, or it is not for want of states that no
  /// step is good.
  bool begin_anew(double dt);
  /// No step is short enough.
  void end_too_short();
  /// From outside; where it is, is kept.
  void stop();

  WornBearing& b_;
  const SolveControl& control_;
  const std::function<void(const RunningInRun&)>& seen_;
  RunningInRun& run_;
  double per_load_;  ///< C/H [1/Pa]
  double unit_;      ///< summit roughness of the new surfaces [m]
  double t_ = 0.0;
  double dt_ = 0.0;     ///< length of the next step [s]
  double first_ = 0.0;  ///< of the first one; 0: there was none [s]
  double past_ = 0.0;   ///< of the last one [s]
  WearPoint now_;
  std::optional<WearPoint> before_;
  double depth_ = 0.0;    ///< wear of the last step tried, at most [m]
  StepError error_;       ///< what it errs
  double over_ = 0.0;     ///< its error over the one that is allowed [-]
  bool found_ = true;     ///< it was found
  bool failing_ = false;  ///< from cold none was found near the last good one
  Verdict why_;           ///< not
};

}  // namespace shellback::bearing
