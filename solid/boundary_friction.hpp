#pragma once
/// Friction of asperities in contact: the one place at which contact pressure becomes shear stress.
///
///   mu_a = mu_abrasive + mu_adhesive,0 D + c r_c L_N (1 - D),   D = a^(-sqrt(b L_N))      (1)
///   L_N = eta |du| / (p_a L_s)                                                             (2)
///   L_s = 1 / (eta_d beta sqrt(Theta))                                                     (3)
///   tau_a = mu_a p_a tanh(du/v)                                                            (4)
///
/// p_a [Pa] contact pressure, eta [Pa s] viscosity of the oil around the summits, du [m/s] sliding
/// speed with its sign, r_c real over nominal area of contact. tau_a > 0 brakes a motion du > 0;
/// it is odd in du with a continuous slope. At rest mu_a is mu_abrasive + mu_adhesive,0.
/// A constant coefficient is (1) with mu_abrasive alone.
///
/// Summit density eta_d and radius beta are tied by the contact's own elastic factor
///   K = 16 sqrt2 pi/15 (eta_d beta sigma)^2 sqrt(sigma/beta)                               (5)
/// so that beta alone is asked for. Real contact area (textbook: Greenwood and Tripp):
///   r_c = pi^2 (eta_d beta sigma)^2 F_2(H),  F_2(H) = ((1 + H^2) erfc(H/sqrt2) - H sqrt(2/pi)
///         exp(-H^2/2)) / 2                                                                 (6)
///
/// tanh(du/v): summits in contact give way by about a micrometre before they slide (Rabinowicz,
/// textbook); v is the speed that a shaft has after so little under the accelerations at which
/// bearings start (0.2 m/s2 and seconds to full speed: 0.6 mm/s). From 20 v on it is 1.
///
/// Validity: a, b, c belong to one pair of surfaces and one oil and are found by experiment; no
/// published values (seed 001, 3.1). Only (ln a)^2 b acts, so that a is a choice. (6) as in
/// solid/asperity_contact.hpp: small against 1. Sources: (1)-(3) seed 001 Eq. 3-5; (4) its Eq. 2.
#include "solid/surface.hpp"

namespace shellback::solid {

/// Three parts of a boundary friction coefficient [-] or of a shear stress [Pa].
struct FrictionParts {
  double abrasive = 0.0;
  double adhesive = 0.0;
  double micro_hydrodynamic = 0.0;
  [[nodiscard]] double sum() const { return abrasive + adhesive + micro_hydrodynamic; }
};

/// One place of the contact, as (1)-(4) see it.
struct RubbingPlace {
  double p = 0.0;    ///< p_a [Pa], not negative
  double r_c = 0.0;  ///< [-]
  double eta = 0.0;  ///< [Pa s]
  double du = 0.0;   ///< [m/s]
};

/// eta_d beta sigma of (5) [-]; K, sigma and beta positive.
[[nodiscard]] double summit_product(double elastic_factor, double sigma, double summit_radius);

/// F_2 of (6) [-]; relative error below 1e-11 for H <= 10.
[[nodiscard]] double contact_area_integral(double H);

/// The law of one pair of surfaces.
class BoundaryFriction {
 public:
  static constexpr double kMicroSlip = 1e-3;  ///< v [m/s]
  /// Speed from which on summits slide: tanh is then 0.995 [m/s].
  static constexpr double kSliding = 3.0 * kMicroSlip;

  /// `sigma`: combined summit deviation [m]. Throws InputError if a law is given and its summit
  /// radius or its reference length is not positive, or a is not above 1.
  BoundaryFriction(const ContactParameters& parameters, double sigma);

  /// (1) of surfaces that slide; p_a = 0: D = 0 and the part that would have no bound is zero.
  [[nodiscard]] FrictionParts coefficient(const RubbingPlace& at) const;
  /// (4) in its parts [Pa]; zero where p_a is.
  [[nodiscard]] FrictionParts stress(const RubbingPlace& at) const;
  /// (4) over p_a [-]; where that is zero, its abrasive part.
  [[nodiscard]] double per_pressure(const RubbingPlace& at) const;
  /// (1) at rest [-].
  [[nodiscard]] double at_rest() const { return law_.abrasive + law_.adhesive; }
  /// r_c of (6) at H, no more than the whole surface; zero if (1) does not ask for it.
  [[nodiscard]] double contact_ratio(double H) const;
  /// True if (1) depends on L_N: the case has a law, and not a constant.
  [[nodiscard]] bool varies() const { return law_.adhesive > 0.0 || law_.c > 0.0; }
  [[nodiscard]] double L_s() const { return L_s_; }  ///< (3) [m]; 0: constant coefficient
  /// eta_d beta sigma of (5) [-]; 0: constant coefficient.
  [[nodiscard]] double summits() const { return summits_; }

 private:
  GenericFriction law_;
  double decay_ = 0.0;    ///< ln a sqrt(b) [-]
  double summits_ = 0.0;  ///< eta_d beta sigma [-]
  double L_s_ = 0.0;      ///< [m]
};

}  // namespace shellback::solid
