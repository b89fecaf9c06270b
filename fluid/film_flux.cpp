#include "fluid/film_flux.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::fluid {
namespace {

/// Logarithmic mean of two positive numbers with its derivative by the first; r = ln a - ln b.
struct LogMean {
  double value;
  double d_first;
};
LogMean log_mean(double a, double b, double r) {
  constexpr double kSeries = 0.1;  ///< below: series, to avoid 0/0; error (r/2)^8/46 < 1e-12
  const double mean = 0.5 * (a + b);
  if (std::abs(r) < kSeries) {
    const double x2 = 0.25 * r * r;
    const double value = mean * (1.0 - x2 * (1.0 / 3.0 - x2 * (2.0 / 15.0 - x2 * 17.0 / 315.0)));
    // (1 - L/a)/r expanded with L/a = (1 - exp(-r))/r
    return {value, 0.5 - r * (1.0 / 6.0 - r * (1.0 / 24.0 - r * (1.0 / 120.0 - r / 720.0)))};
  }
  const double value = (a - b) / r;
  return {value, (1.0 - value / a) / r};
}

/// One side of a face: the half cell between its unknown and the face.
struct Half {
  double distance;         ///< [m]
  double h3;               ///< pressure-flow conductance h^3 phi [m3]
  double dh3;              ///< its derivative [m2]
  double couette;          ///< chi hT + sigma phi_s / 2 [m]
  double dcouette;         ///< its derivative [-]
  double ddistance = 0.0;  ///< derivative of the distance [-]
};

/// f of film_flux.hpp and its derivative.
struct Opening {
  double f;
  double df;
};
Opening opening(double x) {
  const double to = 1.0 + std::abs(x);
  const double f = (1.0 + 0.5 * std::abs(x)) / (to * to);
  const double df = 0.5 / (to * to) - 2.0 * f / to;  // even: f(x) = 2 - f(-x)
  return {x < 0.0 ? 2.0 - f : f, df};
}

/// Part of what a cell's flow follows its slope of pressure by, that counts at a face. The cell's
/// slope is the mean over its two faces, which stands to that of a face as cos^2 of half the phase
/// of a wave from cell to cell: from 1 (smooth) to 0 (up and down). With the middle Newton's
/// iteration leaves half of the effect at worst, the least that a single number can.
constexpr double kOfFace = 0.5;

/// Side of a face as the pressure law sees it.
struct Side {
  double p;
  double g;
  double ln_g;
  double alpha;
  double thins = 0.0;  ///< flow that follows the slope across the face, over g h^3 [-]
};

/// Flow through a face of `length` from `left` to `right`; both halves in series. Divisions cost
/// what ten products do: each divisor is inverted once.
FaceFlow series_flow(const Half& a, const Half& b, const Side& left, const Side& right,
                     CarriedFill fill, double speed, double rho, double length) {
  const double over_a = 1.0 / a.h3;
  const double over_b = 1.0 / b.h3;
  const double ra = a.distance * over_a;
  const double rb = b.distance * over_b;
  const double over_sum = 1.0 / (ra + rb);
  const LogMean g = log_mean(left.g, right.g, left.ln_g - right.ln_g);
  const LogMean g_back = log_mean(right.g, left.g, right.ln_g - left.ln_g);
  const double dp = left.p - right.p;
  const double couette = speed * (ra * a.couette + rb * b.couette) * over_sum;
  const double poiseuille = g.value * dp * over_sum;
  const double scale = rho * length;
  FaceFlow f;
  f.couette = scale * couette;
  f.carried = fill.value * f.couette;
  f.m = f.carried + scale * poiseuille;
  f.rise = -ra * over_sum * (dp + fill.value * speed * rb * (b.couette - a.couette) / g.value);
  f.d_theta = fill.slope * f.couette;
  const double by_slope = g.value * (1.0 + kOfFace * 0.5 * (left.thins + right.thins));
  f.d_left = scale * over_sum * (by_slope - dp * g.d_first * left.alpha * left.g);
  f.d_right = -scale * over_sum * (by_slope + dp * g_back.d_first * right.alpha * right.g);
  const double dra = (a.ddistance - ra * a.dh3) * over_a;
  const double drb = (b.ddistance - rb * b.dh3) * over_b;
  const double jump = speed * (a.couette - b.couette) * over_sum;
  f.d_h =
      scale * over_sum *
      (fill.value * (speed * (ra * a.dcouette + rb * b.dcouette) + jump * (rb * dra - ra * drb)) -
       poiseuille * (dra + drb));
  return f;
}

/// Flow from a half cell to a place of given pressure at the face (or from it, by `sign` = -1).
FaceFlow half_flow(const Half& a, const Side& cell, const Side& face, CarriedFill fill,
                   double speed, double rho, double length, int sign) {
  const LogMean g = log_mean(cell.g, face.g, cell.ln_g - face.ln_g);
  const double dp = cell.p - face.p;
  const double conductance = rho * length * a.h3 / a.distance;
  const double couette = rho * length * speed * a.couette;
  FaceFlow f;
  f.couette = couette;
  f.carried = fill.value * couette;
  f.m = f.carried + sign * conductance * g.value * dp;
  f.d_theta = fill.slope * couette;
  const double d =
      conductance * (g.value * (1.0 + kOfFace * cell.thins) - dp * g.d_first * cell.alpha * cell.g);
  (sign > 0 ? f.d_left : f.d_right) = sign * d;
  const double dconductance = (a.dh3 - a.h3 * a.ddistance / a.distance) / a.distance;
  f.d_h = rho * length * (fill.value * speed * a.dcouette + sign * dconductance * g.value * dp);
  return f;
}

/// Gap-dependent factors at many gaps at once.
struct Transport {
  GapTransport at;
  Half half(std::size_t k, double distance, double chi, bool axial) const {
    return {distance, axial ? at.h3_z[k] : at.h3_x[k], axial ? at.dh3_z[k] : at.dh3_x[k],
            chi * at.average_gap[k] + 0.5 * at.sigma_phi_s[k],
            chi * at.daverage_gap[k] + 0.5 * at.dsigma_phi_s[k]};
  }
  /// Half cell along the axis beside face k, the shape of the bore opening by `rise` towards its
  /// unknown.
  Half axial_half(std::size_t k, double distance, const Field& rise) const {
    Half h = half(k, distance, 0.0, true);
    if (rise.empty() || rise[k] == 0.0) return h;
    const double x = rise[k] / at.average_gap[k];
    const Opening o = opening(x);
    h.distance = o.f * distance;
    h.ddistance = -o.df * distance * x / at.average_gap[k] * at.daverage_gap[k];
    return h;
  }
};

struct Evaluation {
  const FilmScene& scene;
  const Gap& gap;
  const Field& profile;
  const FilmCoefficients& oil;
  const FilmState& state;
  Field ln_g;

