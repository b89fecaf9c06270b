#include "fidelity/auto_nodes.hpp"

#include <cmath>

#include "fidelity/coarse_solution.hpp"

namespace shellback::fidelity {
namespace {

using namespace coupling;

constexpr double kNegligible = 0.1;  ///< share of the tolerance that the nodes may leave open [-]
constexpr int kMore = 2;             ///< nodes at a time; their number stays odd

std::vector<Quantity> change(const std::vector<Quantity>& from, const std::vector<Quantity>& to) {
  std::vector<Quantity> list = from;
  for (Quantity& q : list) q.value = value_in(to, q.name) - q.value;
  return list;
}

}  // namespace

NodeChoice choose_nodes(Solution& probe, Tier tier, double tolerance, bool given,
                        const SolveControl& control) {
  NodeChoice out;
  const Model& by = probe.model.input.model;
  if (!probe.model.physics.film_energy || by.methods.across != AcrossFilm::lobatto) return out;
  while (true) {
    out.nodes = by.film_nodes;
    Case richer = probe.model.input;
    richer.model.film_nodes += kMore;
    Solution more = solve_tier_from(richer, tier, probe, {{}, control.stop}, Otherwise::give_up);
    out.cost.factorizations += more.cost.factorizations;
    out.cost.newton_iterations += more.cost.newton_iterations;
    out.known = more.verdict.good();
    if (!out.known) return out;
    const auto here = quantities_of(probe, tier);
    out.left = change(here, quantities_of(more, tier));
    const auto small = [&](const char* name) {
      return std::abs(value_in(out.left, name)) <=
             kNegligible * tolerance * std::abs(value_in(here, name));
    };
    const bool enough = small("friction_torque") && small("h_min");
    if (enough || given || richer.model.film_nodes > kMostAutoNodes) return out;
    probe = std::move(more);
  }
}

}  // namespace shellback::fidelity
