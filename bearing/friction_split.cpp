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
  const KnownPoint begun{guess, excess(guess)};
  if (begun.f == 0.0) return guess;
  if (std::isnan(begun.f)) return NAN;
  const double full_film = begun.f > 0.0 ? 1.0 : -1.0;  // warmer oil, less friction
  for (const double side : {full_film, -full_film}) {   // the other way where summits rub
    KnownPoint here = begun, other = begun;
    if (side != full_film) other.f = here.f = excess(guess);  // what is carried along goes back
    for (double reach = 4.0; reach <= kCalibrationReach && other.f * here.f > 0.0; reach *= 2.0) {
      here = other;
      other.x = guess + side * reach;
      other.f = excess(other.x);
    }
    if (!(other.f * here.f < 0.0)) continue;
    const BracketedRoot root = bracketed_root(excess, here, other, options);
    return root.found ? root.at.x : NAN;
  }
  return NAN;
}

}  // namespace shellback::bearing
