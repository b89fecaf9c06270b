#pragma once
/// Coefficients of Patir and Cheng's flow factors and their interpolation between orientations.
///
///   phi_x  = 1 - C exp(-r H)        gamma <= 1,      1 + C H^-r    gamma > 1
///   Phi_s  = A1 H^a1 exp(-a2 H + a3 H^2)   H <= 5,   A2 exp(-0.25 H)    H > 5
///   phi_fp = 1 - D exp(-s H)
///   Phi_fs = A3 H^a4 exp(-a5 H + a6 H^2)
///
/// gamma is Peklenik's orientation of the roughness (length over width of the asperities along
/// the sliding direction: > 1 longitudinal, 1 isotropic, < 1 transverse), H = h/sigma.
///
/// Source: Patir and Cheng, J. Lubr. Technol. 100 (1978) 12-17 and 101 (1979) 220-230, as handed
/// down in validation/data/patir_cheng_coefficients.csv. Standing of the numbers: the rows
/// gamma = 1 of phi_x, phi_fp and Phi_fs were read in public code (rboman/progs), the others were
/// recalled [memory] and not read in the papers. They stand up to two checks that are independent
/// of memory (tests): the branches of Phi_s meet at H = 5 to 0.1 %, and phi_fp, which belongs to a
/// separate table, is the reciprocal of Phi_s (flow_factors.hpp) to 0.03 for H >= 1.5 in all rows.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/monotone_cubic.hpp"

namespace shellback::fluid {

/// One orientation. All phi_x laws share the form 1 - C_exp exp(-r H) + C_pow H^-1.5 (the tabulated
/// exponent is 1.5 in every row above gamma = 1), so that rows can be joined across gamma = 1.
struct PatirChengRow {
  double gamma;
  double C_exp, r, C_pow;  ///< phi_x
  double H_low;            ///< lower end of the fits of phi_x and phi_fp
  double A1, a1, a2, a3;   ///< Phi_s up to H = 5
  double D, s;             ///< phi_fp
  double A3, a4, a5, a6;   ///< Phi_fs
};

inline constexpr double kShearBranch = 5.0;     ///< H where Phi_s changes branch [-]
inline constexpr double kShearDecay = 0.25;     ///< decay of Phi_s beyond [-]
inline constexpr double kShearLow = 0.5;        ///< lower end of the fits of Phi_s, Phi_fs [-]
inline constexpr double kShearStressEnd = 7.0;  ///< upper end of the fit of Phi_fs [-]

/// Where C_exp (above gamma = 1) or C_pow (below) vanishes, r is that of the neighbour.
inline constexpr std::array<PatirChengRow, 7> kPatirCheng{{
    {1.0 / 9.0, 1.48, 0.42, 0.0, 1.0, 2.046, 1.12, 0.78, 0.03, 1.51, 0.52, 14.1, 2.45, 2.30, 0.10},
    {1.0 / 6.0, 1.38, 0.42, 0.0, 1.0, 1.962, 1.08, 0.77, 0.03, 1.51, 0.54, 13.4, 2.42, 2.30, 0.10},
    {1.0 / 3.0, 1.18, 0.42, 0.0, 0.75, 1.858, 1.01, 0.76, 0.03, 1.47, 0.58, 12.3, 2.32, 2.30, 0.10},
    {1.0, 0.90, 0.56, 0.0, 0.5, 1.899, 0.98, 0.92, 0.05, 1.40, 0.66, 11.1, 2.31, 2.38, 0.11},
    {3.0, 0.0, 0.56, 0.225, 0.5, 1.560, 0.85, 1.13, 0.08, 0.98, 0.79, 9.8, 2.25, 2.80, 0.18},
    {6.0, 0.0, 0.56, 0.520, 0.5, 1.290, 0.62, 1.09, 0.08, 0.97, 0.91, 10.1, 2.25, 2.90, 0.18},
    {9.0, 0.0, 0.56, 0.870, 0.5, 1.011, 0.54, 1.07, 0.08, 0.73, 0.91, 8.7, 2.15, 2.97, 0.18},
}};

/// One coefficient at orientation `gamma`: monotone piecewise cubic (monotone_cubic.hpp) in ln
/// gamma through the seven rows, hence smooth, exact at the rows and without overshoot. Outside
/// [1/9, 9] the end row holds: the laws are not known there (1 + C H^-1.5 with C extrapolated would
/// exceed the exact longitudinal limit 1 + 3 H^-2); RoughPair::beyond_table reports it.
[[nodiscard]] inline double patir_cheng(double PatirChengRow::*coefficient, double gamma) {
  std::vector<double> ln_gamma, values;
  for (const PatirChengRow& row : kPatirCheng) {
    ln_gamma.push_back(std::log(row.gamma));
    values.push_back(row.*coefficient);
  }
  const double at = std::clamp(std::log(gamma), ln_gamma.front(), ln_gamma.back());
  return MonotoneCubic(std::move(ln_gamma), std::move(values)).at(at).value;
}

}  // namespace shellback::fluid
