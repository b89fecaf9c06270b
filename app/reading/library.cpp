#include "app/reading/library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "app/reading/case_text.hpp"
#include "app/reading/did_you_mean.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

namespace fs = std::filesystem;

bool is_library(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "data", error) && fs::is_directory(folder / "cases", error);
}

/// Names (without .toml) of the files in a folder of the library.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  if (error) throw FileError(fmt::format("{}: cannot be listed", folder.string()));
  std::sort(names.begin(), names.end());
  return names;
}

const toml::table& document(Reader& reader, const fs::path& path) {
  const auto known = reader.documents.find(path.string());
  if (known != reader.documents.end()) return known->second;
  toml::table parsed = parse_toml(read_text_file(path.string()), path.string());
  return reader.documents.emplace(path.string(), std::move(parsed)).first->second;
}

}  // namespace

fs::path library_root() {
  if (const char* home = std::getenv("SHELLBACK_HOME"); home != nullptr && *home != '\0') {
    if (is_library(home)) return home;
    throw FileError(
        fmt::format("SHELLBACK_HOME is {}, which does not hold data/ and cases/", home));
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" / "shellback";
  if (!error && is_library(installed)) return installed;
  if (is_library(SHELLBACK_LIBRARY)) return SHELLBACK_LIBRARY;
  throw FileError(
      "the shipped oils, materials and cases are not to be found; set SHELLBACK_HOME "
      "to the folder that holds data/ and cases/");
}

std::vector<std::string> shipped_oils() { return names_in(library_root() / "data" / "oils"); }

std::vector<std::string> shipped_cases() { return names_in(library_root() / "cases"); }

std::vector<std::string> shipped_materials(Reader& reader) {
  std::vector<std::string> names;
  for (auto&& [key, node] : document(reader, library_root() / "data" / "materials.toml")) {
    if (node.is_table()) names.emplace_back(key.str());
  }
  return names;
}

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    if (entry.is_regular_file(error)) files.push_back(entry.path().string());
  }
  return files;
}

std::vector<std::string> shipped_files() {
  std::vector<std::string> files;
  for (const char* folder : {"cases", "data", "validation"}) {
    const std::vector<std::string> more = files_below(library_root() / folder);
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

fs::path case_path(const std::string& name) {
  const std::vector<std::string> known = shipped_cases();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    throw InputError(fmt::format("there is no shipped case {}{}", in_quotes(name),
                                 choices_for(name, known, "shipped are")));
  }
  return library_root() / "cases" / (name + ".toml");
}

const toml::table* find_oil(Reader& reader, const std::string& name) {
  const std::vector<std::string> known = shipped_oils();
  if (std::find(known.begin(), known.end(), name) == known.end()) return nullptr;
  const toml::table& file = document(reader, library_root() / "data" / "oils" / (name + ".toml"));
  const toml::table* oil = file["oil"].as_table();
  return oil == nullptr ? &file : oil;
}

const toml::table* find_material(Reader& reader, const std::string& name) {
  return document(reader, library_root() / "data" / "materials.toml")[name].as_table();
}

}  // namespace shellback::app
