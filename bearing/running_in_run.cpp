#include "bearing/running_in_run.hpp"

#include <algorithm>

namespace shellback::bearing {

Profile wear_table(const FilmGrid& g, const Field& wear) {
  Profile table;
  table.phi = g.phi;
  table.z.push_back(g.z_face.front());
  table.z.insert(table.z.end(), g.z.begin(), g.z.end());
  table.z.push_back(g.z_face.back());
  const auto beyond = [&](int i, int last, int inner, double z) {
    const double a = wear[g.index(i, last)];
    if (last == inner) return a;
    const double slope = (a - wear[g.index(i, inner)]) / (g.z[last] - g.z[inner]);
    return std::max(0.0, a + slope * (z - g.z[last]));
  };
  const int end = g.nz - 1;
  for (int i = 0; i < g.nt; ++i) {
    table.height.push_back(beyond(i, 0, std::min(1, end), g.z_face.front()));
    for (int j = 0; j < g.nz; ++j) table.height.push_back(wear[g.index(i, j)]);
    table.height.push_back(beyond(i, end, std::max(end - 1, 0), g.z_face.back()));
  }
  return table;
}

}  // namespace shellback::bearing
