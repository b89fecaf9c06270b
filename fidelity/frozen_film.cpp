#include "fidelity/frozen_film.hpp"

#include <algorithm>

#include "coupling/nested.hpp"

namespace shellback::fidelity {
namespace {

using namespace coupling;

constexpr int kMostIterations = 30;  ///< a film that takes more is no neighbour of the solution
/// Residuals at which the film is left, all in the units of EquilibriumOptions [-]: friction and
/// smallest film are then known to about that, far better than the grids that they stand for.
constexpr double kEnough = 1e-6;

Physics film_only(Physics p, const Frozen& keep) {
  p.film_energy = p.elastic = p.growth = false;
  p.pressure_dependence = p.pressure_dependence && keep.pressure;
  p.shear_thinning = p.shear_thinning && keep.shear;
  p.contact = p.contact && keep.roughness;
  p.flow_factors = p.flow_factors && keep.roughness;
  return p;
}

Field widening(const Solution& s, const Frozen& keep) {
  Field sum(s.model.scene.grid.cells(), 0.0);
  const auto add = [&](const Field& d) {
    for (std::size_t k = 0; k < d.size(); ++k) sum[k] += d[k];
  };
  if (keep.elastic) add(s.film.elastic);
  if (keep.growth) add(s.heat.growth);
  return sum;
}

void set_temperatures(const Case& c, const Frozen& keep, int nodes, OilColumns& columns) {
  auto& T = columns.T;
  if (!keep.heating) std::fill(T.begin(), T.end(), c.supplies.front().temperature);
  if (!keep.across) {
    for (std::size_t first = 0; first < T.size(); first += nodes) {
      double mean = 0.0;
      for (int k = 0; k < nodes; ++k) mean += T[first + k] / nodes;
      std::fill_n(T.begin() + first, nodes, mean);
    }
  }
  for (double& t : T) t += keep.warmer;
}

}  // namespace

Solution frozen_film(const Solution& s, std::array<int, 2> grid, const Frozen& keep,
                     const std::atomic<bool>* stop) {
  Solution out;
  out.target = s.target;
  out.T_film = s.T_film;
  out.model = make_bearing(s.model.input, film_only(s.model.physics, keep), grid);
  out.film = carry_over(s.model, s.film, out.model);
  set_temperatures(s.model.input, keep, out.model.gl.n, out.film.columns);
  out.heat.growth = interpolate(s.model.scene.grid, widening(s, keep), out.model.scene.grid);
  EquilibriumOptions options;
  options.max_iterations = kMostIterations;
  options.film_tolerance = options.load_tolerance = options.viscosity_tolerance = kEnough;
  out.verdict =
      solve_equilibrium(out.model, out.target, out.heat.growth, options, out.film, out.cost, stop);
  return out;
}

}  // namespace shellback::fidelity
