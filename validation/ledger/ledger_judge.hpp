#pragma once
/// Ours beside theirs: difference, what is allowed, verdict.
#include "validation/ledger/ledger_report.hpp"

namespace shellback::validation {

/// Fills `quantities`, `features` and `deviations` from `points`. Throws InputError if an evaluator
/// knows no value of a name that the entry asks for, or a cell is no number.
void judge(EntryReport& report);

}  // namespace shellback::validation
