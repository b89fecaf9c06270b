/// Patir-Cheng factors of one rough surface against a smooth one.
#include "fluid/flow_factors.hpp"

#include "validation/evaluators/evaluators.hpp"

namespace shellback::validation {

Values flow_factor_values(const Question& q) {
  constexpr double kSigma = 0.4e-6;  // the factors depend on H = h/sigma only [m]
  const double gamma = q.number("gamma");
  const double h = q.number("H") * kSigma;
  // The rough surface moves: then phi_s and phi_fs are Phi_s and Phi_fs themselves.
  const fluid::FlowFactors f =
      fluid::flow_factors(fluid::rough_pair({0.0, 1.0}, {kSigma, gamma}), h);
  Values values;
  values.value = {{"phi_x", f.phi_x}, {"phi_z", f.phi_z},   {"phi_s", f.sigma_phi_s / kSigma},
                  {"phi_f", f.phi_f}, {"phi_fs", f.phi_fs}, {"phi_fp", f.phi_fp}};
  return values;
}

}  // namespace shellback::validation
