#pragma once
/// Roughness of one surface and of the pair, as the contact and the flow factors need it.
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

/// Greenwood-Tripp contact of two rough surfaces with constant boundary friction.
struct ContactParameters {
  double elastic_factor = 0.0;     ///< K = 16 sqrt2 pi/15 (sigma beta eta)^2 sqrt(sigma/beta) [-]
  double composite_modulus = 0.0;  ///< E* [Pa]
  double friction = 0.0;           ///< boundary friction coefficient [-]
  ContactIntegral integral = ContactIntegral::exact;
  double hardness = 0.0;           ///< limit of the contact pressure; 0: none [Pa]
};

}  // namespace shellback::solid
