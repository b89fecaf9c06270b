#pragma once
/// Running-in: the shell wears where it rubs until it no longer does.
///
///   dw/dt = r = (C/H) L,  L = <|U| max(0, p_a - p_lim)>   p_lim = 0: seed 000 Eq. 9 (Archard)  (1)
///
/// w: depth of wear of the shell, opening the gap [m]; C: wear coefficient [-]; H: hardness of
/// the shell [Pa]; L: wear load (wear_load.hpp) of a film under a load that stands still, or
/// mean over the periodic state of a load cycle [W/m2]; p_a: contact pressure [Pa]; p_lim: that at
/// which wear ceases, if one is given (our own: Archard knows none) [Pa]. The film, or the cycle,
/// is solved again for every shape. Wear takes pressure away from where it is: over a step of
/// length dt each cell follows the exponential that its own contact stiffness asks for, and what
/// that leaves of the rate is carried on in a straight line from the step before (exponential Adams
/// method of two steps, textbook),
///   w_n+1 = w_n + dt phi_1(-dt J) r_n + dt phi_2(-dt J) (dt/dt_before) (N_n - N_n-1)           (2)
///   N = r + J (w - w_n),   J = (C/H) S at t_n
///   phi_1(x) = (e^x - 1)/x,   phi_2(x) = (phi_1(x) - 1)/x
/// with S the stiffness of the wear load, solids included: the rest of the load moves elsewhere.
/// A cell cannot wear past where its pressure ends, so edges do not oscillate (of the straight line
/// the step's error sees to that). One solve makes one step, of second order; the first one is of
/// first order and short. Its error is judged by what the rate at its end says, N_n+1 in place of
/// the straight line; it bounds the next step's length, and a step that errs too much is taken
/// back. What has gone does not come back. Where the states that were followed end, however short
/// the step (heat may have two), it goes on from the one that is found from cold.
///
/// A shape at rest, in which nothing is pressed harder than p_lim:
///   w >= 0,  p_a <= p_lim,  w (p_lim - p_a) = 0 in every cell                                  (3)
/// solved for itself, without the way there; over a load cycle p_a is the largest of each cell in
/// the periodic state. Wear in time ends beside
/// it, a little deeper: a cell that has worn and is relieved later, by its neighbours or a smoother
/// surface, stays worn at less than p_lim. A load that only contact can carry has no such end.
///
/// The shaft does not wear (much harder, seed 000 4.2.1). The roughness moves from that of the case
/// to `worn` in proportion to the greatest depth. Units SI.
#include <functional>

#include "bearing/over_time/running_in_run.hpp"

namespace shellback::bearing {

/// Throws InputError where the case has no [running_in], or its tier solves no film.
void expect_running_in(const Case& c, Tier tier);

/// Runs the case in (its [running_in]) under its load or its load cycle, from the shape that it
/// has. `seen` is told every state that has been found. What lies between two shapes is kept where
/// `control` has a KeptRun, and gone on with from there to the same digits. Throws InputError where
/// the case has no [running_in], FileError where what was kept is not sound. `steps`: to be taken
/// as they are, whatever they err, instead of [running_in].duration [s].
[[nodiscard]] RunningInRun run_in(const Case& c, Tier tier, const SolveControl& control = {},
                                  const std::function<void(const RunningInRun&)>& seen = {},
                                  const std::vector<double>& steps = {});

}  // namespace shellback::bearing
