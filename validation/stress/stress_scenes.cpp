#include "validation/stress/stress_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "app/reading/case_text.hpp"
#include "app/reading/did_you_mean.hpp"
#include "app/reading/library.hpp"
#include "app/reading/read_case.hpp"
#include "core/contract.hpp"

namespace shellback::validation {
namespace {

using namespace app;

const std::vector<std::string> kKeys{"name", "title",  "case",  "tiers",  "set",    "vary",
                                     "axis", "values", "trend", "mirror", "expect", "expects"};
constexpr const char* kQuickGrid = "model.grid=[48, 8]";

[[noreturn]] void fail(const toml::node& node, const std::string& problem) {
  throw InputError(place_of(node.source()), problem);
}

const toml::node& need(const toml::table& table, const char* key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) fail(table, fmt::format("the scene has no \"{}\"", key));
  return *node;
}

std::string text_of(const toml::node& node) {
  const auto* text = node.as_string();
  if (text == nullptr) fail(node, "a text belongs here");
  return text->get();
}

std::string text_or(const toml::table& table, const char* key, const std::string& fallback) {
  const toml::node* node = table.get(key);
  return node == nullptr ? fallback : text_of(*node);
}

const toml::array& list_of(const toml::node& node) {
  const auto* list = node.as_array();
  if (list == nullptr || list->empty()) fail(node, "a list with something in it belongs here");
  return *list;
}

/// One text, or a list of them.
std::vector<std::string> texts_of(const toml::node& node) {
  if (node.is_string()) return {text_of(node)};
  std::vector<std::string> out;
  for (const toml::node& entry : list_of(node)) out.push_back(text_of(entry));
  return out;
}

/// A value as it stands behind --set: texts without quotes, all else in TOML.
std::string word_of(const toml::node& node) {
  if (node.is_string()) return text_of(node);
  if (const auto* number = node.as_floating_point()) return fmt::format("{:g}", number->get());
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  return out.str();
}

std::string label_of(const toml::node& node) {
  if (!node.is_array()) return word_of(node);
  std::vector<std::string> parts;
  for (const toml::node& entry : *node.as_array()) parts.push_back(word_of(entry));
  return fmt::format("{}", fmt::join(parts, "x"));
}

StressStep step_of(const toml::node& value, const std::vector<std::string>& keys) {
  if (keys.size() == 1) return {label_of(value), {keys.front() + "=" + word_of(value)}};
  const toml::array& list = list_of(value);
  if (list.size() != keys.size()) fail(value, "a value for each key of \"vary\" belongs here");
  StressStep step{label_of(list[0]), {}};
  for (std::size_t k = 0; k < keys.size(); ++k) {
    step.words.push_back(keys[k] + "=" + word_of(list[k]));
  }
  return step;
}

StressTrend trend_of(const toml::node& node) {
  const std::string text = text_of(node);
  const std::size_t blank = text.find(' ');
  const std::string way = blank == std::string::npos ? "" : text.substr(blank + 1);
  if (way != "falls" && way != "rises") {
    fail(node, "a trend is written \"QUANTITY falls\" or \"QUANTITY rises\"");
  }
  return {text.substr(0, blank), way == "falls"};
}

/// Of "expects": a text for all tiers, or a table with a text for some of them.
StressExpectation expectation_of(const toml::node& node, const StressScene& scene) {
  const toml::node* text = &node;
  if (node.is_table()) text = node.as_table()->get(to_string(scene.tier));
  if (text == nullptr) return {};
  std::vector<std::string> labels;
  for (const StressStep& step : scene.steps) labels.push_back(step.label);
  try {
    return expectation_from(text_of(*text), labels);
  } catch (const std::invalid_argument& error) {
    fail(*text, error.what());
  }
}

/// Refuses tiers of "expects" that the scene does not have.
void check_expected_tiers(const toml::node& node, const std::vector<std::string>& tiers) {
  if (!node.is_table()) return;
  for (auto&& [key, value] : *node.as_table()) {
    const std::string tier(key.str());
    if (std::find(tiers.begin(), tiers.end(), tier) == tiers.end()) {
      fail(value, "the scene has no tier " + in_quotes(tier));
    }
  }
}

bool chooses_grid(const StressScene& scene) {
  const auto names_grid = [](const std::string& word) { return word.starts_with("model.grid="); };
  return std::any_of(scene.words.begin(), scene.words.end(), names_grid) ||
         std::any_of(scene.steps.front().words.begin(), scene.steps.front().words.end(),
                     names_grid);
}

/// The rows of one [[scene]].
std::vector<StressScene> rows_of(const toml::table& table, const std::string& folder, bool quick) {
  for (auto&& [key, node] : table) {
    const std::string word(key.str());
    if (std::find(kKeys.begin(), kKeys.end(), word) != kKeys.end()) continue;
    fail(node, in_quotes(word) + " does not belong to a scene" +
                   choices_for(word, kKeys, "possible are"));
  }
  StressScene scene;
  scene.name = text_of(need(table, "name"));
  scene.title = text_of(need(table, "title"));
  scene.expect = text_of(need(table, "expect"));
  scene.case_path = (std::filesystem::path(folder) / text_of(need(table, "case"))).string();
  if (const toml::node* set = table.get("set")) scene.words = texts_of(*set);
  const auto keys = texts_of(need(table, "vary"));
  scene.axis = text_or(table, "axis", fmt::format("{}", fmt::join(keys, ", ")));
  for (const toml::node& value : list_of(need(table, "values"))) {
    scene.steps.push_back(step_of(value, keys));
  }
  if (const toml::node* trend = table.get("trend")) scene.trend = trend_of(*trend);
  if (const toml::node* mirror = table.get("mirror")) scene.mirror = mirror->value_or(false);
  if (quick && !chooses_grid(scene)) scene.words.emplace_back(kQuickGrid);
  std::vector<StressScene> rows;
  const toml::node& tiers = need(table, "tiers");
  const toml::node* expects = table.get("expects");
  if (expects != nullptr) check_expected_tiers(*expects, texts_of(tiers));
  for (const std::string& tier : texts_of(tiers)) {
    rows.push_back(scene);
    rows.back().tier = tier_named(tier, place_of(tiers.source()));
    if (expects != nullptr) rows.back().expects = expectation_of(*expects, rows.back());
  }
  return rows;
}

}  // namespace

