#include "validation/stress/stress_methods.hpp"

namespace shellback::validation {

const std::vector<StressMethod>& stress_methods() {
  constexpr double kSameEquations = 1e-3;
  constexpr double kOtherGrid = 0.02;
  constexpr double kOtherModel = 0.1;
  static const std::vector<StressMethod> methods{
      {.name = "default", .title = "Shellback", .shipped = true, .same_equations = true},
      {.name = "fischer-burmeister",
       .title = "Fischer-Burmeister Newton",
       .allowed = kSameEquations,
       .same_equations = true},
      {.name = "p-theta",
       .title = "p-theta relaxation",
       .allowed = kSameEquations,
       .same_equations = true},
      {.name = "swift-stieber",
       .title = "Swift-Stieber",
       .allowed = kOtherModel,
       .less_physics = true,
       .full_shear = true},
      {.name = "fixed-point",
       .title = "elastic fixed point",
       .allowed = kSameEquations,
       .same_equations = true},
      {.name = "layers", .title = "20 even layers", .allowed = kOtherGrid},
      {.name = "mean",
       .title = "one temperature across",
       .allowed = kOtherModel,
       .less_physics = true},
  };
  return methods;
}

StressMethodWords words_for(const StressMethod& method, const bearing::Physics& physics) {
  if (method.shipped) return {true, {}};
  StressMethodWords out;
  if (method.name == "layers" || method.name == "mean") {
    out.applies = physics.film_energy;
    out.words = {"model.methods.across=" + method.name};
    return out;
  }
  if (method.name == "fixed-point") {
    out.applies = physics.elastic;
    out.words = {"model.methods.elastic=fixed-point"};
    return out;
  }
  out.applies = true;
  out.words = {"model.methods.cavitation=" + method.name};
  // No cavitation method but the default's has an elastic Newton step.
  if (physics.elastic) out.words.emplace_back("model.methods.elastic=fixed-point");
  return out;
}

}  // namespace shellback::validation
