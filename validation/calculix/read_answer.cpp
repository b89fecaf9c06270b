#include <algorithm>
#include <cmath>
#include <cstdio>
#include <istream>
#include <stdexcept>
#include <string>

#include "validation/calculix/ring.hpp"

namespace shellback::calculix {
namespace {

struct Displacement {
  double x = 0.0, y = 0.0;  ///< [m]
};
using Displacements = std::vector<Displacement>;  ///< by node

/// Displacements of all nodes at the end of every step.
std::vector<Displacements> read_steps(std::istream& answer, std::size_t nodes) {
  std::vector<Displacements> steps;
  std::string line;
  while (std::getline(answer, line)) {
    if (line.find("displacements") != std::string::npos) {
      steps.emplace_back(nodes);
      continue;
    }
    long node = 0;
    Displacement u;
    if (steps.empty() || std::sscanf(line.c_str(), "%ld %lf %lf", &node, &u.x, &u.y) != 3) continue;
    steps.back().at(static_cast<std::size_t>(node) - 1) = u;
  }
  return steps;
}

/// Shape function of a brick's node at (xi, eta, zeta).
double shape(const std::array<int, 3>& offset, const std::array<double, 3>& at) {
  double corner = 1.0, sum = -2.0, edge = 1.0;
  bool mid = false;
  for (int d = 0; d < 3; ++d) {
    const double side = offset[d] - 1.0;
    corner *= 0.5 * (1.0 + side * at[d]);
    sum += side * at[d];
    edge *= offset[d] == 1 ? 1.0 - at[d] * at[d] : 0.5 * (1.0 + side * at[d]);
    mid = mid || offset[d] == 1;
  }
  return mid ? edge : corner * sum;
}

/// Mean of u_x over the volume: the translation of a ring that nothing holds.
double mean_along_x(const BrickMesh& mesh, const Displacements& u) {
  double volume = 0.0, sum = 0.0;
  for (int a = 0; a < mesh.bricks(0); ++a) {
    for (int b = 0; b < mesh.bricks(1); ++b) {
      for (int c = 0; c < mesh.bricks(2); ++c) {
        const auto brick = mesh.brick(a, b, c);
        const Node& low = mesh.nodes()[brick[0]];
        const Node& high = mesh.nodes()[brick[6]];
        const double box = 0.125 * (high.r - low.r) * (high.phi - low.phi) * (high.z - low.z);
        for (int q = 0; q < 125; ++q) {
          const GaussPoint& g = gauss_points()[q / 25];
          const GaussPoint& h = gauss_points()[q / 5 % 5];
          const GaussPoint& i = gauss_points()[q % 5];
          const double r = low.r + 0.5 * (1.0 + g.x) * (high.r - low.r);
          const double dv = r * box * g.w * h.w * i.w;
          volume += dv;
          for (std::size_t m = 0; m < brick.size(); ++m) {
            sum += dv * shape(brick_offsets()[m], {g.x, h.x, i.x}) * u[brick[m]].x;
          }
        }
      }
    }
  }
  return sum / volume;
}

/// Radial displacement of the bore along z on corner line j of the lattice, corners and mid-sides.
std::vector<double> along_z(const BrickMesh& mesh, const Displacements& u, int j) {
  std::vector<double> radial;
  for (int k = 0; k <= 2 * mesh.bricks(2); ++k) {
    const int node = mesh.at(0, j, k);
    const double phi = mesh.nodes()[node].phi;
    radial.push_back(u[node].x * std::cos(phi) + u[node].y * std::sin(phi));
  }
  return radial;
}

/// Mean over z_low .. z_high of the quadratics through the nodal values.
double mean(const std::vector<double>& z_line, const std::vector<double>& u, double z_low,
            double z_high) {
  double sum = 0.0;
  for (std::size_t c = 0; c + 1 < z_line.size(); ++c) {
    const double z0 = z_line[c], z1 = z_line[c + 1];
    const double low = std::max(z0, z_low), high = std::min(z1, z_high);
    if (high <= low) continue;
    for (const GaussPoint& g : gauss_points()) {
      const double z = 0.5 * (low + high) + 0.5 * (high - low) * g.x;
      const double t = (2.0 * z - z0 - z1) / (z1 - z0);
      sum += 0.5 * (high - low) * g.w *
             (0.5 * t * (t - 1.0) * u[2 * c] + (1.0 - t * t) * u[2 * c + 1] +
              0.5 * t * (t + 1.0) * u[2 * c + 2]);
    }
  }
  return sum / (z_high - z_low);
}

/// Faces of the film cells on z >= 0 of `cells` over the full width; an odd one has half a cell
/// at the plane of symmetry.
std::vector<double> film_faces(int cells) {
  const double dz = kWidth / cells;
  std::vector<double> face{0.0};
  for (double z = cells % 2 == 1 ? 0.5 * dz : dz; z < 0.5 * kWidth + 0.25 * dz; z += dz) {
    face.push_back(z);
  }
  return face;
}

/// Rows of the means on `cells` film cells, to be compared with a film of `film_cells`.
void write_cells(const Ring& ring, const Lines& lines, const BrickMesh& mesh,
                 const std::vector<Displacements>& steps, const std::vector<double>& translation,
                 int cells, int film_cells) {
  const auto face = film_faces(cells);
  for (int third = 0; third <= 3; ++third) {  // of the sector
    const int j = 2 * (third * mesh.bricks(1) / 3);
    const double phi = lines.phi[j / 2];
    for (std::size_t c = 0; c + 1 < face.size(); ++c) {
      const double z = cells % 2 == 1 && c == 0 ? 0.0 : 0.5 * (face[c] + face[c + 1]);
      std::printf("%.10g,%.10g,%.10g,%d,%d,%.10g,%.10g", ring.thickness * 1e6 + ring.poisson_ratio,
                  ring.thickness * 1e6, ring.poisson_ratio, cells, film_cells, phi * 180.0 / kPi,
                  z * 1e3);
      if (ring.load == Load::heat) std::printf(",");
      for (std::size_t s = 0; s < steps.size(); ++s) {
        const double u = mean(lines.z, along_z(mesh, steps[s], j), face[c], face[c + 1]);
        std::printf(",%.6g", (u - translation[s] * std::cos(phi)) * 1e6);
      }
      std::printf(ring.load == Load::pressure ? ",,,,\n" : "\n");
    }
  }
}

}  // namespace

void write_rows(const Ring& ring, std::istream& answer) {
  const Lines lines = mesh_lines(ring);
  const BrickMesh mesh(lines);
  const auto steps = read_steps(answer, mesh.nodes().size());
  const std::size_t expected = ring.load == Load::pressure ? 1 : 4;
  if (steps.size() != expected) throw std::runtime_error("the answer lacks steps of the deck");
  std::vector<double> translation(steps.size(), 0.0);
  for (std::size_t s = 0; s < 2 && ring.load == Load::heat; ++s) {  // outer surface free
    translation[s] = mean_along_x(mesh, steps[s]);
  }
  for (const int cells : {20, 25}) {
    write_cells(ring, lines, mesh, steps, translation, cells, cells);
    write_cells(ring, lines, mesh, steps, translation, cells, 4 * cells);
  }
}

}  // namespace shellback::calculix
