/// What the walls answer within a turn.
#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/largest.hpp"
#include "coupling/thermal_turn.hpp"

namespace shellback::coupling {

void ThermalTurn::impose_walls(std::vector<double>& T) const {
  const FilmGrid& g = model_.scene.grid;
  const int n = model_.gl.n;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      if (model_.scene.supply.cell[c] >= 0) continue;
      T[c * n] = heat_.T_shell[c];
      T[c * n + n - 1] = heat_.T_shaft[j];
    }
  }
}

void ThermalTurn::warm_the_walls(const thermal::FilmEnergy& energy, Solids::Wanted wanted) {
  const FilmGrid& g = model_.scene.grid;
  const thermal::WallHeat walls = energy.wall_heat(film_.columns.T);
  const ContactHeat rubbed = contact_heat(model_, film_);
  WallFlux q{walls.shell, std::vector<double>(g.nz, 0.0), heat_.response};
  heat_.contact_heat = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      q.shell[c] = q.shell[c] / g.area(i, j) + rubbed.shell[c];
      q.shaft[j] += (walls.shaft[c] / g.area(i, j) + rubbed.shaft[c]) * g.dphi[i] / (2.0 * kPi);
      heat_.contact_heat += g.multiplicity() * g.area(i, j) * (rubbed.shell[c] + rubbed.shaft[c]);
    }
  }
  heat_.solids = model_.solids->answer(q, heat_.T_shell, heat_.T_shaft, wanted);
}

double ThermalTurn::take_wall_temperatures() {
  const double change = larger(largest_difference(heat_.solids.shell.surface, heat_.T_shell),
                               largest_difference(heat_.solids.shaft.temperature, heat_.T_shaft));
  heat_.T_shell = heat_.solids.shell.surface;
  heat_.T_shaft = heat_.solids.shaft.temperature;
  impose_walls(film_.columns.T);
  return change;
}

double ThermalTurn::wall_round(thermal::FilmEnergy& energy) {
  for (int k = 0; k < options_.sweeps; ++k) energy.sweep(film_.columns.T);
  warm_the_walls(energy, {false, false});
  return take_wall_temperatures();
}

double ThermalTurn::balance_walls(thermal::FilmEnergy& energy, double enough, int rounds) {
  constexpr int kDepth = 12;
  const std::size_t cells = heat_.T_shell.size();
  double least = INFINITY;  // of the best round: the walls are left as they were there
  std::vector<double> best_T = film_.columns.T;
  HeatState best = heat_;
  const auto round = [&](const std::vector<double>& x, std::vector<double>& g) {
    std::copy_n(x.begin(), cells, heat_.T_shell.begin());
    std::copy(x.begin() + cells, x.end(), heat_.T_shaft.begin());
    impose_walls(film_.columns.T);
    const double change = wall_round(energy);
    if (change < least) {
      least = change;
      best_T = film_.columns.T;
      best = heat_;
    }
    g = heat_.T_shell;
    g.insert(g.end(), heat_.T_shaft.begin(), heat_.T_shaft.end());
    return true;
  };
  std::vector<double> x = heat_.T_shell;
  x.insert(x.end(), heat_.T_shaft.begin(), heat_.T_shaft.end());
  const auto end = fixed_point(round, {kDepth, 1, rounds, enough}, x);
  if (end != FixedPointEnd::converged) {
    film_.columns.T = best_T;
    heat_ = best;
  }
  return least;
}

}  // namespace shellback::coupling
