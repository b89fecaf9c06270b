#pragma once
/// All gap-dependent factors of the film fluxes for many gaps at once.
///
/// Smooth surfaces: average_gap = h, h3_x = h3_z = h^3 (h > 0), sigma_phi_s = 0. Rough surfaces:
/// the average gap and the Patir-Cheng factors of flow_factors.hpp, finite for any nominal h.
#include <vector>

#include "fluid/flow_factors.hpp"

namespace shellback::fluid {

struct GapTransport {
  std::vector<double> average_gap;                               ///< hT [m]
  std::vector<double> h3_x;                                      ///< phi_x h^3 [m3]
  std::vector<double> h3_z;                                      ///< phi_z h^3 [m3]
  std::vector<double> sigma_phi_s;                               ///< [m]
  std::vector<double> daverage_gap, dh3_x, dh3_z, dsigma_phi_s;  ///< derivatives by h
};

void gap_transport(const RoughPair& pair, const std::vector<double>& h, GapTransport& out);

}  // namespace shellback::fluid
