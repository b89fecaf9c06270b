#include "fidelity/coarse_solution.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "coupling/nested.hpp"

namespace shellback::fidelity {

using namespace coupling;

namespace {

/// Coarse solves are quick; they stop with the others but tell nothing.
SolveControl quiet(const SolveControl& control) { return {{}, control.stop}; }

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
