#pragma once
/// The parts of a random bearing: oil, supplies, surfaces, solids.
#include <vector>

#include "coupling/case.hpp"
#include "proof/draw.hpp"

namespace shellback::proof {

/// One of several kinds of oil; `T_supply` is set to a temperature at which it is used [K].
[[nodiscard]] rheology::Oil draw_oil(Draw& d, double& T_supply);

/// One or two holes or axial grooves, mostly in the unloaded part, or one circumferential groove.
[[nodiscard]] std::vector<coupling::Supply> draw_supplies(Draw& d, const coupling::Bearing& b,
                                                          double load_angle, double T_supply);

/// Two rough surfaces, mostly with contact.
[[nodiscard]] coupling::Surfaces draw_surfaces(Draw& d, const coupling::Bearing& b);

[[nodiscard]] coupling::Shell draw_shell(Draw& d, const coupling::Bearing& b, double T_supply);
[[nodiscard]] coupling::Shaft draw_shaft(Draw& d, const coupling::Bearing& b, double T_supply);

/// The temperature at which the clearance is that given: 20 degC where the materials leave most of
/// it when the bearing is as warm as its supply, else that of the supply.
void draw_fit(Draw& d, coupling::Case& c, double T_supply);

}  // namespace shellback::proof
