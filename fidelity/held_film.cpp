#include "fidelity/held_film.hpp"

#include <algorithm>
#include <numeric>

#include "bearing/steady/nested.hpp"

namespace shellback::fidelity {
namespace {

using namespace bearing;

Field widening(const Solution& s, const Physics& has) {
  Field sum(s.model.domain.grid.cells(), 0.0);
  const auto add = [&](const Field& d) {
    for (std::size_t k = 0; k < d.size(); ++k) sum[k] += d[k];
  };
  if (has.elastic) add(s.film.elastic);
  if (has.thermal_deformation) add(s.heat.thermal_deformation);
  return sum;
}

void set_temperatures(const Case& c, const Held& held, const CrossFilmNodes& gl,
                      std::vector<double>& T) {
  if (!held.heated) std::fill(T.begin(), T.end(), mean_supply_temperature(c));
  for (auto column = T.begin(); column != T.end() && !held.physics.film_energy; column += gl.n) {
    std::fill_n(column, gl.n, std::inner_product(column, column + gl.n, gl.w.begin(), 0.0));
  }
  for (double& t : T) t += held.warmer;
}

}  // namespace

Solution held_film(const Solution& s, std::array<int, 2> grid, const Held& held,
                   const std::atomic<bool>* stop) {
  Physics film_only = held.physics;
  film_only.film_energy = film_only.elastic = film_only.thermal_deformation = false;
  Solution out;
  out.T_film = s.T_film;
  out.model = make_bearing(s.model.input, film_only, grid);
  out.model.gl = s.model.gl;  // on which its temperatures stand
  out.point = operating_point(out.model);
  out.film = carry_over(s.model, s.film, out.model);
  set_temperatures(s.model.input, held, out.model.gl, out.film.columns.T);
  out.heat.thermal_deformation =
      interpolate(s.model.domain.grid, widening(s, held.physics), out.model.domain.grid);
  // Friction and smallest film are then known to about these residuals, far better than the grids
  // that they stand for; a film that takes more steps is no neighbour of the solution.
  constexpr double kEnough = 1e-6;  // all in the units of EquilibriumOptions [-]
  EquilibriumOptions options;
  options.max_iterations = 30;
  options.film_tolerance = options.load_tolerance = options.viscosity_tolerance = kEnough;
  out.verdict = solve_equilibrium(
      {out.model, out.point, out.heat.thermal_deformation, options, stop}, out.film, out.cost);
  return out;
}

}  // namespace shellback::fidelity
