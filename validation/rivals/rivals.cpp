#include "validation/rivals/rivals.hpp"

#include "validation/rivals/elastic_fixed_point.hpp"
#include "validation/rivals/film_then_position.hpp"

namespace shellback::validation {
namespace {

using namespace bearing;

/// Elastic surfaces around the film, if that is asked for and there are any.
Verdict solve_by_rivals(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost) {
  const bool in_turn = task.model.input.model.methods.elastic == ElasticMethod::fixed_point;
  const auto solve = in_turn && !s.elastic.empty() ? elastic_fixed_point : film_then_position;
  return solve(task, s, cost);
}

}  // namespace

EquilibriumMethod rival_for(const Methods& methods) {
  const bool usual = methods.cavitation == CavitationMethod::active_set &&
                     methods.elastic == ElasticMethod::newton;
  return usual ? nullptr : solve_by_rivals;
}

Case with_rivals(Case c) {
  c.model.methods.stand_in = rival_for(c.model.methods);
  return c;
}

}  // namespace shellback::validation
