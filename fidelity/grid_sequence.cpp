#include "fidelity/grid_sequence.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/steady/nested.hpp"
#include "core/contract.hpp"
#include "core/round_off.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

constexpr std::size_t kGrids = 3;  ///< with which an order can be observed [-]

int cells(const Grid& grid) { return grid[0] * grid[1]; }

Grid scaled(const Grid& grid, double by) {
  return {static_cast<int>(std::lround(by * grid[0])), static_cast<int>(std::lround(by * grid[1]))};
}

/// `s` on another grid, with operators that were kept for it.
std::optional<Solution> beside(const Solution& s, const Grid& grid, const SolveControl& control,
                               KeptSolids* kept) {
  Solution near = s;
  near.model.solids = kept != nullptr ? kept->find(grid) : nullptr;
  Case c = s.model.input;
  c.model.grid = grid;
  auto found = solve_near(c, near, control);
  if (found && kept != nullptr) kept->keep(found->model);
  return found;
}

/// Where summits make most of the friction and heat opens or closes the gap, a coarse grid may
/// stand on another branch than finer ones: of that the coarser ones, which stand on its own, say
/// nothing.
bool may_stand_on_another_branch(const Solution& s) {
  constexpr double kMostly = 0.5;       // of the friction [-]
  constexpr Grid kFineEnough{200, 25};  // that of the bars' safety (grid_error.hpp)
  const std::vector<Quantity> q = scalars(s);
  return s.model.physics.film_energy && cells(s.model.input.model.grid) < cells(kFineEnough) &&
         std::abs(value_in(q, "friction_torque_asperity")) >
             kMostly * std::abs(value_in(q, "friction_torque"));
}

/// Whether a face lies where an opening at the ends begins.
bool shows(const Case& c, const Grid& grid, const bearing::EdgeOpening& opening) {
  const FilmGrid g = film_grid(c, grid);
  const double foot = 0.5 * c.bearing.width - opening.length;
  return std::any_of(g.z_face.begin(), g.z_face.end(),
                     [&](double z) { return std::abs(z - foot) < kRoundOff * c.bearing.width; });
}

/// Whether a grid carries the supplies along and shows the openings that the case's own grid shows:
/// without a face at its foot one reaches into the film, and makes another bearing of it.
bool carries(const Case& c, const Grid& grid) {
  if (!holds_supplies(c, grid)) return false;
  for (const auto& opening : {c.bearing.edge_relief, c.bearing.chamfer}) {
    if (!opening || shows(c, grid, *opening) || !shows(c, c.model.grid, *opening)) continue;
    return false;
  }
  return true;
}

}  // namespace

std::vector<Grid> coarse_grids(const Case& c) {
  std::vector<Grid> grids;
  for (Grid grid = c.model.grid;;) {
    const std::optional<Grid> half = halved(grid);
    if (!half && grids.size() + 1 >= kGrids) break;
    grid = half ? *half : scaled(grid, 1.0 / kRefinement);
    if (grid[0] < 20 || grid[1] < 3) break;
    grids.insert(grids.begin(), grid);
  }
  const auto [around, along] = c.model.grid;
  for (Grid& grid : grids) {
    const int as_coarse = grid[1];
    while (grid[1] < along && !carries(c, grid)) ++grid[1];
    if (grid[1] == along) grid[1] = as_coarse;  // fewer cells than the own ones show no opening
    while (grid[1] < along && !holds_supplies(c, grid)) ++grid[1];
    while (grid[0] < around && !holds_supplies(c, grid)) ++grid[0];
  }
  std::erase_if(grids, [&](const Grid& g) { return g[0] >= around || g[1] >= along; });
  grids.erase(std::unique(grids.begin(), grids.end()), grids.end());
  return grids;
}

std::optional<Grid> finer_grid(const Case& c) {
  const Grid grid = c.model.grid;
  if (cells(grid) > cells(kUsualGrid)) return std::nullopt;
  const auto [around, along] = scaled(grid, kRefinement);
  return Grid{around, std::min(along, most_axial_cells(c))};
}

std::vector<Grid> nearest_coarse_grids(const Case& c) {
  std::vector<Grid> grids = coarse_grids(c);
  if (grids.size() > 2) grids.erase(grids.begin(), grids.end() - 2);
  return grids;
}

std::optional<Solution> solve_near(const Case& c, const Solution& near, const SolveControl& control,
                                   double* work) {
  SolveControl quiet;
  quiet.stop = control.stop;
  quiet.most_work = control.most_work;
  try {
    Solution s = solve_tier_from(c, c.model.tier, near, quiet);
    if (work != nullptr) *work += s.cost.work;
    if (s.verdict.good()) return s;
  } catch (const InputError&) {  // the supplies need more cells than this grid has
  }
  return std::nullopt;
}

std::optional<Solution> with_more_nodes(const Solution& s, const SolveControl& control) {
  Case richer = s.model.input;
  richer.model.film_nodes += kMoreNodes;
  return solve_near(richer, s, control);
}

std::vector<Quantity> scalars(const Solution& s) {
  return quantities_of(s, s.model.input.model.tier);
}

GridSequence grid_sequence(const Solution& s, const SolveControl& control, KeptSolids* kept) {
  GridSequence out{std::nullopt, s.levels};
  const auto known = [&](const Grid& grid) {
    return std::find_if(out.levels.begin(), out.levels.end(),
                        [&](const LevelRecord& l) { return l.grid == grid; });
  };
  const Grid own = s.model.input.model.grid;
  if (known(own) == out.levels.end()) out.levels.push_back({own, scalars(s)});
  for (const Grid& grid : coarse_grids(s.model.input)) {
    if (stopped(control)) return out;
    const auto level = known(grid);
    const bool wanted = level == out.levels.end() && out.levels.size() < kGrids;
    if (out.coarse && !wanted) continue;
    auto coarse = beside(s, grid, control, kept);
    if (!coarse) continue;
    if (level == out.levels.end()) {
      out.levels.push_back({grid, scalars(*coarse)});
    } else {
      level->quantities = scalars(*coarse);  // to the end, where the nested iteration stopped early
    }
    if (!out.coarse) out.coarse = std::move(coarse);
  }
  const std::optional<Grid> fine = finer_grid(s.model.input);
  if ((!out.coarse || may_stand_on_another_branch(s)) && fine && !stopped(control)) {
    if (const auto finer = beside(s, *fine, control, kept)) {
      if (!out.coarse) {
        out.levels = {{own, scalars(s)}};
        out.coarse = s;
      }
      out.levels.push_back({*fine, scalars(*finer)});
    }
  }
  std::sort(out.levels.begin(), out.levels.end(),
            [](const auto& a, const auto& b) { return cells(a.grid) < cells(b.grid); });
  return out;
}

}  // namespace shellback::fidelity
