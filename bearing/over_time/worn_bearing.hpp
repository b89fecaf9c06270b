#pragma once
/// A bearing whose shell has worn: solved anew, warm, for every shape.
///
/// Under a load that stands still its state is one film; over a load cycle it is the periodic
/// state of the cycle (CycleSearch::follow), and what wears the shell its mean. Wear is that of the
/// cells of the solved grid.
#include <memory>

#include "bearing/over_time/running_in_run.hpp"
#include "bearing/over_time/wear_load.hpp"
#include "core/tape.hpp"

namespace shellback::bearing {

class WornBearing {
 public:
  virtual ~WornBearing() = default;
  /// Of the new bearing.
  [[nodiscard]] virtual const Verdict& verdict() const = 0;
  [[nodiscard]] virtual const BearingModel& model() const = 0;
  [[nodiscard]] virtual WearLoad load() const = 0;
  /// Largest contact pressure of each cell [Pa] and its smallest gap [m].
  [[nodiscard]] virtual const Field& contact() const = 0;
  [[nodiscard]] virtual const Field& gap() const = 0;
  /// Of the last good solution [m].
  [[nodiscard]] virtual const Field& wear() const = 0;
  /// Solves with this wear [m]; steady heat until it moves the gap by less than `within` [m], if
  /// that is less than a result asks for. False: no solution; the last good one stays.
  [[nodiscard]] virtual bool wear_to(const Field& wear, double within, Verdict& why) = 0;
  /// The same from cold, whatever the last solution: another state of that shape may be found.
  [[nodiscard]] virtual bool wear_from_cold(const Field& wear, Verdict& why) = 0;
  /// To the state before the last wear_to that was good; once.
  virtual void go_back() = 0;
  /// Contact pressure, friction and film of the state; the solution itself.
  virtual void tell(RunningInState& state, RunningInRun& run) const = 0;
  /// All that the next shape starts from.
  virtual void keep(Tape& tape) = 0;
};

/// Solves the new bearing, from cold. `control` must outlive it.
[[nodiscard]] std::unique_ptr<WornBearing> new_bearing(const Case& c, Tier tier,
                                                       const SolveControl& control);

/// As keep() has left it on a tape.
[[nodiscard]] std::unique_ptr<WornBearing> kept_bearing(const Case& c, Tier tier,
                                                        const SolveControl& control, Tape& tape);

}  // namespace shellback::bearing
