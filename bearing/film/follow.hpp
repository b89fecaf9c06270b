#pragma once
/// The branch of steady states over one number of the operating point, through turning points.
///
/// Predictor: the secant of the last two states, with temperatures, growth and displacement.
/// Corrector: the steady equations, along a load with its factor unknown and the length of the path
/// given (operating_point.hpp (4): pseudo-arclength), along a speed at the speed predicted. A path
/// is measured in the journal's place and ln load: in its place among the surfaces, where the
/// beginning of the path moves along as they grow (film_motion.hpp (1)), or in space. Measured in
/// space, a clearance that heat closes moves the journal more than its load does, and what lies a
/// given way off is another load as soon as the surfaces have followed; among the surfaces, journal
/// and load stand still where heat makes the branch turn. A step that fails is repeated, shorter,
/// in the other measure. The step grows where a state is found and shrinks where none is, or one
/// that does not continue the branch; where the load falls in a short step the branch has turned:
/// more is not carried on it. Source: textbook (Keller's pseudo-arclength continuation, control of
/// the angle); the measures are our own (docs/decisions/054).
#include <array>
#include <functional>
#include <optional>
#include <span>

#include "bearing/control.hpp"
#include "bearing/film/solution.hpp"

namespace shellback::bearing {

/// Solves the steady state of `s.point` in `s.model` from the state that `s` holds, to the
/// accuracy of a way point or of a result.
enum class Accuracy { way_point, result };
using Corrector = std::function<Verdict(Solution& s, Accuracy accuracy)>;

using ending::BranchEnd;

/// Parts of load or speed from which a branch may begin, the first that is found [-].
inline constexpr std::array kLight{0.3, 0.1, 0.02, 2e-3, 2e-4};
/// Parts of the load from which one may begin that none from a light load leads to [-]: oil that
/// lifts the journal from below ends that one where the journal comes down, on a thin film of its
/// own (docs/decisions/049).
inline constexpr std::array kHeavy{2.0, 5.0};
/// Two ends of a branch that are nearer than this are one [-].
inline constexpr double kAgree = 0.1;
/// An end at this part of what is asked for tells of it: it lies more than that before it.
[[nodiscard]] inline bool is_apart_from_asked(double part) { return (1.0 + kAgree) * part < 1.0; }

using ending::Raised;

struct Branch {
  Raised raised = Raised::load;
  BranchEnd end = BranchEnd::lost;
  double carried = 0.0;  ///< part of what is raised that was reached [-]
  double h_min = 0.0;    ///< there [m]
  Verdict last;          ///< of the corrector where it failed
};

/// Follows the branch of `s`, a state at the part `begun` of the load (of `s.point`), to the whole
/// load; `s` is left at the solution or at the last state of the branch.
[[nodiscard]] Branch follow_load(Solution& s, double begun, const Corrector& correct,
                                 const SolveControl& control);

/// The same over the speed, or over a load from a heavier one: each state at the part predicted,
/// from the one before.
[[nodiscard]] Branch follow_parts(Solution& s, Raised raised, double begun,
                                  const Corrector& correct, const SolveControl& control);

/// Gives the operating point a part of its load, its speed or its supplies' pressures, or the film
/// one of its place.
class Part {
 public:
  Part(Solution& s, Raised raised);
  void take(double part);

 private:
  Solution& s_;
  Raised raised_;
  fluid::Wrench force_;
  double speed_;
  std::vector<double> pressure_;  ///< of each patch, gauge [Pa]
  std::array<double, 4> place_;
};

/// From the first of `parts` at which `start` finds a state, along load or speed to the whole; none
/// if it finds no state at any.
[[nodiscard]] std::optional<Branch> follow_from(Solution& s, Raised raised,
                                                std::span<const double> parts,
                                                const std::function<Verdict()>& start,
                                                const Corrector& correct,
                                                const SolveControl& control);

/// From a light load; where that branch turns or is lost, or none begins, from a heavy one. What
/// ends is the branch from the light load, at whose last state `s` is left.
[[nodiscard]] std::optional<Branch> follow_loads(Solution& s, const std::function<Verdict()>& start,
                                                 const Corrector& correct,
                                                 const SolveControl& control);

/// True if a branch was followed on the grid of `s` itself: its limit is the last of `s.limits`.
[[nodiscard]] bool has_own_limit(const Solution& s);

/// Notes in `s.limits` where a branch has ended.
void note_limit(Solution& s, const Branch& branch, bool proven);

}  // namespace shellback::bearing
