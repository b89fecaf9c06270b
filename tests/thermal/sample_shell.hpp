#pragma once
/// Shell of two layers, soft lining on steel, for the tests of thermal/revolution_conduction.
#include <random>
#include <vector>

#include "core/make_grid.hpp"
#include "thermal/revolution_conduction.hpp"

namespace shellback::thermal::tests {

inline const std::vector<double> kThickness{1e-3, 12e-3};
inline const std::vector<double> kConductivity{0.8, 50.0};
inline constexpr double kRadius = 0.024, kWidth = 0.018;

struct Shell {
  FilmGrid grid;
  RevolutionMesh mesh;
};
inline Shell shell(bool half, int halvings = 0, const GridEdges& phi_edges = {}) {
  Shell s;
  s.grid = make_grid(kRadius, kWidth, 64, 13, half, phi_edges);
  auto rows = rows_outwards(kRadius, kThickness, surface_row(kRadius, 32));
  for (int k = 0; k < halvings; ++k) rows = halved(rows);
  s.mesh = make_revolution_mesh(rows.face, rows.layer, axial_elements(s.grid), half);
  return s;
}

inline ShellConduction conduction(const Shell& s, ConductionBoundary boundary, int layer,
                                  int highest) {
  boundary.back_line = outer_line(s.mesh, layer);
  return ShellConduction(s.mesh, s.grid, kConductivity, boundary, Harmonics(s.grid, highest));
}

inline const ConductionBoundary kConvective{BackKind::convective, 400.0, 60.0};
inline const ConductionBoundary kPrescribed{BackKind::prescribed, 0.0, 60.0};

inline Field random_flux(const FilmGrid& grid, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-2e4, 8e4);
  Field q(grid.cells());
  for (double& x : q) x = uniform(engine);
  return q;
}

}  // namespace shellback::thermal::tests
