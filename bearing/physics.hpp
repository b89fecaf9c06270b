#pragma once
/// Which physics one solve has: the tier and the switches, made definite.
#include "bearing/case.hpp"

namespace shellback::bearing {

struct Physics {
  bool film_energy = false;  ///< temperature resolved; otherwise one temperature
  bool elastic = false;
  bool thermal_deformation = false;
  bool contact = false;
  bool flow_factors = false;
  bool pressure_dependence = true;
  bool shear_thinning = true;
};
[[nodiscard]] Physics physics_of(const Case& c, Tier tier);

}  // namespace shellback::bearing
