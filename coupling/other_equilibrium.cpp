#include "coupling/other_equilibrium.hpp"

#include "coupling/elastic_fixed_point.hpp"
#include "coupling/film_then_position.hpp"

namespace shellback::coupling {
namespace {

bool by_fixed_point(const BearingModel& model, const FilmEquilibrium& s) {
  return !s.elastic.empty() && model.input.model.methods.elastic == ElasticMethod::fixed_point;
}

}  // namespace

bool solved_otherwise(const BearingModel& model, const FilmEquilibrium& s) {
  return by_fixed_point(model, s) ||
         model.input.model.methods.cavitation != CavitationMethod::active_set;
}

Verdict solve_otherwise(const BearingModel& model, const LoadTarget& target, const Field& growth,
                        const EquilibriumOptions& options, FilmEquilibrium& s,
                        EquilibriumCost& cost, const std::atomic<bool>* stop) {
  return by_fixed_point(model, s)
             ? elastic_fixed_point(model, target, growth, options, s, cost, stop)
             : film_then_position(model, target, growth, options, s, cost, stop);
}

}  // namespace shellback::coupling
