#pragma once
/// The record of honest bars as table, JSON and picture.
#include <iosfwd>
#include <string>

#include "validation/honesty/honesty_record.hpp"

namespace shellback::validation {

/// What could not be judged, coverage per grid, tier, set and quantity (the poorest first) with the
/// intervals of the shares, and the refusals by name.
void write_honesty_table(std::ostream& out, const HonestyRecord& record);

/// Coverage, how each case ended, all samples and refusals.
[[nodiscard]] std::string honesty_json(const HonestyRecord& record);

/// How long bars are over true errors, by tier: grid bars against the finer grid and against the
/// limit of fine grids, sums against the full physics. A complete SVG file.
[[nodiscard]] std::string honesty_svg(const HonestyRecord& record);

}  // namespace shellback::validation
