#pragma once
/// The ledger as one self-contained page.
#include <string>
#include <vector>

#include "validation/ledger/ledger_report.hpp"

namespace shellback::validation {

/// Overview (published evidence first, then exact and recomputed, own regressions apart), then
/// each entry with figures, rows, source, assumptions and unknown inputs, then the datasets that
/// are not run. All outside text is escaped.
[[nodiscard]] std::string ledger_page(const std::vector<EntryReport>& reports,
                                      const std::vector<UnrunDataset>& gaps);

}  // namespace shellback::validation
