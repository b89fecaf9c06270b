#pragma once
/// Curves over phi that compare the results, at mid-width or beside a groove all round there.
#include <optional>

#include "app/pictures/svg_lines.hpp"
#include "bearing/result.hpp"

namespace shellback::app {

enum class Profile { pressure, gap, film_temperature, shell_temperature };

/// A tier keeps its colour whatever else is shown.
[[nodiscard]] const std::string& tier_colour(bearing::Tier tier, const Theme& theme);

/// One curve per result that has the field, in the colour of its tier; shell temperature has
/// two: surface solid, back dashed. None if no result has it.
[[nodiscard]] std::optional<LinePlot> profile_plot(const bearing::Comparison& comparison,
                                                   Profile which, const Theme& theme);

}  // namespace shellback::app
