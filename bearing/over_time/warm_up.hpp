#pragma once
/// A bearing from one temperature everywhere to its steady state, in time.
///
/// Shell, housing and shaft start at a given temperature while oil, speed and load are those of the
/// case at once. Clearance, film and friction follow the walls (heat_march.hpp). Where the surfaces
/// seize on the way the time is told. At each instant
///   heat in (friction, pump) = heat out (oil, back, ends, overhangs) + heat stored      [W]
/// with what is stored in the film's oil, shell, housing and shaft.
#include "bearing/over_time/stretch.hpp"
#include "bearing/result.hpp"

namespace shellback::bearing {

/// |in - out - stored| over heat in of the instants from `first` up to `end`, taken together, over
/// cycles: an instant is that of the cycle at its end, and between two of them what is left of the
/// heat dies away (march_over_cycles.hpp) [-].
[[nodiscard]] double imbalance_over(const std::vector<Instant>& instants, std::size_t first,
                                    std::size_t end);

/// |in - out - stored| of an instant under a steady load over the larger of in and out [-].
[[nodiscard]] double imbalance_of(const Instant& i);

struct WarmUp {
  std::vector<Instant> instants;
  MarchEnd end;       ///< not good: the last instant was the last that had a film
  Solution solution;  ///< at the last instant
  /// Largest |in - out - stored| over heat in or out of all instants; over cycles that of the whole
  /// warm-up, whose instants end steps between two of them [-].
  [[nodiscard]] double imbalance() const;
};

/// Solves tier thd or tehd on the case's grid. A case with a load cycle is taken over many cycles:
/// one is passed with walls that stay as they are, then the bodies see its mean heat until a wall
/// has moved by 2 K, and so on; torque and heat of an instant are means of its cycle, the smallest
/// film and the largest temperatures those of the cycle. Throws InputError for other tiers and for
/// single events.
[[nodiscard]] WarmUp warm_up(const Case& c, Tier tier, const WarmUpOptions& options,
                             const SolveControl& control = {});

/// Where the film leaves the temperatures of its oil, and whether the walls came to rest in another
/// state than `steady`, the steady or periodic one of the same case on the same grid: beyond its
/// bars of friction torque and largest film temperature. Nothing of what is not known.
[[nodiscard]] std::vector<Note> warm_up_warnings(const rheology::Oil& oil, const WarmUp& run,
                                                 const Result& steady);

}  // namespace shellback::bearing
