#include "fluid/resultants.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace shellback::fluid {

double wrench_weight(const FilmDomain& s, int k, int i, int j) {
  const FilmGrid& g = s.grid;
  if (g.half && k > 1) return 0.0;
  // d(gap)/d(position k) is also minus the arm of the pressure: virtual work.
  return g.multiplicity() * g.area(i, j) *
         gap_slope(k, s.angles.cos_cell[i], s.angles.sin_cell[i], g.z[j]);
}

Wrench wrench(const FilmDomain& s, const Field& p) {
  Wrench w{};
  const FilmGrid& g = s.grid;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      for (int k = 0; k < 4; ++k) w[k] += wrench_weight(s, k, i, j) * p[g.index(i, j)];
    }
  }
  return w;
}

namespace {

/// Of a supply that stands on the face between l and r; none: film on both sides.
std::optional<double> supplied_pressure(const FilmScene& s, const FilmState& state, int l, int r) {
  if (const int line = s.supply.line[r]; line >= 0) return s.supply.patches[line].pressure;
  if (s.supply.cell[l] >= 0) return state.p[l];
  if (s.supply.cell[r] >= 0) return state.p[r];
  return std::nullopt;
}

/// `at_face(l, r, part)`: pressure on the face where film is on both sides; the half of l is `part`
/// of the distance to r. Each half cell carries its own part of the difference.
template <class AtFace>
Field gradient_by(const FilmScene& s, const FilmState& state, const AtFace& at_face) {
  const FilmGrid& g = s.grid;
  Field gradient(g.cells(), 0.0);
  for (int i = 0; i < g.nt; ++i) {
    const int west = g.previous(i);
    const double near = 0.5 * g.radius * g.dphi[i];
    const double far = 0.5 * g.radius * g.dphi[west];
    for (int j = 0; j < g.nz; ++j) {
      const int r = g.index(i, j);
      const int l = g.index(west, j);
      const std::optional<double> supplied = supplied_pressure(s, state, l, r);
      const double p = supplied ? *supplied : at_face(l, r, far / (near + far));
      gradient[l] += (p - state.p[l]) / (2.0 * far);
      if (s.supply.cell[r] < 0) gradient[r] += (state.p[r] - p) / (2.0 * near);
    }
  }
  return gradient;
}

double series_pressure(const FilmState& state, const FilmFlow& flow, int l, int r) {
  const bool film = state.full[l] || state.full[r];  // else both stand at one pressure
  return state.p[l] + (film ? flow.phi[r].rise : 0.0);
}

}  // namespace

double face_pressure(const FilmScene& s, const FilmState& state, const FilmFlow& flow, int l,
                     int r) {
  return supplied_pressure(s, state, l, r).value_or(series_pressure(state, flow, l, r));
}

Field pressure_gradient_x(const FilmScene& s, const FilmState& state) {
  return gradient_by(s, state, [&](int l, int r, double part) {
    return state.p[l] + part * (state.p[r] - state.p[l]);
  });
}

Field pressure_gradient_x(const FilmScene& s, const FilmState& state, const FilmFlow& flow) {
  return gradient_by(s, state,
                     [&](int l, int r, double) { return series_pressure(state, flow, l, r); });
}

Field pressure_gradient_z(const FilmScene& s, const FilmState& state) {
  const FilmGrid& g = s.grid;
  Field gradient(g.cells(), 0.0);
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      if (g.half && g.z[j] == 0.0) continue;  // on the plane of symmetry
      if (s.supply.cell[k] >= 0) continue;
      // Pressure rise from the lower face to the upper one, each half cell its own part.
      const auto rise = [&](int other, double own, double whole) {
        const double d = state.p[other] - state.p[k];
        return s.supply.cell[other] >= 0 ? d : d * own / whole;
      };
      // Nothing flows in over a dry edge.
      const bool shut = s.edges == SideEdges::dry && state.p[k] <= s.p_edge;
      const double beyond = shut ? 0.0 : s.p_edge - state.p[k];
      double sum = 0.0;
      if (j > 0) {
        sum -= rise(k - 1, g.z[j] - g.z_face[j], g.z[j] - g.z[j - 1]);
      } else if (!g.half) {
        sum -= beyond;
      }
      if (j + 1 < g.nz) {
        sum += rise(k + 1, g.z_face[j + 1] - g.z[j], g.z[j + 1] - g.z[j]);
      } else {
        sum += beyond;
      }
      gradient[k] = sum / g.dz[j];
    }
  }
  return gradient;
}

