#include "fluid/film_update.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::fluid {

UpdateReport advance(const FilmScene& scene, const FilmCoefficients& oil, const Field& step,
                     double fraction, FilmState& s, double most_barus) {
  UpdateReport report;
  for (std::size_t k = 0; k < step.size(); ++k) {
    if (scene.supply.cell[k] >= 0) continue;
    const double t = fraction * step[k];
    if (s.full[k]) {
      double x = oil.alpha[k] * t;
      if (x >= 1.0) {
        ++report.beyond_barus;
        report.worst_cell = static_cast<int>(k);
      }
      x = std::min(x, most_barus);
      s.p[k] += oil.alpha[k] > 0.0 ? -std::log1p(-x) / oil.alpha[k] : t;
      if (s.p[k] < scene.p_cavitation) {
        s.p[k] = scene.p_cavitation;
        s.full[k] = 0;
        ++report.moved;
      }
    } else {
      s.theta[k] += t;
      if (s.theta[k] > 1.0) {
        s.full[k] = 1;
        s.theta[k] = 1.0;
        ++report.moved;
      }
    }
  }
  return report;
}

FilmState cold_film(const FilmScene& scene) {
  const auto n = static_cast<std::size_t>(scene.grid.cells());
  FilmState s{Field(n, std::max(scene.p_edge, scene.p_cavitation)), Field(n, 1.0),
              std::vector<char>(n, 1)};
  impose_supply(scene.supply, s);
  return s;
}

void impose_supply(const SupplyMap& supply, FilmState& s) {
  for (std::size_t k = 0; k < s.p.size(); ++k) {
    const int patch = supply.cell[k];
    if (patch < 0) continue;
    s.p[k] = supply.patches[patch].pressure;
    s.theta[k] = supply.patches[patch].fill;
    s.full[k] = 1;
  }
}

}  // namespace shellback::fluid
