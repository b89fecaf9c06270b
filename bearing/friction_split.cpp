#include "bearing/friction_split.hpp"

#include <algorithm>

namespace shellback::bearing {

void close_split(const Torque& start, const Torque& end, FrictionSplit& split) {
  const FrictionStep asperities{"asperity share", end.asperity - start.asperity};
  const bool known = std::all_of(split.steps.begin(), split.steps.end(),
                                 [](const FrictionStep& s) { return std::isfinite(s.change); });
  if (!known)
    split.steps = {{"oil, clearance and elasticity together", end.viscous - start.viscous}};
  split.steps.push_back(asperities);
}

Calibration calibrate(const std::function<double(double)>& torque, double wanted, double guess,
                      const BracketOptions& options) {
  Calibration out;
  const double turned = wanted < 0.0 ? -1.0 : 1.0;  // a journal that turns clockwise
  const auto excess = [&](double T) {
    const double here = torque(T);
    if (std::isnan(here)) return here;
    out.coldest = std::min(out.coldest, T);
    out.warmest = std::max(out.warmest, T);
    out.least_torque = std::min(out.least_torque, here);
    out.most_torque = std::max(out.most_torque, here);
    return turned * (here - wanted);
  };
  const KnownPoint begun{guess, excess(guess)};
  if (begun.f == 0.0) out.T = guess;
  if (begun.f == 0.0 || std::isnan(begun.f)) return out;
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
    if (root.found) out.T = root.at.x;
    return out;
  }
  return out;
}

}  // namespace shellback::bearing
