#include "fidelity/solve_case.hpp"

#include "fidelity/auto_tier.hpp"
#include "fidelity/estimate.hpp"
#include "fidelity/solve.hpp"

namespace shellback::fidelity {

coupling::Result solve_case(const coupling::Case& c, const coupling::SolveControl& control) {
  if (c.model.tier == coupling::Tier::estimate) return estimate_result(c);
  if (c.model.tier == coupling::Tier::automatic) return solve_auto(c, control);
  return fidelity::solve(c, control);
}

}  // namespace shellback::fidelity
