#pragma once
/// Reruns one ledger entry: our values for every row, between the rows, and at the ends of the
/// unknown inputs; then the verdict.
#include <functional>

#include "validation/ledger/ledger_judge.hpp"

namespace shellback::validation {

struct LedgerOptions {
  int threads = 1;
  bool curves = false;  ///< also points between the rows
  bool bands = false;   ///< also the unknown inputs at their ends
  bearing::SolveControl control;
  std::function<void(const std::string& entry, int done, int of)> progress;  ///< may be empty
};

/// Does not throw for films that do not converge: their rows have no result. If stopped, the
/// report is marked interrupted and its verdicts mean nothing. Throws InputError as judge().
[[nodiscard]] EntryReport run_entry(const Entry& entry, const LedgerOptions& options);

/// Points of our curve between the rows: `figure.between` in each interval of a series, evenly
/// spaced along x (or its logarithm), other numbers interpolated alike.
[[nodiscard]] std::vector<RowNumbers> points_between(const Entry& entry,
                                                     const std::vector<RowNumbers>& rows);

}  // namespace shellback::validation
