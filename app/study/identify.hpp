#pragma once
/// Keys of a case from measured points: the bearing as the model of a least-squares fit.
///
/// An evaluation solves every measured point at one set of keys. The first walks along the points
/// of each curve (study/curve.hpp); afterwards a point starts from its own film at the last keys
/// that were accepted, from its neighbour, then from cold. Points that are not found at the start
/// are left out and named.
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/study/bounded_fit.hpp"
#include "app/study/curve.hpp"
#include "app/study/measured_residuals.hpp"
#include "bearing/steady/solve.hpp"

namespace shellback::study {

/// The judged case at place `at` among the points (between two: a fraction) with the keys `x`.
/// Throws InputError. Called from several threads at once.
using MeasuredCase = std::function<bearing::Case(double at, const std::vector<double>& x)>;

/// What is known of a point at the end.
struct FittedPoint {
  std::vector<double> start;   ///< computed with the keys at the start, per value; empty: not found
  std::vector<double> fitted;  ///< with Fit::x, as computed at that step; empty: not found
  Verdict verdict;             ///< of the last try at the start
  [[nodiscard]] bool used() const { return !start.empty(); }
};

struct IdentifyProgress {
  int evaluation = 0;
  double chi2 = 0.0;
};

struct IdentifyOptions {
  int threads = 1;
  std::function<void(const IdentifyProgress&)> progress{};  ///< may be empty
  const std::atomic<bool>* stop = nullptr;
};

struct Identification {
  Fit fit;
  std::vector<FittedPoint> points;  ///< in the order given
  double accuracy = 0.0;            ///< of what is computed, relative: of differences and ranks
  double wall_s = 0.0;
  [[nodiscard]] int lost() const;  ///< points that are not found
  [[nodiscard]] int values_used(const std::vector<MeasuredPoint>& measured) const;
};

/// Relative accuracy to which the tier's solver finds torques: its own tolerances (film's load
/// 1e-9, elasticity 1e-8 of the gap; heat 3e-4 of 10 K a round, relaxed by about ten rounds).
[[nodiscard]] double accuracy_of(bearing::Tier tier);

/// Fits. Throws InputError before any work if a case cannot be read at the start or at a bound, or
/// if its tier has no film to go on from; with the first film if a quantity is not one that the
/// tier knows.
[[nodiscard]] Identification identify(const std::vector<MeasuredPoint>& measured,
                                      const std::vector<FitParameter>& keys,
                                      const MeasuredCase& case_at,
                                      const IdentifyOptions& options = {});

}  // namespace shellback::study
