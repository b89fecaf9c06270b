#include "app/labels/command_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/reading/did_you_mean.hpp"

namespace shellback::app {
namespace {

/// The value without the quotes of TOML around it.
std::string bare(const std::string& value) {
  const bool quoted = value.size() >= 2 && value.front() == '"' && value.back() == '"' &&
                      value.find('"', 1) == value.size() - 1;
  return quoted ? value.substr(1, value.size() - 2) : value;
}

std::string words_of(const bearing::Change& change) {
  if (change.option == "--tier") return "--tier " + shell_word(bare(change.value));
  // The proposed run may ask for the coefficients without their table.
  if (change.option == "--coefficients-table") return "--coefficients";
  if (change.option != "--set") return change.option;  // a switch
  return set_words(change.key, change.value);
}

}  // namespace

std::string shell_word(const std::string& word) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string("_-./=,:+%@").find(c) != std::string::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  if (word.find_first_of("\"$`\\!") == std::string::npos) return "\"" + word + "\"";
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string set_words(const std::string& key, const std::string& value) {
  return "--set " + key + "=" + shell_word(value);
}

std::string command_line(const std::string& command, const bearing::Case& c,
                         const std::string& more, const std::vector<std::string>& replaced) {
  std::string line = "shellback " + command + " " + shell_word(c.path);
  for (const auto& change : c.changes) {
    if (std::find(replaced.begin(), replaced.end(), change.key) != replaced.end()) continue;
    line += " " + words_of(change);
  }
  return more.empty() ? line : line + " " + more;
}

std::string vary_words(const study::Axis& axis) {
  std::string values = comma_list(axis.words);
  if (axis.spacing != study::Spacing::listed) {
    values = fmt::format("{}..{}/{}{}", axis.words.front(), axis.words.back(), axis.size(),
                         axis.spacing == study::Spacing::logarithmic ? "log" : "");
  }
  return "--vary " + axis.key + "=" + shell_word(values);
}

std::string describe_changes(const bearing::Case& c) {
  std::string words;
  for (const auto& change : c.changes) {
    words += fmt::format("{}{} = {}", words.empty() ? "changed on the command line: " : ", ",
                         change.key, bare(change.value));
  }
  return words;
}

}  // namespace shellback::app
