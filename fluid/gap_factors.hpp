#pragma once
/// What flow and friction of rough surfaces need at one gap; by flow_factors.hpp from laws, by
/// measured_factors.hpp from a table.

namespace shellback::fluid {

/// What is left of phi h^3 in closed contact, of its value at the end of the fit or table. Small
/// enough not to carry a flow, large enough to keep the film equation regular in double precision
/// [-].
inline constexpr double kClosedFlow = 1e-6;

/// What the film equation needs at one gap; finite for every h.
struct GapFlow {
  double average_gap;                               ///< hT [m]
  double h3_x;                                      ///< phi_x h^3 [m3], positive
  double h3_z;                                      ///< phi_z h^3 [m3], positive
  double sigma_phi_s;                               ///< sigma phi_s [m], |sigma phi_s| < hT
  double daverage_gap, dh3_x, dh3_z, dsigma_phi_s;  ///< derivatives by h
};

/// What friction needs at one gap, in the combinations that stay finite for every h.
struct GapShear {
  double phi_f_over_h;      ///< phi_f/h [1/m], not negative; 0 where h < -3 sigma
  double phi_fs_over_h;     ///< phi_fs/h [1/m]
  double phi_total_over_h;  ///< phi_total/h [1/m]
  double h_phi_fp;          ///< h phi_fp [m], not negative
};

}  // namespace shellback::fluid
