#include "fidelity/solve_case.hpp"

#include "fidelity/auto_tier.hpp"
#include "fidelity/estimate.hpp"
#include "fidelity/solve.hpp"

namespace shellback::fidelity {

coupling::Result solve_case(const coupling::Case& c, const coupling::SolveControl& control) {
  switch (c.model.tier) {
    case coupling::Tier::estimate:
      return estimate_result(c);
    case coupling::Tier::automatic:
      return solve_auto(c, control);
    default:
      return fidelity::solve(c, control);
  }
}

}  // namespace shellback::fidelity
