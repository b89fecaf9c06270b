#pragma once
/// Steps in time through one period of a load course.
///
/// A step is as long as its estimated error of the loaded film allows, ends on jumps and on corners
/// of the load that it would feel, and is repeated shorter where it is not found. A further period
/// takes the steps of the one before again, so that two periods can be compared.
#include <functional>

#include "bearing/control.hpp"
#include "bearing/over_time/film_step.hpp"
#include "core/tape.hpp"

namespace shellback::bearing {

struct StepOptions {
  double error = 1e-3;      ///< allowed, of the loaded film in one step [-]
  double longest = 0.0;     ///< [s]
  double shortest = 0.0;    ///< below which there is no way on [s]
  double after_jump = 0.0;  ///< first step behind a jump, and from rest [s]
  double fixed = 0.0;  ///< of this length, whatever its error, less before a corner, and where less
                       ///< than two are left [s]; 0: chosen by `error`
};

/// How a period was passed.
struct PeriodEnd {
  Verdict verdict;
  int accepted = 0;
  int rejected = 0;
  int over = 0;  ///< steps that err by more than one and a half times what is allowed: given ones,
                 ///< or of the shortest length
};

/// Called with every accepted step and its length [s].
using TellStep = std::function<void(const FilmStep&, double dt)>;

class CycleSteps {
 public:
  CycleSteps(FilmSteps& film, const LoadCourse& course, double length, const StepOptions& options);

  /// From `now` over one period, or on through one that a tape has brought back. `landed` is
  /// called where `now` has come to stand at the end of a step.
  [[nodiscard]] PeriodEnd pass(FilmInTime& now, EquilibriumCost& cost, const SolveControl& control,
                               const TellStep& tell, const std::function<void()>& landed);
  /// The next period takes the steps of the one that `other` has passed last.
  void repeat(const CycleSteps& other);
  /// For a tape: where the period stands after its last step.
  void members(Tape& tape);
  /// The period that a tape has brought back was not passed to its end: the next pass goes on.
  void go_on() { brought_back_ = true; }

 private:
  /// The next corner that a step of dt would feel, or the end of the period.
  [[nodiscard]] double next_corner(double since, double dt) const;
  /// Where the step that begins at `since` (within the period) and may be `dt` long ends.
  [[nodiscard]] double end_of_step(double since, double dt) const;
  [[nodiscard]] bool switched_at(double since) const;
  [[nodiscard]] double begin_with(bool switched) const;
  [[nodiscard]] bool jump_at(double since) const;
  /// Length of the next step, or of the next attempt.
  [[nodiscard]] double length_for(const FilmStep& step, double dt, bool anew) const;
  /// The step that begins at `since`, shortened until it is found and errs little enough.
  [[nodiscard]] FilmStep find(double since, const FilmInTime& now, double& end, PeriodEnd& out,
                              EquilibriumCost& cost, const SolveControl& control);
  /// The step that ends at `end` is taken.
  void accept(double end, FilmInTime& now, FilmStep& step, const TellStep& tell);

  FilmSteps& film_;
  double length_;
  StepOptions options_;
  std::vector<LoadCorner> corners_;  ///< within the period
  std::vector<double> ends_;         ///< of the steps of this period [s]
  std::vector<double> before_;       ///< and of the one before [s]
  double wish_ = 0.0;                ///< length that the error allows [s]
  bool eased_ = false;               ///< a given step is chosen behind a switching
  double begun_ = 0.0;               ///< of this period, in the course's time [s]
  double since_ = 0.0;               ///< its beginning [s]
  PeriodEnd end_;                    ///< so far
  bool brought_back_ = false;        ///< in the middle of a period
};

}  // namespace shellback::bearing
