#pragma once
/// The axis over which a load cycle is drawn.
#include "app/pictures/svg_axes.hpp"
#include "bearing/over_time/cycle.hpp"

namespace shellback::app {

/// The crank angle [deg], or the time [ms], of long events [s].
[[nodiscard]] Axis cycle_axis(const bearing::CycleResult& cycle);

/// An instant on that axis.
[[nodiscard]] double on_axis(const bearing::CycleResult& cycle, double t);

}  // namespace shellback::app
