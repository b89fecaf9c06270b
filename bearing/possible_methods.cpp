#include "bearing/possible_methods.hpp"

#include <fmt/format.h>

#include "bearing/case_limits.hpp"
#include "bearing/pressed_layer.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {

std::string impossible_methods(const Case& c, const Physics& physics) {
  const Methods& m = c.model.methods;
  const auto [fewest, most] = kValueRanges.layers;
  if (m.across == AcrossFilm::layers && (m.layers < fewest || m.layers > most)) {
    return fmt::format("layers must lie between {} and {}", fewest, most);
  }
  const bool by_aitken = m.relaxation == 0.0;
  if (!by_aitken && !kValueRanges.relaxation.holds(m.relaxation)) {
    return std::string("relaxation must ") + kValueRanges.relaxation.words;
  }
  if (m.cavitation == CavitationMethod::swift_stieber && physics.film_energy) {
    return "cavitation = \"swift-stieber\" does not conserve oil, so that the heat in the film "
           "cannot be balanced; take tier isothermal or lumped, or another method";
  }
  if (m.cavitation == CavitationMethod::swift_stieber && c.model.coefficients) {
    return "cavitation = \"swift-stieber\" has no fill ratio, which stiffness and damping need "
           "(model.coefficients); take another method";
  }
  if (physics.elastic && m.elastic == ElasticMethod::fixed_point && pressed_layer(c, 0)) {
    return "elastic = \"fixed-point\" knows no elasto-plastic layer; take elastic = \"newton\", or "
           "shell.layers.0.elasto_plastic out";
  }
  if (m.cavitation != CavitationMethod::active_set && physics.elastic &&
      m.elastic == ElasticMethod::newton) {
    return std::string("cavitation = \"") + to_string(m.cavitation) +
           "\" has no Newton step for elastic bearings; add elastic = \"fixed-point\", or "
           "switch elastic_deformation off";
  }
  return "";
}

bool usual_methods(const Case& c) {
  const Methods& by = c.model.methods;
  return by.cavitation == CavitationMethod::active_set && by.elastic == ElasticMethod::newton;
}

void expect_possible_methods(const Case& c, const Physics& physics) {
  const std::string problem = impossible_methods(c, physics);
  if (!problem.empty()) throw InputError("model.methods: " + problem);
  const Methods& m = c.model.methods;
  if (usual_methods(c) || m.stand_in != nullptr) return;
  throw InputError(std::string("model.methods: cavitation = \"") + to_string(m.cavitation) +
                   "\" with elastic = \"" + to_string(m.elastic) +
                   "\" is a method to compare with: the program shellback has it, the library has "
                   "not; take active-set and newton, or give methods.stand_in");
}

const char* to_string(CavitationMethod method) {
  switch (method) {
    case CavitationMethod::active_set:
      return "active-set";
    case CavitationMethod::fischer_burmeister:
      return "fischer-burmeister";
    case CavitationMethod::p_theta:
      return "p-theta";
    case CavitationMethod::swift_stieber:
      return "swift-stieber";
  }
  return "";
}

const char* to_string(AcrossFilm method) {
  switch (method) {
    case AcrossFilm::lobatto:
      return "lobatto";
    case AcrossFilm::layers:
      return "layers";
    case AcrossFilm::mean:
      return "mean";
  }
  return "";
}

const char* to_string(ElasticMethod method) {
  return method == ElasticMethod::newton ? "newton" : "fixed-point";
}

}  // namespace shellback::bearing
