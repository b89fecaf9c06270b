#include "app/reading/toml_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/reading/case_text.hpp"
#include "app/reading/did_you_mean.hpp"
#include "bearing/case_limits.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

constexpr double kAtmosphere = -bearing::kValueRanges.gauge_pressure.low;  ///< [Pa]

/// What a node is, in words for the user.
std::string type_name(const toml::node& node) {
  if (node.is_string()) return "a text";
  if (node.is_number()) return "a number";
  if (node.is_boolean()) return "true/false";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  return "a date or time";
}

std::string written(const toml::node& node) {
  if (const auto* text = node.as_string()) return in_quotes(text->get());
  if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
  if (const auto* real = node.as_floating_point()) return fmt::format("{}", real->get());
  return type_name(node);
}

/// Keys put there by the command line have no place of their own; their values have.
std::string place_of_key(const toml::key& key, const toml::node& node) {
  return place_of(key.source().begin.line > 0 ? key.source() : node.source());
}

/// The kind's example as it stands in a file.
std::string example_of(const Kind& kind) {
  const bool plain = kind.dimension == Dimension{};
  return plain ? kind.example : fmt::format("\"{}\"", kind.example);
}

}  // namespace

std::string Reader::place(std::string key) const {
  for (;;) {
    const auto found = places.find(key);
    if (found != places.end()) return found->second;
    const std::size_t dot = key.rfind('.');
    if (dot == std::string::npos) return file;
    key.resize(dot);
  }
}

InputError error_at(const std::string& place, const std::string& key, const std::string& problem) {
  const bool named = place == "--set " + key || key.empty();
  return {place, named ? problem : key + ": " + problem};
}

Section::Section(Reader& reader, const toml::table& table, std::string path,
                 const toml::table* behind)
    : reader_(&reader), table_(&table), behind_(behind), path_(std::move(path)) {
  if (!path_.empty() && table.source().begin.line > 0) {
    reader_->places.emplace(path_, place_of(table.source()));
  }
}

std::string Section::name(const std::string& key) const {
  if (key.empty()) return path_;
  return path_.empty() ? key : path_ + "." + key;
}

void Section::only(std::initializer_list<const char*> keys, const std::string& what) const {
  const std::vector<std::string> known(keys.begin(), keys.end());
  for (const toml::table* table : {table_, behind_}) {
    if (table == nullptr) continue;
    for (auto&& [key, node] : *table) {
      const std::string word(key.str());
      bool allowed = false;
      for (const std::string& k : known) allowed = allowed || k == word;
      if (allowed) continue;
      throw InputError(place_of_key(key, node),
                       fmt::format("unknown key {} in {}{}", in_quotes(word), what,
                                   choices_for(word, known, "keys here")));
    }
  }
}

const toml::node* Section::find(const std::string& key) const {
  for (const toml::table* table : {table_, behind_}) {
    const toml::node* node = table == nullptr ? nullptr : table->get(key);
    if (node == nullptr) continue;
    reader_->used.insert(node);
    reader_->places.emplace(name(key), place_of(node->source()));
    return node;
  }
  return nullptr;
}

const toml::node& Section::need(const std::string& key, const std::string& example) const {
  const toml::node* node = find(key);
  if (node == nullptr) fail_missing(key, example);
  return *node;
}

void Section::fail(const std::string& key, const std::string& problem) const {
  throw error_at(reader_->place(name(key)), name(key), problem);
}

void Section::fail_file(const std::string& key, const std::string& problem) const {
  throw FileError(error_at(reader_->place(name(key)), name(key), problem).what());
}

void Section::fail_missing(const std::string& key, const std::string& example) const {
  fail(key, fmt::format("this key is missing; add for example {} = {}", key, example));
}

void Section::warn(const std::string& key, const std::string& problem) const {
  reader_->warnings.emplace_back(error_at(reader_->place(name(key)), name(key), problem).what());
}

