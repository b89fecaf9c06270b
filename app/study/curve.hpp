#pragma once
/// Continuation along one curve of a sweep, in both directions, with mending of gaps.
///
/// A piece of the curve begins at a point that can be solved from cold and walks to both its ends,
/// each point from the one before (secant predictor). A point that fails is tried by way of points
/// between the two, in steps that are halved where they fail, then from cold; the walk goes on
/// beyond it. Afterwards `mend` enters
/// every gap from its solved borders. Pieces may run on several threads at once; `mend` afterwards,
/// alone.
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "app/study/axis.hpp"
#include "app/study/sweep_point.hpp"
#include "bearing/steady/solve.hpp"

namespace shellback::study {

/// True if its solution gives its neighbours nothing to start from.
[[nodiscard]] bool stands_alone(const bearing::Case& c);

class Curve {
 public:
  using Along = std::function<bearing::Case(double index)>;  ///< the case along the curve
  using Known = std::shared_ptr<const bearing::Solution>;
  /// Told after each point with its solution; null: none was found.
  using Finished = std::function<void(int k, const Known& solution)>;
  using FinishedAlone = std::function<void(int k, bool good)>;  ///< of a tier without a film

  /// `solve_alone` is handed the index on this curve. `points` are those of the curve in their
  /// order; they must outlive it, as must `options`.
  Curve(const Axis& axis, Along case_at, std::vector<SweepPoint*> points,
        const SweepOptions& options, Finished finished, SolveAlone solve_alone = {},
        FinishedAlone finished_alone = {});

  /// Solves the points of [low, high), as far as they can be reached from within.
  void solve_piece(int low, int high);
  /// Enters what is left from solved neighbours, then from cold.
  void mend();

 private:
  struct Step {
    double at = 0.0;
    Known solution;
  };
  struct Trail;

  static bool beside(int k, const Trail& trail);
  static bearing::Solution predicted(const Axis& axis, const Trail& trail, double at);
  Known solve(int k, double at, const Trail* trail);
  Known reach(int k, const Trail& trail);
  Known halve_steps(int k, Trail trail);
  Known cold(int k);
  void solve_alone(int k);
  void walk(Trail trail, int direction, int low, int high, bool to_first_failure);
  bool enter_gaps();
  Trail trail_at(int k, int direction);
  void settle(int k, const Known& solution);
  void forget_inner(int k);
  [[nodiscard]] bool solved(int k);
  [[nodiscard]] bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }
  [[nodiscard]] bearing::SolveControl control() const { return {{}, options_.stop}; }

  const Axis& axis_;
  Along case_at_;
  std::vector<SweepPoint*> points_;
  const SweepOptions& options_;
  Finished finished_;
  SolveAlone solve_alone_;
  FinishedAlone finished_alone_;
  std::vector<char> alone_;            ///< per point: its tier has no film to go on from
  std::vector<unsigned> failed_from_;  ///< per point: Side bits from which it cannot be solved

  std::mutex guard_;           ///< of what follows
  std::vector<char> solved_;   ///< per point
  std::map<int, Known> kept_;  ///< solutions beside points that are not solved
};

}  // namespace shellback::study
