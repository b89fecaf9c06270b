#pragma once
/// Root of a continuous function between two points at which its signs differ: secants of the
/// bracket's ends; an end that stays twice counts half (Illinois rule, Dowell and Jarratt 1971).
#include <cmath>

namespace shellback::fidelity {

/// To `width` of x. Without a change of sign: the end to which f falls off. Where f is not a
/// number: not a number.
template <class F>
[[nodiscard]] double bracketed_root(F f, double low, double high, double width) {
  double f_low = f(low), f_high = f(high);
  if (f_low * f_high >= 0.0) return f_low * f_low < f_high * f_high ? low : high;
  int kept = 0;  // end that the last step kept: -1 low, 1 high
  while (high - low > width) {
    const double secant = high - f_high * (high - low) / (f_high - f_low);
    const double x = secant > low && secant < high ? secant : 0.5 * (low + high);
    const double f_x = f(x);
    if (f_x == 0.0) return x;
    if (std::isnan(f_x)) return f_x;
    const bool replaces_high = (f_x > 0.0) == (f_high > 0.0);
    (replaces_high ? high : low) = x;
    (replaces_high ? f_high : f_low) = f_x;
    if (replaces_high && kept == -1) f_low *= 0.5;
    if (!replaces_high && kept == 1) f_high *= 0.5;
    kept = replaces_high ? -1 : 1;
  }
  return 0.5 * (low + high);
}

}  // namespace shellback::fidelity
