#pragma once
/// Roughness of one surface and of the pair, as the contact and the flow factors need it.
#include <optional>

#include "solid/material.hpp"

namespace shellback::solid {

/// One rough surface. Orientation is Peklenik's gamma: length over width of the asperities,
/// above 1 if they run along the sliding direction.
struct RoughSurface {
  double roughness = 0.0;         ///< standard deviation of heights Rq [m]
  double orientation = 1.0;       ///< Peklenik number gamma [-]
  double summit_roughness = 0.0;  ///< standard deviation of summit heights [m]
  double summit_height = 0.0;     ///< mean summit height above the mean plane [m]
};

enum class ContactIntegral { exact, power_law };

/// Constants of the generic boundary friction (solid/boundary_friction.hpp, (1)-(2)).
struct GenericFriction {
  double abrasive = 0.0;        ///< mu_abrasive [-]
  double adhesive = 0.0;        ///< mu_adhesive,0, of surfaces that stick [-]
  double a = 10.0;              ///< base of the adhesive part's decay, above 1 [-]
  double b = 0.0;               ///< its factor of the lubrication number [-]
  double c = 0.0;               ///< factor of the micro-hydrodynamic part [-]
  double summit_radius = 0.0;   ///< beta [m]
  double orientation = 1.0;     ///< Theta [-]
  std::optional<double> L_s{};  ///< reference length of summit contact [m]; none: (3) there
};

/// Greenwood-Tripp contact of two rough surfaces with boundary friction.
struct ContactParameters {
  double elastic_factor = 0.0;     ///< K = 16 sqrt2 pi/15 (sigma beta eta)^2 sqrt(sigma/beta) [-]
  double composite_modulus = 0.0;  ///< E* [Pa]
  double friction = kNotGiven;     ///< constant boundary friction coefficient [-]
  ContactIntegral integral = ContactIntegral::exact;
  double hardness = 0.0;                          ///< limit of the contact pressure; 0: none [Pa]
  std::optional<GenericFriction> friction_law{};  ///< takes the place of the constant
};

}  // namespace shellback::solid
