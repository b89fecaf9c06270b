#include "fidelity/solve_case.hpp"

#include "fidelity/auto_cycle.hpp"
#include "fidelity/auto_tier.hpp"
#include "fidelity/estimate.hpp"
#include "fidelity/solve.hpp"

namespace shellback::fidelity {

bearing::Result solve_case(const bearing::Case& c, const bearing::SolveControl& control) {
  if (c.cycle) return bearing::as_result(solve_cycle_case(c, control));
  if (c.model.tier == bearing::Tier::estimate) return estimate_result(c);
  if (c.model.tier == bearing::Tier::automatic) return solve_auto(c, control);
  return fidelity::solve(c, control);
}

}  // namespace shellback::fidelity
