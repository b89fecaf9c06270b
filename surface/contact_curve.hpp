#pragma once
/// Contact pressure and contact area of a surface over the separation.
///
/// h: distance of the mean planes. Pressures are per composite modulus E*, over the nominal area.
///
/// Two surfaces like this one (as Greenwood and Tripp, shell and shaft alike):
///   p/E* = K F_5/2((h - 2 d)/s),  s = sqrt2 sigma_s, d mean summit height            formula
///   K    = 16 sqrt2 pi/15 (s beta eta)^2 sqrt(s/beta)
///   r_c  = pi^2 (s beta eta)^2 F_2                                real over nominal area
///   p/E* = (1/A^2) sum_ij (16 pi/15) sqrt(|k_i + k_j|/(|k_i| |k_j|)) g(k_i + k_j)
///          <z_i + z_j - h>^(5/2)                                                     summits
/// the second over all pairs of the map's own counted summits, k_i their curvatures with
/// determinant |k_i|, those of the second surface turned over about the motion (z_xy changes its
/// sign: oblique lays cross face to face), g by hertz_ellipse.hpp (1), averaged over every place
/// that they can have to one another (paraboloids with offset r approach by z_i + z_j - h - r
/// (1/k_i + 1/k_j)^-1 r/2; Hertz, integrated over r). It is Greenwood and Tripp's theory without
/// their Gaussian heights and equal spheres; with those it becomes the formula.
///
/// This surface on a smooth plane:
///   p/E* = (1/A) sum_i (4/3) g(k_i) <z_i - h>^(3/2)           Hertz on every counted summit
///   bearing area  = part of the surface above h (Abbott); times the hardness of the softer surface
///                   it is the pressure at which all that overlaps flows: an upper bound
///
/// Validity: summits that do not feel each other, bearing area small against 1. The formula needs
/// summits of different height, at H >= -100 (solid::gt_integral); elsewhere it is NaN, and without
/// summits so is all but the bearing area. Sources: Greenwood
/// and Tripp 1971, Greenwood and Williamson 1966, Bowden and Tabor (textbook).
#include <vector>

#include "surface/summits.hpp"

namespace shellback::surface {

/// Part of the surface's Rq that summit heights scatter by at least: below, they are equal but for
/// the map's digits, and F(H) of heights over their scatter says nothing [-].
inline constexpr double kAlikeSummits = 1e-3;

/// True if the formula can be used: two summits or more, of different height. Rq of the map [m].
[[nodiscard]] bool scattered(const SummitStatistics& one, double Rq);

/// K of two surfaces like this one [-]; NaN without summits.
[[nodiscard]] double elastic_factor(const SummitStatistics& one);

struct ContactRow {
  double h = 0.0;                   ///< separation of the mean planes [m]
  double pair_formula = 0.0;        ///< p/E* [-]; NaN: not known
  double pair_summits = 0.0;        ///< p/E* [-]; NaN: no summits
  double pair_contact_ratio = 0.0;  ///< r_c [-]; NaN: not known
  double plane_summits = 0.0;       ///< p/E* [-]; NaN: no summits
  double bearing_area = 0.0;        ///< [-]
};

/// `one`: of the counted summits, with a roughness. Map without holes, mean 0.
[[nodiscard]] std::vector<ContactRow> contact_curve(const HeightMap& map,
                                                    const std::vector<Summit>& summits,
                                                    const SummitStatistics& one,
                                                    const std::vector<double>& h);

}  // namespace shellback::surface
