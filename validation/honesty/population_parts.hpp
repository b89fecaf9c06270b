#pragma once
/// The parts of a random bearing: oil, supplies, surfaces, solids.
#include <vector>

#include "bearing/case.hpp"
#include "validation/draw.hpp"

namespace shellback::validation {

/// One of several kinds of oil; `T_supply` is set to a temperature at which it is used [K].
[[nodiscard]] rheology::Oil draw_oil(Draw& d, double& T_supply);

/// One or two holes or axial grooves, mostly in the unloaded part, or one circumferential groove.
[[nodiscard]] std::vector<bearing::Supply> draw_supplies(Draw& d, const bearing::Bearing& b,
                                                         double load_angle, double T_supply);

/// Two rough surfaces, mostly with contact.
[[nodiscard]] bearing::Surfaces draw_surfaces(Draw& d, const bearing::Bearing& b);

[[nodiscard]] bearing::Shell draw_shell(Draw& d, const bearing::Bearing& b, double T_supply);
[[nodiscard]] bearing::Shaft draw_shaft(Draw& d, const bearing::Bearing& b, double T_supply);

/// The temperature at which the clearance is that given: 20 degC where the materials leave most of
/// it when the bearing is as warm as its supply, else that of the supply.
void draw_fit(Draw& d, bearing::Case& c, double T_supply);

}  // namespace shellback::validation
