#pragma once
/// Reader of the ledger: validation/<name>/entry.toml and its table.
///
/// Everything wrong in a file is an InputError with its place, what is wrong and what would do.
#include <string>
#include <vector>

#include "validation/ledger/ledger_entry.hpp"

namespace shellback::validation {

/// Where the ledger lies: `folder`, or, if that is empty, validation/ of the library. Throws
/// FileError if there is none.
[[nodiscard]] std::string ledger_folder(const std::string& folder);

/// Names of the entries, sorted.
[[nodiscard]] std::vector<std::string> entry_names(const std::string& ledger);

/// The entries of those names (all if there are none), in the order of `entry_names`. Throws
/// InputError for a name that is none (did you mean).
[[nodiscard]] std::vector<Entry> read_entries(const std::string& ledger,
                                              const std::vector<std::string>& names);

/// One entry.
[[nodiscard]] Entry read_entry(const std::string& ledger, const std::string& name);

/// The datasets without an entry, from not-run.toml; empty if there is no such file.
[[nodiscard]] std::vector<UnrunDataset> read_unrun(const std::string& ledger);

}  // namespace shellback::validation
