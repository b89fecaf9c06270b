#include <chrono>

#include "bearing/cycle.hpp"
#include "bearing/cycle_lumped.hpp"
#include "bearing/cycle_search.hpp"
#include "bearing/nested.hpp"
#include "bearing/solve.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {
namespace {

/// On the case's own grid, from rest.
CycleResult on_one_grid(const Case& c, Tier tier, const SolveControl& control) {
  CycleSearch search(c, tier, control);
  search.begin(tier == Tier::lumped ? c.supplies.front().temperature : equivalent_temperature(c));
  const Verdict v = tier == Tier::lumped ? settle_lumped_cycle(search, c) : search.search(false);
  CycleResult r = search.result();
  r.verdict = v;
  return r;
}

/// The walls of a resolved tier settle on coarse grids first: what they need is many cycles, not
/// many cells. A coarse grid that fails is left out.
CycleResult on_grids(const Case& c, Tier tier, const SolveControl& control) {
  std::unique_ptr<CycleSearch> coarse;
  CycleResult r;
  for (const std::array<int, 2>& grid : grid_ladder(c.model.grid)) {
    Case on = c;
    on.model.grid = grid;
    const bool last = grid == c.model.grid;
    auto search = std::make_unique<CycleSearch>(on, tier, control);
    if (coarse) {
      search->begin(*coarse);
    } else {
      search->begin(equivalent_temperature(c));
    }
    const Verdict& v = search->search(!last);
    r.cost.factorizations += search->cost().factorizations;
    r.cost.newton_iterations += search->cost().newton_iterations;
    if (last || v.status == Status::interrupted) {
      const Cost cost = r.cost;
      r = search->result();
      r.cost = cost;
      return r;
    }
    if (v.good()) coarse = std::move(search);
  }
  return r;
}

}  // namespace

CycleResult solve_cycle(const Case& c, Tier tier, const SolveControl& control) {
  EXPECTS(c.cycle.has_value());
  const auto begin = std::chrono::steady_clock::now();
  const bool resolved = physics_of(c, tier).film_energy && c.cycle->repeats();
  CycleResult r = resolved ? on_grids(c, tier, control) : on_one_grid(c, tier, control);
  r.cost.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return r;
}

}  // namespace shellback::bearing
