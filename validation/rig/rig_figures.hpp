#pragma once
/// The figures of the study's page, as inline SVG.
#include <string>

#include "validation/rig/rig_study.hpp"

namespace shellback::validation {

/// Figures 5 to 7: torque of the rig over speed with each oil, and with temperature solved.
[[nodiscard]] std::string torque_figures(const RigStudy& study);
/// Run-up and run-down over time and over speed.
[[nodiscard]] std::string course_figures(const RigStudy& study);
/// Peak pressure and shear rate of the test bearing over speed.
[[nodiscard]] std::string film_figures(const RigStudy& study);
/// Figure 15: start and stop.
[[nodiscard]] std::string start_figures(const RigStudy& study);

}  // namespace shellback::validation
