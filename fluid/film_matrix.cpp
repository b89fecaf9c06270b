#include "fluid/film_matrix.hpp"

#include <algorithm>
#include <cmath>

#include "core/largest.hpp"

namespace shellback::fluid {

UnknownMap active_set_unknowns(const FilmState& s) {
  UnknownMap u;
  u.a_p.resize(s.p.size());
  u.a_theta.resize(s.p.size());
  for (std::size_t k = 0; k < s.p.size(); ++k) {
    u.a_p[k] = s.full[k] ? 1.0 : 0.0;
    u.a_theta[k] = s.full[k] ? 0.0 : 1.0;
  }
  return u;
}

namespace {

/// Adds the derivatives of face flow f, which leaves row `from` and enters row `to`, to the
/// diagonal entries and to the couplings `from_to` (row from, column to) and `to_from`.
void add_face(const FaceFlow& f, bool upstream_is_left, int from, int to, const UnknownMap& u,
              RingMatrix& a, double& from_to, double& to_from) {
  const double left =
      f.d_left * u.a_p[from] + (upstream_is_left ? f.d_theta * u.a_theta[from] : 0.0);
  const double right = f.d_right * u.a_p[to] + (upstream_is_left ? 0.0 : f.d_theta * u.a_theta[to]);
  a.c[from] += left;
  from_to += right;
  a.c[to] -= right;
  to_from -= left;
}

void fix_supply_rows(const FilmScene& scene, RingMatrix& a) {
  const FilmGrid& g = scene.grid;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      if (scene.supply.cell[k] < 0) continue;
      a.c[k] = 1.0;
      a.w[k] = a.e[k] = a.s[k] = a.n[k] = 0.0;
      a.e[g.index(g.previous(i), j)] = 0.0;  // a known value moves nobody
      a.w[g.index(g.next(i), j)] = 0.0;
      if (j > 0) a.n[k - 1] = 0.0;
      if (j + 1 < g.nz) a.s[k + 1] = 0.0;
    }
  }
}

}  // namespace

void assemble_film(const FilmScene& scene, const FilmFlow& flow, const UnknownMap& u,
                   RingMatrix& a) {
  const FilmGrid& g = scene.grid;
  const bool forward = scene.speed >= 0.0;
  a.resize(g.nt, g.nz);
  for (int i = 0; i < g.nt; ++i) {
    const int west = g.previous(i);
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      if (scene.supply.line[k] < 0) {
        const int l = g.index(west, j);
        add_face(flow.phi[k], forward, l, k, u, a, a.e[l], a.w[k]);
      } else {  // the line lies between: only the cell's own derivative
        const FaceFlow& f = flow.phi[k];
        a.c[k] -= f.d_right * u.a_p[k] + (forward ? 0.0 : f.d_theta * u.a_theta[k]);
      }
      const int f = i * (g.nz + 1) + j;
      if (j > 0) add_face(flow.z[f], true, k - 1, k, u, a, a.n[k - 1], a.s[k]);
    }
    const int first = g.index(i, 0);
    const int last = g.index(i, g.nz - 1);
    a.c[first] -= flow.z[i * (g.nz + 1)].d_right * u.a_p[first];
    a.c[last] += flow.z[i * (g.nz + 1) + g.nz].d_left * u.a_p[last];
  }
  for (const LineFace& l : flow.lines) {
    const int k = g.index(g.previous(l.face / g.nz), l.face % g.nz);
    a.c[k] += l.west.d_left * u.a_p[k] + (forward ? l.west.d_theta * u.a_theta[k] : 0.0);
  }
  for (std::size_t k = 0; k < flow.stored_by_theta.size(); ++k) {
    a.c[k] += flow.stored_by_theta[k] * u.a_theta[k] + flow.stored_by_p[k] * u.a_p[k];
  }
  for (const Mouth& m : scene.supply.mouths) a.c[m.cell] += m.conductance * u.a_p[m.cell];
  fix_supply_rows(scene, a);
}

