#pragma once
/// The ledger as JSON, for other programs.
#include <string>
#include <vector>

#include "validation/ledger/ledger_report.hpp"

namespace shellback::validation {

/// { "entries": [ { "name", "title", "verdict", "wall_s", "quantities": [ { "name", "unit",
/// "evidence", "tolerance", "rms", "verdict", "rows": [ ... ] } ], "features": [ ... ] } ],
///   "not_run": [ { "title", "reason" } ] }. Values that are not there are absent.
[[nodiscard]] std::string ledger_json(const std::vector<EntryReport>& reports,
                                      const std::vector<UnrunDataset>& gaps);

}  // namespace shellback::validation
