#pragma once
/// The journal's path over a load cycle by its mobility, at one temperature of the film.
#include <cmath>
#include <optional>
#include <vector>

#include "bearing/control.hpp"
#include "fidelity/mobility_motion.hpp"

namespace shellback::fidelity {

class JournalPath {
 public:
  /// `tolerance`: of a step, over the gap that is left [-]. Case and control must outlive the path.
  JournalPath(const bearing::Case& c, double tolerance, const bearing::SolveControl& control);

  /// Finds the periodic path, from where the last one ended; of an event the path from the steady
  /// place of its first row. On success instants() hold it.
  [[nodiscard]] Verdict find(double T);
  /// Begins the next search where the last path of `other` ended.
  void begin_as(const JournalPath& other) { at_ = other.at_; }
  [[nodiscard]] const std::vector<bearing::CycleInstant>& instants() const { return instants_; }
  /// Largest share of the load that asperities carry [-].
  [[nodiscard]] double asperity_share() const;
  [[nodiscard]] const MobilityMotion& motion() const { return motion_; }
  [[nodiscard]] double length() const { return length_; }  ///< of the cycle or event [s]

  [[nodiscard]] int cycles() const { return cycles_; }  ///< of the last find()
  /// What separates the last cycle from the periodic path, over the gap that is left [-]; NaN: an
  /// event.
  [[nodiscard]] double closure() const { return closure_; }
  [[nodiscard]] int steps() const { return steps_; }        ///< of the last cycle
  [[nodiscard]] int rejected() const { return rejected_; }  ///< the same
  /// False: the event's first row has no steady place that is found.
  [[nodiscard]] bool began_steady() const { return began_steady_; }

 private:
  /// From `from` over the whole length; with the instants, or only to where it ends.
  [[nodiscard]] std::optional<Pair> pass(const Pair& from, bool record);
  /// What separates `end`, where the cycle from at_ has come to, from the periodic path, over the
  /// gap that is left there: (1 - J)^-1 J (end - at_), J what paths begun beside at_ make of the
  /// distance. For cycles that differ by no more than their steps err, in whose differences no rate
  /// is seen. Not a number: a path beside is lost, or draws near too slowly to be told from the
  /// error.
  [[nodiscard]] double left_beside(const Pair& end);
  /// Where the journal comes to rest under the first row.
  [[nodiscard]] Pair steady_place();
  [[nodiscard]] Verdict lost() const;

  const bearing::Case& c_;
  const bearing::SolveControl& control_;
  double length_;
  double tolerance_;
  bearing::LoadCourse course_;
  MobilityMotion motion_;
  std::vector<bearing::LoadCorner> corners_;  ///< of the load, the end with them
  std::vector<double> told_;                  ///< instants between [s]
  double lost_at_ = 0.0;                      ///< [s]
  Pair at_{};                                 ///< where the last path ended, over the clearance
  std::vector<bearing::CycleInstant> instants_;
  int cycles_ = 0;
  double closure_ = NAN;
  int steps_ = 0;
  int rejected_ = 0;
  bool began_steady_ = true;
};

}  // namespace shellback::fidelity
