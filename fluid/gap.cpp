#include "fluid/gap.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::fluid {

Angles::Angles(const FilmGrid& g) {
  for (int i = 0; i < g.nt; ++i) {
    cos_cell.push_back(std::cos(g.phi[i]));
    sin_cell.push_back(std::sin(g.phi[i]));
    cos_face.push_back(std::cos(g.phi_face[i]));
    sin_face.push_back(std::sin(g.phi_face[i]));
  }
}

Field gap_slopes(const FilmGrid& g, const Angles& angles, int k) {
  Field slope(g.cells());
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      slope[g.index(i, j)] = gap_slope(k, angles.cos_cell[i], angles.sin_cell[i], g.z[j]);
    }
  }
  return slope;
}

namespace {

double rigid(double c, const JournalPosition& q, double cos_phi, double sin_phi, double z) {
  return c - (q.ex() + q.psi_y() * z) * cos_phi - (q.ey() - q.psi_x() * z) * sin_phi;
}

/// Of the values in a line of cells that on axial face j: mean of the neighbours by distance, or
/// continued.
struct OnAxialFace {
  int left = 0, right = 0;  ///< cells
  double share = 0.0;       ///< of the right one [-]
  OnAxialFace(const FilmGrid& g, int j) {
    if (g.nz == 1 || (j == 0 && g.half)) return;
    left = j == 0 ? 0 : (j == g.nz ? g.nz - 2 : j - 1);
    right = left + 1;
    share = (g.z_face[j] - g.z[left]) / (g.z[right] - g.z[left]);
  }
  [[nodiscard]] double of(const double* line) const {
    return line[left] + share * (line[right] - line[left]);
  }
};

/// The same on west face i of line j.
double on_phi_face(const FilmGrid& g, const Field& d, int i, int j) {
  const int west = g.previous(i);
  const double share = g.dphi[west] / (g.dphi[west] + g.dphi[i]);  // of the cell at i
  return share * d[g.index(i, j)] + (1.0 - share) * d[g.index(west, j)];
}

}  // namespace

void to_faces(const FilmGrid& g, const Field& d, std::vector<double>& phi_face,
              std::vector<double>& z_face) {
  phi_face.resize(g.cells());
  z_face.resize(static_cast<std::size_t>(g.nt) * (g.nz + 1));
  std::vector<OnAxialFace> axial;
  for (int j = 0; j <= g.nz; ++j) axial.emplace_back(g, j);
  for (int i = 0; i < g.nt; ++i) {
    const int west = g.previous(i);
    const double share = g.dphi[west] / (g.dphi[west] + g.dphi[i]);  // of the cell at i
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      phi_face[k] = share * d[k] + (1.0 - share) * d[g.index(west, j)];
    }
    for (int j = 0; j <= g.nz; ++j) {
      z_face[i * (g.nz + 1) + j] = axial[j].of(&d[g.index(i, 0)]);
    }
  }
}

int bent_edges(const Gap& gap) {
  const auto bent = [](const EdgeSlopes& s) { return s.line != 1.0; };
  return static_cast<int>(std::count_if(gap.edge.begin(), gap.edge.end(), bent)) +
         static_cast<int>(gap.bent_phi.size() + gap.bent_z.size());
}

EdgeGap edge_gap(double own, double line, double summits) {
  const double room = own + summits;
  if (line >= -kMostOfEdge * std::max(room, 0.0)) return {own + line, {}};
  if (room <= 0.0) return {own, {1.0, 0.0}};
  const double part = room / (-2.0 * line);  // below one
  return {0.5 * part * room - summits, {part, part * part}};
}

namespace {

/// The displacement of a pressed edge, continued to it.
void close_edges(const FilmGrid& g, const Field& d, const Field& profile, double summits,
                 Gap& gap) {
  for (int i = 0; i < g.nt; ++i) {
    for (const int j : {0, g.nz}) {
      if (j == 0 && g.half) continue;
      const int k = g.index(i, j == 0 ? 0 : g.nz - 1);
      const double line = OnAxialFace(g, j).of(&d[g.index(i, 0)]) - d[k];
      const double step = profile.empty() ? 0.0 : profile[k];
      double& face = gap.z_face[i * (g.nz + 1) + j];
      const EdgeGap edge = edge_gap(face - line + step, line, summits);
      if (edge.slope.line == 1.0) continue;
      if (gap.edge.empty()) gap.edge.resize(2 * static_cast<std::size_t>(g.nt));
      gap.edge[2 * static_cast<std::size_t>(i) + (j == 0 ? 0 : 1)] = edge.slope;
      face = edge.h - step;
    }
  }
}

/// Faces between film and supply, and at the foot of a smooth opening of the bore, on which `gap`
/// has the mean of both displacements.
struct InnerEdges {
  const FilmGrid& g;
  const Field& d;
  const Field& profile;
  const Gap* shape;
  const SupplyMap& supply;
  double summits;

