#include "core/bracketed_root.hpp"

#include <gsl/gsl_roots.h>

#include <cmath>
#include <exception>
#include <memory>

#include "core/contract.hpp"
#include "core/gsl_errors.hpp"
#include "core/round_off.hpp"

namespace shellback {
namespace {

struct Search {
  const std::function<double(double)>* f;
  KnownPoint low, high;
  KnownPoint last;
  std::exception_ptr thrown{};  ///< by f: GSL's own frames are not to be unwound
};

double value_at(double x, void* data) {
  Search& s = *static_cast<Search*>(data);
  if (x == s.low.x) return s.low.f;
  if (x == s.high.x) return s.high.f;
  if (s.thrown) return NAN;
  try {
    s.last = {x, (*s.f)(x)};
  } catch (...) {
    s.thrown = std::current_exception();
    return NAN;
  }
  return s.last.f;
}

struct FreeRootSolver {
  void operator()(gsl_root_fsolver* s) const { gsl_root_fsolver_free(s); }
};

}  // namespace

BracketedRoot bracketed_root(const std::function<double(double)>& f, KnownPoint a, KnownPoint b,
                             const BracketOptions& o) {
  EXPECTS((a.f < 0.0) != (b.f < 0.0));
  for (const KnownPoint& end : {a, b}) {
    if (std::abs(end.f) <= o.enough) return {true, {end.x, f(end.x)}};
  }
  if (b.x < a.x) std::swap(a, b);
  Search search{&f, a, b, a};
  gsl_function function{value_at, &search};
  gsl_errors_are_results();
  const std::unique_ptr<gsl_root_fsolver, FreeRootSolver> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
  if (gsl_root_fsolver_set(solver.get(), &function, a.x, b.x) != GSL_SUCCESS) {
    return {false, search.last};
  }
  for (int it = 0; it < kMostIterations; ++it) {
    const int status = gsl_root_fsolver_iterate(solver.get());
    if (search.thrown) std::rethrow_exception(search.thrown);
    if (status != GSL_SUCCESS) break;
    const double width =
        gsl_root_fsolver_x_upper(solver.get()) - gsl_root_fsolver_x_lower(solver.get());
    if (std::abs(search.last.f) <= o.enough || width <= o.narrowest) return {true, search.last};
  }
  return {false, search.last};
}

double root_between(const std::function<double(double)>& f, double low, double high, double width) {
  const KnownPoint a{low, f(low)}, b{high, f(high)};
  if (std::isnan(a.f * b.f)) return NAN;
  if ((a.f < 0.0) == (b.f < 0.0)) return std::abs(a.f) < std::abs(b.f) ? low : high;
  const BracketedRoot root = bracketed_root(f, a, b, {0.0, width});
  return root.found ? root.at.x : NAN;
}

}  // namespace shellback
