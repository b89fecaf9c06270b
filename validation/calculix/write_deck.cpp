#include <cmath>
#include <cstdio>
#include <functional>

#include "validation/calculix/ring.hpp"

namespace shellback::calculix {
namespace {

/// Shape functions of the eight-node square; node (a, b) on the lattice 0, 1, 2.
double serendipity(int a, int b, double xi, double eta) {
  const double x = a - 1.0, y = b - 1.0;
  if (a == 1) return 0.5 * (1.0 - xi * xi) * (1.0 + y * eta);
  if (b == 1) return 0.5 * (1.0 + x * xi) * (1.0 - eta * eta);
  return 0.25 * (1.0 + x * xi) * (1.0 + y * eta) * (x * xi + y * eta - 1.0);
}

/// Force of the pressure on a node of the bore, radial and tangential [N].
struct Force {
  double radial = 0.0, tangential = 0.0;
};

std::vector<Force> patch_forces(const BrickMesh& mesh) {
  std::vector<Force> force(mesh.nodes().size());
  for (int b = 0; b < mesh.bricks(1); ++b) {
    for (int c = 0; c < mesh.bricks(2); ++c) {
      const Node& low = mesh.nodes()[mesh.at(0, 2 * b, 2 * c)];
      const Node& high = mesh.nodes()[mesh.at(0, 2 * b + 2, 2 * c + 2)];
      const double half_phi = 0.5 * (high.phi - low.phi), half_z = 0.5 * (high.z - low.z);
      for (const GaussPoint& g : gauss_points()) {
        for (const GaussPoint& h : gauss_points()) {
          const double phi = low.phi + half_phi * (1.0 + g.x), z = low.z + half_z * (1.0 + h.x);
          const double f = patch(phi, z) * g.w * h.w * kBore * half_phi * half_z;
          for (int m = 0; m < 9; ++m) {
            const int node = mesh.at(0, 2 * b + m / 3, 2 * c + m % 3);
            if (node < 0) continue;
            const double share = f * serendipity(m / 3, m % 3, g.x, h.x);
            const double turn = phi - mesh.nodes()[node].phi;
            force[node].radial += share * std::cos(turn);
            force[node].tangential += share * std::sin(turn);
          }
        }
      }
    }
  }
  return force;
}

void write_set(const BrickMesh& mesh, const char* name,
               const std::function<bool(const Node&)>& holds) {
  std::printf("*NSET,NSET=%s\n", name);
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    if (holds(mesh.nodes()[n])) std::printf("%zu,\n", n + 1);
  }
}

void write_bricks(const Ring& ring, const BrickMesh& mesh, const char* set, int first, int end) {
  std::printf("*ELEMENT,TYPE=%s,ELSET=%s\n", ring.reduced ? "C3D20R" : "C3D20", set);
  for (int a = first; a < end; ++a) {
    for (int b = 0; b < mesh.bricks(1); ++b) {
      for (int c = 0; c < mesh.bricks(2); ++c) {
        std::printf("%d", 1 + (a * mesh.bricks(1) + b) * mesh.bricks(2) + c);
        const auto brick = mesh.brick(a, b, c);
        for (std::size_t m = 0; m < brick.size(); ++m) {
          std::printf(m == 14 ? ",\n%d" : ",%d", brick[m] + 1);  // at most 16 numbers a line
        }
        std::printf("\n");
      }
    }
  }
}

void write_material(const char* name, const char* set, const Elastic& m) {
  std::printf("*MATERIAL,NAME=%s\n*ELASTIC\n%.10g,%.10g\n*EXPANSION\n%.10g\n", name,
              m.youngs_modulus, m.poisson_ratio, m.expansion);
  std::printf("*SOLID SECTION,ELSET=%s,MATERIAL=%s\n", set, name);
}

void write_model(const Ring& ring, const BrickMesh& mesh) {
  std::printf("** Layered ring, half width; units m, N, K. Layer %.4g um, nu = %.4g, %s mesh.\n",
              ring.thickness * 1e6, ring.poisson_ratio, ring.fine ? "fine" : "coarse");
  std::printf("*NODE,NSET=ALL\n");
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    const Node& p = mesh.nodes()[n];
    std::printf("%zu,%.12e,%.12e,%.12e\n", n + 1, p.r * std::cos(p.phi), p.r * std::sin(p.phi),
                p.z);
  }
  const int layer = layer_bricks(ring);
  write_bricks(ring, mesh, "LAYER", 0, layer);
  write_bricks(ring, mesh, "STEEL", layer, mesh.bricks(0));
  write_material("LAYER", "LAYER", {kLayerModulus, ring.poisson_ratio, kLayerExpansion});
  write_material("STEEL", "STEEL", kSteel);
  const int around = 2 * mesh.bricks(1), outwards = 2 * mesh.bricks(0);
  write_set(mesh, "BORE", [](const Node& p) { return p.i == 0; });
  write_set(mesh, "OUTER", [&](const Node& p) { return p.i == outwards; });
  write_set(mesh, "MIDDLE", [](const Node& p) { return p.k == 0; });
  write_set(mesh, "SIDES", [&](const Node& p) { return p.j == 0 || p.j == around; });
  write_set(mesh, "CYLINDRIC",
            [&](const Node& p) { return p.i == 0 || p.j == 0 || p.j == around; });
  std::printf("*TRANSFORM,NSET=CYLINDRIC,TYPE=C\n0,0,0,0,0,1\n");
  std::printf("*BOUNDARY\nSIDES,2,2\nMIDDLE,3,3\n");
}

void write_pressure_step(const BrickMesh& mesh) {
  std::printf("*BOUNDARY\nOUTER,1,3\n");
  std::printf("*STEP\n*STATIC\n*CLOAD\n");
  const auto force = patch_forces(mesh);
  for (std::size_t n = 0; n < force.size(); ++n) {
    if (force[n].radial == 0.0) continue;
    std::printf("%zu,1,%.10e\n%zu,2,%.10e\n", n + 1, force[n].radial, n + 1, force[n].tangential);
  }
  std::printf("*NODE PRINT,NSET=ALL,GLOBAL=YES\nU\n*END STEP\n");
}

void write_heat_steps(const BrickMesh& mesh) {
  // Outer surface free: one node at phi = 0 keeps the ring in place; the mean is taken off later.
  std::printf("*BOUNDARY\n%d,1,1\n", mesh.at(2 * mesh.bricks(0), 0, 0) + 1);
  std::printf("*INITIAL CONDITIONS,TYPE=TEMPERATURE\nALL,0\n");
  for (const bool clamped : {false, true}) {
    for (const bool uneven : {false, true}) {
      std::printf("*STEP\n*STATIC\n");
      if (clamped && !uneven) std::printf("*BOUNDARY\nOUTER,1,3\n");
      std::printf("*TEMPERATURE\n");
      for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
        const Node& p = mesh.nodes()[n];
        std::printf("%zu,%.10e\n", n + 1, uneven ? uneven_heat(p.r, p.phi, p.z) : kHeating);
      }
      std::printf("*NODE PRINT,NSET=ALL,GLOBAL=YES\nU\n*END STEP\n");
    }
  }
}

}  // namespace

void write_deck(const Ring& ring) {
  const BrickMesh mesh(mesh_lines(ring));
  write_model(ring, mesh);
  if (ring.load == Load::pressure) {
    write_pressure_step(mesh);
  } else {
    write_heat_steps(mesh);
  }
}

}  // namespace shellback::calculix
