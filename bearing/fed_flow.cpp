#include "bearing/fed_flow.hpp"

#include <cmath>

#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// A face between a patch and the film cell `k`, through which so much is pressed into the film.
void take_face(const Solution& s, int patch, int k, double m, double width, note::FedFlow& most) {
  const fluid::FilmScene& scene = s.point.scene;
  const double drive = scene.supply.patches[patch].pressure - scene.p_cavitation;
  if (!(m > 0.0) || !(drive > 0.0)) return;
  const double rho = s.film.oil.density[k];
  const double u = m / (rho * s.film.shear_gap[k] * width);
  most.reynolds = larger(most.reynolds, 12.0 * s.film.oil.fluidity[k] * m / width);
  const double head = 0.5 * rho * u * u;
  if (head / drive <= most.part) return;
  most.part = head / drive;
  most.velocity = u;
  most.head = head;
  most.place = fluid::place_of(scene.grid, k);
}

}  // namespace

note::FedFlow fed_flow(const Solution& s) {
  const FilmGrid& g = s.model.domain.grid;
  const fluid::SupplyMap& supply = s.point.scene.supply;
  note::FedFlow most;
  const auto look = [&](int before, int after, double m, double width) {
    const int from = supply.cell[before], into = supply.cell[after];
    if (from >= 0 && into < 0) take_face(s, from, after, m, width, most);
    if (into >= 0 && from < 0) take_face(s, into, before, -m, width, most);
  };
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int west = g.index((i + g.nt - 1) % g.nt, j), k = g.index(i, j);
      const fluid::FaceFlow& f = s.film.flow.phi[k];
      if (supply.line[k] >= 0) {
        take_face(s, supply.line[k], k, f.m - f.carried, g.dz[j], most);
      } else {
        look(west, k, f.m - f.carried, g.dz[j]);
      }
      if (j == 0) continue;
      look(g.index(i, j - 1), k, s.film.flow.z[i * (g.nz + 1) + j].m, g.radius * g.dphi[i]);
    }
  }
  for (const fluid::LineFace& l : s.film.flow.lines) {
    const int j = l.face % g.nz, west = g.index((l.face / g.nz + g.nt - 1) % g.nt, j);
    take_face(s, l.patch, west, l.west.carried - l.west.m, g.dz[j], most);
  }
  return most;
}

void add_fed_flow(const Solution& s, std::vector<Note>& notes) {
  const note::FedFlow most = fed_flow(s);
  if (most.part > kHeadThatCounts || most.reynolds > kTurbulentFlow) notes.push_back(most);
}

}  // namespace shellback::bearing
