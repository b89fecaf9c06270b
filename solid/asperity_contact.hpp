#pragma once
/// Contact pressure of two rough surfaces after Greenwood and Tripp.
///
///   p_a = K E* F_{5/2}(H),   H = (h - delta)/sigma                       seed 000 Eq. 2
///   F_n(H) = 1/sqrt(2 pi) int_H^inf (s - H)^n exp(-s^2/2) ds
///   dp_a/dh = -(5/2) K E* F_{3/2}(H) / sigma          since F_n' = -n F_{n-1}
///
/// h [m] is the gap between the mean planes of the surfaces; the summits of shell and shaft
/// stand on average delta = delta_shell + delta_shaft above them, with a combined standard
/// deviation sigma = sqrt(sigma_shell^2 + sigma_shaft^2). Contact therefore begins near
/// h = delta + 4 sigma. p_a > 0 pushes the surfaces apart, spread over the nominal area; h may
/// be negative (nominal interpenetration).
///
/// With a hardness the pressure ends there: summits that are pressed further flow,
///   p_a = min(K E* F_{5/2}(H), hardness),  flowed by max(0, h_f - h),  p_a(h_f) = hardness
/// (return mapping of an ideally plastic summit layer under loading, textbook). Valid while
/// summits are loaded for the first time or further; unloading is not told apart.
///
/// The named alternative is the power law F = 4.4086e-5 (4 - H)^6.804 below H = 4, 0 above
/// (seed 004, below its Eq. 2): 11 % low at H = 0, exact near 1.7, 74 % low at 3, zero at 4. It is
/// what papers computed with AVL codes contain.
///
/// Validity: elastic summits that do not feel each other, hence a real contact area small against
/// the nominal one. It is pi^2 (eta beta sigma)^2 F_2(H) of it (Greenwood and Tripp, textbook),
/// with eta beta sigma 0.03 to 0.05 of engineering surfaces (textbook); with 0.05 all is contact
/// from H = -6.3 on. Below that the pressure is the formula's and no material's: results say so.
#include <span>
#include <vector>

#include "solid/boundary_friction.hpp"
#include "solid/surface.hpp"

namespace shellback::solid {

/// F_n(H) by adaptive quadrature, relative error below 1e-12 for 0.5 <= n <= 4 and
/// -100 <= H <= 30. Slow. Throws std::runtime_error if the quadrature misses that.
[[nodiscard]] double gt_integral(double n, double H);

/// Contact pressure at a gap and its derivative.
struct ContactPressure {
  double p;      ///< p_a [Pa], not negative
  double dp_dh;  ///< d p_a / d h [Pa/m], not positive
};

/// The contact of one pair of surfaces, ready to be evaluated at many gaps.
///
/// With ContactIntegral::exact, ln F_{5/2} and F_{3/2}/F_{5/2} are Chebyshev polynomials on
/// intervals of H between -30 and 10, made once from gt_integral; relative error of p_a and of
/// its derivative below 1e-10. Below H = -30 the asymptotic series of F for deep contact is
/// used (same error). Above H = 10 both are exactly zero: F_{5/2}(10) < 1e-24, that is p_a below
/// 1e-16 Pa for any material, and a solver then need not carry such numbers.
class AsperityContact {
 public:
  /// Throws InputError if neither surface has a summit roughness, if the elastic factor or the
  /// composite modulus is not positive, or if the hardness is negative.
  AsperityContact(const RoughSurface& shell, const RoughSurface& shaft,
                  const ContactParameters& parameters);

  [[nodiscard]] ContactPressure at(double h) const;

  /// All gaps at once: spans of equal size.
  void evaluate(std::span<const double> h, std::span<double> p, std::span<double> dp_dh) const;

  /// Gap at which the contact pressure, without the limit, is p > 0 [m].
  [[nodiscard]] double gap_of(double p) const;
  /// Gap at which summits begin to flow [m]; -infinity without a hardness.
  [[nodiscard]] double flow_gap() const { return flow_gap_; }
  [[nodiscard]] double hardness() const { return hardness_; }  ///< infinity: none [Pa]
  [[nodiscard]] double sigma() const { return sigma_; }        ///< combined summit deviation [m]
  [[nodiscard]] double delta() const { return delta_; }        ///< sum of summit heights [m]
  /// Gap below which the whole surface would be in contact: beyond the law [m].
  [[nodiscard]] double least_gap() const { return delta_ + whole_surface_ * sigma_; }
  /// Friction of the pair (solid/boundary_friction.hpp).
  [[nodiscard]] const BoundaryFriction& friction() const { return friction_; }
  /// What friction asks for where the gap is `h` [m] and the contact presses with `p` [Pa], with
  /// oil of viscosity `eta` [Pa s] around the summits and the sliding speed `du` [m/s].
  [[nodiscard]] RubbingPlace place(double h, double p, double eta, double du) const {
    return {p, p > 0.0 ? friction_.contact_ratio((h - delta_) / sigma_) : 0.0, eta, du};
  }

 private:
  [[nodiscard]] ContactPressure elastic(double h) const;  ///< without the limit

  double sigma_, delta_, scale_;
  BoundaryFriction friction_;
  double hardness_;
  ContactIntegral integral_;
  double whole_surface_;  ///< H at which r_c = 1 [-]
  double flow_gap_;
};

}  // namespace shellback::solid
