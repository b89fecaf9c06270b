#pragma once
/// Flow factors of rough surfaces after Patir and Cheng, for a moving journal in a shell at rest.
///
/// Averaged flux per width [m2/s] and shear stress [Pa], H = h/sigma, U journal speed:
///   q_x = -phi_x h^3/(12 eta) dp/dx + U/2 (hT + sigma phi_s)              seed 000 Eq. 1
///   q_z = -phi_z h^3/(12 eta) dp/dz
///   tau_journal = eta U/h (phi_f - phi_fs) + phi_fp h/2 dp/dx             seed 000 Eq. 4
///   tau_shell   = eta U/h (phi_f + phi_fs) - phi_fp h/2 dp/dx
/// tau is eta du/dy at the surface: it brakes the journal and drags the shell along.
///
///   hT     = h/2 (1 + erf(h/(sigma sqrt2))) + sigma/sqrt(2 pi) exp(-h^2/(2 sigma^2)), mean gap
///   phi_x, phi_z(H, gamma) = phi_x(H, 1/gamma), phi_fp, Phi_s, Phi_fs: patir_cheng.hpp
///   phi_s  = (sj/sigma)^2 Phi_s(H, gamma_j)  - (ss/sigma)^2 Phi_s(H, gamma_s)
///   phi_fs = (sj/sigma)^2 Phi_fs(H, gamma_j) - (ss/sigma)^2 Phi_fs(H, gamma_s)
///   phi_f  = h E[1/(h + d)], d distributed as (35/96)(1 - (d/3 sigma)^2)^3/sigma within 3 sigma,
///            gaps below sigma/100 left out: closed form of Patir and Cheng
/// with j the journal, s the shell, sigma^2 = sj^2 + ss^2.
///
/// Signs. A rough moving journal carries oil in its valleys: it ADDS transport, phi_s > 0; a
/// rough shell at rest holds oil back, phi_s < 0. The rough surface feels the smaller shear
/// stress (seed 001, text after Eq. 1), hence minus phi_fs on the journal with the same weights
/// as in phi_s; it carries the rest as pressure on the flanks of its asperities. In seed 000
/// Eq. 4, with (u1 - u2) = -U, that is surface 1 = shell (+), 2 = journal (-).
///
/// Momentum and energy. With its flanks a rough journal is braked, and the shell dragged, by
///   F_journal = eta U/h phi_total + (hT + sigma phi_s)/2 dp/dx
///   F_shell   = eta U/h phi_total - (hT - sigma phi_s)/2 dp/dx
///   phi_total = phi_f + (sj/sigma)^2 Phi_fs(gamma_j) + (ss/sigma)^2 Phi_fs(gamma_s)
/// so that F_journal - F_shell = hT dp/dx (momentum of the film), and the coefficient of dp/dx in
/// F_journal is that of U in the flux, as Onsager's reciprocity asks. For one rough surface it
/// says phi_fp h = hT - sigma |phi_s|, which the tabulated laws fulfil to their accuracy. U
/// F_journal is the power put into the film; U tau_journal leaves the flanks out. Moment and
/// energy audits of rough surfaces close with F, not with tau.
///
/// A choice: phi_x, phi_z, phi_fp of two rough surfaces take one gamma, the mean of ln gamma
/// weighted with sj^2 and ss^2 (Patir and Cheng give it for equal gammas only).
///
/// Below the fits (H < 0.5, for phi_x and phi_fp up to H < 1 if gamma < 1/3), also for h <= 0,
/// nominal interpenetration, the laws are continued; nothing is published there:
///   phi h^3      value and slope continued by an exponential to a floor of 1e-6 of its value at
///                the end of the fit, so that the film equation stays regular in closed contact
///   sigma phi_s  its ratio to hT continued in value and slope to a constant below 1: the
///                transport vanishes with the gap and never turns round
///   Phi_fs       the law itself, which vanishes at H = 0; 0 for H < 0
///   phi_fp       the law itself as long as it is positive, else 0
/// Above H = 7 Phi_fs decays as Phi_s does (exp(-H/4)); the papers set it to zero, a jump of at
/// most 0.023. Smooth limit H -> inf: phi_x, phi_z, phi_f, phi_fp -> 1, phi_s, phi_fs -> 0.
///
/// A smooth pair (sigma = 0) has exactly 1 and 0, hT = h; for h <= 0 its gap is closed: hT and
/// phi h^3 are 0, which a film equation cannot take, and gap_shear (1/h) is not defined.
///
/// A pair with a measured table (fluid/measured_factors.hpp) takes all factors from there.
#include <optional>
#include <span>

