#pragma once
/// Film and walls in time, with the heat capacities of oil, shell, housing and shaft.
///
/// Flow and pressure are steady at each instant (oil passes within milliseconds, walls follow
/// within seconds to minutes). A step dt of SDIRK2 (core/tableau.hpp), of second order and stiffly
/// accurate, has two stages of g dt, g = 1 - 1/sqrt(2), each of them a backward Euler step that the
/// outer iteration of the steady bearing solves with the walls' storage in it: the first from the
/// state T_n of bodies and oil, the second from
///   T* = T_n + (1 - g)/g (T_1 - T_n)                                                     (1)
/// Heat made, given away and stored are told as means over the step, (1 - g) of the first stage and
/// g of the second: what is stored is the change of what the bodies hold. dt is chosen so that the
/// walls are nowhere farther than a given amount from T_n + (T_1 - T_n)/g, the first stage
/// carried on in a straight line; the shortest steps, in which hot oil may first meet a cold wall,
/// are of backward Euler, which does not overshoot. Without such an amount steps of backward Euler
/// grow as long as they are found, and the march is but a way to the steady state (pseudo-transient
/// continuation). Source: textbook.
#include <functional>
#include <limits>

#include "bearing/heat/heat_iteration.hpp"
#include "bearing/instant.hpp"
#include "bearing/note.hpp"

namespace shellback::bearing {

/// A step of a third of a year: what still moves never rests, and a march that began anywhere is at
/// its steady state [s].
inline constexpr double kEndless = 1e7;

struct MarchOptions {
  double first = 0.1;                                      ///< step [s]
  double shortest = 1e-4;                                  ///< below which there is no way on [s]
  double end = std::numeric_limits<double>::infinity();    ///< [s]
  double error = std::numeric_limits<double>::infinity();  ///< of wall temperatures per step [K]
  std::vector<double> steps{};  ///< to be taken as they are [s]; empty: by their error
  ThermalOptions heat;
};

/// How a march ended.
struct MarchEnd {
  Verdict verdict;  ///< good: it came to its end, or to rest
  double t = 0.0;   ///< of the last instant [s]
  bool at_rest = false;
  /// It ended because no film is left: a clearance used up, a bound of the equations, smooth
  /// surfaces nearer than a molecule, or so near that ten of the shortest steps bring them
  /// together, or rough ones pressed beyond the contact law. A step that was merely not found
  /// leaves no bound.
  bool left_bounds = false;
  /// Steps of the shortest length that erred by more than was allowed: where hot oil first meets a
  /// cold wall its surface jumps, however short the step.
  int jumps = 0;
  /// Instants over cycles whose film had not followed its walls yet: their bodies see too little
  /// heat.
  int unfollowed = 0;
  /// What the film of the last instant, or cycle, says of itself; the case's own apart.
  std::vector<Note> warnings{};
};

/// Where a march stands between two steps: with film and heat all that the next step depends on.
struct MarchStand {
  static constexpr int kCalm = 3;  ///< steps before one that was rejected is tried as long again
  /// How fast walls and smallest film change.
  struct Rate {
    Field shell;                ///< [K/s]; empty: not known
    std::vector<double> shaft;  ///< [K/s]
    double h_min = 0.0;         ///< [m/s]
  };

  SolidState bodies;
  MarchEnd end{};    ///< so far
  double dt = 0.0;   ///< next step [s]; 0: the march begins
  int calm = kCalm;  ///< steps since one was rejected
  Rate rate{};       ///< over the last step
};

/// Marches `s` on from its film and heat; `stand` is left at the last instant. `tell` has each
/// instant as soon as `stand` is there.
[[nodiscard]] MarchEnd march_heat(Solution& s, MarchStand& stand, const MarchOptions& options,
                                  const SolveControl& control,
                                  const std::function<void(const Instant&)>& tell = {});

/// Puts what bodies and film hold and give away into an instant: all but what is the film's alone.
/// `films`: factor of the film's balance, its multiplicity, over the time if it is a sum [-],
/// [1/s].
void tell_bodies(const FilmGrid& g, const SolidTemperature& solids,
                 const thermal::EnergyBalance& film, double films, const Field& deformation,
                 Instant& i);

/// The bearing as it stands, after a step.
[[nodiscard]] Instant instant_of(const Solution& s, double t, double dt);

/// Where the film of a march leaves the temperatures of its oil.
[[nodiscard]] std::vector<Note> march_warnings(const rheology::Oil& oil,
                                               const std::vector<Instant>& instants);

}  // namespace shellback::bearing
