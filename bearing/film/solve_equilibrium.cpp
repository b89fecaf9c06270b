#include "bearing/film/solve_equilibrium.hpp"

#include "bearing/film/newton.hpp"
#include "bearing/film/pseudo_time.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {
namespace {

/// `usual`, or what stands in for it where the case asks for another method in this state.
EquilibriumMethod method_of(const FilmTask& task, const FilmEquilibrium& s,
                            EquilibriumMethod usual) {
  const Methods& by = task.model.input.model.methods;
  const bool fixed_point = !s.elastic.empty() && by.elastic == ElasticMethod::fixed_point;
  if (!fixed_point && by.cavitation == CavitationMethod::active_set) return usual;
  EXPECTS(by.stand_in != nullptr);  // make_bearing has refused the case otherwise
  return by.stand_in;
}

}  // namespace

Verdict solve_equilibrium(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost) {
  return method_of(task, s, newton_or_through_time)(task, s, cost);
}

Verdict solve_equilibrium_near(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost) {
  return method_of(task, s, newton)(task, s, cost);
}

}  // namespace shellback::bearing
