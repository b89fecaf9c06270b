#pragma once
/// What wears the shell: the wear load (seed 000 Eq. 9) and its stiffness.
///
///   L = |U| max(0, p_a - p_lim)                                        wear load [W/m2]      (1)
///   S = |U| |dp_a/dh| / (1 + tau |dp_a/dh|)   where p_a > p_lim        its stiffness [W/m3]  (2)
///
/// U: speed of the journal against the shell, in which a rotation of the frame is contained [m/s];
/// tau: compliance of the solids on the spot, which relieves a cell that has worn [m/Pa]. Over a
/// load cycle both are means over its time, by the trapezoid between the ends of its steps. Cells
/// are the shell's, which stands still in the film's frame. Source: textbook (Archard); S is ours.
#include "bearing/film/equilibrium.hpp"
#include "core/tape.hpp"

namespace shellback::bearing {

struct WearLoad {
  Field load;       ///< L of each cell [W/m2]
  Field stiffness;  ///< S [W/m3]
  void members(Tape& tape) { tape(load, stiffness); }
};

/// (1), (2) of one film; `limit`: p_lim [Pa].
[[nodiscard]] WearLoad wear_load_of(const BearingModel& model, const OperatingPoint& point,
                                    const FilmEquilibrium& film, double limit);

/// Their means over a cycle.
class MeanWearLoad {
 public:
  /// The load with which the cycle begins.
  void begin(WearLoad first);
  /// The load at the end of a step of dt [s].
  void add(WearLoad now, double dt);
  /// Of the time that was added, which is some.
  [[nodiscard]] WearLoad mean() const;
  void members(Tape& tape) { tape(now_, sum_, time_); }

 private:
  WearLoad now_;
  WearLoad sum_;  ///< integral over time
  double time_ = 0.0;
};

}  // namespace shellback::bearing
