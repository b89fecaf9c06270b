#include "coupling/nested.hpp"

#include <algorithm>

#include "rheology/viscosity.hpp"

namespace shellback::coupling {
namespace {

constexpr int kCoarsestTurn = 48;  ///< circumferential cells below which nothing is gained
constexpr int kCoarsestAxial = 5;

/// The model without anything elastic or thermal, on a grid of the ladder.
BearingModel rigid_model(const BearingModel& fine, std::array<int, 2> grid, bool isoviscous) {
  Physics rigid = fine.physics;
  rigid.elastic = rigid.film_energy = rigid.growth = false;
  if (isoviscous) rigid.pressure_dependence = false;
  return make_bearing(fine.input, rigid, grid);
}

}  // namespace

std::vector<std::array<int, 2>> grid_ladder(std::array<int, 2> fine) {
  std::vector<std::array<int, 2>> ladder{fine};
  while (true) {
    const auto [nt, nz] = ladder.back();
    const std::array<int, 2> coarser{nt / 2, nz % 2 == 1 ? (nz + 1) / 2 : nz / 2};
    if (coarser[0] < kCoarsestTurn || coarser[1] < kCoarsestAxial) break;
    ladder.push_back(coarser);
  }
  std::reverse(ladder.begin(), ladder.end());
  return ladder;
}

FilmEquilibrium carry_over(const BearingModel& from, const FilmEquilibrium& s,
                           const BearingModel& to) {
  FilmEquilibrium out;
  const FilmGrid& a = from.scene.grid;
  const FilmGrid& b = to.scene.grid;
  out.film.p = interpolate(a, s.film.p, b);
  out.film.theta = interpolate(a, s.film.theta, b);
  out.film.full.resize(b.cells());
  for (int k = 0; k < b.cells(); ++k) {
    const bool full = out.film.theta[k] > 1.0 - 1e-9 ||
                      out.film.p[k] > to.scene.p_cavitation * (1.0 + 1e-12) + 1e-6;
    out.film.full[k] = full;
    if (full) out.film.theta[k] = 1.0;
    if (!full) out.film.p[k] = to.scene.p_cavitation;
  }
  fluid::impose_supply(to.scene, out.film);
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

Verdict nested_rigid_start(const BearingModel& fine, const LoadTarget& target, double T,
                           bool isoviscous, FilmEquilibrium& state, EquilibriumCost& cost,
                           const std::atomic<bool>* stop) {
  const auto ladder = grid_ladder(fine.input.model.grid);
  EquilibriumOptions loose;  // only the last grid is solved to the end, by the caller
  loose.film_tolerance = 1e-5;
  loose.load_tolerance = 1e-3;
  loose.viscosity_tolerance = 1e-3;
  BearingModel before;
  FilmEquilibrium s;
  for (std::size_t level = 0; level < ladder.size(); ++level) {
    const bool last = level + 1 == ladder.size();
    BearingModel model = rigid_model(fine, ladder[level], isoviscous);
    s = level == 0 ? cold_start(model, T) : carry_over(before, s, model);
    if (last && !isoviscous) {
      state = std::move(s);
      if (fine.physics.elastic) state.elastic.assign(fine.scene.grid.cells(), 0.0);
      return {};
    }
    const Verdict verdict = solve_equilibrium(model, target, {}, loose, s, cost, stop);
    if (!verdict.good()) {
      state = carry_over(model, s, fine);
      return verdict;
    }
    before = std::move(model);
  }
  state = carry_over(before, s, fine);
  return {};
}

}  // namespace shellback::coupling
