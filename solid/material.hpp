#pragma once
/// One solid material: what conduction, elasticity and thermal deformation need of it.
#include <limits>
#include <string>

namespace shellback::solid {

/// What nobody has set, where zero would be a value: every case that needs it is refused.
inline constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

struct Material {
  std::string name;
  double conductivity = 0.0;         ///< [W/(m K)]
  double density = 0.0;              ///< [kg/m3]
  double heat_capacity = 0.0;        ///< [J/(kg K)]
  double youngs_modulus = 0.0;       ///< [Pa]
  double poisson_ratio = kNotGiven;  ///< [-], below 0.5; zero is a value
  double expansion = kNotGiven;      ///< linear thermal expansion [1/K]; zero is a value
  double hardness = 0.0;             ///< largest contact pressure; 0: not known [Pa]
  // Of a coating as an elasto-plastic layer (surface_layer.hpp).
  double progression = 0.0;                     ///< rate at which it stiffens, N [-]
  double damping_ratio = 0.0;                   ///< of damping to stiffness; 0: not known [s]
  double limit_temperature = 0.0;               ///< up to which it serves; 0: not known [K]
  [[nodiscard]] double shear_modulus() const {  ///< [Pa]
    return 0.5 * youngs_modulus / (1.0 + poisson_ratio);
  }
  [[nodiscard]] bool operator==(const Material&) const = default;
};

/// Strain of a layer under unit pressure, sideways held: (1 + nu)(1 - 2 nu)/(E (1 - nu)) [1/Pa].
/// Source: textbook.
[[nodiscard]] inline double confined_compliance(const Material& m) {
  const double nu = m.poisson_ratio;
  return (1.0 + nu) * (1.0 - 2.0 * nu) / (m.youngs_modulus * (1.0 - nu));
}

}  // namespace shellback::solid
