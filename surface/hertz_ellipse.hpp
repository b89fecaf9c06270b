#pragma once
/// Hertz's contact of a summit whose principal curvatures differ.
///
///   force = (4/3) E* g w^(3/2),  w the approach,  g = (k1 k2)^(-1/4) phi                      (1)
/// k1 >= k2 > 0 the principal curvatures of the gap that closes. With the pressed ellipse's k =
/// b/a, e^2 = 1 - k^2 and the complete elliptic integrals K(e), E(e),
///   k1/k2 = (E/k^2 - K)/(K - E),   phi = (pi/sqrt2) [(K - E)(E/k^2 - K)]^(1/4)/(e K^(3/2))    (2)
/// phi = 1 on a sphere, where g = 1/sqrt(curvature). Source: Hertz, in the form of Johnson, Contact
/// Mechanics, 4.2 (textbook).

namespace shellback::surface {

/// phi of (2); `ratio` = k1/k2 >= 1, up to 1e6 (beyond: that of 1e6). Within 1e-6.
[[nodiscard]] double ellipse_factor(double ratio);

/// g of (1) [m^1/2] of principal curvatures k1 and k2 in any order, both positive [1/m].
[[nodiscard]] double hertz_factor(double k1, double k2);

/// Radius of the sphere that two summits alike, of these curvatures and one direction, press and
/// give way as: (k1 k2)^(-1/2) phi^(2/3) [m].
[[nodiscard]] double sphere_alike(double k1, double k2);

}  // namespace shellback::surface
