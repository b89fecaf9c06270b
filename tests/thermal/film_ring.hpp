#pragma once
/// Hand-made films for the tests of thermal/film_energy: flows, heat and vessels set freely.
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "core/constants.hpp"
#include "core/make_grid.hpp"
#include "thermal/film_energy.hpp"

namespace shellback::thermal::tests {

/// A film at rest without heat: 10 mm x 10 mm bearing, its energy problem and its temperatures.
struct Ring {
  FilmGrid grid;
  CrossFilmNodes gl;
  FilmEnergyProblem problem;
  std::vector<double> T;  ///< [K]

  Ring(int nt, int nz, int n, double T0 = 300.0)
      : grid(make_grid(0.01, 0.01, nt, nz, false)), gl(gauss_lobatto(n)) {
    const auto cells = static_cast<std::size_t>(grid.cells());
    problem.phi_flow.assign(cells * n, 0.0);
    problem.z_flow.assign(static_cast<std::size_t>(nt) * (nz + 1) * n, 0.0);
    problem.patch.assign(cells, -1);
    problem.line.assign(cells, -1);
    problem.conductance.assign(cells, 0.0);
    problem.heat.assign(cells * n, 0.0);
    problem.cp.assign(cells * n, 2000.0);
    problem.cp_edge = 2000.0;
    problem.T_reference = problem.T_edge = T0;
    T.assign(cells * n, T0);
  }
  [[nodiscard]] int n() const { return gl.n; }
  [[nodiscard]] std::size_t at(int cell, int k) const {
    return static_cast<std::size_t>(cell) * gl.n + k;
  }
  [[nodiscard]] std::size_t z_face(int i, int j) const {
    return (static_cast<std::size_t>(i) * (grid.nz + 1) + j) * gl.n;
  }
  /// The problem refers to this ring's grid and nodes.
  [[nodiscard]] FilmEnergy film() const {
    FilmEnergyProblem p = problem;
    p.grid = &grid;
    p.gl = &gl;
    return FilmEnergy(std::move(p));
  }
  void set_walls(double shell, double shaft) {
    for (int c = 0; c < grid.cells(); ++c) {
      T[at(c, 0)] = shell;
      T[at(c, gl.n - 1)] = shaft;
    }
  }
  /// Flow through the west face of a cell: total [kg/s] times a profile of unit mean.
  void west_flow(int cell, const std::function<double(double)>& profile) {
    for (int k = 0; k < gl.n; ++k) problem.phi_flow[at(cell, k)] = profile(gl.s[k]);
  }
};

/// Sweeps until nothing changes any more; the number of sweeps, or `most` if it goes on.
inline int settle(FilmEnergy& film, std::vector<double>& T, double change = 1e-12,
                  int most = 5000) {
  for (int k = 1; k <= most; ++k) {
    if (film.sweep(T) < change) return k;
  }
  return most;
}

/// Random flows that fill no cell: phi flows of about `mean` [kg/s] with scatter across the film,
/// axial flows whatever the balance of each cell leaves.
inline void random_flows(Ring& r, double mean, double scatter, std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const FilmGrid& g = r.grid;
  const CrossFilmNodes& gl = r.gl;
  const auto total = [&](const double* flow) {
    double sum = 0.0;
    for (int k = 0; k < gl.n; ++k) sum += gl.w[k] * flow[k];
    return sum;
  };
  const auto fill = [&](double* flow, double wanted) {
    for (int k = 0; k < gl.n; ++k) flow[k] = scatter * mean * uniform(engine);
    const double missing = wanted - total(flow);
    for (int k = 0; k < gl.n; ++k) flow[k] += missing;
  };
  for (int c = 0; c < g.cells(); ++c) {
    fill(&r.problem.phi_flow[r.at(c, 0)], mean * (1.0 + 0.3 * uniform(engine)));
  }
  for (int i = 0; i < g.nt; ++i) {
    fill(&r.problem.z_flow[r.z_face(i, 0)], 0.1 * mean * uniform(engine));
    for (int j = 0; j < g.nz; ++j) {
      const double left = total(&r.problem.z_flow[r.z_face(i, j)]) +
                          total(&r.problem.phi_flow[r.at(g.index(i, j), 0)]) -
                          total(&r.problem.phi_flow[r.at(g.index(g.next(i), j), 0)]);
      const bool fed = r.problem.patch[g.index(i, j)] >= 0;
      fill(&r.problem.z_flow[r.z_face(i, j + 1)], fed ? 0.2 * mean * uniform(engine) : left);
    }
  }
}

inline void random_conduction(Ring& r, double mean, std::mt19937& engine) {
  std::uniform_real_distribution<double> factor(0.2, 2.0);
  for (double& K : r.problem.conductance) K = mean * factor(engine);
}

}  // namespace shellback::thermal::tests
