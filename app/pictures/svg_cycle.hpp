#pragma once
/// The pictures of a load cycle: curves over the crank angle (or time), maps of its largest values,
/// and all of it on one sheet.
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/cycle_axis.hpp"
#include "app/pictures/svg_lines.hpp"
#include "app/pictures/svg_map.hpp"
#include "bearing/over_time/cycle.hpp"

namespace shellback::app {

enum class CycleCurve { film, pressure, torque, load, speed, temperature, heat };
enum class CycleMap { pressure, contact, gap, friction, shell, shell_heat };

/// One curve, or a quantity and what is part of it.
[[nodiscard]] LinePlot cycle_plot(const bearing::CycleResult& cycle, CycleCurve which,
                                  const Theme& theme);

/// All curves that the tier knows, in two columns within `box`.
[[nodiscard]] double height_of_cycle_curves(const bearing::CycleResult& cycle);  ///< wanted [px]
void draw_cycle_curves(Svg& svg, const Box& box, const bearing::CycleResult& cycle,
                       const Theme& theme);

/// Largest pressure, largest contact pressure, smallest gap, mean friction power, mean temperature
/// of the shell and mean heat into it of each place on the unrolled bearing; none if the cycle does
/// not have it (or has no contact).
[[nodiscard]] std::optional<FieldMap> cycle_map(const bearing::Case& c,
                                                const bearing::CycleResult& cycle, CycleMap which);

/// The sheet (1240 px wide, white): orbit, curves, maps. A cycle that did not converge says so.
[[nodiscard]] std::string cycle_svg(const bearing::Case& c, const bearing::CycleResult& cycle);

}  // namespace shellback::app
