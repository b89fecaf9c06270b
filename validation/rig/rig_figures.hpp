#pragma once
/// The figures of the study's page, as inline SVG.
#include <string>
#include <vector>

#include "validation/rig/rig_study.hpp"

namespace shellback::validation {

/// A picture with the words below it.
struct RigFigure {
  std::string svg;
  std::string caption;
};

/// Figures 5 to 7: torque of the rig over speed with each oil, and with temperature solved.
[[nodiscard]] std::vector<RigFigure> torque_figures(const RigStudy& study);
/// Run-up and run-down over time and over speed.
[[nodiscard]] std::vector<RigFigure> course_figures(const RigStudy& study);
/// Peak pressure and shear rate of the test bearing over speed.
[[nodiscard]] std::vector<RigFigure> film_figures(const RigStudy& study);
/// Figure 15: start and stop.
[[nodiscard]] std::vector<RigFigure> start_figures(const RigStudy& study);

}  // namespace shellback::validation
