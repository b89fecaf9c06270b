#include "thermal/film_energy.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"

namespace shellback::thermal {
namespace {

constexpr int kMostNodes = 64;  ///< across the film; bounds the stack arrays below

// Negative weights of a column from which on upwind fluxes begin, and are alone (header).
constexpr double kBlendFrom = 0.25;
constexpr double kBlendTo = 0.5;

/// Gauss-Jordan inversion in place of a row-major m x m matrix with pivoting by rows [textbook].
/// M = 0: any size; otherwise the size is known to the compiler.
template <int M>
void invert_rows(double* a, int size) {
  const int m = M > 0 ? M : size;
  int swapped[kMostNodes];
  for (int k = 0; k < m; ++k) {
    int p = k;
    for (int r = k + 1; r < m; ++r) p = std::abs(a[r * m + k]) > std::abs(a[p * m + k]) ? r : p;
    swapped[k] = p;
    if (p != k) std::swap_ranges(a + p * m, a + (p + 1) * m, a + k * m);
    const double d = 1.0 / a[k * m + k];
    a[k * m + k] = 1.0;
    for (int c = 0; c < m; ++c) a[k * m + c] *= d;
    for (int r = 0; r < m; ++r) {
      if (r == k) continue;
      const double f = a[r * m + k];
      a[r * m + k] = 0.0;
      for (int c = 0; c < m; ++c) a[r * m + c] -= f * a[k * m + c];
    }
  }
  for (int k = m - 1; k >= 0; --k) {
    if (swapped[k] == k) continue;
    for (int r = 0; r < m; ++r) std::swap(a[r * m + k], a[r * m + swapped[k]]);
  }
}

/// The usual sizes with loops that the compiler can unroll.
void invert(double* a, int m) {
  switch (m) {
    case 3:
      return invert_rows<3>(a, 3);
    case 5:
      return invert_rows<5>(a, 5);
    case 7:
      return invert_rows<7>(a, 7);
    default:
      return invert_rows<0>(a, m);
  }
}

/// Takes the highest mode out of every node vector of a face array.
void project(const CrossFilmNodes& gl, std::vector<double>& flow) {
  const int n = gl.n;
  double f[kMostNodes];
  for (std::size_t at = 0; at + n <= flow.size(); at += n) {
    std::copy_n(&flow[at], n, f);
    for (int k = 0; k < n; ++k) {
      double sum = 0.0;
      for (int l = 0; l < n; ++l) sum += gl.S[k * n + l] * f[l];
      flow[at + k] = sum;
    }
  }
}

}  // namespace

std::vector<double> heat_content(const Field& mass, const std::vector<double>& enthalpy) {
  const std::size_t n = enthalpy.size() / mass.size();
  std::vector<double> heat(enthalpy.size());
  for (std::size_t k = 0; k < heat.size(); ++k) heat[k] = mass[k / n] * enthalpy[k];
  return heat;
}

FilmEnergy::FilmEnergy(FilmEnergyProblem problem) : p_(std::move(problem)) {
  EXPECTS(p_.grid && p_.gl && p_.gl->n <= kMostNodes);
  const FilmGrid& g = *p_.grid;
  n_ = p_.gl->n;
  stiffness_ = p_.gl->A;
  project(*p_.gl, p_.phi_flow);
  project(*p_.gl, p_.z_flow);
  line_west_.assign(g.cells(), nullptr);
  for (LineFlow& l : p_.lines) {
    project(*p_.gl, l.flow);
    line_west_[l.face] = &l;
  }
  const auto nodes = static_cast<std::size_t>(g.cells()) * n_;
  cross_.assign(nodes, 0.0);
  outflow_.assign(nodes, 0.0);
  take_storage();
  take_fed_oil();
  blend_.assign(g.cells(), 0.0);
  const auto cells = static_cast<std::size_t>(g.cells());
  const auto inner = static_cast<std::size_t>(n_ - 2);
  inverse_.assign(cells * inner * inner, 0.0);
  base_.assign(cells * inner, 0.0);
  by_shell_.assign(cells * inner, 0.0);
  by_shaft_.assign(cells * inner, 0.0);
  inflow_.assign(cells * 4 * n_, 0.0);
  source_.assign(cells * 4, 0);
  if (p_.shell) {
    EXPECTS(p_.shell->impedance > 0.0 && p_.shell->free.size() == cells);
    EXPECTS(p_.shell->rubbed.size() == cells);
    shell_row_.assign(cells * n_, 0.0);
    shell_pivot_.assign(cells, 0.0);
  }
  for (const SupplyVessel& v : p_.vessels) T_mix_.push_back(v.T_supply);
  shell_ring_.assign(g.nz, 0.0);
  shaft_ring_.assign(g.nz, 0.0);
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      Inflow faces[4];
      const int count = faces_of(i, j, faces);
      if (p_.patch[g.index(i, j)] >= 0) {
        const bool at_brink =
            std::any_of(faces, faces + count, [](const Inflow& f) { return f.source == kEdge; });
        if (at_brink) brink_.push_back(g.index(i, j));
        const double h = vessel_transfer(g.index(i, j)), part = g.dphi[i] / (2.0 * kPi);
        shell_local_ = std::max(shell_local_, h);
        shell_ring_[j] += part * h;
        shaft_ring_[j] += part * h;
        continue;
      }
      build_column(i, j);
      const bool at_shore = std::any_of(
          faces, faces + count, [](const Inflow& f) { return f.source < 0 && f.source != kEdge; });
      if (at_shore) shore_.push_back(g.index(i, j));
    }
  }
}

