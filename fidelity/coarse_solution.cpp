#include "fidelity/coarse_solution.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "coupling/bearing.hpp"
#include "coupling/nested.hpp"

namespace shellback::fidelity {

using namespace coupling;

namespace {

/// Coarse solves are quick; they stop with the others but tell nothing.
SolveControl quiet(const SolveControl& control) { return {{}, control.stop}; }

/// Whether the edges of the supplies can be resolved.
bool holds_supplies(const Case& c, std::array<int, 2> grid) {
  try {
    static_cast<void>(make_bearing(c, {}, grid));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::optional<CoarseSolution> finished(const Case& c, Tier tier, Solution s) {
  if (!s.verdict.good()) return std::nullopt;
  std::vector<Quantity> quantities = quantities_of(s, tier);
  return CoarseSolution{c, tier, std::move(s), std::move(quantities)};
}

}  // namespace

std::vector<std::array<int, 2>> coarse_grids(std::array<int, 2> fine) {
  constexpr double kRatio = 0.7;  // of the cells in each direction: still apart from the next
  constexpr int kFewestRound = 20;
  constexpr int kFewestAxial = 3;
  auto grids = grid_ladder(fine);
  grids.pop_back();
  while (grids.size() < 2) {
    const auto [nt, nz] = grids.empty() ? fine : grids.front();
    const std::array<int, 2> coarser{static_cast<int>(std::lround(kRatio * nt)),
                                     static_cast<int>(std::lround(kRatio * nz))};
    if (coarser[0] < kFewestRound || coarser[1] < kFewestAxial) break;
    grids.insert(grids.begin(), coarser);
  }
  return grids;
}

std::vector<std::array<int, 2>> coarse_grids(const Case& c) {
  const auto [most_round, most_axial] = c.model.grid;
  std::vector<std::array<int, 2>> grids;
  for (auto grid : coarse_grids(c.model.grid)) {
    while (grid[1] < most_axial && !holds_supplies(c, grid)) ++grid[1];
    while (grid[0] < most_round && !holds_supplies(c, grid)) ++grid[0];
    const bool coarser = grid[0] < most_round && grid[1] < most_axial;
    if (coarser && (grids.empty() || grids.back() != grid)) grids.push_back(grid);
  }
  return grids;
}

std::array<int, 2> next_finer(std::array<int, 2> grid) {
  constexpr double kRatio = 1.4;  // of the cells in each direction: apart, and affordable
  return {static_cast<int>(std::lround(kRatio * grid[0])),
          static_cast<int>(std::lround(kRatio * grid[1]))};
}

std::optional<CoarseSolution> solve_coarse(const Case& c, Tier tier, std::array<int, 2> grid,
                                           const SolveControl& control) {
  Case coarse = c;
  coarse.model.tier = tier;
  coarse.model.grid = grid;
  try {
    return finished(coarse, tier, solve_tier(coarse, tier, quiet(control)));
  } catch (const InputError&) {  // the supplies need more cells than this grid has
    return std::nullopt;
  }
}

std::optional<CoarseSolution> solve_beside(const Solution& s, Tier tier, std::array<int, 2> grid,
                                           std::shared_ptr<const Solids> solids,
                                           const SolveControl& control) {
  Case other = s.model.input;
  other.model.tier = tier;
  other.model.grid = grid;
  Solution near = s;
  near.model.solids = std::move(solids);
  try {
    return finished(other, tier,
                    solve_tier_from(other, tier, near, quiet(control), Otherwise::give_up));
  } catch (const InputError&) {  // the supplies need more cells than this grid has
    return std::nullopt;
  }
}

std::optional<CoarseSolution> solve_changed(const Case& changed, Tier tier,
                                            const CoarseSolution& near,
                                            const SolveControl& control) {
  Case c = changed;
  c.model.tier = tier;
  return finished(c, tier, solve_tier_from(c, tier, near.solution, quiet(control)));
}

double value_in(const std::vector<Quantity>& list, const std::string& name) {
  const auto q =
      std::find_if(list.begin(), list.end(), [&](const Quantity& a) { return a.name == name; });
  return q == list.end() ? NAN : q->value;
}

}  // namespace shellback::fidelity
