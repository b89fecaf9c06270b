#pragma once
/// Flow factors of a measured surface, interpolated in a table over H = h/sigma.
///
/// The table (FactorTable) holds the factors of ONE rough surface against a smooth one, in the
/// sense and with the signs of fluid/flow_factors.hpp (Phi_s, Phi_fs >= 0). What the film needs is
/// interpolated so that it cannot lose its sign (monotone cubics, core/monotone_cubic.hpp):
///
///   phi_x h^3, phi_z h^3    ln(H^3 phi) over ln H: rises with the gap if the table does
///   hT                      hT/sigma over H
///   sigma Phi_s             Phi_s sigma/hT over H: below 1 everywhere if the table is
///   phi_f/h, Phi_fs         ln(phi_f/H) over ln H; Phi_fs over H
///   h phi_fp                hT - sigma Phi_s (momentum, reciprocity), not a column: shear by
///                           pressure and flow by sliding are one number (flow_factors.hpp)
///
/// Two rough surfaces share the table: only the combined heights count for phi_x, phi_z, phi_f
/// (Patir and Cheng's premise), and phi_s = (sj^2 - ss^2)/sigma^2 Phi_s, likewise phi_fs:
/// exact if one of them is smooth, else the table's texture is taken for both.
///
/// Above the table second-order perturbation holds for every surface: phi - 1, Phi_s sigma/hT and
/// Phi_fs decay as H^-2 from the table's last row, hT - h with the rate of the last row; the
/// table's end slopes are those of this law (as far as it leaves the last piece monotone).
/// Below it nothing was computed; as below the fits of Patir and Cheng the film equation stays
/// regular:
///   phi h^3      continued in value and slope by an exponential to a floor of 1e-6 of its value
///   hT           continued in value and slope by an exponential that vanishes with the gap
///   sigma Phi_s  keeps its ratio to hT
///   phi_f/h, Phi_fs/h   in proportion to hT: the area that is still open
#include <string>
#include <vector>

#include "core/monotone_cubic.hpp"
#include "fluid/gap_factors.hpp"

namespace shellback::fluid {

/// Factors of one surface over the gap, as `shellback surface` writes them.
struct FactorTable {
  std::string name;                 ///< of the file, for messages
  double sigma = 0.0;               ///< standard deviation of the map's heights [m]
  std::vector<double> H;            ///< h/sigma, positive, rising [-]
  std::vector<double> average_gap;  ///< hT/sigma, rising [-]
  std::vector<double> phi_x;        ///< pressure flow along the motion, positive [-]
  std::vector<double> phi_z;        ///< across [-]
  std::vector<double> phi_s;        ///< shear flow, 0 <= phi_s < hT/sigma [-]
  std::vector<double> phi_f;        ///< sliding shear, positive [-]
  std::vector<double> phi_fs;       ///< roughness shear, not negative [-]
  std::vector<double> phi_fp;       ///< pressure shear, may be empty; only judged: fault_of [-]
};

/// Row and column of the first number that no surface can have, and why; empty if all is well.
/// phi_fp, where it is given, has to fulfil |H phi_fp - (hT/sigma - Phi_s)| <= 0.05 hT/sigma: the
/// fits of Patir and Cheng do to 0.03 h (tests of flow_factors), the factors of one map to 1e-7.
struct FactorFault {
  std::size_t row = 0;
  std::string column;
  std::string problem;
};
[[nodiscard]] FactorFault fault_of(const FactorTable& table);

/// The table, ready for evaluation at many gaps.
struct MeasuredFactors {
  MonotoneCubic ln_c_x, ln_c_z;  ///< ln(H^3 phi) over ln H
  MonotoneCubic average_gap;     ///< hT/sigma over H
  MonotoneCubic carried;         ///< Phi_s sigma/hT over H
  MonotoneCubic ln_f;            ///< ln(phi_f/H) over ln H
  MonotoneCubic phi_fs;          ///< over H
  double H_low = 0.0, H_high = 0.0;
  double sigma = 0.0;        ///< combined standard deviation of heights of the pair [m]
  double shear_share = 0.0;  ///< (sj^2 - ss^2)/sigma^2 [-]
};

/// `table` is sound (fault_of); roughness of the two surfaces [m], not both zero.
[[nodiscard]] MeasuredFactors measured_factors(const FactorTable& table, double shell,
                                               double journal);

[[nodiscard]] GapFlow gap_flow(const MeasuredFactors& factors, double h);
[[nodiscard]] GapShear gap_shear(const MeasuredFactors& factors, double h);

}  // namespace shellback::fluid
