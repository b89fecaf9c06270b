#pragma once
/// The search of study/bounded_fit.hpp: its problem in u of (3), and Levenberg-Marquardt steps.
///
/// J by central differences, as said there. What was found is the step of least chi2.
#include <Eigen/Dense>
#include <limits>

#include "app/study/fit_problem.hpp"

namespace shellback::study {

/// Sum of squares.
[[nodiscard]] double square_sum(const std::vector<double>& r);

/// Where r has been computed with the least chi2 so far; y empty: nowhere.
struct BestStep {
  std::vector<double> y;
  std::vector<double> r;
  double chi2 = std::numeric_limits<double>::infinity();
};

class BoundedSearch {
 public:
  using Values = std::vector<double>;

  /// `problem` outlives the search.
  explicit BoundedSearch(const FitProblem& problem) : p_(problem) {}

  [[nodiscard]] int count() const { return static_cast<int>(p_.parameters.size()); }
  [[nodiscard]] double low(int j) const {
    return fit_coordinate(p_.parameters[j], p_.parameters[j].low);
  }
  [[nodiscard]] double span(int j) const {
    return fit_coordinate(p_.parameters[j], p_.parameters[j].high) - low(j);
  }
  /// (3) and back.
  [[nodiscard]] double y_of(int j, double u) const;
  [[nodiscard]] double u_of(int j, double y) const;
  /// (2) back.
  [[nodiscard]] Values x_of(const Values& y) const;
  [[nodiscard]] Values start_u() const;
  [[nodiscard]] bool stopped() const { return p_.stopped && p_.stopped(); }
  /// True if y lies closer to a bound than a thousandth of their distance, and the least chi2 along
  /// it alone, y - J^T r/|J|^2 with J = dr/dy of this parameter, at the bound or beyond.
  [[nodiscard]] bool held_by_bound(int j, double y, const Eigen::VectorXd& column,
                                   const Values& r) const;

  /// r at y; nothing if it cannot be computed. A step keeps what is better than `best`.
  std::optional<Values> residuals(const Values& y, Purpose purpose);
  /// dr/dy at y, where r is `here`; nothing if it cannot be computed on either side.
  std::optional<Eigen::MatrixXd> slopes(const Values& y, const Values& here);

  BestStep best;
  int evaluations = 0;
  int refused = 0;    ///< steps that led to where r cannot be computed; an interrupt is none
  bool lost = false;  ///< a slope cannot be computed

 private:
  const FitProblem& p_;
  Values last_y_;
  std::optional<Values> last_r_;
};

/// Whether the search may end where r has the slopes A = dr/dy, in distances of the bounds, without
/// the columns of parameters at their bounds.
using MayEnd = std::function<bool(const Eigen::MatrixXd& A, const std::vector<double>& r)>;

/// Steps from the start, whose r has been computed, until they are small and `may_end` says so; at
/// most problem.most_iterations, fewer if interrupted or without progress. GSL's own verdict is not
/// asked for. Gives their number. Throws what the residuals throw.
int descend(const FitProblem& problem, BoundedSearch& search, const MayEnd& may_end);

}  // namespace shellback::study
