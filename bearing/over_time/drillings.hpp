#pragma once
/// Supplies that turn with the journal: where their mouths stand in a load cycle.
///
///   phi(t) = phi(0) + int omega dt,   omega of the journal against the shell             (1)
/// The flow through a mouth is (1)-(2) of fluid/supply.hpp, by the film's conductance at the
/// beginning of the step: it only says where within a link the mouth's edge lies, and follows the
/// film from step to step.
#include "bearing/bearing.hpp"
#include "bearing/film/equilibrium.hpp"
#include "bearing/load_cycle.hpp"
#include "bearing/note.hpp"

namespace shellback::bearing {

class Drillings {
 public:
  /// Of a bearing under this course; both outlive it.
  Drillings(const BearingModel& model, const LoadCourse& course);

  [[nodiscard]] bool any() const { return !of_patch_.empty(); }
  /// Takes the conductance of an evaluated film.
  void take(const BearingModel& model, const FilmEquilibrium& film);
  /// Puts the mouths into `scene` where they stand at time t of the course.
  void place(double t, fluid::FilmScene& scene) const;
  /// Mouths that are finer than the grid.
  [[nodiscard]] std::vector<note::MouthWidened> widened(const fluid::FilmScene& scene) const;

 private:
  const LoadCourse& course_;
  std::vector<int> of_patch_;
  std::vector<double> begun_;  ///< phi(0) [rad]
  Field conductance_;          ///< K of fluid/supply.hpp [kg/(s Pa)]
};

}  // namespace shellback::bearing
