#pragma once
/// The record of honest bars as table, JSON and picture.
#include <iosfwd>
#include <string>

#include "proof/honesty.hpp"

namespace shellback::proof {

/// Coverage per grid, tier and quantity, and the refusals by name.
void write_honesty_table(std::ostream& out, const HonestyRecord& record);

/// All samples and refusals.
[[nodiscard]] std::string honesty_json(const HonestyRecord& record);

/// Bar over true error, one point a bar, both in parts of the quantity's natural size; grid bars
/// left, total bars right. Points above the diagonal hold the truth. A complete SVG file.
[[nodiscard]] std::string honesty_svg(const HonestyRecord& record);

}  // namespace shellback::proof