void FilmEnergy::take_fed_oil() {
  if (p_.fed.empty()) return;
  fed_.assign(p_.grid->cells(), 0.0);
  for (const FedOil& f : p_.fed) {
    EXPECTS(p_.patch[f.cell] < 0);
    fed_[f.cell] += f.flow;
    if (!(f.flow > 0.0)) continue;
    const SupplyVessel& v = p_.vessels[f.vessel];
    const double heat = f.flow * v.cp_supply * (v.T_supply - p_.T_reference);
    fed_heat_ += heat;
    for (int k = 0; k < n_; ++k) {
      p_.heat[static_cast<std::size_t>(f.cell) * n_ + k] += p_.gl->w[k] * heat;
    }
  }
}

void FilmEnergy::take_storage() {
  const auto cells = static_cast<std::size_t>(p_.grid->cells());
  accumulation_.assign(cells, 0.0);
  if (!p_.storage) return;
  const FilmStorage& s = *p_.storage;
  EXPECTS(s.dt > 0.0 && s.mass.size() == cells && s.mass_before.size() == cells);
  EXPECTS(s.heat_before.size() == cells * n_);
  brought_.assign(cells * n_, 0.0);
  for (std::size_t c = 0; c < cells; ++c) {
    if (p_.patch[c] >= 0) continue;
    accumulation_[c] = (s.mass[c] - s.mass_before[c]) / s.dt;
    for (int k = 0; k < n_; ++k) {
      brought_[c * n_ + k] = p_.gl->w[k] / s.dt * s.heat_before[c * n_ + k];
    }
  }
}

int FilmEnergy::faces_of(int i, int j, Inflow* faces) const {
  const FilmGrid& g = *p_.grid;
  const auto cell_or_patch = [&](int c) { return p_.patch[c] >= 0 ? -1 - p_.patch[c] : c; };
  const int k = g.index(i, j);
  const int east = g.index(g.next(i), j);
  int count = 0;
  faces[count++] = {&p_.phi_flow[static_cast<std::size_t>(k) * n_], 1.0,
                    p_.line[k] >= 0 ? -1 - p_.line[k] : cell_or_patch(g.index(g.previous(i), j))};
  if (line_west_[east]) {
    faces[count++] = {line_west_[east]->flow.data(), -1.0, -1 - line_west_[east]->patch};
  } else {
    faces[count++] = {&p_.phi_flow[static_cast<std::size_t>(east) * n_], -1.0, cell_or_patch(east)};
  }
  const double* low = &p_.z_flow[(static_cast<std::size_t>(i) * (g.nz + 1) + j) * n_];
  if (j > 0) {
    faces[count++] = {low, 1.0, cell_or_patch(k - 1)};
  } else if (!g.half) {
    faces[count++] = {low, 1.0, kEdge};
  }
  faces[count++] = {low + n_, -1.0, j + 1 < g.nz ? cell_or_patch(k + 1) : kEdge};
  return count;
}