double Section::value_of(const toml::node& node, const std::string& key, const Kind& kind) const {
  const bool plain = kind.dimension == Dimension{};
  if (const auto* text = node.as_string()) {
    try {
      return parse_quantity(text->get(), kind);
    } catch (const UnitError& error) {
      fail(key, error.what());
    }
  }
  const auto number = node.value<double>();
  if (!node.is_number() || !number) {
    fail(key, fmt::format("this is {}, but {} is wanted, for example {} = {}", type_name(node),
                          kind.name, key, example_of(kind)));
  }
  if (!plain) {
    fail(key, fmt::format("{} has no unit ({} is wanted); units that would do: {}; write for "
                          "example {} = \"{}\"",
                          written(node), kind.name, kind.units, key, kind.example));
  }
  if (!std::isfinite(*number)) fail(key, fmt::format("{} is not a finite number", *number));
  return *number;
}

void Section::check_range(const std::string& key, double value, const Kind& kind,
                          const Range& range) const {
  const std::string shown = written(*find(key));
  if (kind.absolute && !bearing::kValueRanges.temperature.holds(value)) {
    fail(key, fmt::format("{} cannot be meant ({}; a bearing lives between -60 and 400 degC); "
                          "check the number and whether degC or K is meant",
                          shown, show(value, "degC", kind)));
  }
  if (range.holds(value)) return;
  fail(key, fmt::format("{} is not possible (it must {}); write for example {} = {}", shown,
                        range.words, key, example_of(kind)));
}

double Section::quantity(const std::string& key, const Kind& kind, const Range& range) const {
  const double value = value_of(need(key, example_of(kind)), key, kind);
  check_range(key, value, kind, range);
  return value;
}

std::optional<double> Section::maybe_quantity(const std::string& key, const Kind& kind,
                                              const Range& range) const {
  if (!has(key)) return std::nullopt;
  return quantity(key, kind, range);
}

double Section::quantity_or(const std::string& key, const Kind& kind, double fallback,
                            const std::string& assumption, const Range& range) const {
  if (has(key)) return quantity(key, kind, range);
  if (!assumption.empty()) assume(assumption);
  return fallback;
}

std::optional<double> Section::maybe_gauge_pressure(const std::string& key,
                                                    const Kind& kind) const {
  const std::string absolute = key + "_absolute";
  if (has(key) && has(absolute)) {
    fail(absolute, fmt::format("{} is given too; keep one of them", key));
  }
  if (has(absolute)) return quantity(absolute, kind, kNotNegative) - kAtmosphere;
  const auto gauge = maybe_quantity(key, kind);
  if (gauge && *gauge < -kAtmosphere) {
    fail(key,
         "this gauge pressure lies below vacuum (-1.013 bar); pressures are counted from "
         "ambient unless the key says absolute");
  }
  return gauge;
}

std::string Section::text(const std::string& key) const {
  const toml::node& node = need(key, "\"...\"");
  const auto* text = node.as_string();
  if (text == nullptr) fail(key, fmt::format("this is {}, but a text is wanted", type_name(node)));
  return text->get();
}

bool Section::is_text(const std::string& key) const {
  const toml::node* node = find(key);
  return node != nullptr && node->is_string();
}

bool Section::is_table(const std::string& key) const {
  const toml::node* node = find(key);
  return node != nullptr && node->is_table();
}

std::optional<bool> Section::maybe_switch(const std::string& key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (const auto* boolean = node->as_boolean()) return boolean->get();
  if (const auto* word = node->as_string(); word != nullptr && word->get() == "auto") {
    return std::nullopt;
  }
  fail(key, fmt::format("{} is none of true, false, \"auto\"", written(*node)));
}

int Section::whole(const toml::node& node, const std::string& key, int low, int high) const {
  const auto* number = node.as_integer();
  if (node.is_floating_point()) {
    fail(key,
         fmt::format("{} is no whole number; write one from {} to {} without point and exponent",
                     written(node), low, high));
  }
  if (number == nullptr || number->get() < low || number->get() > high) {
    fail(key, fmt::format("{} is no whole number from {} to {}", written(node), low, high));
  }
  return static_cast<int>(number->get());
}

int Section::whole_number(const std::string& key, int low, int high) const {
  return whole(need(key, fmt::format("{}", low)), key, low, high);
}

