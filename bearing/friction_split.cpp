#include "bearing/friction_split.hpp"

#include <algorithm>

namespace shellback::bearing {

void close_split(const Torque& start, const Torque& end, FrictionSplit& split) {
  const FrictionStep asperities{"asperity share", end.asperity - start.asperity};
  const bool known = std::all_of(split.steps.begin(), split.steps.end(),
                                 [](const FrictionStep& s) { return std::isfinite(s.change); });
  if (!known) split.steps = {{"all viscous effects together", end.viscous - start.viscous}};
  split.steps.push_back(asperities);
}

double calibrated_temperature(const std::function<double(double)>& excess, double guess,
                              const BracketOptions& options) {
  constexpr double kReach = 32.0;  // from the guess, towards where the friction has to go [K]
  KnownPoint here{guess, excess(guess)};
  if (here.f == 0.0) return guess;
  KnownPoint other = here;
  for (double reach = 4.0; reach <= kReach && other.f * here.f > 0.0; reach *= 2.0) {
    here = other;
    other.x = here.f > 0.0 ? guess + reach : guess - reach;  // warmer oil, less friction
    other.f = excess(other.x);
  }
  if (!(other.f * here.f < 0.0)) return NAN;
  const BracketedRoot root = bracketed_root(excess, here, other, options);
  return root.found ? root.at.x : NAN;
}

}  // namespace shellback::bearing