namespace {

/// Adds d (c_a t_a weight_a + c_b t_b weight_b) to the row of cell `row`, which is a or b; `to_b`
/// or `to_a` is the row's coupling to the other one.
struct GapCoupling {
  const FilmScene& scene;
  const Field& c;
  RingMatrix& m;
  [[nodiscard]] bool film(int k) const { return scene.supply.cell[k] < 0; }
  void add(double d, int own, double own_weight, int other, double other_weight,
           double& coupling) const {
    if (!film(own)) return;
    m.c[own] += d * own_weight * c[own];
    if (film(other)) coupling += d * other_weight * c[other];
  }
};

/// Of line i on axial face j, 0 or nz.
EdgeSlopes edge_slopes(const FilmFlow& flow, int i, int j) {
  return flow.edge.empty() ? EdgeSlopes{}
                           : flow.edge[2 * static_cast<std::size_t>(i) + (j == 0 ? 0 : 1)];
}

/// What faces that are bent have otherwise than the mean of their cells, in the row of the land's
/// cell: that of a supply yields nothing, and in that of an opening little flows by the gap.
void bend_inner_edges(const FilmScene& scene, const FilmFlow& flow, const Field& c,
                      const std::vector<double>& into_line, RingMatrix& a) {
  const FilmGrid& g = scene.grid;
  const auto add = [&](const BentFace& f, double share, double out) {
    const double more = f.slope.own - f.slope.line + (f.slope.line - 1.0) * share;
    a.c[f.cell] += out * more * c[f.cell];
  };
  for (const BentFace& f : flow.bent_phi) {
    const int i = f.face / g.nz, west = g.previous(i);
    const double share = g.dphi[west] / (g.dphi[west] + g.dphi[i]);  // of the cell east of it
    const double d = flow.phi[f.face].d_h;
    if (f.cell == f.face) {
      add(f, share, -d);
    } else {
      add(f, 1.0 - share, scene.supply.line[f.face] < 0 ? d : into_line[f.face]);
    }
  }
  for (const BentFace& f : flow.bent_z) {
    const int j = f.face % (g.nz + 1);
    const double share = (g.z_face[j] - g.z[j - 1]) / (g.z[j] - g.z[j - 1]);
    const double d = flow.z[f.face].d_h;
    const bool above = f.cell % g.nz == j;
    add(f, above ? share : 1.0 - share, above ? -d : d);
  }
}

}  // namespace

void add_gap_compliance(const FilmScene& scene, const FilmFlow& flow, const Field& c,
                        RingMatrix& a) {
  const FilmGrid& g = scene.grid;
  const GapCoupling couple{scene, c, a};
  std::vector<double> into_line(scene.supply.has_lines ? g.cells() : 0, 0.0);
  for (const LineFace& l : flow.lines) into_line[l.face] = l.west.d_h;
  for (int i = 0; i < g.nt; ++i) {
    const int west = g.previous(i);
    const double share = g.dphi[west] / (g.dphi[west] + g.dphi[i]);
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      const int l = g.index(west, j);
      const double in = flow.phi[k].d_h;
      const double out = scene.supply.line[k] < 0 ? in : into_line[k];
      couple.add(out, l, 1.0 - share, k, share, a.e[l]);
      couple.add(-in, k, share, l, 1.0 - share, a.w[k]);
      if (j == 0) continue;
      const double d = flow.z[i * (g.nz + 1) + j].d_h;
      const double weight = (g.z_face[j] - g.z[j - 1]) / (g.z[j] - g.z[j - 1]);
      couple.add(d, k - 1, 1.0 - weight, k, weight, a.n[k - 1]);
      couple.add(-d, k, weight, k - 1, 1.0 - weight, a.s[k]);
    }
    // Side edges: continued from the two outermost cells, as edge_gap has it.
    const int first = g.index(i, 0);
    const int last = g.index(i, g.nz - 1);
    const double low = flow.z[i * (g.nz + 1)].d_h;
    const double high = flow.z[i * (g.nz + 1) + g.nz].d_h;
    if (g.nz == 1) {
      couple.add(high - low, first, 1.0, first, 0.0, a.c[first]);
      continue;
    }
    const double beyond_low = (g.z[0] - g.z_face[0]) / (g.z[1] - g.z[0]);
    const double beyond_high = (g.z_face[g.nz] - g.z[g.nz - 1]) / (g.z[g.nz - 1] - g.z[g.nz - 2]);
    const EdgeSlopes at_low = edge_slopes(flow, i, 0), at_high = edge_slopes(flow, i, g.nz);
    const double of_low = at_low.line * beyond_low, of_high = at_high.line * beyond_high;
    if (!g.half) couple.add(-low, first, at_low.own + of_low, first + 1, -of_low, a.n[first]);
    couple.add(high, last, at_high.own + of_high, last - 1, -of_high, a.s[last]);
  }
  bend_inner_edges(scene, flow, c, into_line, a);
  for (std::size_t k = 0; k < flow.stored_by_gap.size(); ++k) {
    if (couple.film(static_cast<int>(k))) a.c[k] += flow.stored_by_gap[k] * c[k];
  }
}