  [[nodiscard]] bool parts(int a, int b) const {
    return (supply.cell[a] >= 0) != (supply.cell[b] >= 0);
  }
  /// Cell a or b, whichever is the land beside the other, whose ground opens by more than it is
  /// pressed away less; none: -1. `face`: axial, between them.
  [[nodiscard]] int land_beside_opening(int a, int b, int face) const {
    if (shape == nullptr || supply.cell[a] >= 0) return -1;
    const int land = d[a] > d[b] ? a : b;
    const int other = a + b - land;
    const double opens = shape->cell[other] - shape->z_face[face];
    return opens > d[land] - d[other] ? land : -1;
  }
  void bend(int face, int cell, double mean, std::vector<double>& faces,
            std::vector<BentFace>& bent) const {
    const double line = mean - d[cell];
    const double step = profile.empty() ? 0.0 : profile[cell];
    const EdgeGap edge = edge_gap(faces[face] - line + step, line, summits);
    if (edge.slope.line == 1.0) return;
    faces[face] = edge.h - step;
    bent.push_back({face, cell, edge.slope});
  }
  void bend_all(Gap& gap) const {
    for (int i = 0; i < g.nt; ++i) {
      const int west = g.previous(i);
      for (int j = 0; j < g.nz; ++j) {
        const int k = g.index(i, j), l = g.index(west, j);
        if (parts(l, k)) {
          bend(k, supply.cell[l] >= 0 ? k : l, on_phi_face(g, d, i, j), gap.phi_face, gap.bent_phi);
        }
        if (j == 0) continue;
        const int face = i * (g.nz + 1) + j;
        const int land = !parts(k - 1, k)          ? land_beside_opening(k - 1, k, face)
                         : supply.cell[k - 1] >= 0 ? k
                                                   : k - 1;
        if (land < 0) continue;
        bend(face, land, OnAxialFace(g, j).of(&d[g.index(i, 0)]), gap.z_face, gap.bent_z);
      }
    }
  }
};

}  // namespace

Gap film_gap(const FilmGrid& g, const Angles& a, double c, const JournalPosition& q, const Field& d,
             const Field& profile, const Gap* shape, double summits, const SupplyMap* supply) {
  Gap gap;
  if (d.empty()) {
    gap.phi_face.assign(g.cells(), 0.0);
    gap.z_face.assign(static_cast<std::size_t>(g.nt) * (g.nz + 1), 0.0);
  } else {
    to_faces(g, d, gap.phi_face, gap.z_face);
  }
  gap.cell = d.empty() ? Field(g.cells(), 0.0) : d;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      gap.cell[k] += rigid(c, q, a.cos_cell[i], a.sin_cell[i], g.z[j]);
      if (!profile.empty()) gap.cell[k] += profile[k];
      gap.phi_face[k] += rigid(c, q, a.cos_face[i], a.sin_face[i], g.z[j]);
    }
    for (int j = 0; j <= g.nz; ++j) {
      gap.z_face[i * (g.nz + 1) + j] += rigid(c, q, a.cos_cell[i], a.sin_cell[i], g.z_face[j]);
    }
  }
  if (shape != nullptr) {
    const auto add = [](const Field& from, Field& to) {
      for (std::size_t k = 0; k < to.size(); ++k) to[k] += from[k];
    };
    add(shape->cell, gap.cell);
    add(shape->phi_face, gap.phi_face);
    add(shape->z_face, gap.z_face);
  }
  if (d.empty()) return gap;
  close_edges(g, d, profile, summits, gap);
  if (supply != nullptr) InnerEdges{g, d, profile, shape, *supply, summits}.bend_all(gap);
  return gap;
}

namespace {

/// By which the cell is deeper than the bore around it [m].
double depth_at(const SupplyMap& supply, int cell) {
  const int patch = supply.cell[cell];
  return patch < 0 ? 0.0 : supply.patches[patch].depth;
}

}  // namespace

Field nominal_depth(const Gap& gap, const SupplyMap& supply) {
  Field h = gap.cell;
  for (std::size_t k = 0; k < h.size(); ++k) h[k] += depth_at(supply, static_cast<int>(k));
  return h;
}

SmallestGap smallest_gap(const FilmGrid& g, const Gap& gap, const Field& profile,
                         const SupplyMap& supply) {
  SmallestGap least{INFINITY, g.phi[0], g.z[0]};
  const auto step = [&](int k) {
    return depth_at(supply, k) + (profile.empty() ? 0.0 : profile[k]);
  };
  const auto consider = [&](double h, double phi, double z) {
    if (h < least.h) least = {h, phi, z};
  };
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      consider(gap.cell[k] + depth_at(supply, k), g.phi[i], g.z[j]);
      const double side = std::min(step(k), step(g.index(g.previous(i), j)));
      consider(gap.phi_face[k] + side, g.phi_face[i], g.z[j]);
    }
    for (const int j : {0, g.nz}) {
      if (j == 0 && g.half) continue;
      const double side = step(g.index(i, j == 0 ? 0 : g.nz - 1));
      consider(gap.z_face[i * (g.nz + 1) + j] + side, g.phi[i], g.z_face[j]);
    }
  }
  least.phi -= 2.0 * kPi * std::floor(least.phi / (2.0 * kPi));
  return least;
}

FilmPlace place_of(const FilmGrid& g, int cell) {
  if (cell < 0) return {};
  return {g.phi[cell / g.nz], g.z[cell % g.nz]};
}

}  // namespace shellback::fluid
