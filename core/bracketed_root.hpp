#pragma once
/// Root of a function between two points where its sign differs, by GSL's Brent-Dekker method.
#include <functional>

namespace shellback {

/// A point at which the function is known.
struct KnownPoint {
  double x = 0.0;
  double f = 0.0;
};

struct BracketOptions {
  double enough = 0.0;     ///< |f| that ends the search
  double narrowest = 0.0;  ///< width of the bracket that ends it
};

/// `found` is false where `f` gave no finite number, or where the iterations ran out; `x` and `f`
/// are those of the last evaluation in any case.
struct BracketedRoot {
  bool found = false;
  KnownPoint at;
};

/// The signs of `a.f` and `b.f` must differ; `f` is not evaluated there again, unless one is near
/// enough already: the last evaluation is that of the result.
[[nodiscard]] BracketedRoot bracketed_root(const std::function<double(double)>& f, KnownPoint a,
                                           KnownPoint b, const BracketOptions& options);

/// The root between two points, to `width` of x. Without a change of sign: the end at which |f| is
/// smaller. Where f is not a number: not a number.
[[nodiscard]] double root_between(const std::function<double(double)>& f, double low, double high,
                                  double width);

}  // namespace shellback
