/// Greenwood-Tripp: the integrals, and the contact pressure that the solver evaluates.
#include "solid/asperity_contact.hpp"

#include "validation/evaluators/evaluators.hpp"

namespace shellback::validation {
namespace {

using namespace solid;

/// A pair of surfaces with unit K E*: the KS rig's, whose values are of no effect on F(H).
ContactPressure contact_at(double H, ContactIntegral integral) {
  const AsperityContact contact({0.34e-6, 12.0, 0.28e-6, 0.39e-6}, {0.20e-6, 4.0, 0.13e-6, 0.21e-6},
                                {1.0, 1.0, 0.02, integral});
  return contact.at(contact.delta() + H * contact.sigma());
}

}  // namespace

Values asperity_contact_values(const Question& q) {
  const double H = q.number("H");
  Values values;
  values.value = {{"F_5/2", gt_integral(2.5, H)},
                  {"F_2", gt_integral(2.0, H)},
                  {"contact_pressure", contact_at(H, ContactIntegral::exact).p},
                  {"contact_pressure_power_law", contact_at(H, ContactIntegral::power_law).p}};
  return values;
}

}  // namespace shellback::validation