#include "fluid/gap_factors.hpp"
#include "fluid/measured_factors.hpp"

namespace shellback::fluid {

/// Roughness of one surface, as plain numbers.
struct SurfaceTexture {
  double roughness = 0.0;    ///< standard deviation of heights Rq [m]
  double orientation = 1.0;  ///< Peklenik gamma, > 1 along the sliding direction [-]
};

/// phi h^3 in one direction.
struct PressureFlowLaw {
  double C_exp = 0.0, r = 1.0, C_pow = 0.0;  ///< 1 - C_exp exp(-r H) + C_pow H^-1.5
  double H_low = 0.0;                        ///< below: the continuation [-]
  double at_low = 0.0;                       ///< H^3 phi at H_low [-]
  double rate_low = 0.0;                     ///< exponent of the continuation [-]
};

/// Part of one surface in phi_s and phi_fs.
struct ShearFlowLaw {
  double share = 0.0;                                             ///< (s_i/sigma)^2 [-]
  double ln_A1 = 0.0, a1 = 0.0, a2 = 0.0, a3 = 0.0, ln_A2 = 0.0;  ///< Phi_s
  double ratio_low = 0.0, slope_low = 0.0;           ///< Phi_s sigma/hT at H = 0.5, slope by H [-]
  double ln_A3 = 0.0, a4 = 1.0, a5 = 0.0, a6 = 0.0;  ///< Phi_fs
};

/// Two surfaces, ready for evaluation at many gaps. Default: smooth.
struct RoughPair {
  double sigma = 0.0;  ///< combined standard deviation of heights [m]
  double gamma = 1.0;  ///< combined orientation of phi_x, phi_z, phi_fp [-]
  PressureFlowLaw x, z;
  ShearFlowLaw journal, shell;
  double D = 0.0, s = 1.0;    ///< phi_fp
  bool beyond_table = false;  ///< an orientation lies outside [1/9, 9]: its end row is used; warn
  std::optional<MeasuredFactors> measured{};  ///< instead of the laws of Patir and Cheng
};

/// Throws InputError if a roughness is negative or the orientation of a rough surface is not
/// positive. `measured`: a sound table whose factors take the place of the laws, or none.
[[nodiscard]] RoughPair rough_pair(const SurfaceTexture& shell, const SurfaceTexture& journal,
                                   const FactorTable* measured = nullptr);

[[nodiscard]] GapFlow gap_flow(const RoughPair& pair, double h);

/// The same for many gaps: spans as long as h, not overlapping.
struct GapFlowSpans {
  std::span<double> average_gap, h3_x, h3_z, sigma_phi_s;
  std::span<double> daverage_gap, dh3_x, dh3_z, dsigma_phi_s;
};
void gap_flow(const RoughPair& pair, std::span<const double> h, const GapFlowSpans& out);

[[nodiscard]] GapShear gap_shear(const RoughPair& pair, double h);

struct GapShearSpans {
  std::span<double> phi_f_over_h, phi_fs_over_h, phi_total_over_h, h_phi_fp;
};
void gap_shear(const RoughPair& pair, std::span<const double> h, const GapShearSpans& out);

/// The factors as printed. phi_x, phi_z and their slopes are quotients by h^3: only for h > 0.
struct FlowFactors {
  double phi_x, phi_z;           ///< [-]
  double sigma_phi_s;            ///< [m]
  double phi_f, phi_fs, phi_fp;  ///< [-]
  double dphi_x, dphi_z;         ///< d phi / d h [1/m]
  double dsigma_phi_s;           ///< d(sigma phi_s)/d h [-]
};
[[nodiscard]] FlowFactors flow_factors(const RoughPair& pair, double h);

}  // namespace shellback::fluid
