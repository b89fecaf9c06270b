#include "coupling/solve_equilibrium.hpp"

#include "coupling/elastic_fixed_point.hpp"
#include "coupling/film_then_position.hpp"
#include "coupling/pseudo_time.hpp"

namespace shellback::coupling {

Verdict solve_equilibrium(const BearingModel& model, const LoadTarget& target, const Field& growth,
                          const EquilibriumOptions& options, FilmEquilibrium& s,
                          EquilibriumCost& cost, const std::atomic<bool>* stop) {
  const Methods& by = model.input.model.methods;
  const bool in_turn = !s.elastic.empty() && by.elastic == ElasticMethod::fixed_point;
  const bool usual = by.cavitation == CavitationMethod::active_set;
  const auto solve = in_turn ? elastic_fixed_point
                     : usual ? newton_or_through_time
                             : film_then_position;
  return solve(model, target, growth, options, s, cost, stop);
}

}  // namespace shellback::coupling
