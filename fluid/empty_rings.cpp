#include "fluid/empty_rings.hpp"

namespace shellback::fluid {

std::vector<int> empty_rings(const FilmScene& scene, const FilmState& s) {
  const FilmGrid& g = scene.grid;
  std::vector<int> rings;
  std::vector<char> mouth(g.nz, 0);
  for (const Mouth& m : scene.supply.mouths) mouth[m.cell % g.nz] = 1;
  for (int j = 0; j < g.nz; ++j) {
    bool fed = mouth[j] != 0;
    for (int i = 0; i < g.nt; ++i) {
      const int k = g.index(i, j);
      fed = fed || s.full[k] || scene.supply.cell[k] >= 0 || scene.supply.line[k] >= 0;
    }
    if (!fed) rings.push_back(j);
  }
  return rings;
}

bool steady_ring_is_empty(const FilmScene& scene, const FilmState& s) {
  return !scene.storage.finite() && !empty_rings(scene, s).empty();
}

bool refill_empty_rings(const FilmScene& scene, FilmState& s) {
  const std::vector<int> rings = empty_rings(scene, s);
  for (const int j : rings) {
    for (int i = 0; i < scene.grid.nt; ++i) {
      const int k = scene.grid.index(i, j);
      s.full[k] = 1;
      s.theta[k] = 1.0;
    }
  }
  return !rings.empty();
}

}  // namespace shellback::fluid
