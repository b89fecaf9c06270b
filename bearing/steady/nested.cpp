#include "bearing/steady/nested.hpp"

#include <algorithm>

namespace shellback::bearing {
namespace {

constexpr std::array kCoarsest{48, 5};  ///< cells of a grid below which nothing is gained
constexpr double kFullFrom =
    0.9;  ///< share of full neighbours from which a new cell starts full [-]

}  // namespace

std::optional<std::array<int, 2>> halved(std::array<int, 2> grid) {
  const std::array<int, 2> coarser{grid[0] / 2, (grid[1] + 1) / 2};
  if (coarser[0] < kCoarsest[0] || coarser[1] < kCoarsest[1]) return std::nullopt;
  return coarser;
}

std::vector<std::array<int, 2>> grid_ladder(const Case& c) {
  std::vector<std::array<int, 2>> ladder{c.model.grid};
  for (auto coarser = halved(c.model.grid); coarser; coarser = halved(*coarser)) {
    if (holds_supplies(c, *coarser)) ladder.push_back(*coarser);
  }
  std::reverse(ladder.begin(), ladder.end());
  return ladder;
}

FilmEquilibrium carry_over(const BearingModel& from, const FilmEquilibrium& s,
                           const BearingModel& to) {
  FilmEquilibrium out;
  const FilmGrid& a = from.domain.grid;
  const FilmGrid& b = to.domain.grid;
  out.film.p = interpolate(a, s.film.p, b);
  out.film.theta = interpolate(a, s.film.theta, b);
  out.film.full.resize(b.cells());
  const Field part_full = interpolate(a, Field(s.film.full.begin(), s.film.full.end()), b);
  for (int k = 0; k < b.cells(); ++k) {
    const bool full = part_full[k] > kFullFrom;
    out.film.full[k] = full;
    if (full) out.film.theta[k] = 1.0;
    if (!full) out.film.p[k] = to.domain.p_cavitation;
  }
  fluid::impose_supply(to.supply, out.film);
  out.position = s.position;
  if (to.physics.elastic) {
    out.elastic = s.elastic.empty() ? Field(b.cells(), 0.0) : interpolate(a, s.elastic, b);
  }
  out.columns = uniform_columns(b.cells(), to.gl.n, 0.0);
  const int n = from.gl.n;
  Field layer(a.cells());
  for (int k = 0; k < to.gl.n; ++k) {
    const int source = std::min(k * (n - 1) / std::max(to.gl.n - 1, 1), n - 1);
    for (int c = 0; c < a.cells(); ++c) layer[c] = s.columns.T[c * n + source];
    const Field fine = interpolate(a, layer, b);
    for (int c = 0; c < b.cells(); ++c) out.columns.T[c * to.gl.n + k] = fine[c];
  }
  return out;
}

HeatState carry_over(const BearingModel& from, const HeatState& heat, const BearingModel& to) {
  HeatState out;
  const FilmGrid& a = from.domain.grid;
  const FilmGrid& b = to.domain.grid;
  out.T_shell = interpolate(a, heat.T_shell, b);
  if (to.physics.thermal_deformation && !heat.thermal_deformation.empty())
    out.thermal_deformation = interpolate(a, heat.thermal_deformation, b);
  Field shaft(a.cells());
  for (int c = 0; c < a.cells(); ++c) shaft[c] = heat.T_shaft[c % a.nz];
  const Field finer = interpolate(a, shaft, b);
  out.T_shaft.assign(finer.begin(), finer.begin() + b.nz);
  out.residual = heat.residual;
  out.response = heat.response;
  return out;
}

}  // namespace shellback::bearing
