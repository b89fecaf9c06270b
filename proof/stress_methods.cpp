#include "proof/stress_methods.hpp"

namespace shellback::proof {

const std::vector<StressMethod>& stress_methods() {
  constexpr double kSameEquations = 1e-3;
  constexpr double kOtherGrid = 0.02;
  constexpr double kOtherModel = 0.1;
  static const std::vector<StressMethod> methods{
      {"default", "Shellback", 0.0, true},
      {"fischer-burmeister", "Fischer-Burmeister Newton", kSameEquations, false},
      {"p-theta", "p-theta relaxation", kSameEquations, false},
      {"swift-stieber", "Swift-Stieber", kOtherModel, false},
      {"fixed-point", "elastic fixed point", kSameEquations, false},
      {"layers", "20 even layers", kOtherGrid, false},
      {"mean", "one temperature across", kOtherModel, false},
  };
  return methods;
}

StressMethodWords words_for(const StressMethod& method, const coupling::Physics& physics) {
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

}  // namespace shellback::proof
