#include "app/study/bounded_fit.hpp"

#include <algorithm>
#include <cmath>

#include "app/study/bounded_search.hpp"
#include "core/contract.hpp"
#include "core/decompositions.hpp"
#include "core/round_off.hpp"

namespace shellback::study {
namespace {

using Values = std::vector<double>;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kSettled = 0.1;  ///< of a deviation: nobody sees the difference [-]

/// Part of the largest singular value that errors of the differences make.
double of_differences(const FitProblem& p) { return 10.0 * std::pow(p.accuracy, 2.0 / 3.0); }

bool is_determined(const FitProblem& p, const ThinSvd& svd, Eigen::Index k, double scale) {
  const Eigen::VectorXd& S = svd.values;
  return S(k) > of_differences(p) * S(0) && scale / S(k) <= 1.0 / std::sqrt(12.0);
}

/// s of the data alone: of what was measured, without what r is computed with.
double scatter(const FitProblem& p, double chi2, int freedom) {
  return !p.deviations_known && freedom > 0 ? std::sqrt(chi2 / freedom) : 1.0;
}

/// How far a Gauss-Newton step would still go along the determined directions, in (5).
double remaining_step(const FitProblem& p, const ThinSvd& svd, const Values& r, double scale) {
  const Eigen::Map<const Eigen::VectorXd> f(r.data(), static_cast<Eigen::Index>(r.size()));
  double most = 0.0;
  for (Eigen::Index k = 0; k < svd.values.size(); ++k) {
    if (!is_determined(p, svd, k, scale)) continue;
    most = std::max(most, std::abs(svd.U.col(k).dot(f)));
  }
  return scale > 0.0 ? most / scale : 0.0;  // nothing is left of exact data that are met exactly
}

/// s of (4).
double scale_of(const FitProblem& p, double chi2, int freedom) {
  return std::hypot(scatter(p, chi2, freedom), p.noise);
}

/// The right side of (6) over s.
double settled_below(const FitProblem& p, double chi2, int freedom) {
  const double data = scatter(p, chi2, freedom), scale = std::hypot(data, p.noise);
  return scale > 0.0 ? std::hypot(kSettled * data, p.noise) / scale : 0.0;
}

/// (6) with these slopes.
bool is_settled(const FitProblem& p, const Eigen::MatrixXd& A, const Values& r, int freedom) {
  const double chi2 = square_sum(r);
  const ThinSvd svd = thin_svd(A);
  return remaining_step(p, svd, r, scale_of(p, chi2, freedom)) <= settled_below(p, chi2, freedom);
}

/// Covariance (4) of the parameters that are not at a bound, in distances of the bounds.
void add_deviations(const FitProblem& p, const BoundedSearch& s, const Values& y, const Values& r,
                    const Eigen::MatrixXd& J, Fit& fit) {
  const int n = s.count();
  std::vector<int> free;
  for (int j = 0; j < n; ++j) {
    if (fit.at_bound[j] == 0) free.push_back(j);
  }
  fit.deviation.assign(n, kNone);
  fit.correlation.assign(n, Values(n, kNone));
  if (free.empty()) return;
  Eigen::MatrixXd A(J.rows(), free.size());
  for (std::size_t k = 0; k < free.size(); ++k) {
    A.col(static_cast<Eigen::Index>(k)) = J.col(free[k]) * s.span(free[k]);
  }
  const ThinSvd svd = thin_svd(A);
  fit.remaining = remaining_step(p, svd, r, fit.scale);
  // A direction that the data do not determine says nothing of keys that have no part in it.
  Eigen::MatrixXd half = svd.V;
  for (Eigen::Index k = 0; k < half.cols(); ++k) {
    for (double& part : half.col(k)) {
      part = std::abs(part) < kRoundOff ? 0.0 : part * fit.scale / svd.values[k];
    }
  }
  const Eigen::MatrixXd cov = half * half.transpose();
  for (std::size_t a = 0; a < free.size(); ++a) {
    const auto ia = static_cast<Eigen::Index>(a);
    const int j = free[a];
    const double dx_dy = in_logarithms(p.parameters[j]) ? fit_value(p.parameters[j], y[j]) : 1.0;
    const double deviation = std::sqrt(cov(ia, ia)) * s.span(j) * dx_dy;
    if (std::isfinite(deviation)) fit.deviation[j] = deviation;
    for (std::size_t b = 0; b < free.size(); ++b) {
      const auto ib = static_cast<Eigen::Index>(b);
      fit.correlation[j][free[b]] = cov(ia, ib) / std::sqrt(cov(ia, ia) * cov(ib, ib));
    }
  }
}

void add_directions(const FitProblem& p, const BoundedSearch& s, const Eigen::MatrixXd& J,
                    Fit& fit) {
  Eigen::MatrixXd A = J;
  for (int j = 0; j < s.count(); ++j) A.col(j) *= s.span(j);
  const ThinSvd svd = thin_svd(A);
  for (Eigen::Index k = 0; k < svd.values.size(); ++k) {
    FitDirection d;
    d.singular_value = svd.values(k);
    d.deviation = fit.scale / d.singular_value;
    for (Eigen::Index j = 0; j < s.count(); ++j) d.part.push_back(svd.V(j, k));
    d.determined = is_determined(p, svd, k, fit.scale);
    fit.directions.push_back(std::move(d));
  }
}

/// Slopes, deviations and directions at the best step; false if slopes cannot be computed.
bool judge(const FitProblem& p, BoundedSearch& s, Fit& fit) {
  const Values &y = s.best.y, &r = s.best.r;
  const auto J = s.slopes(y, r);
  if (!J) return false;
  fit.scale = scale_of(p, s.best.chi2, fit.freedom);
  for (int j = 0; j < s.count(); ++j) {
    fit.at_bound.push_back(s.held_by_bound(j, y[j], J->col(j), r) ? 1 : 0);
  }
  add_deviations(p, s, y, r, *J, fit);
  add_directions(p, s, *J, fit);
  if (p.deviations_known || fit.freedom > 0) return true;
  // Neither deviations nor scatter: that the values are met says nothing of how well they are
  // known.
  fit.deviation.assign(s.count(), kNone);
  for (FitDirection& d : fit.directions) {
    d.deviation = kNone;
    d.determined = d.singular_value > of_differences(p) * fit.directions.front().singular_value;
  }
  return true;
}

}  // namespace

bool Fit::computed() const { return std::isfinite(chi2_start); }

bool Fit::determined() const {
  return !directions.empty() && std::all_of(directions.begin(), directions.end(),
                                            [](const FitDirection& d) { return d.determined; });
}

Fit fit_bounded(const FitProblem& p) {
  EXPECTS(!p.parameters.empty());
  Fit fit;
  for (const FitParameter& q : p.parameters) {
    EXPECTS(q.low < q.start && q.start < q.high);
    fit.x.push_back(q.start);
  }
  BoundedSearch s(p);
  const auto ended = [&](FitStatus status) {
    fit.status = s.stopped() ? FitStatus::interrupted : status;
    fit.evaluations = s.evaluations;
    fit.refused_steps = s.refused;
    if (s.best.y.empty()) return fit;
    fit.x = s.x_of(s.best.y);
    fit.chi2 = s.best.chi2;
    return fit;
  };
  Values start = s.start_u();
  for (int j = 0; j < s.count(); ++j) start[j] = s.y_of(j, start[j]);
  const auto first = s.residuals(start, Purpose::step);
  if (!first || s.best.y.empty()) return ended(FitStatus::not_computed);
  fit.chi2_start = s.best.chi2;
  fit.freedom = static_cast<int>(first->size()) - s.count();
  if (fit.freedom < 0) return ended(FitStatus::unsettled);
  fit.iterations = descend(p, s, [&](const Eigen::MatrixXd& A, const Values& r) {
    return is_settled(p, A, r, fit.freedom);
  });
  if (s.lost || !judge(p, s, fit)) return ended(FitStatus::not_computed);
  return ended(fit.remaining <= settled_below(p, s.best.chi2, fit.freedom) ? FitStatus::settled
                                                                           : FitStatus::unsettled);
}

}  // namespace shellback::study
