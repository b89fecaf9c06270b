#include "app/reading/read_case.hpp"

#include <fmt/format.h>

#include "app/reading/case_text.hpp"
#include "app/reading/sections.hpp"
#include "bearing/judge/judge_case.hpp"
#include "bearing/over_time/cycle_numbers.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

using bearing::Case;
using bearing::Tier;

/// The file's text and, as comments, what the command line changed in it.
std::string with_overrides(const std::string& text, const std::vector<Override>& overrides) {
  std::string verbatim = text;
  for (const Override& change : overrides) {
    verbatim += fmt::format("{}# changed on the command line: {} = {}\n",
                            verbatim.ends_with('\n') ? "" : "\n", change.key, change.value);
  }
  return verbatim;
}

void read_sections(const Section& file, Case& result) {
  file.only({"title", "bearing", "supply", "operation", "load_cycle", "crank", "oil", "shell",
             "shaft", "surfaces", "model", "measured", "running_in"},
            "the case");
  if (file.has("title")) result.title = file.text("title");
  result.bearing = read_bearing(file);
  result.operation = read_operation(file);
  result.cycle = read_load_cycle(file, result.operation.omega);
  if (result.cycle) result.operation.position = bearing::largest_load(*result.cycle);
  result.oil = read_oil(file);
  result.oil_temperature = read_oil_temperature(file);
  result.supplies =
      read_supplies(file, result.bearing.radius, result.oil_temperature, result.operation.omega);
  result.model = read_model(file);
  result.shell = read_shell(file);
  result.shaft = read_shaft(file);
  result.surfaces = read_surfaces(file);
  result.measured = read_measured(file, result.operation.omega);
  result.running_in = read_running_in(file);
  if (result.running_in && result.running_in->worn && result.bearing.shape) {
    file.assume(
        "the shell's surface is that of [surfaces.shell], however worn bearing.shape is: a "
        "running-in tells which surface belongs to its profile");
  }
}

/// The key as the file has it: a value that can be given in two ways is judged as one.
std::string key_in_file(const std::string& key, const Reader& reader) {
  if (reader.given(key)) return key;
  if (key == "load_cycle.file" && reader.given("crank")) return "crank";
  const std::string absolute = key + "_absolute";
  if (reader.given(absolute)) return absolute;
  const std::string stem = key.substr(0, key.rfind('.'));
  return key.ends_with(".arc") && reader.given(stem + ".width") ? stem + ".width" : key;
}

/// Throws at the place of the first refusal; the rest become warnings with theirs.
void judge_with_places(Case& subject, const std::vector<Tier>& tiers, const Reader& reader) {
  for (const bearing::Finding& f : judge(subject, tiers)) {
    const std::string key = key_in_file(f.key, reader);
    const InputError found = error_at(reader.place(key), key, f.words());
    if (f.refused()) throw found;
    subject.warnings.emplace_back(found.what());
  }
}

/// Files beside that of the case.
std::vector<std::string> others_of(const Reader& reader) {
  std::vector<std::string> files;
  for (const auto& [name, unused] : reader.documents) files.push_back(name);
  files.insert(files.end(), reader.tables.begin(), reader.tables.end());
  return files;
}

/// `reader` knows the file's name; what gathers on the way is in it afterwards.
Case read_with(Reader& reader, const std::string& text, const std::vector<Override>& overrides,
               const std::vector<Tier>& tiers) {
  const std::string& path = reader.file;
  expect_text(text, path);
  toml::table root = parse_toml(text, path);
  for (const Override& change : overrides) apply_override(root, change);
  const Section file(reader, root, "");
  Case result;
  result.path = path;
  result.verbatim = with_overrides(text, overrides);
  for (const Override& change : overrides) {
    result.changes.push_back(
        {change.key, change.value, change.place.substr(0, change.place.find(' '))});
  }
  read_sections(file, result);
  file.expect_all_used();
  for (const std::string& other : others_of(reader)) {
    result.taken_in.push_back(read_text_file(other));
  }
  result.assumptions = reader.assumptions;
  result.warnings = reader.warnings;
  judge_with_places(result, tiers.empty() ? std::vector{result.model.tier} : tiers, reader);
  return result;
}

}  // namespace

Case read_case_text(const std::string& text, const std::string& path,
                    const std::vector<Override>& overrides, const std::vector<Tier>& tiers) {
  Reader reader;
  reader.file = path;
  return read_with(reader, text, overrides, tiers);
}

std::vector<std::string> files_of_case(const std::string& text, const std::string& path,
                                       const std::vector<Override>& overrides,
                                       const std::vector<Tier>& tiers) {
  Reader reader;
  reader.file = path;
  static_cast<void>(read_with(reader, text, overrides, tiers));
  std::vector<std::string> files = others_of(reader);
  files.insert(files.begin(), path);
  return files;
}

std::vector<std::string> tables_of_case(const std::string& text, const std::string& path) {
  Reader reader;
  reader.file = path;
  static_cast<void>(read_with(reader, text, {}, {}));
  return reader.tables;
}

Case read_case(const std::string& path, const std::vector<Override>& overrides,
               const std::vector<Tier>& tiers) {
  return read_case_text(read_text_file(path), path, overrides, tiers);
}

}  // namespace shellback::app
