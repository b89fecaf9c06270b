#include "app/study/bounded_search.hpp"

#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

#include "core/gsl_errors.hpp"

namespace shellback::study {
namespace {

using Values = BoundedSearch::Values;
constexpr double kAtBound = 1e-3;  ///< of the bounds' distance: closer, a bound may hold it [-]
/// Residual of a step that cannot be computed: no step to it is ever taken, its square is finite.
constexpr double kRefused = 1e100;

/// What GSL's functions of C are given.
struct Context {
  BoundedSearch& search;
  std::exception_ptr thrown;
};

Values y_of(const BoundedSearch& s, const gsl_vector* u) {
  Values y;
  for (int j = 0; j < s.count(); ++j) y.push_back(s.y_of(j, gsl_vector_get(u, j)));
  return y;
}

int residuals_for_gsl(const gsl_vector* u, void* context, gsl_vector* out) {
  Context& c = *static_cast<Context*>(context);
  BoundedSearch& s = c.search;
  try {
    const auto r = s.residuals(y_of(s, u), Purpose::step);
    if (!r && s.stopped()) return GSL_EFAILED;
    if (!r) ++s.refused;
    for (std::size_t i = 0; i < out->size; ++i) gsl_vector_set(out, i, r ? (*r)[i] : kRefused);
    return GSL_SUCCESS;
  } catch (...) {
    c.thrown = std::current_exception();
    return GSL_EFAILED;
  }
}

int slopes_for_gsl(const gsl_vector* u, void* context, gsl_matrix* out) {
  Context& c = *static_cast<Context*>(context);
  BoundedSearch& s = c.search;
  try {
    const Values y = y_of(s, u);
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
    c.thrown = std::current_exception();
    return GSL_EFAILED;
  }
}

/// `may_end` at the last step: GSL's slopes by u, taken back to y, serve.
bool arrived(const BoundedSearch& s, const gsl_multifit_nlinear_workspace* work,
             const MayEnd& may_end) {
  const gsl_vector* u = gsl_multifit_nlinear_position(work);
  const gsl_vector* f = gsl_multifit_nlinear_residual(work);
  const gsl_matrix* J = gsl_multifit_nlinear_jac(work);
  Values r(f->size);
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = gsl_vector_get(f, i);
  Eigen::MatrixXd A(f->size, 0);
  for (int j = 0; j < s.count(); ++j) {
    const double u_j = gsl_vector_get(u, j);
    Eigen::VectorXd column(A.rows());  // dr/dy times the distance of the bounds
    for (std::size_t i = 0; i < r.size(); ++i) {
      column(static_cast<Eigen::Index>(i)) = gsl_matrix_get(J, i, j) / (0.5 * std::cos(u_j));
    }
    if (s.held_by_bound(j, s.y_of(j, u_j), column / s.span(j), r)) continue;
    A.conservativeResize(Eigen::NoChange, A.cols() + 1);
    A.rightCols(1) = column;
  }
  return A.cols() == 0 || may_end(A, r);
}

}  // namespace

double square_sum(const std::vector<double>& r) {
  double sum = 0.0;
  for (const double v : r) sum += v * v;
  return sum;
}

double BoundedSearch::y_of(int j, double u) const {
  return low(j) + 0.5 * span(j) * (1.0 + std::sin(u));
}

double BoundedSearch::u_of(int j, double y) const {
  return std::asin(std::clamp(2.0 * (y - low(j)) / span(j) - 1.0, -1.0, 1.0));
}

Values BoundedSearch::x_of(const Values& y) const {
  Values x;
  for (int j = 0; j < count(); ++j) x.push_back(fit_value(p_.parameters[j], y[j]));
  return x;
}

Values BoundedSearch::start_u() const {
  Values u;
  for (int j = 0; j < count(); ++j) {
    u.push_back(u_of(j, fit_coordinate(p_.parameters[j], p_.parameters[j].start)));
  }
  return u;
}

bool BoundedSearch::held_by_bound(int j, double y, const Eigen::VectorXd& column,
                                  const Values& r) const {
  const double share = (y - low(j)) / span(j);
  if (share > kAtBound && share < 1.0 - kAtBound) return false;
  const Eigen::Map<const Eigen::VectorXd> f(r.data(), static_cast<Eigen::Index>(r.size()));
  const double step = -column.dot(f) / column.squaredNorm();
  return !std::isfinite(step) || y + step <= low(j) || y + step >= low(j) + span(j);
}

std::optional<Values> BoundedSearch::residuals(const Values& y, Purpose purpose) {
  if (purpose == Purpose::step && y == last_y_) return last_r_;  // GSL asks twice
  ++evaluations;
  auto r = p_.residuals(x_of(y), purpose);
  if (purpose == Purpose::difference) return r;
  last_y_ = y;
  last_r_ = r;
  if (!r) return r;
  const double chi2 = square_sum(*r);
  if (chi2 < best.chi2) best = {y, *r, chi2};
  return r;
}

std::optional<Eigen::MatrixXd> BoundedSearch::slopes(const Values& y, const Values& here) {
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

int descend(const FitProblem& p, BoundedSearch& s, const MayEnd& may_end) {
  const double step = std::cbrt(p.accuracy) * std::cbrt(p.accuracy);  // the error of J
  const std::size_t n = p.parameters.size(), values = s.best.r.size();
  Context context{s, nullptr};
  gsl_multifit_nlinear_parameters options = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_fdf system{};
  system.f = residuals_for_gsl;
  system.df = slopes_for_gsl;
  system.n = values;
  system.p = n;
  system.params = &context;
  const std::unique_ptr<gsl_multifit_nlinear_workspace, void (*)(gsl_multifit_nlinear_workspace*)>
      work(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &options, values, n),
           gsl_multifit_nlinear_free);
  const std::unique_ptr<gsl_vector, void (*)(gsl_vector*)> u(gsl_vector_alloc(n), gsl_vector_free);
  const Values start = s.start_u();
  for (std::size_t j = 0; j < n; ++j) gsl_vector_set(u.get(), j, start[j]);
  gsl_errors_are_results();
  int status = gsl_multifit_nlinear_init(u.get(), &system, work.get());
  int iterations = 0;
  while (status == GSL_SUCCESS && iterations < p.most_iterations && !s.stopped()) {
    ++iterations;
    status = gsl_multifit_nlinear_iterate(work.get());
    int info = 0;
    if (status == GSL_SUCCESS &&
        gsl_multifit_nlinear_test(step, step * step, 0.0, &info, work.get()) == GSL_SUCCESS &&
        arrived(s, work.get(), may_end)) {
      break;
    }
  }
  if (context.thrown) std::rethrow_exception(context.thrown);
  return iterations;
}

}  // namespace shellback::study
