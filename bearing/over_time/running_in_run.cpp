#include "bearing/over_time/running_in_run.hpp"

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

solid::RoughSurface worn_surface(const Case& c, double depth) {
  const RunningIn& given = *c.running_in;
  solid::RoughSurface shell = c.surfaces.shell;
  if (!given.worn) return shell;
  const double part = std::min(1.0, depth / given.worn_after);
  const auto mix = [part](double& a, double b) { a += part * (b - a); };
  mix(shell.roughness, given.worn->roughness);
  mix(shell.orientation, given.worn->orientation);
  mix(shell.summit_roughness, given.worn->summit_roughness);
  mix(shell.summit_height, given.worn->summit_height);
  return shell;
}

}  // namespace shellback::bearing