Field outflow_by_gap(const FilmScene& scene, const FilmFlow& flow,
                     const std::vector<double>& phi_face, const std::vector<double>& z_face) {
  const FilmGrid& g = scene.grid;
  Field r(g.cells(), 0.0);
  for (int i = 0; i < g.nt; ++i) {
    const int west = g.previous(i);
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      const double d = flow.phi[k].d_h * phi_face[k];
      r[k] -= d;
      if (scene.supply.line[k] < 0) r[g.index(west, j)] += d;
    }
    for (int j = 0; j <= g.nz; ++j) {
      const int f = i * (g.nz + 1) + j;
      const double d = flow.z[f].d_h * z_face[f];
      if (j > 0) r[g.index(i, j - 1)] += d;
      if (j < g.nz) r[g.index(i, j)] -= d;
    }
  }
  for (const LineFace& l : flow.lines) {
    const int i = l.face / g.nz;
    r[g.index(g.previous(i), l.face % g.nz)] += l.west.d_h * phi_face[l.face];
  }
  for (std::size_t k = 0; k < r.size(); ++k) {
    if (scene.supply.cell[k] >= 0) r[k] = 0.0;
  }
  return r;
}

Field residual_by_gap(const FilmScene& scene, const FilmFlow& flow, const Field& gap) {
  const FilmGrid& g = scene.grid;
  std::vector<double> phi, z;
  to_faces(g, gap, phi, z);
  for (int i = 0; i < g.nt && !flow.edge.empty(); ++i) {
    for (const int j : {0, g.nz}) {
      const EdgeSlopes slope = edge_slopes(flow, i, j);
      const double own = gap[g.index(i, j == 0 ? 0 : g.nz - 1)];
      double& face = z[i * (g.nz + 1) + j];
      face = slope.own * own + slope.line * (face - own);
    }
  }
  const auto bend = [&](const std::vector<BentFace>& bent, std::vector<double>& faces) {
    for (const BentFace& f : bent) {
      const double own = gap[f.cell];
      faces[f.face] = f.slope.own * own + f.slope.line * (faces[f.face] - own);
    }
  };
  bend(flow.bent_phi, phi);
  bend(flow.bent_z, z);
  Field r = outflow_by_gap(scene, flow, phi, z);
  for (std::size_t k = 0; k < flow.stored_by_gap.size(); ++k)
    r[k] += flow.stored_by_gap[k] * gap[k];
  return r;
}

Field residual_by_position(const FilmScene& scene, const FilmFlow& flow, int component) {
  const FilmGrid& g = scene.grid;
  const Angles& a = scene.angles;
  std::vector<double> phi(g.cells()), z(static_cast<std::size_t>(g.nt) * (g.nz + 1));
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      phi[g.index(i, j)] = gap_slope(component, a.cos_face[i], a.sin_face[i], g.z[j]);
    }
    for (int j = 0; j <= g.nz; ++j) {
      const double own = j == 0 || j == g.nz ? edge_slopes(flow, i, j).own : 1.0;
      z[i * (g.nz + 1) + j] = own * gap_slope(component, a.cos_cell[i], a.sin_cell[i], g.z_face[j]);
    }
  }
  for (const BentFace& f : flow.bent_phi) phi[f.face] *= f.slope.own;
  for (const BentFace& f : flow.bent_z) z[f.face] *= f.slope.own;
  Field r = outflow_by_gap(scene, flow, phi, z);
  if (flow.stored_by_gap.empty()) return r;
  const Field slope = gap_slopes(g, a, component);
  for (std::size_t k = 0; k < r.size(); ++k) r[k] += flow.stored_by_gap[k] * slope[k];
  return r;
}

Field film_residual(const FilmScene& scene, const FilmFlow& flow) {
  Field r = net_outflow(scene, flow);
  for (std::size_t k = 0; k < flow.stored.size(); ++k) r[k] += flow.stored[k];
  for (std::size_t k = 0; k < r.size(); ++k) {
    if (scene.supply.cell[k] >= 0) r[k] = 0.0;
  }
  return r;
}

double flow_by_pressure(const FilmScene& scene, const FilmFlow& flow, const Field& p) {
  const FilmGrid& g = scene.grid;
  double most = 0.0;
  const auto look = [&](const FaceFlow& f, double left, double right) {
    most = larger(most, larger(std::abs(f.d_left * left), std::abs(f.d_right * right)));
  };
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      look(flow.phi[k], p[g.index(g.previous(i), j)], p[k]);
      if (j > 0) look(flow.z[i * (g.nz + 1) + j], p[k - 1], p[k]);
    }
  }
  return most;
}

double flow_scale(const FilmFlow& flow) {
  double scale = 0.0;
  for (std::size_t k = 0; k < flow.phi.size(); ++k) {
    scale = std::max(scale, std::abs(flow.phi[k].d_theta));
    scale = std::max(scale, std::abs(flow.phi[k].m));
  }
  for (const double x : flow.stored) scale = std::max(scale, std::abs(x));
  return scale;
}

}  // namespace shellback::fluid
