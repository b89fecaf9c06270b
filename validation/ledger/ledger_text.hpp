#pragma once
/// The ledger as text: tables on the terminal and comma-separated rows.
#include <iosfwd>
#include <string>
#include <vector>

#include "validation/ledger/ledger_report.hpp"

namespace shellback::validation {

enum class RowsShown { worst, all };

/// One entry: by kind of evidence its quantities with ours, theirs, difference, what is allowed,
/// the root of the mean square difference and the verdict.
void write_entry_table(std::ostream& out, const EntryReport& report, RowsShown rows);

/// Numbers of entries within and outside by kind of evidence, and what is outside.
void write_summary(std::ostream& out, const std::vector<EntryReport>& reports,
                   const std::vector<UnrunDataset>& gaps);

/// Every expected value of every row as a line of a CSV table with a header.
[[nodiscard]] std::string ledger_csv(const std::vector<EntryReport>& reports);

/// "+0.0123": a difference with its sign and four digits.
[[nodiscard]] std::string signed_number(double value);
/// Five significant digits, without padding.
[[nodiscard]] std::string short_number(double value);
/// "15 % of the maximum + 0.03": a tolerance in words.
[[nodiscard]] std::string describe(const Tolerance& tolerance, const std::string& unit);
/// " um" for "um", nothing for "1".
[[nodiscard]] std::string after_number(const std::string& unit);

}  // namespace shellback::validation
