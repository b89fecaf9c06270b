#pragma once
/// The pictures of a film: what of a Result goes into which map or curve, in which unit.
///
/// Functions that need a field expect it to be there; ask `has_field` first.
#include <vector>

#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg_lines.hpp"
#include "app/pictures/svg_map.hpp"
#include "bearing/result.hpp"

namespace shellback::app {

enum class FilmField { pressure, fill, gap, temperature, shell_temperature };

[[nodiscard]] bool has_field(const bearing::Result& result, FilmField which);

/// Common scale for `which` over `results`, so that colours compare. The depth of supply
/// features does not count for the gap.
[[nodiscard]] ColourScale common_scale(const std::vector<const bearing::Result*>& results,
                                       FilmField which);

/// Map on the unrolled bearing: supply features outlined, the edge of the full film dashed, the
/// place of the largest pressure and the smallest gap marked.
[[nodiscard]] FieldMap film_map(const bearing::Case& c, const bearing::Result& result,
                                FilmField which, const ColourScale& scale,
                                const std::string& title);

/// Where curves over phi are drawn: "at mid-width", or, of a groove all round there, "midway on a
/// land" and its z.
[[nodiscard]] std::string words_of_mid_line(const bearing::Result& result);

/// Temperature there over phi and y/h; needs `fields.T`.
[[nodiscard]] FieldMap across_film_map(const bearing::Result& result, const std::string& title);

/// Outline of a supply feature in (deg, mm), not wrapped into [0, 360].
[[nodiscard]] std::vector<Point> supply_outline(const bearing::Supply& supply, double radius);

/// Values there over phi [deg, rising], interpolated between the two nearest rows of cells. `show`
/// converts. The gap inside supply features is not-a-number if `hide_supplied`.
[[nodiscard]] Series mid_line(const bearing::Result& result, const Field& field,
                              const DisplayUnit& show, bool hide_supplied);

}  // namespace shellback::app
