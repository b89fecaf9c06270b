#pragma once
/// Summits of a surface: by spectral moments (Nayak, McCool) and by counting.
///
///   m0 = <z^2>,  m2 = <(dz/ds)^2>,  m4 = <(d2z/ds2)^2>  along profiles in x and in y;
///   m2 = sqrt(m2x m2y), m4 = sqrt(m4x m4y): the isotropic surface in the place of this one
///   density   m4/m2/(6 pi sqrt3)              radius    3 sqrt(pi)/(8 sqrt(m4))
///   roughness sqrt((1 - 0.8968/alpha) m0)     height    4 sqrt(m0/(pi alpha)),  alpha = m0 m4/m2^2
///
/// of a Gaussian surface; height is the mean of the summits over the mean plane, radius the inverse
/// of their mean curvature. Source: Nayak 1971, McCool 1987 (textbook).
///
/// Counted: a point is a summit if it is higher than its eight neighbours and its curvatures, those
/// of -z_xx, -z_yy and -z_xy, are of one sign: on a crest that slopes between the points one of
/// them may top its eight neighbours where the surface has no maximum (2 to 6 % of them at gamma 3
/// to 8, at any pitch). Its radius is that of the sphere which presses as the mean summit does
/// (hertz_ellipse.hpp): of an isotropic surface the inverse of the mean curvature. No assumption
/// about the heights.
///
/// Both use differences over one pitch: they belong to the map's pitch, as summits of every real
/// surface do, and noise of the instrument makes summits too.
#include <cmath>
#include <limits>
#include <vector>

#include "surface/height_map.hpp"

namespace shellback::surface {

/// What a map without summits does not tell.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct SpectralMoments {
  double m0 = 0.0;              ///< [m2]
  double m2x = 0.0, m2y = 0.0;  ///< [-]
  double m4x = 0.0, m4y = 0.0;  ///< [1/m2]
  [[nodiscard]] double m2() const { return std::sqrt(m2x * m2y); }
  [[nodiscard]] double m4() const { return std::sqrt(m4x * m4y); }
  [[nodiscard]] double alpha() const { return m0 * m4() / (m2() * m2()); }  ///< bandwidth [-]
};

/// By central differences of second order over one pitch, z' between two points.
/// Of a map without holes, three points or more each way, mean 0.
[[nodiscard]] SpectralMoments spectral_moments(const HeightMap& map);

struct SummitStatistics {
  double density = 0.0;    ///< eta [1/m2]
  double radius = 0.0;     ///< beta [m]
  double roughness = 0.0;  ///< standard deviation of summit heights [m]
  double height = 0.0;     ///< mean height over the mean plane [m]
};

/// Valid for alpha > 0.8968 (1.5 is the least of any isotropic Gaussian surface); the roughness is
/// NaN below. All are where one slope is round-off of the other: grooves without end have no
/// summit.
[[nodiscard]] SummitStatistics summits_of(const SpectralMoments& moments);

/// Curvatures of a paraboloid, positive downwards [1/m].
struct Curvature {
  double xx = 0.0, yy = 0.0, xy = 0.0;
  [[nodiscard]] double determinant() const { return xx * yy - xy * xy; }
  [[nodiscard]] double mean() const { return 0.5 * (xx + yy); }
  /// Half the difference of the principal ones.
  [[nodiscard]] double deviation() const { return std::hypot(0.5 * (xx - yy), xy); }
};
[[nodiscard]] inline Curvature operator+(const Curvature& a, const Curvature& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy};
}

struct Summit {
  double height = 0.0;  ///< over the mean plane [m]
  Curvature curvature;  ///< both principal ones positive
};

/// All of a map without holes, mean 0; none on its rim.
[[nodiscard]] std::vector<Summit> count_summits(const HeightMap& map);

/// Roughness is NaN with one summit, all but the density with none.
[[nodiscard]] SummitStatistics statistics_of(const std::vector<Summit>& summits,
                                             const HeightMap& map);

}  // namespace shellback::surface
