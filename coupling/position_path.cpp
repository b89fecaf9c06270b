#include "coupling/position_path.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::coupling {
namespace {

constexpr double kFirst = 0.5;          ///< of the eccentricity, to begin with [-]
constexpr double kFirstRatio = 0.7;     ///< of the remaining way's gap, from step to step [-]
constexpr double kLargestRatio = 0.98;  ///< a step that leaves more is not worth taking [-]
constexpr double kLoose = 1e-3;         ///< residuals on the way [-]
constexpr int kMostSteps = 100;

}  // namespace

Verdict follow_position(const BearingModel& model, const LoadTarget& target, double T,
                        const Field& growth, FilmEquilibrium& s, EquilibriumCost& cost,
                        const std::atomic<bool>* stop) {
  EquilibriumOptions loose;
  loose.film_tolerance = loose.elastic_tolerance = loose.viscosity_tolerance = kLoose;
  s = cold_start(model, T);
  const fluid::JournalPosition goal = s.position;
  const double ratio_wanted = std::hypot(goal.ex(), goal.ey()) / model.clearance;
  const auto place = [&](double part) {
    for (int k = 0; k < 2; ++k) s.position.q[k] = part * goal.q[k];
  };
  double part = kFirst;
  place(part);
  Verdict v = newton_equilibrium(model, target, growth, loose, s, cost, stop);
  if (!v.good()) return v;
  double ratio = kFirstRatio;
  FilmEquilibrium solved = s;
  for (int step = 0; step < kMostSteps; ++step) {
    // In equal ratios of the rigid gap at its smallest, 1 - part * eccentricity.
    const double gap = ratio * (1.0 - part * ratio_wanted);
    const double next = std::min(1.0, (1.0 - gap) / ratio_wanted);
    place(next);
    v = newton_equilibrium(model, target, growth, next == 1.0 ? EquilibriumOptions{} : loose, s,
                           cost, stop);
    if (v.status == Status::interrupted || (v.good() && next == 1.0)) return v;
    if (v.good()) {
      part = next;
      solved = s;
      ratio = std::max(kFirstRatio, ratio * ratio);
    } else {
      s = solved;
      ratio = std::sqrt(ratio);
      if (ratio > kLargestRatio) break;
    }
  }
  return v;
}

}  // namespace shellback::coupling
