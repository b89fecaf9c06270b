#include "bearing/film/pockets.hpp"

namespace shellback::bearing {

std::vector<double> oil_in_pockets(const BearingModel& model, const FilmEquilibrium& film) {
  const FilmGrid& g = model.domain.grid;
  std::vector<double> oil(model.supply.patches.size(), 0.0);
  for (int c = 0; c < g.cells(); ++c) {
    const int patch = model.supply.cell[c];
    if (patch < 0) continue;
    oil[patch] += g.multiplicity() * film.oil.density[c] * film.gap.cell[c] * g.area(c);
  }
  return oil;
}

void count_pockets(const BearingModel& model, const FilmEquilibrium& film,
                   const std::vector<double>& star, double own, fluid::OilFlows& flows) {
  flows.pocket = oil_in_pockets(model, film);
  for (std::size_t k = 0; k < star.size(); ++k) {
    flows.pocket[k] = (flows.pocket[k] - star[k]) / own;
    flows.patch[k] += flows.pocket[k];
    flows.supply += flows.pocket[k];
  }
}

double work_on_pockets(const BearingModel& model, const FilmEquilibrium& before,
                       const FilmEquilibrium& after) {
  const FilmGrid& g = model.domain.grid;
  double work = 0.0;
  for (int c = 0; c < g.cells(); ++c) {
    if (model.supply.cell[c] < 0) continue;
    const double mean = 0.5 * (before.film.p[c] + after.film.p[c]);
    work += mean * (after.gap.cell[c] - before.gap.cell[c]) * g.area(c);
  }
  return g.multiplicity() * work;
}

}  // namespace shellback::bearing
