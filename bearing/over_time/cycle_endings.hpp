#pragma once
/// When a search for a periodic state has come to its end.
#include <cmath>

#include "core/outcome.hpp"

namespace shellback::bearing {

/// Two cycles that agree so well are one, of smallest film and torque [-].
inline constexpr double kClosed = 1e-4;
/// Cycles of a search: starved films gather their oil over a hundred.
inline constexpr int kMostCycles = 300;

/// How cycles draw near to the periodic state: where the change falls by the ratio rho from cycle
/// to cycle, rho/(1 - rho) of the last one is still to come. With three differences rho is that of
/// two cycles, as changes that swing are large and small in turn, or that of the last one,
/// whichever is more; with fewer, as much as the last difference may be to come at least.
struct Closure {
  double last = NAN;     ///< difference of the last two cycles [-]
  double before = NAN;   ///< of the two before [-]
  double earlier = NAN;  ///< and before those [-]
  double rate = 0.0;     ///< least rho that is counted on [-]
  void add(double difference);
  /// The next cycle begins with what these lead to: its difference from the last one says nothing,
  /// but what is still wrong dies out no faster than before.
  void lead_on();
  /// What separates the last cycle from the periodic state [-].
  [[nodiscard]] double left() const;
  [[nodiscard]] bool closed() const { return left() <= kClosed; }
};

/// The same from two cycles that differ by `apart` [-] and lie `cycles` apart: with the slowest
/// rate that is counted on, and no slower one is, no more than apart rho/(1 - rho)/cycles is still
/// to come. Cycles whose steps are chosen anew differ by chance, which does not add up.
[[nodiscard]] double left_after(double apart, int cycles);
/// Cycles from which on that counts.
inline constexpr int kApart = 16;

/// A step that was not found because of `v`, at `where` of the cycle.
[[nodiscard]] Verdict at_instant(Verdict v, const ending::NoStep& where);

}  // namespace shellback::bearing
