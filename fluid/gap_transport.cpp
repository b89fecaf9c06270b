#include "fluid/gap_transport.hpp"

namespace shellback::fluid {

void gap_transport(const RoughPair& pair, const std::vector<double>& h, GapTransport& out) {
  for (auto* v : {&out.average_gap, &out.h3_x, &out.h3_z, &out.sigma_phi_s, &out.daverage_gap,
                  &out.dh3_x, &out.dh3_z, &out.dsigma_phi_s}) {
    v->resize(h.size());
  }
  gap_flow(pair, h,
           {out.average_gap, out.h3_x, out.h3_z, out.sigma_phi_s, out.daverage_gap, out.dh3_x,
            out.dh3_z, out.dsigma_phi_s});
}

}  // namespace shellback::fluid
