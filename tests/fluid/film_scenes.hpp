#pragma once
/// Bearings for the tests of fluid/: a set-up in the terms of a drawing, and the film in it.
#include <functional>
#include <random>

#include "core/constants.hpp"
#include "core/largest.hpp"
#include "core/make_grid.hpp"
#include "fluid/resultants.hpp"
#include "fluid/reynolds.hpp"

namespace shellback::fluid::tests {

/// A bearing of mild proportions: 40 mm x 20 mm, 20 um clearance, 10 m/s, 10 mPa s.
struct Setup {
  double radius = 0.02;       ///< [m]
  double width = 0.02;        ///< [m]
  double clearance = 20e-6;   ///< [m]
  double viscosity = 0.01;    ///< [Pa s]
  double barus = 0.0;         ///< pressure-viscosity coefficient alpha [1/Pa]
  double density = 850.0;     ///< [kg/m3]
  double speed = 10.0;        ///< [m/s]
  double p_cavitation = 0.0;  ///< [Pa]
  double p_edge = 0.0;        ///< [Pa]
  SideEdges edges = SideEdges::flooded;
  int nt = 60;
  int nz = 12;  ///< over the full width
  bool half = false;
  bool fit_grid = true;  ///< faces on the edges of the patches
  std::vector<SupplyPatch> patches;
  JournalPosition position;
  RoughPair rough;
  std::function<double(double phi, double z)> profile;  ///< step of the cell there [m]
};

struct PosedFilm {
  FilmScene scene;
  Field step;
  Gap gap;
  OilLaw oil;
};

[[nodiscard]] inline OilLaw barus_oil(const Setup& s) {
  return [eta = s.viscosity, alpha = s.barus, rho = s.density](const FilmState& state,
                                                               FilmCoefficients& oil) {
    const std::size_t n = state.p.size();
    oil.fluidity.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      oil.fluidity[k] = std::exp(-alpha * state.p[k]) / (12.0 * eta);
    }
    oil.chi.assign(n, 0.5);
    oil.alpha.assign(n, alpha);
    oil.density.assign(n, rho);
  };
}

[[nodiscard]] inline PosedFilm make_bearing(const Setup& s) {
  PosedFilm b;
  FilmScene& scene = b.scene;
  const GridEdges none;
  scene.grid =
      make_grid(s.radius, s.width, s.nt, s.nz, s.half, s.fit_grid ? phi_edges(s.patches) : none,
                s.fit_grid ? z_edges(s.patches) : none);
  scene.angles = Angles(scene.grid);
  scene.supply = map_supplies(scene.grid, s.patches);
  scene.speed = s.speed;
  scene.p_cavitation = s.p_cavitation;
  scene.p_edge = s.p_edge;
  scene.edges = s.edges;
  scene.rough = s.rough;
  if (s.profile) {
    for (int k = 0; k < scene.grid.cells(); ++k) {
      b.step.push_back(
          s.profile(scene.grid.phi[k / scene.grid.nz], scene.grid.z[k % scene.grid.nz]));
    }
  }
  b.gap = film_gap(scene.grid, scene.angles, s.clearance, s.position, {}, b.step);
  b.oil = barus_oil(s);
  return b;
}

[[nodiscard]] inline Outcome<FilmSolution> solve(const PosedFilm& b,
                                                 const ReynoldsOptions& options = {}) {
  return solve_reynolds(b.scene, b.gap, b.step, b.oil, cold_film(b.scene), options);
}

/// Journal moved by eps c towards `phi` [rad].
[[nodiscard]] inline JournalPosition eccentric(double eps_c, double phi) {
  return {{eps_c * std::cos(phi), eps_c * std::sin(phi), 0.0, 0.0}};
}

/// Line of given pressure across the whole width.
[[nodiscard]] inline SupplyPatch line_supply(const Setup& s, double phi, double pressure = 0.0) {
  return {.phi = phi, .length = s.width, .pressure = pressure};
}

[[nodiscard]] inline Field random_field(int size, unsigned seed, double low, double high) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(low, high);
  Field f(static_cast<std::size_t>(size));
  for (double& x : f) x = uniform(engine);
  return f;
}

[[nodiscard]] inline double largest_difference(const Field& a, const Field& b) {
  double m = a.size() == b.size() ? 0.0 : INFINITY;
  for (std::size_t k = 0; k < a.size() && k < b.size(); ++k) m = larger(m, std::abs(a[k] - b[k]));
  return m;
}

/// What tables of journal bearings list, for a journal displaced along +X (line of centres 0).
struct Characteristics {
  double sommerfeld;  ///< S = (R/c)^2 mu N L D/W [-]
  double attitude;    ///< [deg]
  double friction;    ///< f R/c, friction of the journal [-]
  double side_flow;   ///< Q_s/(R c N L) [-]
  double inlet_flow;  ///< Q/(R c N L), through the section at the start of the film [-]
  double p_ratio;     ///< W/(L D p_max) [-]
};

[[nodiscard]] inline Characteristics characteristics(const Setup& s, const PosedFilm& b,
                                                     const FilmSolution& v, CavitatedShear rule) {
  const FilmGrid& g = b.scene.grid;
  const Wrench f = wrench(b.scene, v.state.p);
  const double load = std::hypot(f[0], f[1]);
  const double turns = s.speed / (2.0 * kPi * s.radius);  // N [1/s]
  const double area = 2.0 * s.radius * s.width;
  const auto n = static_cast<std::size_t>(g.cells());
  const ShearStress tau =
      shear_stress(b.scene, b.gap.cell, Field(n, 1.0 / s.viscosity), Field(n, 0.5), v.state,
                   pressure_gradient_x(b.scene, v.state), rule);
  const double unit = s.density * s.radius * s.clearance * turns * s.width;  // [kg/s]
  double inlet = 0.0;
  for (int j = 0; j < g.nz; ++j) inlet += v.flow.phi[g.index(0, j)].m * g.multiplicity();
  return {std::pow(s.radius / s.clearance, 2) * s.viscosity * turns * area / load,
          -std::atan2(-f[1], -f[0]) * 180.0 / kPi,
          torque(b.scene, tau.journal) / (s.radius * load) * s.radius / s.clearance,
          oil_flows(b.scene, v.flow).side / unit,
          inlet / unit,
          load / area / largest_magnitude(v.state.p)};
}

}  // namespace shellback::fluid::tests
