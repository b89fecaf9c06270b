#include "bearing/solve_equilibrium.hpp"

#include "bearing/newton.hpp"
#include "bearing/pseudo_time.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {
namespace {

/// `usual`, or what stands in for it where the case asks for another method in this state.
EquilibriumMethod method_of(const BearingModel& model, const FilmEquilibrium& s,
                            EquilibriumMethod usual) {
  const Methods& by = model.input.model.methods;
  const bool fixed_point = !s.elastic.empty() && by.elastic == ElasticMethod::fixed_point;
  if (!fixed_point && by.cavitation == CavitationMethod::active_set) return usual;
  EXPECTS(by.stand_in != nullptr);  // make_bearing has refused the case otherwise
  return by.stand_in;
}

}  // namespace

Verdict solve_equilibrium(const BearingModel& model, const OperatingPoint& point,
                          const Field& thermal_deformation, const EquilibriumOptions& options,
                          FilmEquilibrium& s, EquilibriumCost& cost,
                          const std::atomic<bool>* stop) {
  const EquilibriumMethod solve = method_of(model, s, newton_or_through_time);
  return solve(model, point, thermal_deformation, options, s, cost, stop);
}

Verdict solve_equilibrium_near(const BearingModel& model, const OperatingPoint& point,
                               const Field& thermal_deformation, const EquilibriumOptions& options,
                               FilmEquilibrium& s, EquilibriumCost& cost,
                               const std::atomic<bool>* stop) {
  const EquilibriumMethod solve = method_of(model, s, newton);
  return solve(model, point, thermal_deformation, options, s, cost, stop);
}

}  // namespace shellback::bearing
