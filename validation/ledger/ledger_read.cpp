#include "validation/ledger/ledger_read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/reading/case_text.hpp"
#include "app/reading/did_you_mean.hpp"
#include "app/reading/library.hpp"
#include "app/reading/toml_reader.hpp"
#include "core/contract.hpp"
#include "validation/evaluators/evaluators.hpp"
#include "validation/ledger/ledger_parts.hpp"

namespace shellback::validation {
namespace {

namespace fs = std::filesystem;
using namespace app;

Tolerance read_tolerance(const Section& section) {
  const Section part = section.section("tolerance");
  part.only({"relative", "absolute", "of_maximum"}, "a tolerance");
  const Tolerance t{part.quantity_or("relative", kNumber, 0.0, "", kNotNegative),
                    part.quantity_or("absolute", kNumber, 0.0, "", kNotNegative),
                    part.quantity_or("of_maximum", kNumber, 0.0, "", kNotNegative)};
  if (t.relative + t.absolute + t.of_maximum <= 0.0) {
    section.fail("tolerance", "a tolerance of nothing; give relative, absolute or of_maximum");
  }
  return t;
}

QuantitySpec read_quantity(const Section& s, const Table& table) {
  s.only({"name", "column", "ours", "unit", "scale", "kind", "tolerance", "group", "why"},
         "a quantity");
  QuantitySpec q;
  q.name = s.text("name");
  q.column = column_of(s, "column", table);
  q.ours = s.text("ours");
  q.unit = text_or(s, "unit", "1");
  q.scale = number_or(s, "scale", 1.0);
  q.evidence = read_evidence(s);
  q.tolerance = read_tolerance(s);
  if (s.has("group")) q.group = column_of(s, "group", table);
  q.why = s.text("why");
  return q;
}

Vary read_vary(const Section& s, const Table& table) {
  s.only({"column", "key", "unit", "factor", "bearing"}, "a [[vary]]");
  return {column_of(s, "column", table), s.text("key"), text_or(s, "unit", ""),
          number_or(s, "factor", 1.0), text_or(s, "bearing", "")};
}

BearingPart read_bearing(const Section& s, const fs::path& folder) {
  s.only({"name", "file", "times"}, "a [[bearing]]");
  return {s.text("name"), (folder / s.text("file")).lexically_normal().string(),
          s.quantity_or("times", kNumber, 1.0, "", kPositive)};
}

Changes read_changes(const Section& section, const std::string& key,
                     const std::vector<BearingPart>& bearings) {
  Changes changes;
  const Section side = section.section(key);
  for (auto&& [name, unused] : *side.table()) {
    const std::string bearing(name.str());
    const bool known = std::any_of(bearings.begin(), bearings.end(),
                                   [&](const BearingPart& b) { return b.name == bearing; });
    if (!known) side.fail(bearing, "there is no [[bearing]] of this name");
    const Section keys = side.section(bearing);
    for (auto&& [word, node] : *keys.table()) {
      const std::string path(word.str());
      changes[bearing].push_back({path, keys.text(path), keys.name(path)});
    }
  }
  return changes;
}

Unknown read_unknown(const Section& s, const std::vector<BearingPart>& bearings) {
  s.only({"name", "range", "why", "low", "high"}, "an [[unknown]]");
  return {s.text("name"), s.text("range"), s.text("why"), read_changes(s, "low", bearings),
          read_changes(s, "high", bearings)};
}

std::string read_evaluator(const Section& file) {
  std::string name = file.text("evaluator");
  if (find_evaluator(name) == nullptr) {
    file.fail("evaluator", fmt::format("there is no evaluator {}{}", in_quotes(name),
                                       choices_for(name, evaluator_names(), "possible are")));
  }
  return name;
}

/// A deviation of a column that nothing is compared with would never be found.
void expect_compared(const Section& file, const Entry& entry) {
  for (std::size_t k = 0; k < entry.deviations.size(); ++k) {
    const std::string& column = entry.deviations[k].column;
    std::vector<std::string> compared;
    for (const QuantitySpec& q : entry.quantities) compared.push_back(q.column);
    if (std::find(compared.begin(), compared.end(), column) != compared.end()) continue;
    file.sections("deviation")[k].fail(
        "column", fmt::format("no [[quantity]] compares the column {}{}", in_quotes(column),
                              choices_for(column, compared, "compared are")));
  }
}

void read_lists(const Section& file, const fs::path& folder, Entry& entry) {
  const Table& table = *entry.table;
  for (const Section& s : file.sections("bearing"))
    entry.bearings.push_back(read_bearing(s, folder));
  for (const Section& s : file.sections("vary")) entry.vary.push_back(read_vary(s, table));
  for (const Section& s : file.sections("quantity")) {
    entry.quantities.push_back(read_quantity(s, table));
  }
  for (const Section& s : file.sections("exclude")) {
    entry.exclusions.push_back(read_exclusion(s, table));
  }
  for (const Section& s : file.sections("deviation")) {
    entry.deviations.push_back(read_deviation(s, table));
  }
  for (const Section& s : file.sections("unknown")) {
    entry.unknowns.push_back(read_unknown(s, entry.bearings));
  }
  for (const Section& s : file.sections("feature")) {
    entry.features.push_back(read_feature(s, table));
  }
  if (entry.quantities.empty()) file.fail("quantity", "no [[quantity]]: nothing is compared");
  expect_compared(file, entry);
}

Entry entry_from(const Section& file, const fs::path& folder) {
  file.only(
      {"title", "source", "compared", "note", "assumptions", "evaluator", "expected", "bearing",
       "vary", "settings", "quantity", "exclude", "deviation", "unknown", "feature", "figure"},
      "a ledger entry");
  Entry entry;
  entry.name = folder.filename().string();
  entry.folder = folder.string();
  entry.title = file.text("title");
  entry.source = file.text("source");
  entry.compared = file.text("compared");
  entry.note = text_or(file, "note", "");
  entry.assumptions = file.texts("assumptions");
  entry.evaluator = read_evaluator(file);
  entry.table = read_table((folder / file.text("expected")).lexically_normal().string());
  if (const auto settings = file.maybe_section("settings")) {
    for (auto&& [key, node] : *settings->table()) {
      const std::string word(key.str());
      entry.settings[word] = settings->text(word);
    }
  }
  read_lists(file, folder, entry);
  entry.figure = read_figure(file, *entry.table);
  return entry;
}

}  // namespace

std::string ledger_folder(const std::string& folder) {
  const fs::path path = folder.empty() ? library_root() / "validation" : fs::path(folder);
  if (!fs::is_directory(path)) {
    throw FileError(fmt::format("{}: there is no such folder of ledger entries", path.string()));
  }
  return path.string();
}

std::vector<std::string> entry_names(const std::string& ledger) {
  std::vector<std::string> names;
  for (const auto& item : fs::directory_iterator(ledger)) {
    if (fs::is_regular_file(item.path() / "entry.toml")) {
      names.push_back(item.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<Entry> read_entries(const std::string& ledger, const std::vector<std::string>& names) {
  const std::vector<std::string> known = entry_names(ledger);
  if (known.empty()) {
    throw InputError("--ledger", fmt::format("{} has no entry: a folder with an entry.toml in it",
                                             in_quotes(ledger)));
  }
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw InputError(fmt::format("there is no ledger entry {}{}", in_quotes(name),
                                   choices_for(name, known, "entries are")));
    }
  }
  std::vector<Entry> entries;
  for (const std::string& name : known) {
    const bool wanted = names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    if (wanted) entries.push_back(read_entry(ledger, name));
  }
  return entries;
}

Entry read_entry(const std::string& ledger, const std::string& name) {
  const fs::path folder = fs::path(ledger) / name;
  const std::string path = (folder / "entry.toml").string();
  const toml::table root = parse_toml(read_text_file(path), path);
  Reader reader;
  reader.file = path;
  const Section file(reader, root, "");
  Entry entry = entry_from(file, folder);
  file.expect_all_used();
  return entry;
}

std::vector<UnrunDataset> read_unrun(const std::string& ledger) {
  const std::string path = (fs::path(ledger) / "not-run.toml").string();
  std::vector<UnrunDataset> gaps;
  if (!fs::exists(path)) return gaps;
  const toml::table root = parse_toml(read_text_file(path), path);
  Reader reader;
  reader.file = path;
  const Section file(reader, root, "");
  file.only({"dataset"}, "the list of datasets without an entry");
  for (const Section& s : file.sections("dataset")) {
    s.only({"title", "reason"}, "a [[dataset]]");
    gaps.push_back({s.text("title"), s.text("reason")});
  }
  return gaps;
}

}  // namespace shellback::validation
