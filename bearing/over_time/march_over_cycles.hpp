#pragma once
/// Bodies in time, load cycles between: multirate steps.
///
/// Cycles are passed with walls that stay as they are until the film has followed them; then shell,
/// housing and shaft see the mean heat of the last one, and what the film answers to moving walls
/// cell by cell (film_answer.hpp), through a step of backward Euler, and so on. The step is halved
/// until no wall moves by more than is allowed, and after one that leaves the walls farther from
/// rest than it found them. What shell and shaft should have gathered over it,
///   dt N,   N = N0 (1 - exp(-x))/x,   x = N0/N1 - 1                                      (1)
/// N0, N1 what they gain from the cycles before and behind it less what they lose to the
/// surroundings, is known when the cycle behind it has been passed: the difference to what they
/// have gathered is made up for in the next step, evenly over the surface. (1) is the mean of heat
/// that dies away at the rate at which backward Euler would make N1 of N0: (N0 + N1)/2 in short
/// steps, N1 in long ones, where nothing is made up for. What is told of the end of a step is of a
/// cycle between the walls of then. The bearing is at rest where that cycle's heat, for ever, would
/// move no wall. Source: methods 3.5; (1) follows from 1/(1 + x) and exp(-x), textbook.
#include <cmath>
#include <functional>

#include "bearing/heat/heat_march.hpp"
#include "bearing/over_time/cycle_passes.hpp"

namespace shellback::bearing {

/// The bodies at one time: what a march leaves and the next one begins with.
struct Bodies {
  SolidState state;
  WallMeans walls;
};

/// (1); where it grows (N0 + N1)/2, its end where the ends are of different signs.
[[nodiscard]] double mean_that_dies_away(double begin, double end);

/// Shell, housing and shaft at one temperature [K].
[[nodiscard]] Bodies uniform_bodies(const Solids& solids, double T);

/// How far a march goes.
struct MarchSpan {
  double duration = std::numeric_limits<double>::infinity();  ///< [s]
  double shortest = 0.0;  ///< first step, taken however far walls move: a cycle [s]
  double longest = std::numeric_limits<double>::infinity();  ///< step [s]
  double move = 2.0;            ///< of a wall until a cycle is passed again [K]
  bool until_rest = true;       ///< ends early where the bearing is at rest
  std::vector<double> steps{};  ///< to be taken as they are [s]; empty: as far as walls move
};

/// Where a march stands between two steps: with the search all that the next step depends on.
struct CycleMarch {
  Bodies bodies;
  MarchEnd end{};   ///< so far
  double dt = 0.0;  ///< next step [s]; 0: the march begins
  /// By which the heat of the last cycle, for ever, would move a wall [K].
  double left = std::numeric_limits<double>::infinity();
  int rises = 0;             ///< of it, from one step to the next
  HeatTaken owed{};          ///< to the bodies, of the step before [J]
  HeatTaken lost{NAN, NAN};  ///< to the surroundings, at its end; not a number: none was [W]
};

/// Goes on with `march` under the cycle of `passes`, the first of which has been made. `tell` has
/// each instant, counted from the beginning of the march, as soon as `march` is there.
[[nodiscard]] MarchEnd march_over_cycles(CyclePasses& passes, const MarchSpan& span,
                                         CycleMarch& march,
                                         const std::function<void(const Instant&)>& tell);

}  // namespace shellback::bearing
