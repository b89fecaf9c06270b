#pragma once
/// Pictures of a ledger entry: our curve, their points, the band of unknown inputs, the difference.
#include <string>
#include <vector>

#include "validation/ledger/ledger_report.hpp"

namespace shellback::validation {

/// One inline SVG per panel of the entry's figure. Above: our curve (line), theirs (marks: filled
/// circle measured, open circle published, cross exact or recomputed, square own), the band over
/// the unknown inputs (shaded). Below: (ours - theirs)/allowed; inside +-1 a value is within.
[[nodiscard]] std::vector<std::string> entry_figures(const EntryReport& report);

}  // namespace shellback::validation