std::string full_name(const StressScene& scene) { return scene.name + "/" + to_string(scene.tier); }

std::vector<StressScene> parse_stress_scenes(const std::string& text, const std::string& path,
                                             const std::string& folder, bool quick) {
  const toml::table file = parse_toml(text, path);
  std::vector<StressScene> rows;
  for (const toml::node& node : list_of(need(file, "scene"))) {
    if (!node.is_table()) fail(node, "a [[scene]] belongs here");
    for (StressScene& row : rows_of(*node.as_table(), folder, quick)) {
      for (const StressScene& other : rows) {
        if (full_name(other) == full_name(row)) fail(node, "there are two scenes " + row.name);
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::vector<StressScene> shipped_stress_scenes(bool quick) {
  const auto folder = library_root() / "validation" / "stress";
  const std::string path = (folder / "scenes.toml").string();
  return parse_stress_scenes(read_text_file(path), path, folder.string(), quick);
}

std::vector<StressScene> chosen_stress_scenes(const std::vector<StressScene>& all,
                                              const std::vector<std::string>& names) {
  if (names.empty()) return all;
  std::vector<std::string> known;
  for (const StressScene& scene : all) {
    if (known.empty() || known.back() != scene.name) known.push_back(scene.name);
  }
  const auto is = [](const StressScene& scene, const std::string& name) {
    return scene.name == name || full_name(scene) == name;
  };
  for (const std::string& name : names) {
    if (std::any_of(all.begin(), all.end(), [&](const auto& s) { return is(s, name); })) continue;
    const std::string scene = name.substr(0, name.find('/'));
    if (std::find(known.begin(), known.end(), scene) != known.end()) {
      std::vector<std::string> rows;
      for (const StressScene& s : all) {
        if (s.name == scene) rows.push_back(full_name(s));
      }
      throw InputError("the scene " + in_quotes(scene) + " has no row " + in_quotes(name) +
                       choices_for(name, rows, "rows are"));
    }
    throw InputError("there is no stress scene " + in_quotes(name) +
                     choices_for(name, known, "scenes are"));
  }
  std::vector<StressScene> chosen;
  for (const StressScene& scene : all) {
    if (std::any_of(names.begin(), names.end(), [&](const auto& n) { return is(scene, n); })) {
      chosen.push_back(scene);
    }
  }
  return chosen;
}

}  // namespace shellback::validation
