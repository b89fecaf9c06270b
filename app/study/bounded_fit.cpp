#include "app/study/bounded_fit.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

#include "core/contract.hpp"

namespace shellback::study {
namespace {

using Values = std::vector<double>;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kDecade = 10.0;   ///< ratio of bounds from which on a logarithm serves better [-]
constexpr double kAtBound = 1e-3;  ///< of the bounds' distance: closer, the bound holds it [-]
/// Residual of a step that cannot be computed: no step to it is ever taken, its square is finite.
constexpr double kRefused = 1e100;

/// The problem in u with all that GSL's functions of C need.
class Search {
 public:
  explicit Search(const FitProblem& p) : p_(p) {}

  [[nodiscard]] int count() const { return static_cast<int>(p_.parameters.size()); }
  [[nodiscard]] double low(int j) const {
    return fit_coordinate(p_.parameters[j], p_.parameters[j].low);
  }
  [[nodiscard]] double span(int j) const {
    return fit_coordinate(p_.parameters[j], p_.parameters[j].high) - low(j);
  }
  /// (3) and back.
  [[nodiscard]] double y_of(int j, double u) const {
    return low(j) + 0.5 * span(j) * (1.0 + std::sin(u));
  }
  [[nodiscard]] double u_of(int j, double y) const {
    return std::asin(std::clamp(2.0 * (y - low(j)) / span(j) - 1.0, -1.0, 1.0));
  }
  [[nodiscard]] Values y_of(const gsl_vector* u) const {
    Values y;
    for (int j = 0; j < count(); ++j) y.push_back(y_of(j, gsl_vector_get(u, j)));
    return y;
  }
  [[nodiscard]] Values x_of(const Values& y) const {
    Values x;
    for (int j = 0; j < count(); ++j) x.push_back(fit_value(p_.parameters[j], y[j]));
    return x;
  }

  std::optional<Values> residuals(const Values& y, Purpose purpose) {
    if (purpose == Purpose::step && y == last_y_) return last_r_;  // GSL asks twice
    ++evaluations;
    auto r = p_.residuals(x_of(y), purpose);
    if (purpose == Purpose::step) {
      last_y_ = y;
      last_r_ = r;
    }
    return r;
  }
  /// dr/dy at y, where r is `here`; nothing if it cannot be computed on either side.
  std::optional<Eigen::MatrixXd> slopes(const Values& y, const Values& here);

  int evaluations = 0;
  int refused = 0;
  bool lost = false;  ///< a slope cannot be computed
  std::exception_ptr thrown;