double FilmEnergy::source_enthalpy(const Inflow& f, int k, const std::vector<double>& T) const {
  if (f.source >= 0) {
    const std::size_t at = static_cast<std::size_t>(f.source) * n_ + k;
    return p_.cp[at] * (T[at] - p_.T_reference);
  }
  if (f.source == kEdge) return p_.cp_edge * (p_.T_edge - p_.T_reference);
  const int patch = -1 - f.source;
  return p_.vessels[patch].cp_mix * (T_mix_[patch] - p_.T_reference);
}

namespace {

/// Oil that enters through the surface, or leaves that way [kg/s].
void add_fed(double fed, const CrossFilmNodes& gl, double* divergence, double* out) {
  for (int k = 0; k < gl.n; ++k) {
    divergence[k] -= fed;
    if (fed < 0.0) out[k] -= gl.w[k] * fed;
  }
}

}  // namespace

void FilmEnergy::build_column(int i, int j) {
  const int n = n_;
  const CrossFilmNodes& gl = *p_.gl;
  const int cell = p_.grid->index(i, j);
  double* V = &cross_[static_cast<std::size_t>(cell) * n];
  double* out = &outflow_[static_cast<std::size_t>(cell) * n];
  double divergence[kMostNodes];
  std::fill_n(divergence, n, accumulation_[cell]);
  Inflow faces[4];
  const int count = faces_of(i, j, faces);
  const int patches = static_cast<int>(p_.vessels.size());
  for (int f = 0; f < count; ++f) {
    const int s = faces[f].source;
    const int slot = s >= 0 ? s : p_.grid->cells() + (s == kEdge ? patches : -1 - s);
    source_[static_cast<std::size_t>(cell) * 4 + f] = slot;
    double* inflow = &inflow_[(static_cast<std::size_t>(cell) * 4 + f) * n];
    for (int k = 0; k < n; ++k) {
      const double in = faces[f].sign * faces[f].flow[k];
      divergence[k] -= in;
      if (in < 0.0) out[k] -= gl.w[k] * in;
      if (in > 0.0) inflow[k] = gl.w[k] * in;
    }
  }
  if (!fed_.empty()) add_fed(fed_[cell], gl, divergence, out);
  const double direction = p_.forward ? 1.0 : -1.0;
  for (int k = 0; k < n; ++k) backflow_ += faces[0].flow[k] * direction < 0.0;
  for (int k = 1; k + 1 < n; ++k) {
    for (int l = 0; l < n; ++l) V[k] -= gl.Q[k * n + l] * divergence[l];
  }
  const double gained =
      std::max(accumulation_[cell], 0.0);  // stays: the least that leaves the flow
  for (int k = 0; k < n; ++k) out[k] += gl.w[k] * gained;
  invert_column(cell);
  blend_[cell] =
      std::clamp((negative_weights(cell) - kBlendFrom) / (kBlendTo - kBlendFrom), 0.0, 1.0);
  const double store = p_.storage ? p_.storage->mass[cell] / p_.storage->dt - gained : 0.0;
  for (int k = 0; k < n; ++k) out[k] += gl.w[k] * store;
  if (blend_[cell] > 0.0) ++blended_;
  if (blend_[cell] > 0.0 || p_.storage) invert_column(cell);
  if (p_.shell) let_shell_yield(cell);
  const int m = n - 2;
  const double* by_shell = &by_shell_[static_cast<std::size_t>(cell) * m];
  const double* by_shaft = &by_shaft_[static_cast<std::size_t>(cell) * m];
  // Heat into a wall per unit rise of it, the column following: a Schur complement.
  const auto schur = [&](int wall, const double* by_wall) {
    double row[kMostNodes];
    matrix_row(cell, wall, row);
    double response = p_.conductance[cell] * stiffness_[wall * n + wall] + thins(cell, wall);
    if (p_.storage) {
      response += gl.w[wall] * (store + gained) * p_.cp[static_cast<std::size_t>(cell) * n + wall];
    }
    for (int r = 0; r < m; ++r) response -= row[r + 1] * by_wall[r];
    return response / p_.grid->area(i, j);
  };
  const double shell = schur(0, by_shell);
  const double part = p_.grid->dphi[i] / (2.0 * kPi);
  shell_local_ = std::max(shell_local_, shell);
  shell_ring_[j] += part * shell;
  shaft_ring_[j] += part * schur(n - 1, by_shaft);
}

