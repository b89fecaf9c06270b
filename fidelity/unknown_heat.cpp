#include "fidelity/unknown_heat.hpp"

#include <algorithm>

#include "fidelity/frozen_film.hpp"

namespace shellback::fidelity {

using namespace coupling;

Bars unknown_heat(const Solution& lumped, EquilibriumCost& cost, const std::atomic<bool>* stop) {
  Bars bars{0.0, 0.0};
  const double rise = lumped.T_film - lumped.model.input.supplies.front().temperature;
  if (rise == 0.0) return bars;
  const auto friction = [](const Solution& s) {
    const Friction f = friction_of(s.model, s.film);
    return f.viscous + f.asperity;
  };
  const FilmGrid& g = lumped.model.scene.grid;
  for (const double part : {kUnknownHeat, -kUnknownHeat}) {
    Frozen warmer;
    warmer.warmer = part * rise;
    const Solution s = frozen_film(lumped, {g.nt, g.full_nz()}, warmer, stop);
    cost.factorizations += s.cost.factorizations;
    cost.newton_iterations += s.cost.newton_iterations;
    const bool good = s.verdict.good();
    const double f = good ? std::abs(friction(s) / friction(lumped) - 1.0) : INFINITY;
    const double h = good ? std::abs(s.film.least.h / lumped.film.least.h - 1.0) : INFINITY;
    bars.friction = std::max(bars.friction, f);
    bars.h_min = std::max(bars.h_min, h);
  }
  return bars;
}

}  // namespace shellback::fidelity
