#pragma once
/// Bounded nonlinear least squares, and what the data say about each parameter.
///
///   minimize chi2 = sum_i r_i(x)^2,   low_j <= x_j <= high_j                              (1)
///   y = ln x if low > 0 and high/low >= 10, else y = x                                    (2)
///   y = y_low + (y_high - y_low) (1 + sin u)/2,  u free                                   (3)
///   cov(y) = s^2 (J^T J)^-1,  J = dr/dy at the end                                        (4)
///   remaining = max_k |u_k . r|/s                                                         (5)
///   settled: s remaining <= sqrt((s_data/10)^2 + noise^2)                                 (6)
///
/// r: (computed - measured)/standard deviation. s^2 = s_data^2 + noise^2: s_data = 1 if the
/// deviations are known; otherwise they are taken as equal and s_data^2 = chi2/(values -
/// parameters); noise is what r is uncertain by because it is computed. (1), (4) textbook; solved
/// by Levenberg-Marquardt steps in u (gsl_multifit_nlinear). (3) is the sine transform of bounds,
/// textbook. (5) is the Gauss-Newton step that is still wanted along the directions u_k that the
/// data determine (below), in deviations of (4): settled if nobody sees it, or if it is within what
/// the noise of one value moves the minimum by.
///
/// J by central differences over h = accuracy^(1/3) of a unit of (2) (1 for a logarithm, the larger
/// of |y| and a tenth of the bounds' distance else): where round-off accuracy/h and truncation h^2
/// are alike, textbook; both are then accuracy^(2/3).
///
/// What the data do not determine: with the bounds' distance as unit of each y, J = U S V^T. Along
/// v_k the data leave the deviation s/S_k. It is not determined if that exceeds 1/sqrt(12), the
/// deviation of a value of which only the bounds are known, or if S_k is within ten times the error
/// of J: S_k <= 10 accuracy^(2/3) S_1.
///
/// Validity: one minimum between the bounds; (4) where r is nearly linear over a deviation. A
/// parameter at its bound is held there in (4) and has no deviation.
#include <limits>
#include <vector>

#include "app/study/fit_problem.hpp"

namespace shellback::study {

/// One direction in the space of parameters, from the best to the least determined.
struct FitDirection {
  double singular_value = 0.0;  ///< S_k [1/s]
  double deviation = 0.0;       ///< s/S_k, in distances of the bounds [-]
  std::vector<double> part;     ///< v_k, in distances of the bounds [-]
  bool determined = false;
};

enum class FitStatus { settled, unsettled, not_computed, interrupted };

struct Fit {
  FitStatus status = FitStatus::unsettled;
  std::vector<double> x;          ///< the best that was found; the start if !computed()
  std::vector<double> deviation;  ///< of x; NaN: at its bound, or without end
  std::vector<std::vector<double>> correlation;  ///< of y; NaN beside a parameter at its bound
  std::vector<char> at_bound;
  std::vector<FitDirection> directions;
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< at x; NaN: !computed()
  double chi2_start = std::numeric_limits<double>::quiet_NaN();
  int freedom = 0;         ///< values - parameters
  double scale = 1.0;      ///< s of (4)
  double remaining = 0.0;  ///< (5): largest step still wanted [deviations of (4)]
  int iterations = 0;
  int evaluations = 0;
  int refused_steps = 0;  ///< that led to where r cannot be computed
  /// r could be computed at the start, so that x is a result.
  [[nodiscard]] bool computed() const;
  [[nodiscard]] bool determined() const;
};

/// Solves (1). Does not throw for lack of convergence: read `status`. A broken contract (start
/// outside the bounds, no parameter) is one.
[[nodiscard]] Fit fit_bounded(const FitProblem& problem);

}  // namespace shellback::study
