#pragma once
/// Tier `estimate`: what closed forms and the table of the plain bearing say about a case.
///
/// Rigid circular bearing fed at ambient pressure at the widest gap (bearing_table.hpp), one
/// temperature from a heat balance in lumps (lumped_heat.hpp), one viscosity: that at this
/// temperature, the specific load and the mean shear rate U/(c sqrt(1 - eps^2)). Rough surfaces
/// share the load with the film by Greenwood-Tripp contact on the nominal film h = c (1 + eps cos);
/// regime by the contact's share of the load, or, without contact data, by lambda = h_min/sigma
/// (seed 002 Eq. 11). A groove all round makes two bearings of half the width. Tilt, profiles,
/// deformation, starvation and the supply's place are left out; the bars say how much that was
/// worth in random cases (estimate_result.cpp).
#include "bearing/result.hpp"

namespace shellback::fidelity {

enum class Regime { hydrodynamic, mixed, boundary };
[[nodiscard]] const char* to_string(Regime regime);

/// The estimated state. SI units.
struct Estimate {
  double T = 0.0;           ///< mean film temperature [K]
  double eta = 0.0;         ///< viscosity there, at mean pressure and shear rate [Pa s]
  double eps = 0.0;         ///< eccentricity ratio [-]
  double attitude = 0.0;    ///< from the load line to the line of centres [rad]
  double load = 0.0;        ///< [N]
  double load_angle = 0.0;  ///< [rad]
  double h_min = 0.0;       ///< [m]
  double p_max = 0.0;       ///< [Pa]
  double torque = 0.0;      ///< on the journal, asperities included, opposing positive motion [N m]
  double torque_asperity = 0.0;  ///< [N m]
  double side_flow = 0.0;        ///< [m3/s]
  double asperity_share = 0.0;   ///< of the load [-]; 0 without contact data
  double lambda = 0.0;           ///< h_min over combined roughness [-]; infinite: smooth
  double rise = 0.0;             ///< T minus supply temperature [K]
  Regime regime = Regime::hydrodynamic;
  bool balanced = true;  ///< false: no temperature below 400 K of rise balances the heat
};

[[nodiscard]] Estimate estimate(const bearing::Case& c);

/// The estimate as a result: quantities with bars, effects by their indicator numbers, no fields.
[[nodiscard]] bearing::Result estimate_result(const bearing::Case& c);

}  // namespace shellback::fidelity
