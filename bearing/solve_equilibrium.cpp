#include "bearing/solve_equilibrium.hpp"

#include "bearing/elastic_fixed_point.hpp"
#include "bearing/film_then_position.hpp"
#include "bearing/newton.hpp"
#include "bearing/pseudo_time.hpp"

namespace shellback::bearing {
namespace {

using Method = decltype(&newton);

/// What the case asks for, `usual` standing for Newton's method.
Method method_of(const BearingModel& model, const FilmEquilibrium& s, Method usual) {
  const Methods& by = model.input.model.methods;
  if (!s.elastic.empty() && by.elastic == ElasticMethod::fixed_point) return elastic_fixed_point;
  return by.cavitation == CavitationMethod::active_set ? usual : film_then_position;
}

}  // namespace

Verdict solve_equilibrium(const BearingModel& model, const LoadTarget& target, const Field& growth,
                          const EquilibriumOptions& options, FilmEquilibrium& s,
                          EquilibriumCost& cost, const std::atomic<bool>* stop) {
  const Method solve = method_of(model, s, newton_or_through_time);
  return solve(model, target, growth, options, s, cost, stop);
}

Verdict solve_equilibrium_near(const BearingModel& model, const LoadTarget& target,
                               const Field& growth, const EquilibriumOptions& options,
                               FilmEquilibrium& s, EquilibriumCost& cost,
                               const std::atomic<bool>* stop) {
  const Method solve = method_of(model, s, newton);
  return solve(model, target, growth, options, s, cost, stop);
}

bool usual_methods(const Case& c) {
  const Methods& by = c.model.methods;
  return by.cavitation == CavitationMethod::active_set && by.elastic == ElasticMethod::newton;
}

}  // namespace shellback::bearing
