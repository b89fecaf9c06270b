#include "app/reading/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <vector>

#include "app/reading/case_text.hpp"
#include "app/reading/did_you_mean.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

std::vector<std::string> split(const std::string& key, const std::string& place) {
  std::vector<std::string> parts(1);
  for (const char c : key) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  };
  for (const std::string& part : parts) {
    if (part.empty() || !std::all_of(part.begin(), part.end(), plain)) {
      throw InputError(place,
                       fmt::format("{} is no key; write it as in section.key", in_quotes(key)));
    }
  }
  if (parts.size() > static_cast<std::size_t>(kDeepestKey)) {
    throw InputError(place, fmt::format("{} has more parts than any key", in_quotes(key)));
  }
  return parts;
}

/// The value in `{value = ...}` with the command line as its place.
toml::table as_document(const std::string& value, const std::string& place) {
  std::string escaped;
  for (const char c : value) {
    const bool special = c == '"' || c == '\\';
    escaped += special ? std::string("\\") + c : std::string(1, c);
  }
  expect_text("=" + value, place);
  if (value.find('\n') == std::string::npos) {
    try {
      toml::table parsed = parse_toml("value = " + value, place);
      if (parsed.size() == 1) return parsed;
    } catch (const InputError&) {
      // Not TOML: then it is a text whose quotes the shell has taken.
    }
  }
  return parse_toml("value = \"" + escaped + "\"", place);
}

toml::node& list_entry(toml::array& list, const std::string& part, const Override& change) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
  const bool padded = part.size() > 1 && part.front() == '0';  // another spelling of the same key
  if (error != std::errc{} || end != part.data() + part.size() || padded) {
    throw InputError(change.place, fmt::format("\"{}\" does not number an entry of a list; the "
                                               "first is 0, as in supply.0.pressure",
                                               part));
  }
  if (index >= list.size()) {
    throw InputError(change.place, fmt::format("there is no entry {} (the list has {}, the first "
                                               "is 0)",
                                               index, list.size()));
  }
  return *list.get(index);
}

/// A material that is named by a text becomes a table of that name, whose values can be set.
void open_material(const std::string& key, toml::table& table) {
  const auto name = table[key].value<std::string>();
  if (key != "material" || !name || !table[key].is_string()) return;
  table.insert_or_assign(key, toml::table{{"name", *name}});
}

}  // namespace

Override parse_override(const std::string& key_and_value) {
  const std::size_t equal = key_and_value.find('=');
  if (equal == std::string::npos || equal == 0) {
    throw InputError("--set", fmt::format("{} is not KEY=VALUE; write for example --set "
                                          "operation.speed=\"1500 rpm\"",
                                          in_quotes(key_and_value)));
  }
  const std::string key = key_and_value.substr(0, equal);
  return {key, key_and_value.substr(equal + 1), "--set " + key};
}

void apply_override(toml::table& root, const Override& change) {
  const std::vector<std::string> parts = split(change.key, change.place);
  toml::table document = as_document(change.value, change.place);
  toml::node* at = &root;
  for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
    if (toml::array* list = at->as_array()) {
      at = &list_entry(*list, parts[k], change);
    } else if (toml::table* table = at->as_table()) {
      if (!table->contains(parts[k])) {
        toml::table made = parse_toml("value = {}", change.place);
        table->insert(parts[k], std::move(*made.get("value")->as_table()));
      }
      open_material(parts[k], *table);
      at = table->get(parts[k]);
    } else {
      throw InputError(change.place,
                       fmt::format("\"{}\" leads through a value that holds no keys", change.key));
    }
  }
  if (toml::array* list = at->as_array()) {
    list_entry(*list, parts.back(), change);  // throws unless the entry exists
    throw InputError(change.place, "a whole entry of a list cannot be replaced; set its keys");
  }
  toml::table* table = at->as_table();
  if (table == nullptr) {
    throw InputError(change.place,
                     fmt::format("\"{}\" leads through a value that holds no keys", change.key));
  }
  toml::table* value = &document;
  value->get("value")->visit(
      [&](auto&& node) { table->insert_or_assign(parts.back(), std::move(node)); });
}

}  // namespace shellback::app
