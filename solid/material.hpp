#pragma once
/// One solid material: what conduction, elasticity and thermal deformation need of it.
#include <string>

namespace shellback::solid {

struct Material {
  std::string name;
  double conductivity = 0.0;    ///< [W/(m K)]
  double density = 0.0;         ///< [kg/m3]
  double heat_capacity = 0.0;   ///< [J/(kg K)]
  double youngs_modulus = 0.0;  ///< [Pa]
  double poisson_ratio = 0.0;   ///< [-], below 0.5
  double expansion = 0.0;       ///< linear thermal expansion [1/K]
  double hardness = 0.0;        ///< largest contact pressure; 0: not known [Pa]
  // Of a coating as an elasto-plastic layer (surface_layer.hpp).
  double progression = 0.0;        ///< rate at which it stiffens, N [-]
  double damping_ratio = 0.0;      ///< of damping to stiffness; 0: not known [s]
  double limit_temperature = 0.0;  ///< up to which it serves; 0: not known [K]
  [[nodiscard]] bool operator==(const Material&) const = default;
};

/// Strain of a layer under unit pressure, sideways held: (1 + nu)(1 - 2 nu)/(E (1 - nu)) [1/Pa].
/// Source: textbook.
[[nodiscard]] inline double confined_compliance(const Material& m) {
  const double nu = m.poisson_ratio;
  return (1.0 + nu) * (1.0 - 2.0 * nu) / (m.youngs_modulus * (1.0 - nu));
}

}  // namespace shellback::solid