Field cell_fill(const FilmScene& s, const FilmState& state) {
  const FilmGrid& g = s.grid;
  Field fill = state.theta;
  const auto carried = [&](int k) { return carried_out_of(s, state, k).value; };
  for (int i = 0; i < g.nt; ++i) {
    const int upstream = s.speed >= 0.0 ? g.previous(i) : g.next(i);
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      if (s.supply.cell[k] >= 0) continue;
      const int face = s.speed >= 0.0 ? k : g.index(upstream, j);  // on the upstream side
      const int line = s.supply.line[face];
      const double entering =
          line >= 0 ? s.supply.patches[line].fill : carried(g.index(upstream, j));
      fill[k] = 0.5 * (entering + carried(k));
    }
  }
  return fill;
}

ShearStress shear_stress(const FilmScene& s, const Field& h, const Field& g0, const Field& chi,
                         const FilmState& state, const Field& gradient, CavitatedShear rule) {
  ShearStress tau{Field(h.size()), Field(h.size())};
  GapTransport gap;
  gap_transport(s.rough, h, gap);
  Field phi_f(h.size()), phi_fs(h.size()), phi_total(h.size()), h_phi_fp(h.size());
  gap_shear(s.rough, h, {phi_f, phi_fs, phi_total, h_phi_fp});
  const Field fill = cell_fill(s, state);
  for (std::size_t k = 0; k < h.size(); ++k) {
    const double weight = rule == CavitatedShear::filled ? fill[k] : 1.0;
    const double couette = weight * s.speed / g0[k] * phi_total[k];
    const double carried = 0.5 * gap.sigma_phi_s[k];
    tau.journal[k] = couette + (chi[k] * gap.average_gap[k] + carried) * gradient[k];
    tau.shell[k] = couette - ((1.0 - chi[k]) * gap.average_gap[k] - carried) * gradient[k];
  }
  return tau;
}

double torque(const FilmDomain& s, const Field& tau) {
  const FilmGrid& g = s.grid;
  double sum = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) sum += tau[g.index(i, j)] * g.area(i, j);
  }
  return sum * g.radius * g.multiplicity();
}

OilFlows oil_flows(const FilmScene& s, const FilmFlow& flow) {
  const FilmGrid& g = s.grid;
  const double twice = g.multiplicity();
  OilFlows out;
  out.patch.assign(s.supply.patches.size(), 0.0);
  const Field net = net_outflow(s, flow);
  for (int k = 0; k < g.cells(); ++k) {
    const int patch = s.supply.cell[k];
    if (patch >= 0) out.patch[patch] += twice * net[k];
  }
  for (const LineFace& l : flow.lines) {
    out.patch[l.patch] += twice * (flow.phi[l.face].m - l.west.m);
  }
  for (std::size_t k = 0; k < flow.fed.size(); ++k) {
    out.patch[s.supply.mouths[k].patch] += twice * flow.fed[k];
  }
  for (const double q : out.patch) out.supply += q;
  for (const double m : flow.stored) out.stored += twice * m;
  for (int i = 0; i < g.nt; ++i) {
    const double low = g.half ? 0.0 : -flow.z[i * (g.nz + 1)].m;
    const double high = flow.z[i * (g.nz + 1) + g.nz].m;
    out.side += twice * (low + high);
    out.side_inflow += twice * (std::max(-low, 0.0) + std::max(-high, 0.0));
  }
  return out;
}

}  // namespace shellback::fluid