 private:
  const FitProblem& p_;
  Values last_y_;
  std::optional<Values> last_r_;
};

std::optional<Eigen::MatrixXd> Search::slopes(const Values& y, const Values& here) {
  Eigen::MatrixXd J(here.size(), count());
  for (int j = 0; j < count(); ++j) {
    const double unit =
        in_logarithms(p_.parameters[j]) ? 1.0 : std::max(std::abs(y[j]), 0.1 * span(j));
    const double h = std::cbrt(p_.accuracy) * unit;
    Values below = y, above = y;
    below[j] = std::max(y[j] - h, low(j));
    above[j] = std::min(y[j] + h, low(j) + span(j));
    auto left = below[j] < y[j] ? residuals(below, Purpose::difference) : std::nullopt;
    auto right = above[j] > y[j] ? residuals(above, Purpose::difference) : std::nullopt;
    if (!left && !right) return std::nullopt;
    const double from = left ? below[j] : y[j], to = right ? above[j] : y[j];
    const Values& a = left ? *left : here;
    const Values& b = right ? *right : here;
    for (std::size_t i = 0; i < here.size(); ++i) {
      J(static_cast<Eigen::Index>(i), j) = (b[i] - a[i]) / (to - from);
    }
  }
  return J;
}

int residuals_for_gsl(const gsl_vector* u, void* context, gsl_vector* out) {
  Search& s = *static_cast<Search*>(context);
  try {
    const auto r = s.residuals(s.y_of(u), Purpose::step);
    if (!r) ++s.refused;
    for (std::size_t i = 0; i < out->size; ++i) gsl_vector_set(out, i, r ? (*r)[i] : kRefused);
    return GSL_SUCCESS;
  } catch (...) {
    s.thrown = std::current_exception();
    return GSL_EFAILED;
  }
}

int slopes_for_gsl(const gsl_vector* u, void* context, gsl_matrix* out) {
  Search& s = *static_cast<Search*>(context);
  try {
    const Values y = s.y_of(u);
    const auto here = s.residuals(y, Purpose::step);
    const auto J = here ? s.slopes(y, *here) : std::nullopt;
    s.lost = !J;
    if (!J) return GSL_EFAILED;
    for (int j = 0; j < s.count(); ++j) {
      const double dy_du = 0.5 * s.span(j) * std::cos(gsl_vector_get(u, j));
      for (std::size_t i = 0; i < out->size1; ++i) {
        gsl_matrix_set(out, i, j, (*J)(static_cast<Eigen::Index>(i), j) * dy_du);
      }
    }
    return GSL_SUCCESS;
  } catch (...) {
    s.thrown = std::current_exception();
    return GSL_EFAILED;
  }
}

/// Levenberg-Marquardt from the start; gives the last y. GSL's own verdict is not asked for: what
/// remains to be done is measured afterwards.
Values descend(const FitProblem& p, Search& s, std::size_t values, int& iterations) {
  const double step = std::cbrt(p.accuracy) * std::cbrt(p.accuracy);  // J is no better
  const std::size_t n = p.parameters.size();
  gsl_multifit_nlinear_parameters options = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_fdf system{};
  system.f = residuals_for_gsl;
  system.df = slopes_for_gsl;
  system.n = values;
  system.p = n;
  system.params = &s;
  const std::unique_ptr<gsl_multifit_nlinear_workspace, void (*)(gsl_multifit_nlinear_workspace*)>
      work(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &options, values, n),
           gsl_multifit_nlinear_free);
  const std::unique_ptr<gsl_vector, void (*)(gsl_vector*)> u(gsl_vector_alloc(n), gsl_vector_free);
  for (std::size_t j = 0; j < n; ++j) {
    const int k = static_cast<int>(j);
    gsl_vector_set(u.get(), j, s.u_of(k, fit_coordinate(p.parameters[j], p.parameters[j].start)));
  }
  gsl_error_handler_t* handler = gsl_set_error_handler_off();
  int status = gsl_multifit_nlinear_init(u.get(), &system, work.get());
  while (status == GSL_SUCCESS && iterations < p.most_iterations && !(p.stopped && p.stopped())) {
    ++iterations;
    status = gsl_multifit_nlinear_iterate(work.get());
    int info = 0;
    if (status == GSL_SUCCESS &&
        gsl_multifit_nlinear_test(step, step * step, 0.0, &info, work.get()) == GSL_SUCCESS) {
      break;
    }
  }
  gsl_set_error_handler(handler);
  if (s.thrown) std::rethrow_exception(s.thrown);
  return s.y_of(gsl_multifit_nlinear_position(work.get()));
}

using Svd = Eigen::JacobiSVD<Eigen::MatrixXd>;

bool is_determined(const FitProblem& p, const Svd& svd, Eigen::Index k, double scale) {
  const double error = 10.0 * std::pow(p.accuracy, 2.0 / 3.0);
  const Eigen::VectorXd& S = svd.singularValues();
  return S(k) > error * S(0) && scale / S(k) <= 1.0 / std::sqrt(12.0);
}

/// How far a Gauss-Newton step would still go along the determined directions [deviations, or of
/// exact data errors of J].
double remaining_step(const FitProblem& p, const Svd& svd, const Values& r, double scale) {
  const Eigen::Map<const Eigen::VectorXd> f(r.data(), static_cast<Eigen::Index>(r.size()));
  double most = 0.0;
  for (Eigen::Index k = 0; k < svd.singularValues().size(); ++k) {
    if (!is_determined(p, svd, k, scale)) continue;
    const double S = svd.singularValues()(k);
    const double unit = std::max(scale / S, 10.0 * std::cbrt(p.accuracy * p.accuracy));
    most = std::max(most, std::abs(svd.matrixU().col(k).dot(f)) / S / unit);
  }
  return most;
}

/// Covariance (4) of the parameters that are not at a bound, in distances of the bounds.
void add_deviations(const FitProblem& p, const Search& s, const Values& y, const Values& r,
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
  const Svd svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  fit.remaining = remaining_step(p, svd, r, fit.scale);
  const Eigen::MatrixXd half =
      svd.matrixV() * svd.singularValues().cwiseInverse().asDiagonal() * fit.scale;
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

void add_directions(const FitProblem& p, const Search& s, const Eigen::MatrixXd& J, Fit& fit) {
  Eigen::MatrixXd A = J;
  for (int j = 0; j < s.count(); ++j) A.col(j) *= s.span(j);
  const Svd svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  for (Eigen::Index k = 0; k < svd.singularValues().size(); ++k) {
    FitDirection d;
    d.singular_value = svd.singularValues()(k);
    d.deviation = fit.scale / d.singular_value;
    for (Eigen::Index j = 0; j < s.count(); ++j) d.part.push_back(svd.matrixV()(j, k));
    d.determined = is_determined(p, svd, k, fit.scale);
    fit.directions.push_back(std::move(d));
  }
}

/// chi2 at the end with slopes, deviations and directions; false if slopes cannot be computed.
bool judge(const FitProblem& p, Search& s, const Values& y, const Values& r, Fit& fit) {
  const auto J = s.slopes(y, r);
  if (!J) return false;
  fit.freedom = static_cast<int>(r.size()) - s.count();
  const bool unknown = !p.deviations_known;
  fit.scale = unknown && fit.freedom > 0 ? std::sqrt(fit.chi2 / fit.freedom) : 1.0;
  for (int j = 0; j < s.count(); ++j) {
    const double share = (y[j] - s.low(j)) / s.span(j);
    fit.at_bound.push_back(share < kAtBound || share > 1.0 - kAtBound ? 1 : 0);
  }
  add_deviations(p, s, y, r, *J, fit);
  add_directions(p, s, *J, fit);
  return true;
}

double square_sum(const Values& r) {
  double sum = 0.0;
  for (const double v : r) sum += v * v;
  return sum;
}

}  // namespace

bool in_logarithms(const FitParameter& p) { return p.low > 0.0 && p.high >= kDecade * p.low; }

double fit_coordinate(const FitParameter& p, double x) {
  return in_logarithms(p) ? std::log(x) : x;
}

double fit_value(const FitParameter& p, double y) {
  return std::clamp(in_logarithms(p) ? std::exp(y) : y, p.low, p.high);
}

bool Fit::determined() const {
  return !directions.empty() && std::all_of(directions.begin(), directions.end(),
                                            [](const FitDirection& d) { return d.determined; });
}

Fit fit_bounded(const FitProblem& p) {
  constexpr double kSettled = 0.1;  // of a deviation: nobody sees the difference
  EXPECTS(!p.parameters.empty());
  Fit fit;
  for (const FitParameter& q : p.parameters) {
    EXPECTS(q.low < q.start && q.start < q.high);
    fit.x.push_back(q.start);
  }
  Search s(p);
  const auto ended = [&](FitStatus status) {
    fit.status = p.stopped && p.stopped() ? FitStatus::interrupted : status;
    fit.evaluations = s.evaluations;
    fit.refused_steps = s.refused;
    return fit;
  };
  const auto first = p.residuals(fit.x, Purpose::step);
  if (!first) return ended(FitStatus::not_computed);
  fit.chi2 = fit.chi2_start = square_sum(*first);
  if (first->size() < p.parameters.size()) return ended(FitStatus::unsettled);
  const Values y = descend(p, s, first->size(), fit.iterations);
  const auto r = s.residuals(y, Purpose::step);
  if (s.lost || !r) return ended(FitStatus::not_computed);
  fit.x = s.x_of(y);
  fit.chi2 = square_sum(*r);
  if (!judge(p, s, y, *r, fit)) return ended(FitStatus::not_computed);
  return ended(fit.remaining <= kSettled ? FitStatus::settled : FitStatus::unsettled);
}

}  // namespace shellback::study