void FilmEnergy::invert_column(int cell) {
  const int n = n_;
  const int m = n - 2;
  double A[kMostNodes * kMostNodes];
  for (int r = 0; r < m; ++r) matrix_row(cell, r + 1, A + r * n);
  double* inverse = &inverse_[static_cast<std::size_t>(cell) * m * m];
  for (int r = 0; r < m; ++r) std::copy_n(A + r * n + 1, m, inverse + r * m);
  invert(inverse, m);
  double heat[kMostNodes];
  std::copy_n(&p_.heat[static_cast<std::size_t>(cell) * n], n, heat);
  for (int k = 0; k < n && !brought_.empty(); ++k) {
    heat[k] += brought_[static_cast<std::size_t>(cell) * n + k];
  }
  for (int r = 0; r < m; ++r) {
    const std::size_t at = static_cast<std::size_t>(cell) * m + r;
    base_[at] = by_shell_[at] = by_shaft_[at] = 0.0;
    for (int c = 0; c < m; ++c) {
      base_[at] += inverse[r * m + c] * heat[c + 1];
      by_shell_[at] += inverse[r * m + c] * A[c * n];
      by_shaft_[at] += inverse[r * m + c] * A[c * n + n - 1];
    }
  }
}

void FilmEnergy::let_shell_yield(int cell) {
  const int m = n_ - 2;
  const FilmGrid& g = *p_.grid;
  const double part = p_.shell->impedance / g.area(cell);
  double* row = &shell_row_[static_cast<std::size_t>(cell) * n_];
  matrix_row(cell, 0, row);
  for (int k = 0; k < n_; ++k) row[k] *= part;
  double pivot = 1.0 + row[0];
  for (int r = 0; r < m; ++r) {
    pivot -= row[r + 1] * by_shell_[static_cast<std::size_t>(cell) * m + r];
  }
  shell_pivot_[cell] = pivot;
}

double FilmEnergy::yielded(int cell, const double* x, double shaft, double in) const {
  const FilmGrid& g = *p_.grid;
  const std::size_t at = static_cast<std::size_t>(cell) * n_;
  const double part = p_.shell->impedance / g.area(cell);
  const double* row = &shell_row_[at];
  const double heat = p_.heat[at] + (brought_.empty() ? 0.0 : brought_[at]) + in;
  double sum = p_.shell->free[cell] - p_.T_reference +
               p_.shell->impedance * p_.shell->rubbed[cell] + part * heat - row[n_ - 1] * shaft;
  for (int k = 0; k + 2 < n_; ++k) sum -= row[k + 1] * x[k];
  return sum / shell_pivot_[cell];
}

