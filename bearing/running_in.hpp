#pragma once
/// Running-in: the shell wears where it rubs until it no longer does.
///
///   dw/dt = (C/H) |U| max(0, p_a - p_lim)          p_lim = 0: seed 000 Eq. 9 (Archard)        (1)
///
/// w: depth of wear of the shell, opening the gap [m]; C: wear coefficient [-]; H: hardness of the
/// softer surface [Pa]; p_a: contact pressure [Pa]; U: sliding speed [m/s]; p_lim: contact pressure
/// at which wear ceases, if one is given (our own: Archard knows none) [Pa]. The film is solved
/// again for every shape. Wear takes pressure away from where it is: over a step of length dt each
/// cell follows the exponential that its own contact stiffness asks for (exponential Euler,
/// textbook),
///   w_1 = w_0 + dt phi_1(-dt J) (C/H) p_a |U|,   phi_1(x) = (e^x - 1)/x
///   J = (C/H) |U| |dp_a/dh| / (1 + tau |dp_a/dh|)                                              (2)
/// with tau the solids' local compliance: the rest of the load moves elsewhere. Cells cannot
/// overshoot however long the step is, so edges do not oscillate. Each step is done whole and in
/// halves: their difference bounds its length and is taken off once more (local extrapolation,
/// textbook), which leaves errors of second order in it; what has gone does not come back.
///
/// A shape at rest, in which nothing is pressed harder than p_lim:
///   w >= 0,  p_a <= p_lim,  w (p_lim - p_a) = 0 in every cell                                  (3)
/// solved for itself, without the way there. Wear in time ends beside it, a little deeper:
/// a cell that has worn and is relieved later, by its neighbours or a smoother surface, stays worn
/// at less than p_lim. A load that only contact can carry has no such end.
///
/// The shaft does not wear (much harder, seed 000 4.2.1). The roughness moves from that of the case
/// to `worn` in proportion to the greatest depth. Units SI.
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "bearing/solve.hpp"

namespace shellback::bearing {

/// One state on the way.
struct RunningInState {
  double t = 0.0;               ///< since the start [s]
  double step = 0.0;            ///< length of the step that led here [s]
  double depth = 0.0;           ///< greatest wear [m]
  double volume = 0.0;          ///< worn away [m3]
  double p_asperity_max = 0.0;  ///< [Pa]
  double torque = 0.0;          ///< friction on the journal [N m]
  double h_min = 0.0;           ///< [m]
};

struct RunningInRun {
  std::vector<RunningInState> states;
  FilmGrid grid;      ///< of `wear`, over the full bearing
  Field wear;         ///< [m]
  Solution solution;  ///< of the last state
  Verdict verdict;    ///< not good: the last state is the last that was found
  /// Of (3): largest |min(w, h(p_a) - h(p_lim))|/sigma_s; not a number if it was not sought or no
  /// shape has a film [-].
  double complementarity = std::numeric_limits<double>::quiet_NaN();
  int rejected_steps = 0;
};

/// H of (1): as [running_in] has it, else of the shell's first layer; 0: not known [Pa].
[[nodiscard]] double hardness_of_shell(const Case& c);

/// Runs the case in (its [running_in]) under its load, from the shape that it has. `seen` is told
/// every state that has been found. Throws InputError where the case has no [running_in].
[[nodiscard]] RunningInRun run_in(const Case& c, Tier tier, const SolveControl& control = {},
                                  const std::function<void(const RunningInRun&)>& seen = {});

/// The wear as a table that a case takes as bearing.shape: positions of the cells and, continued
/// linearly, both side edges.
[[nodiscard]] Profile wear_table(const FilmGrid& full, const Field& wear);

}  // namespace shellback::bearing