std::array<int, 2> Section::pair_of_whole_numbers(const std::string& key, int low, int high) const {
  const auto* list = need(key, "[200, 25]").as_array();
  if (list == nullptr || list->size() != 2) {
    fail(key, "two whole numbers in brackets are wanted, as in [200, 25]");
  }
  return {whole(*list->get(0), key, low, high), whole(*list->get(1), key, low, high)};
}

std::array<double, 2> Section::pair_of_quantities(const std::string& key, const Kind& kind,
                                                  const std::string& example) const {
  const auto* list = need(key, example).as_array();
  if (list == nullptr || list->size() != 2) {
    fail(key, fmt::format("two values in brackets are wanted, as in {}", example));
  }
  return {value_of(*list->get(0), key, kind), value_of(*list->get(1), key, kind)};
}

std::vector<std::string> Section::texts(const std::string& key) const {
  std::vector<std::string> result;
  const toml::node* node = find(key);
  if (node == nullptr) return result;
  const auto* list = node->as_array();
  if (list == nullptr) fail(key, "a list of texts is wanted, as in [\"...\", \"...\"]");
  for (const toml::node& entry : *list) {
    const auto* text = entry.as_string();
    if (text == nullptr) fail(key, fmt::format("{} in the list is no text", type_name(entry)));
    result.push_back(text->get());
  }
  return result;
}

std::size_t Section::choice_index(const std::string& key,
                                  const std::vector<std::string>& words) const {
  const std::string word = text(key);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] == word) return k;
  }
  fail(key, fmt::format("{} is not known{}", in_quotes(word),
                        choices_for(word, words, "possible here")));
}

Section Section::section(const std::string& key) const {
  const toml::node& node = need(key, "{ ... }");
  const auto* table = node.as_table();
  if (table == nullptr) {
    fail(key, fmt::format("this is {}, but a table is wanted, as in [{}] or {} = {{ ... }}",
                          written(node), name(key), key));
  }
  const toml::node* behind = behind_ == nullptr ? nullptr : behind_->get(key);
  const bool layered = behind != nullptr && behind != &node;
  return {*reader_, *table, name(key), layered ? behind->as_table() : nullptr};
}

Section Section::law(const std::string& key) const {
  Section result = section(key);
  if (result.table_->contains("law")) result.behind_ = nullptr;
  return result;
}

std::optional<Section> Section::maybe_section(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  return section(key);
}

std::vector<Section> Section::sections(const std::string& key) const {
  std::vector<Section> result;
  const toml::node* node = find(key);
  if (node == nullptr) return result;
  const auto* list = node->as_array();
  if (list == nullptr) {
    fail(key, fmt::format("this is {}, but a list of tables is wanted: write [[{}]], with two "
                          "brackets",
                          type_name(*node), name(key)));
  }
  for (std::size_t k = 0; k < list->size(); ++k) {
    const auto* table = list->get(k)->as_table();
    if (table == nullptr) {
      fail(key, fmt::format("entry {} is {}, but a table is wanted", k, type_name(*list->get(k))));
    }
    reader_->used.insert(table);
    result.emplace_back(*reader_, *table, fmt::format("{}.{}", name(key), k));
  }
  return result;
}

void Section::expect_all_used() const {
  for (auto&& [key, node] : *table_) {
    const std::string word(key.str());
    if (!reader_->used.contains(&node)) {
      throw InputError(place_of_key(key, node),
                       fmt::format("the key {} has no effect beside the other keys given; "
                                   "remove it",
                                   in_quotes(name(word))));
    }
    if (const auto* table = node.as_table()) {
      Section(*reader_, *table, name(word)).expect_all_used();
    } else if (const auto* list = node.as_array()) {
      for (std::size_t k = 0; k < list->size(); ++k) {
        const auto* entry = list->get(k)->as_table();
        if (entry != nullptr) {
          Section(*reader_, *entry, fmt::format("{}.{}", name(word), k)).expect_all_used();
        }
      }
    }
  }
}

}  // namespace shellback::app