double FilmEnergy::negative_weights(int cell) const {
  const int m = n_ - 2;
  const std::size_t at = static_cast<std::size_t>(cell) * n_;
  double entering[kMostNodes] = {};  // heat capacity flow into each interior node [W/K]
  for (int f = 0; f < 4; ++f) {
    for (int k = 0; k < m; ++k) entering[k] += inflow_[at * 4 + f * n_ + k + 1] * p_.cp[at + k + 1];
  }
  const double* inverse = &inverse_[static_cast<std::size_t>(cell) * m * m];
  double worst = 0.0;
  for (int r = 0; r < m; ++r) {
    const std::size_t row = static_cast<std::size_t>(cell) * m + r;
    double sum = std::max(by_shell_[row], 0.0) + std::max(by_shaft_[row], 0.0);
    for (int c = 0; c < m; ++c) sum -= std::min(inverse[r * m + c] * entering[c], 0.0);
    worst = std::max(worst, sum);
  }
  return worst;
}

void FilmEnergy::node_fluxes(int cell, double* M) const {
  const CrossFilmNodes& gl = *p_.gl;
  const double* V = &cross_[static_cast<std::size_t>(cell) * n_];
  double sum = 0.0;
  for (int k = 0; k + 1 < n_; ++k) {
    for (int l = 0; l < n_; ++l) sum += gl.w[k] * gl.D[k * n_ + l] * V[l];
    M[k] = sum;
  }
}

void FilmEnergy::matrix_row(int cell, int k, double* row) const {
  const CrossFilmNodes& gl = *p_.gl;
  const double* V = &cross_[static_cast<std::size_t>(cell) * n_];
  const double* cp = &p_.cp[static_cast<std::size_t>(cell) * n_];
  const double K = p_.conductance[cell];
  const double b = blend_[cell];
  for (int l = 0; l < n_; ++l) {
    row[l] = (1.0 - b) * gl.w[k] * gl.D[k * n_ + l] * V[l] * cp[l] + K * stiffness_[k * n_ + l];
  }
  row[k] += outflow_[static_cast<std::size_t>(cell) * n_ + k] * cp[k];
  row[k] += thins(cell, k);
  if (b == 0.0) return;
  double M[kMostNodes];
  node_fluxes(cell, M);
  if (k + 1 < n_) {
    row[k] += b * std::max(M[k], 0.0) * cp[k];
    row[k + 1] += b * std::min(M[k], 0.0) * cp[k + 1];
  }
  if (k > 0) {
    row[k - 1] -= b * std::max(M[k - 1], 0.0) * cp[k - 1];
    row[k] -= b * std::min(M[k - 1], 0.0) * cp[k];
  }
}

double FilmEnergy::wall_row(int cell, int k, const std::vector<double>& T,
                            const std::vector<double>& enthalpy) const {
  const std::size_t at = static_cast<std::size_t>(cell) * n_;
  double row[kMostNodes];
  matrix_row(cell, k, row);
  double heat = p_.heat[at + k] + (brought_.empty() ? 0.0 : brought_[at + k]);
  for (int l = 0; l < n_; ++l) heat -= row[l] * (T[at + l] - p_.T_reference);
  for (int f = 0; f < 4; ++f) {
    const auto slot = static_cast<std::size_t>(source_[static_cast<std::size_t>(cell) * 4 + f]);
    heat += inflow_[at * 4 + f * n_ + k] * enthalpy[slot * n_ + k];
  }
  return heat;
}

void FilmEnergy::enthalpies_of(const std::vector<double>& T, std::vector<double>& enthalpy) const {
  const std::size_t nodes = p_.cp.size();
  enthalpy.resize(nodes + (p_.vessels.size() + 1) * n_);
  for (std::size_t k = 0; k < nodes; ++k) enthalpy[k] = p_.cp[k] * (T[k] - p_.T_reference);
  for (std::size_t v = 0; v < p_.vessels.size(); ++v) {
    std::fill_n(&enthalpy[nodes + v * n_], n_, p_.vessels[v].cp_mix * (T_mix_[v] - p_.T_reference));
  }
  std::fill_n(enthalpy.end() - n_, n_, p_.cp_edge * (p_.T_edge - p_.T_reference));
}

