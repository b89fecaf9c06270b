#pragma once
/// The oils, materials and cases that come with the program.
#include <filesystem>
#include <string>
#include <vector>

#include "app/reading/toml.hpp"
#include "app/reading/toml_reader.hpp"

namespace shellback::app {

/// The folder that holds data/ and cases/: $SHELLBACK_HOME, else share/shellback beside the
/// program's bin/, else the source tree it was built from. Throws FileError if there is none.
[[nodiscard]] std::filesystem::path library_root();

/// Names of the shipped oils, materials and cases, sorted.
[[nodiscard]] std::vector<std::string> shipped_oils();
[[nodiscard]] std::vector<std::string> shipped_materials(Reader& reader);
[[nodiscard]] std::vector<std::string> shipped_cases();

/// Every file that comes with the program: cases, oils, materials, the ledger's entries.
[[nodiscard]] std::vector<std::string> shipped_files();

/// The files below `folder`, however deep; none if there is no such folder.
[[nodiscard]] std::vector<std::string> files_below(const std::filesystem::path& folder);

/// The shipped case's file. Throws InputError (did you mean, list) if there is none.
[[nodiscard]] std::filesystem::path case_path(const std::string& name);

/// The shipped oil's table, nullptr if there is none of that name.
[[nodiscard]] const toml::table* find_oil(Reader& reader, const std::string& name);

/// The shipped material's table, nullptr if there is none of that name.
[[nodiscard]] const toml::table* find_material(Reader& reader, const std::string& name);

}  // namespace shellback::app
