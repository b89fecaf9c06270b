#include "app/program/complaint.hpp"

#include <fmt/format.h>

#include <vector>

#include "app/reading/did_you_mean.hpp"

namespace shellback::program {

using namespace app;

namespace {

/// The long and short names of a command's options.
std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// The first thing that the command cannot do without; `otherwise` if it is none of its options.
std::string what_is_missing(const CLI::App& command, const std::string& otherwise) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    if (!option->get_positional()) {
      return fmt::format("{} is missing: shellback {} ... {} {}", option->get_name(),
                         command.get_name(), option->get_name(), option->get_type_name());
    }
    const std::string name = option->get_name(true);
    const bool map = name == "MAP", given = name == "CASE";
    return fmt::format("the {} file is missing: shellback {} {}",
                       map     ? "map's"
                       : given ? "case"
                               : "result",
                       command.get_name(),
                       map     ? "MAP.csv"
                       : given ? "CASE.toml"
                               : name);
  }
  return otherwise;
}

}  // namespace

bool is_blank(const std::string& text) { return text.find_first_not_of(' ') == text.npos; }

void expect_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& value : option->results()) {
      if (!is_blank(value)) continue;
      throw CLI::ValidationError(option->get_name(),
                                 "its value is empty; give one, or leave it out");
    }
  }
}

std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const auto rest = app.remaining(true);
  if (!rest.empty()) {
    const std::string word = rest.front().substr(0, rest.front().find('='));
    const bool option = word.starts_with("-");
    return (option ? "there is no option " : "there is one word too many: ") + in_quotes(word) +
           (option ? choices_for(word, option_names(command), "options here") : "");
  }
  const bool lacks = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  return lacks ? what_is_missing(command, error.what()) : error.what();
}

}  // namespace shellback::program