template <int N>
double FilmEnergy::march(std::vector<double>& T) {
  const FilmGrid& g = *p_.grid;
  const int n = N > 0 ? N : n_;
  const int m = n - 2;
  const double T0 = p_.T_reference;
  double change = 0.0;
  const auto column = [&](int i, int j) {
    const int cell = g.index(i, j);
    if (p_.patch[cell] >= 0) return;
    const std::size_t at = static_cast<std::size_t>(cell) * n;
    const std::size_t at_inner = static_cast<std::size_t>(cell) * m;
    const double* inflow = &inflow_[at * 4];
    const int* source = &source_[static_cast<std::size_t>(cell) * 4];
    double in[N > 0 ? N : kMostNodes] = {};
    double at_shell = 0.0;
    for (int f = 0; f < 4; ++f) {
      const double* enthalpy = &enthalpy_[static_cast<std::size_t>(source[f]) * n];
      at_shell += inflow[f * n] * enthalpy[0];
      for (int k = 0; k < m; ++k) in[k] += inflow[f * n + k + 1] * enthalpy[k + 1];
    }
    const double shaft = T[at + n - 1] - T0;
    const double* inverse = &inverse_[at_inner * m];
    double x[N > 0 ? N : kMostNodes];
    for (int k = 0; k < m; ++k) {
      x[k] = base_[at_inner + k] - by_shaft_[at_inner + k] * shaft;
      for (int l = 0; l < m; ++l) x[k] += inverse[k * m + l] * in[l];
    }
    if (p_.shell) {
      const double now = T0 + yielded(cell, x, shaft, at_shell);
      change = larger(change, std::abs(now - T[at]));
      T[at] = now;
      enthalpy_[at] = p_.cp[at] * (now - T0);
    }
    const double shell = T[at] - T0;
    for (int k = 0; k < m; ++k) {
      x[k] -= by_shell_[at_inner + k] * shell;
      change = larger(change, std::abs(T0 + x[k] - T[at + k + 1]));
      T[at + k + 1] = T0 + x[k];
      enthalpy_[at + k + 1] = p_.cp[at + k + 1] * x[k];
    }
  };
  const int middle = g.half ? 0 : g.nz / 2;
  for (int step = 0; step < g.nt; ++step) {
    const int i = p_.forward ? step : g.nt - 1 - step;
    for (int j = middle; j < g.nz; ++j) column(i, j);  // pressure drives the oil outwards
    for (int j = middle - 1; j >= 0; --j) column(i, j);
  }
  return change;
}

double FilmEnergy::sweep(std::vector<double>& T) {
  mix(T);
  enthalpies_of(T, enthalpy_);
  switch (n_) {  // the usual sizes with loops that the compiler can unroll
    case 5:
      return march<5>(T);
    case 7:
      return march<7>(T);
    case 9:
      return march<9>(T);
    default:
      return march<0>(T);
  }
}

WallHeat FilmEnergy::wall_heat(const std::vector<double>& T) const {
  const FilmGrid& g = *p_.grid;
  WallHeat q{Field(g.cells(), 0.0), Field(g.cells(), 0.0)};
  std::vector<double> enthalpy;
  enthalpies_of(T, enthalpy);
  for (int cell = 0; cell < g.cells(); ++cell) {
    if (p_.patch[cell] >= 0) {
      const double hA = vessel_transfer(cell) * g.area(cell);
      const std::size_t at = static_cast<std::size_t>(cell) * n_;
      q.shell[cell] = hA * (T_mix_[p_.patch[cell]] - T[at]);
      q.shaft[cell] = hA * (T_mix_[p_.patch[cell]] - T[at + n_ - 1]);
      continue;
    }
    q.shell[cell] = wall_row(cell, 0, T, enthalpy);
    q.shaft[cell] = wall_row(cell, n_ - 1, T, enthalpy);
  }
  return q;
}

}  // namespace shellback::thermal