  [[nodiscard]] Side side(int k, const Field& thins) const {
    return {state.p[k], oil.fluidity[k], ln_g[k], oil.alpha[k], thins.empty() ? 0.0 : thins[k]};
  }
  [[nodiscard]] Side around(int k) const { return side(k, oil.thins_around); }
  [[nodiscard]] Side along(int k) const { return side(k, oil.thins_along); }
  /// The oil of cell k at pressure p: fluidity follows the local pressure slope.
  [[nodiscard]] Side at_pressure(int k, double p) const {
    const double ln = ln_g[k] - oil.alpha[k] * (p - state.p[k]);
    return {p, std::exp(ln), ln, oil.alpha[k]};
  }
  [[nodiscard]] bool steps() const { return !profile.empty(); }
  /// What the journal carries out of cell k.
  [[nodiscard]] CarriedFill out_of(int k) const { return carried_out_of(scene, state, k); }
};

/// Gaps on the two sides of every face (the second side only if there are steps).
void side_gaps(const Evaluation& e, std::vector<double>& left, std::vector<double>& right) {
  const FilmGrid& g = e.scene.grid;
  left = e.gap.phi_face;
  right = left;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      left[g.index(i, j)] += e.profile[g.index(g.previous(i), j)];
      right[g.index(i, j)] += e.profile[g.index(i, j)];
    }
  }
}

void axial_side_gaps(const Evaluation& e, std::vector<double>& left, std::vector<double>& right) {
  const FilmGrid& g = e.scene.grid;
  left = e.gap.z_face;
  right = left;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j <= g.nz; ++j) {
      left[i * (g.nz + 1) + j] += e.profile[g.index(i, std::max(j - 1, 0))];
      right[i * (g.nz + 1) + j] += e.profile[g.index(i, std::min(j, g.nz - 1))];
    }
  }
}

