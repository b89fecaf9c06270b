// Written so that the loops vectorise (also exp, log and erfc, if compiled with -ffast-math):
// every branch is a selection between values that are both finite.
#include "fluid/flow_factors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "fluid/patir_cheng.hpp"

namespace shellback::fluid {
namespace {

/// Distance in H over which the ratio sigma Phi_s/hT settles below the fit; half the fit's lower
/// limit, for which the ratio stays between 0 and 1 in every row of the table [-].
constexpr double kSettle = 0.25;
/// Gap below which phi_f counts no film, sigma/100 (Patir and Cheng), in units of 3 sigma [-].
constexpr double kCutOff = 1.0 / 300.0;
/// Keeps logarithms and quotients finite where H <= 0; selections discard what comes of it [-].
constexpr double kTiny = 1e-30;
/// Of what counts beside a gap of one roughness: exp(-700) is 1e-304 [-].
constexpr double kLeastExponent = -700.0;
constexpr double kWidest = 37.0;  ///< its root of 2 times that, and a little less [-]

/// A function of H and its derivative by H.
struct Slope {
  double f;
  double d;
};

[[gnu::always_inline]] inline double select(bool condition, double yes, double no) {
  return condition ? yes : no;
}

/// An exponential that underflows, as in the depth of a supply, leaves the loop's lanes.
[[gnu::always_inline]] inline double decaying(double exponent) {
  return std::exp(std::max(exponent, kLeastExponent));
}

/// hT/sigma. Both terms cancel for H < 0 by a factor H^2; below H = -38 they underflow, which
/// may leave the last denormal negative. Bounded by H: compilers take a bound of the exponent out
/// of the exponential.
[[gnu::always_inline]] inline Slope mean_gap(double H) {
  const double open = 0.5 * std::erfc(-H * 0.70710678118654752440);  // share of open area, 1/sqrt2
  const double near = std::min(std::abs(H), kWidest);
  const double density = 0.39894228040143267794 * std::exp(-0.5 * near * near);  // 1/sqrt(2 pi)
  return {std::max(H * open + density, 0.0), open};
}

/// phi_x above the lower end of its fit.
[[gnu::always_inline]] inline Slope pressure_factor(const PressureFlowLaw& law, double H,
                                                    double decay) {
  const double power = law.C_pow / (H * std::sqrt(H));
  return {1.0 - law.C_exp * decay + power, law.r * law.C_exp * decay - 1.5 * power / H};
}

/// phi h^3/sigma^3.
[[gnu::always_inline]] inline Slope conductance(const PressureFlowLaw& law, double H) {
  const bool fitted = H >= law.H_low;
  const double Hc = std::max(H, law.H_low);
  const double e = decaying(select(fitted, -law.r * H, law.rate_low * (H - law.H_low)));
  const Slope phi = pressure_factor(law, Hc, e);
  const double above = Hc * Hc * Hc * phi.f;
  const double d_above = Hc * Hc * (3.0 * phi.f + Hc * phi.d);
  const double below = law.at_low * (kClosedFlow + (1.0 - kClosedFlow) * e);
  const double d_below = law.at_low * (1.0 - kClosedFlow) * law.rate_low * e;
  return {select(fitted, above, below), select(fitted, d_above, d_below)};
}

/// Phi_s inside its fit, H >= 0.5.
[[gnu::always_inline]] inline Slope shear_factor(const ShearFlowLaw& law, double H, double ln_H) {
  const bool near = H <= kShearBranch;
  const double exponent = select(near, law.ln_A1 + law.a1 * ln_H + H * (law.a3 * H - law.a2),
                                 law.ln_A2 - kShearDecay * H);
  const double rate = select(near, law.a1 / H - law.a2 + 2.0 * law.a3 * H, -kShearDecay);
  const double f = decaying(exponent);
  return {f, f * rate};
}

/// Phi_s of one surface times its share; `settle` = exp((H - 0.5)/kSettle) below the fit.
[[gnu::always_inline]] inline Slope transport(const ShearFlowLaw& law, double H, double Hc,
                                              double ln_Hc, double settle, const Slope& gap) {
  const Slope fit = shear_factor(law, Hc, ln_Hc);
  const double ratio = law.ratio_low + law.slope_low * kSettle * (settle - 1.0);
  const double below = ratio * gap.f;
  const double d_below = ratio * gap.d + law.slope_low * settle * gap.f;
  const bool fitted = H >= kShearLow;
  return {law.share * select(fitted, fit.f, below), law.share * select(fitted, fit.d, d_below)};
}

[[gnu::always_inline]] inline GapFlow rough_flow(const RoughPair& pair, double h) {
  const double sigma = pair.sigma;
  const double H = h / sigma, Hc = std::max(H, kShearLow), ln_Hc = std::log(Hc);
  const Slope gap = mean_gap(H);
  const Slope x = conductance(pair.x, H), z = conductance(pair.z, H);
  const double settle = std::exp(std::min(H - kShearLow, 0.0) / kSettle);
  const Slope j = transport(pair.journal, H, Hc, ln_Hc, settle, gap);
  const Slope s = transport(pair.shell, H, Hc, ln_Hc, settle, gap);
  const double area = sigma * sigma, volume = area * sigma;
  return {sigma * gap.f, volume * x.f, volume * z.f, sigma * (j.f - s.f),
          gap.d,         area * x.d,   area * z.d,   j.d - s.d};
}

[[gnu::always_inline]] inline GapFlow smooth_flow(double h) {
  const double open = std::max(h, 0.0), slope = h > 0.0 ? 1.0 : 0.0, square = open * open;
  return {open, square * open, square * open, 0.0, slope, 3.0 * square, 3.0 * square, 0.0};
}

/// E[1/(z + t)] (32/35) for z = h/(3 sigma), t distributed on [-1, 1] as (35/32)(1 - t^2)^3.
/// Beyond z = 3 the closed form cancels and the moments of t give it: (1/z) sum m_2k z^(-2k), with
/// m_(2k+2)/m_2k = (2k + 1)/(2k + 9); twelve terms leave 1e-13.
[[gnu::always_inline]] inline double inverse_gap(double z) {
  const double z1 = std::min(std::max(z, kCutOff - 1.0), 3.0), z2 = z1 * z1;
  const bool inside = z1 <= 1.0;  // the roughness bridges the nominal gap
  const double cube = (1.0 - z2) * (1.0 - z2) * (1.0 - z2);
  const double log =
      std::log(select(inside, (z1 + 1.0) / kCutOff, (z1 + 1.0) / std::max(z1 - 1.0, kTiny)));
  const double p_in =
      (-55.0 +
       z1 * (132.0 + z1 * (345.0 + z1 * (-160.0 + z1 * (-405.0 + z1 * (60.0 + 147.0 * z1)))))) /
      60.0;
  const double p_out = z1 / 15.0 * (66.0 + z2 * (30.0 * z2 - 80.0));
  const double near = cube * log + select(inside, p_in, p_out);
  const double zf = std::max(z, 3.0), q = 1.0 / (zf * zf);
  double sum = 1.0;
  for (int k = 11; k >= 0; --k) sum = 1.0 + q * sum * (2.0 * k + 1.0) / (2.0 * k + 9.0);
  const double far = 32.0 / 35.0 * sum / zf;
  return select(z > 3.0, far, select(z > kCutOff - 1.0, std::max(near, 0.0), 0.0));
}

/// Phi_fs/H of one surface times its share.
[[gnu::always_inline]] inline double stress_difference(const ShearFlowLaw& law, double H) {
  const double Hc = std::min(std::max(H, kTiny), kShearStressEnd);
  const double beyond = std::max(H - kShearStressEnd, 0.0);
  const double exponent =
      law.ln_A3 + law.a4 * std::log(Hc) + Hc * (law.a6 * Hc - law.a5) - kShearDecay * beyond;
  return law.share * select(H > 0.0, decaying(exponent) / std::max(H, kTiny), 0.0);
}

[[gnu::always_inline]] inline GapShear rough_shear(const RoughPair& pair, double h) {
  const double sigma = pair.sigma, H = h / sigma, open = std::max(H, 0.0);
  // phi_f/h = (35/32)/(3 sigma) times the integral.
  const double f = 35.0 / 96.0 * inverse_gap(H / 3.0) / sigma;
  const double j = stress_difference(pair.journal, H) / sigma;
  const double s = stress_difference(pair.shell, H) / sigma;
  const double fp = std::max(1.0 - pair.D * decaying(-pair.s * open), 0.0);
  return {f, j - s, f + j + s, sigma * open * fp};
}

[[gnu::always_inline]] inline GapShear smooth_shear(double h) {
  const double inverse = 1.0 / h;
  return {inverse, 0.0, inverse, h};
}

template <class Law>
void flow_loop(std::span<const double> h, const GapFlowSpans& out, const Law law) {
  const double* gap = h.data();
  double* hT = out.average_gap.data();
  double* x = out.h3_x.data();
  double* z = out.h3_z.data();
  double* s = out.sigma_phi_s.data();
  double* dhT = out.daverage_gap.data();
  double* dx = out.dh3_x.data();
  double* dz = out.dh3_z.data();
  double* ds = out.dsigma_phi_s.data();
  const std::size_t n = h.size();
#pragma GCC ivdep  // the spans do not overlap
  for (std::size_t i = 0; i < n; ++i) {
    const auto [average, h3_x, h3_z, shear, daverage, dh3_x, dh3_z, dshear] = law(gap[i]);
    hT[i] = average, x[i] = h3_x, z[i] = h3_z, s[i] = shear;
    dhT[i] = daverage, dx[i] = dh3_x, dz[i] = dh3_z, ds[i] = dshear;
  }
}

template <class Law>
void shear_loop(std::span<const double> h, const GapShearSpans& out, const Law law) {
  const double* gap = h.data();
  double* f = out.phi_f_over_h.data();
  double* fs = out.phi_fs_over_h.data();
  double* total = out.phi_total_over_h.data();
  double* fp = out.h_phi_fp.data();
  const std::size_t n = h.size();
#pragma GCC ivdep  // the spans do not overlap
  for (std::size_t i = 0; i < n; ++i) {
    const auto [phi_f, phi_fs, phi_total, phi_fp] = law(gap[i]);
    f[i] = phi_f, fs[i] = phi_fs, total[i] = phi_total, fp[i] = phi_fp;
  }
}

PressureFlowLaw pressure_flow_law(double gamma) {
  PressureFlowLaw law;
  law.C_exp = patir_cheng(&PatirChengRow::C_exp, gamma);
  law.r = patir_cheng(&PatirChengRow::r, gamma);
  law.C_pow = patir_cheng(&PatirChengRow::C_pow, gamma);
  law.H_low = patir_cheng(&PatirChengRow::H_low, gamma);
  const double H = law.H_low;
  const Slope phi = pressure_factor(law, H, std::exp(-law.r * H));
  law.at_low = H * H * H * phi.f;
  law.rate_low = (3.0 / H + phi.d / phi.f) / (1.0 - kClosedFlow);
  return law;
}

ShearFlowLaw shear_flow_law(double gamma, double share) {
  ShearFlowLaw law;
  law.share = share;
  law.ln_A1 = std::log(patir_cheng(&PatirChengRow::A1, gamma));
  law.a1 = patir_cheng(&PatirChengRow::a1, gamma);
  law.a2 = patir_cheng(&PatirChengRow::a2, gamma);
  law.a3 = patir_cheng(&PatirChengRow::a3, gamma);
  // A2 is what makes the branches meet (the printed A2 does to 0.1 %), also between the rows.
  law.ln_A2 = law.ln_A1 + law.a1 * std::log(kShearBranch) +
              kShearBranch * (law.a3 * kShearBranch - law.a2 + kShearDecay);
  law.ln_A3 = std::log(patir_cheng(&PatirChengRow::A3, gamma));
  law.a4 = patir_cheng(&PatirChengRow::a4, gamma);
  law.a5 = patir_cheng(&PatirChengRow::a5, gamma);
  law.a6 = patir_cheng(&PatirChengRow::a6, gamma);
  const Slope fit = shear_factor(law, kShearLow, std::log(kShearLow));
  const Slope gap = mean_gap(kShearLow);
  law.ratio_low = fit.f / gap.f;
  law.slope_low = (fit.d - law.ratio_low * gap.d) / gap.f;
  return law;
}

void judge(const SurfaceTexture& surface, const char* which) {
  if (!(surface.roughness >= 0.0)) {
    throw InputError(fmt::format("the roughness of the {} is {} m (must not be negative)", which,
                                 surface.roughness));
  }
  if (surface.roughness > 0.0 && !(surface.orientation > 0.0)) {
    throw InputError(
        fmt::format("the roughness orientation of the {} is {} (must be positive); "
                    "1 is isotropic",
                    which, surface.orientation));
  }
}

bool outside_table(const SurfaceTexture& surface) {
  return surface.roughness > 0.0 && (surface.orientation < kPatirCheng.front().gamma ||
                                     surface.orientation > kPatirCheng.back().gamma);
}

}  // namespace

RoughPair rough_pair(const SurfaceTexture& shell, const SurfaceTexture& journal,
                     const FactorTable* measured) {
  judge(shell, "shell");
  judge(journal, "shaft");
  RoughPair pair;
  pair.sigma = std::hypot(shell.roughness, journal.roughness);
  if (pair.sigma == 0.0) return pair;
  if (measured != nullptr) {
    pair.measured = measured_factors(*measured, shell.roughness, journal.roughness);
    return pair;
  }
  const auto share = [&](const SurfaceTexture& s) {
    return s.roughness * s.roughness / (pair.sigma * pair.sigma);
  };
  const auto weighted_log = [&](const SurfaceTexture& s) {
    return s.roughness > 0.0 ? share(s) * std::log(s.orientation) : 0.0;
  };
  pair.gamma = std::exp(weighted_log(shell) + weighted_log(journal));
  pair.x = pressure_flow_law(pair.gamma);
  pair.z = pressure_flow_law(1.0 / pair.gamma);
  pair.D = patir_cheng(&PatirChengRow::D, pair.gamma);
  pair.s = patir_cheng(&PatirChengRow::s, pair.gamma);
  pair.journal =
      shear_flow_law(journal.roughness > 0.0 ? journal.orientation : 1.0, share(journal));
  pair.shell = shear_flow_law(shell.roughness > 0.0 ? shell.orientation : 1.0, share(shell));
  pair.beyond_table = outside_table(shell) || outside_table(journal);
  return pair;
}

GapFlow gap_flow(const RoughPair& pair, double h) {
  if (pair.measured) return gap_flow(*pair.measured, h);
  return pair.sigma > 0.0 ? rough_flow(pair, h) : smooth_flow(h);
}

GapShear gap_shear(const RoughPair& pair, double h) {
  if (pair.measured) return gap_shear(*pair.measured, h);
  return pair.sigma > 0.0 ? rough_shear(pair, h) : smooth_shear(h);
}

void gap_flow(const RoughPair& pair, std::span<const double> h, const GapFlowSpans& out) {
  EXPECTS(out.average_gap.size() == h.size() && out.dsigma_phi_s.size() == h.size());
  if (pair.measured) {
    flow_loop(h, out, [&m = *pair.measured](double gap) { return gap_flow(m, gap); });
  } else if (pair.sigma > 0.0) {
    flow_loop(h, out, [pair](double gap) { return rough_flow(pair, gap); });
  } else {
    flow_loop(h, out, [](double gap) { return smooth_flow(gap); });
  }
}

void gap_shear(const RoughPair& pair, std::span<const double> h, const GapShearSpans& out) {
  EXPECTS(out.phi_f_over_h.size() == h.size() && out.h_phi_fp.size() == h.size());
  if (pair.measured) {
    shear_loop(h, out, [&m = *pair.measured](double gap) { return gap_shear(m, gap); });
  } else if (pair.sigma > 0.0) {
    shear_loop(h, out, [pair](double gap) { return rough_shear(pair, gap); });
  } else {
    shear_loop(h, out, [](double gap) { return smooth_shear(gap); });
  }
}

FlowFactors flow_factors(const RoughPair& pair, double h) {
  if (pair.sigma == 0.0) return {1.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  const GapFlow flow = gap_flow(pair, h);
  const GapShear shear = gap_shear(pair, h);
  const double volume = h * h * h;
  const double phi_x = flow.h3_x / volume, phi_z = flow.h3_z / volume;
  // phi_fp is that of the law; where h <= 0 there is no gap to shear.
  return {phi_x,
          phi_z,
          flow.sigma_phi_s,
          shear.phi_f_over_h * h,
          shear.phi_fs_over_h * h,
          h > 0.0 ? shear.h_phi_fp / h : 0.0,
          flow.dh3_x / volume - 3.0 * phi_x / h,
          flow.dh3_z / volume - 3.0 * phi_z / h,
          flow.dsigma_phi_s};
}

}  // namespace shellback::fluid
