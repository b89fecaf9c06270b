#pragma once
/// Differences that are known: is what lies outside what the entry documents, and nothing else?
#include "validation/ledger/ledger_report.hpp"

namespace shellback::validation {

/// A row outside its tolerance: documented if a deviation of the entry covers it and it lies on the
/// documented side no farther out than documented. Sets its judgement and reason.
void judge_known(const Entry& entry, const std::string& column, const RowNumbers& point,
                 RowReport& row);

/// Fills `deviations` from the judged quantities. A deviation whose farthest row is not as far out
/// as documented turns its quantity's verdict from documented or within to changed.
void judge_deviations(EntryReport& report);

/// A documented deviation in a sentence: what was found and what is documented.
[[nodiscard]] std::string describe(const DeviationReport& report);

}  // namespace shellback::validation