void circumferential_faces(const Evaluation& e, FilmFlow& flow) {
  const FilmGrid& g = e.scene.grid;
  const double U = e.scene.speed;
  std::vector<double> h_left, h_right;
  if (e.steps()) side_gaps(e, h_left, h_right);
  Transport a, b;
  gap_transport(e.scene.rough, e.steps() ? h_left : e.gap.phi_face, a.at);
  if (e.steps()) gap_transport(e.scene.rough, h_right, b.at);
  const Transport& c = e.steps() ? b : a;
  flow.phi.resize(g.cells());
  flow.lines.clear();
  for (int i = 0; i < g.nt; ++i) {
    const int west = g.previous(i);
    for (int j = 0; j < g.nz; ++j) {
      const int r = g.index(i, j);
      const int l = g.index(west, j);
      const bool from_supply = e.scene.supply.cell[l] >= 0;
      const bool to_supply = e.scene.supply.cell[r] >= 0;
      if (from_supply && to_supply) {  // inside a groove: no film
        flow.phi[r] = {};
        continue;
      }
      // A patch has its pressure up to its edge: nothing drops in its own half of the link.
      const double reach = e.scene.supply.phi_reach[r];
      const double of_l = to_supply ? reach : 0.5 * g.radius * g.dphi[west];
      const double of_r = from_supply ? reach : 0.5 * g.radius * g.dphi[i];
      const Half ha = a.half(r, from_supply ? 0.0 : of_l, e.oil.chi[l], false);
      const Half hb = c.half(r, to_supply ? 0.0 : of_r, e.oil.chi[r], false);
      const int line = e.scene.supply.line[r];
      if (line < 0) {
        const CarriedFill fill = e.out_of(U >= 0.0 ? l : r);
        const double rho = 0.5 * (e.oil.density[l] + e.oil.density[r]);
        flow.phi[r] = series_flow(ha, hb, e.around(l), e.around(r), fill, U, rho, g.dz[j]);
        continue;
      }
      const double p = e.scene.supply.patches[line].pressure;
      const CarriedFill supplied{e.scene.supply.patches[line].fill, 1.0};
      const CarriedFill in = U >= 0.0 ? e.out_of(l) : supplied;
      const CarriedFill out = U >= 0.0 ? supplied : e.out_of(r);
      flow.lines.push_back(
          {r, line,
           half_flow(ha, e.around(l), e.at_pressure(l, p), in, U, e.oil.density[l], g.dz[j], 1)});
      flow.phi[r] =
          half_flow(hb, e.around(r), e.at_pressure(r, p), out, U, e.oil.density[r], g.dz[j], -1);
    }
  }
}

/// Side edge j (0 or nz) of line i: flow in +z between the outermost cell and the surroundings.
FaceFlow edge_flow(const Evaluation& e, const Transport& t, int i, int j) {
  const FilmGrid& g = e.scene.grid;
  const int k = g.index(i, j == 0 ? 0 : g.nz - 1);
  const double distance = std::abs(g.z_face[j] - g.z[j == 0 ? 0 : g.nz - 1]);
  const ShapeBeside& shape = e.scene.shape_beside;
  const Half half = t.axial_half(static_cast<std::size_t>(i) * (g.nz + 1) + j, distance,
                                 j == 0 ? shape.above : shape.below);
  const int sign = j == 0 ? -1 : 1;
  if (e.scene.edges == SideEdges::dry && e.state.p[k] <= e.scene.p_edge) return {};
  return half_flow(half, e.along(k), e.at_pressure(k, e.scene.p_edge), {}, 0.0, e.oil.density[k],
                   g.radius * g.dphi[i], sign);
}

void axial_faces(const Evaluation& e, FilmFlow& flow) {
  const FilmGrid& g = e.scene.grid;
  std::vector<double> h_left, h_right;
  if (e.steps()) axial_side_gaps(e, h_left, h_right);
  Transport a, b;
  gap_transport(e.scene.rough, e.steps() ? h_left : e.gap.z_face, a.at);
  if (e.steps()) gap_transport(e.scene.rough, h_right, b.at);
  const Transport& c = e.steps() ? b : a;
  flow.z.resize(static_cast<std::size_t>(g.nt) * (g.nz + 1));
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j <= g.nz; ++j) {
      const int f = i * (g.nz + 1) + j;
      if (j == 0 && g.half) {
        flow.z[f] = {};
      } else if (j == 0 || j == g.nz) {
        flow.z[f] = edge_flow(e, a, i, j);
      } else {
        const int r = g.index(i, j);
        const bool from_supply = e.scene.supply.cell[r - 1] >= 0;
        const bool to_supply = e.scene.supply.cell[r] >= 0;
        if (from_supply && to_supply) {
          flow.z[f] = {};
          continue;
        }
        const double reach = e.scene.supply.z_reach[f];
        const double of_l = to_supply ? reach : g.z_face[j] - g.z[j - 1];
        const double of_r = from_supply ? reach : g.z[j] - g.z_face[j];
        const ShapeBeside& shape = e.scene.shape_beside;
        const Half ha = a.axial_half(f, from_supply ? 0.0 : of_l, shape.below);
        const Half hb = c.axial_half(f, to_supply ? 0.0 : of_r, shape.above);
        const double rho = 0.5 * (e.oil.density[r - 1] + e.oil.density[r]);
        flow.z[f] =
            series_flow(ha, hb, e.along(r - 1), e.along(r), {}, 0.0, rho, g.radius * g.dphi[i]);
      }
    }
  }
}

