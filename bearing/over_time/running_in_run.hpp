#pragma once
/// What a running-in (running_in.hpp) has found: states over time, the wear, the last solution.
#include <limits>
#include <optional>
#include <vector>

#include "bearing/instant.hpp"
#include "bearing/note.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/steady/solve.hpp"

namespace shellback::bearing {

/// One state on the way. Of a load cycle contact pressure and film are the extremes of the cycle,
/// friction is its mean.
struct RunningInState {
  double t = 0.0;               ///< since the start [s]
  double step = 0.0;            ///< length of the step that led here [s]
  double depth = 0.0;           ///< greatest wear [m]
  double volume = 0.0;          ///< worn away [m3]
  double p_asperity_max = 0.0;  ///< [Pa]
  double torque = 0.0;          ///< friction on the journal [N m]
  double h_min = 0.0;           ///< [m]
  int cycles = 0;               ///< that were passed for it
  /// What the steps so far have erred by their own estimates, each as much as is left of it.
  double depth_error = 0.0;   ///< [m]
  double volume_error = 0.0;  ///< [m3]
  bool anew = false;          ///< found from cold: the states that were followed before end here
};

/// What is followed of them, the length of their steps apart.
inline constexpr std::array kFollowedStates{
    Followed<RunningInState>{"wear_depth", "m", &RunningInState::depth},
    Followed<RunningInState>{"wear_volume", "m3", &RunningInState::volume},
    Followed<RunningInState>{"p_asperity_max", "Pa", &RunningInState::p_asperity_max},
    Followed<RunningInState>{"friction_torque", "N m", &RunningInState::torque},
    Followed<RunningInState>{"h_min", "m", &RunningInState::h_min}};

struct RunningInRun {
  std::vector<RunningInState> states;
  FilmGrid grid;                     ///< of `wear`, over the full bearing
  Field wear;                        ///< [m]
  Solution solution;                 ///< of the last state, under a standing load
  std::optional<CycleResult> cycle;  ///< of the last state, over a load cycle
  Verdict verdict;                   ///< not good: the last state is the last that was found
  /// Of (3): largest |min(w, h(p_a) - h(p_lim))|/sigma_s; not a number if it was not sought or no
  /// shape has a film [-].
  double complementarity = std::numeric_limits<double>::quiet_NaN();
  int rejected_steps = 0;
  std::vector<Note> warnings;  ///< of the wear itself
};

/// The wear as a table that a case takes as bearing.shape: positions of the cells and, continued
/// linearly, both side edges.
[[nodiscard]] Profile wear_table(const FilmGrid& full, const Field& wear);

/// The shell's surface where the wear is `depth` at its deepest [m]: between that of the case and
/// [running_in].worn in proportion, up to worn_after. Needs c.running_in.
[[nodiscard]] solid::RoughSurface worn_surface(const Case& c, double depth);

}  // namespace shellback::bearing
