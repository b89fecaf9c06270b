#pragma once
/// Parts of a ledger entry that name columns of its table: one function per section.
///
/// All throw InputError with file, place and cure.
#include <string>

#include "app/reading/toml_reader.hpp"
#include "validation/ledger/ledger_entry.hpp"

namespace shellback::validation {

[[nodiscard]] std::string text_or(const app::Section& section, const std::string& key,
                                  const std::string& otherwise);
[[nodiscard]] double number_or(const app::Section& section, const std::string& key,
                               double otherwise);
/// A text that must name a column of the table.
[[nodiscard]] std::string column_of(const app::Section& section, const std::string& key,
                                    const Table& table);
[[nodiscard]] Evidence read_evidence(const app::Section& section);

[[nodiscard]] Exclusion read_exclusion(const app::Section& section, const Table& table);
[[nodiscard]] Deviation read_deviation(const app::Section& section, const Table& table);
[[nodiscard]] Feature read_feature(const app::Section& section, const Table& table);
[[nodiscard]] FigureSpec read_figure(const app::Section& file, const Table& table);

}  // namespace shellback::validation
