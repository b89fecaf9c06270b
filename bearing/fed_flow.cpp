#include "bearing/fed_flow.hpp"

#include <cmath>

#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// A face between a patch and the film cell `k`, through which so much is pressed into the film.
void take_face(const fluid::FilmScene& scene, const Evaluation& film, int patch, int k, double m,
               double width, note::FedFlow& most) {
  const double drive = scene.supply.patches[patch].pressure - scene.p_cavitation;
  if (!(m > 0.0) || !(drive > 0.0)) return;
  const double rho = film.oil.density[k];
  const double u = m / (rho * film.shear_gap[k] * width);
  const double head = 0.5 * rho * u * u;
  const double reynolds = 12.0 * film.oil.fluidity[k] * m / width;
  most = worse(most, {u, head, head / drive, reynolds, fluid::place_of(scene.grid, k)});
}

}  // namespace

note::FedFlow worse(note::FedFlow a, const note::FedFlow& b) {
  const double reynolds = larger(a.reynolds, b.reynolds);
  if (b.part > a.part) a = b;
  a.reynolds = reynolds;
  return a;
}

note::FedFlow fed_flow(const fluid::FilmScene& scene, const Evaluation& film) {
  const FilmGrid& g = scene.grid;
  const fluid::SupplyMap& supply = scene.supply;
  note::FedFlow most;
  const auto out_of = [&](int patch, int k, double m, double width) {
    take_face(scene, film, patch, k, m, width, most);
  };
  const auto look = [&](int before, int after, double m, double width) {
    const int from = supply.cell[before], into = supply.cell[after];
    if (from >= 0 && into < 0) out_of(from, after, m, width);
    if (into >= 0 && from < 0) out_of(into, before, -m, width);
  };
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int west = g.index((i + g.nt - 1) % g.nt, j), k = g.index(i, j);
      const fluid::FaceFlow& f = film.flow.phi[k];
      if (supply.line[k] >= 0) {
        out_of(supply.line[k], k, f.m - f.carried, g.dz[j]);
      } else {
        look(west, k, f.m - f.carried, g.dz[j]);
      }
      if (j == 0) continue;
      look(g.index(i, j - 1), k, film.flow.z[i * (g.nz + 1) + j].m, g.radius * g.dphi[i]);
    }
  }
  for (const fluid::LineFace& l : film.flow.lines) {
    const int j = l.face % g.nz, west = g.index((l.face / g.nz + g.nt - 1) % g.nt, j);
    out_of(l.patch, west, l.west.carried - l.west.m, g.dz[j]);
  }
  return most;
}

void add_fed_flow(const note::FedFlow& flow, std::vector<Note>& notes) {
  if (flow.part > kHeadThatCounts || flow.reynolds > kTurbulentFlow) notes.push_back(flow);
}

}  // namespace shellback::bearing