/// What every cell stores per time, and its derivatives.
void storage(const Evaluation& e, FilmFlow& flow) {
  const FilmScene& scene = e.scene;
  for (Field* field : {&flow.stored, &flow.stored_by_theta, &flow.stored_by_p, &flow.stored_by_gap})
    field->clear();
  if (!scene.storage.finite()) return;
  const FilmGrid& g = scene.grid;
  const double rate = 1.0 / scene.storage.dt;
  const OilStore store = oil_store(scene, e.gap, e.oil, e.state);
  const auto n = static_cast<std::size_t>(g.cells());
  flow.stored.assign(n, 0.0);
  flow.stored_by_theta.resize(n);
  flow.stored_by_p.assign(n, 0.0);
  flow.stored_by_gap.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    flow.stored_by_theta[k] = rate * store.by_theta[k];
    flow.stored_by_gap[k] = rate * store.by_gap[k];
    if (scene.supply.cell[k] >= 0) continue;
    const double mass = store.by_theta[k] * e.state.theta[k];
    const double before =
        scene.storage.before[k] * g.area(static_cast<int>(k) / g.nz, static_cast<int>(k) % g.nz);
    flow.stored[k] = rate * (mass - before);
    if (!e.oil.compressibility.empty()) {
      flow.stored_by_p[k] = rate * mass * e.oil.compressibility[k];
    }
  }
}

}  // namespace

Field oil_content(const FilmScene& scene, const Gap& gap, const FilmCoefficients& oil,
                  const FilmState& state) {
  Field content = oil_store(scene, gap, oil, state).by_theta;
  const FilmGrid& g = scene.grid;
  for (int k = 0; k < g.cells(); ++k) {
    content[k] *= state.theta[k] / g.area(k);
  }
  return content;
}

OilStore oil_store(const FilmScene& scene, const Gap& gap, const FilmCoefficients& oil,
                   const FilmState& state) {
  const FilmGrid& g = scene.grid;
  OilStore store{Field(g.cells(), 0.0), Field(g.cells(), 0.0)};
  GapTransport t;
  gap_transport(scene.rough, gap.cell, t);
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      if (scene.supply.cell[k] >= 0) continue;
      const double mass = oil.density[k] * g.area(i, j);
      store.by_gap[k] = mass * state.theta[k] * t.daverage_gap[k];
      store.by_theta[k] = mass * t.average_gap[k];
    }
  }
  return store;
}

void evaluate_flow(const FilmScene& scene, const Gap& gap, const Field& profile,
                   const FilmCoefficients& oil, const FilmState& state, FilmFlow& flow) {
  Evaluation e{scene, gap, profile, oil, state, {}};
  e.ln_g.resize(oil.fluidity.size());
  for (std::size_t k = 0; k < e.ln_g.size(); ++k) e.ln_g[k] = std::log(oil.fluidity[k]);
  circumferential_faces(e, flow);
  axial_faces(e, flow);
  storage(e, flow);
  flow.edge = gap.edge;
  flow.bent_phi = gap.bent_phi;
  flow.bent_z = gap.bent_z;
  flow.fed.clear();
  for (const Mouth& m : scene.supply.mouths) {
    flow.fed.push_back(m.conductance * (scene.supply.patches[m.patch].pressure - state.p[m.cell]));
  }
}

Field net_outflow(const FilmScene& scene, const FilmFlow& flow) {
  const FilmGrid& g = scene.grid;
  Field r(g.cells());
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      const int f = i * (g.nz + 1) + j;
      r[k] = flow.phi[g.index(g.next(i), j)].m - flow.phi[k].m + flow.z[f + 1].m - flow.z[f].m;
    }
  }
  for (const LineFace& l : flow.lines) {  // the cell west of a line feeds the line, not its east
    const int i = l.face / g.nz;
    const int west = g.index(g.previous(i), l.face % g.nz);
    r[west] += l.west.m - flow.phi[l.face].m;
  }
  for (std::size_t k = 0; k < flow.fed.size(); ++k) r[scene.supply.mouths[k].cell] -= flow.fed[k];
  return r;
}

}  // namespace shellback::fluid
