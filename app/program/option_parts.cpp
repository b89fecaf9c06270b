#include "app/program/option_parts.hpp"

#include <algorithm>

#include "app/program/complaint.hpp"
#include "app/reading/did_you_mean.hpp"

namespace shellback::program {
namespace {

using app::in_quotes;

constexpr int kMostThreads = 1024;

std::string without_blanks_around(const std::string& text) {
  if (is_blank(text)) return "";
  const std::size_t begin = text.find_first_not_of(' ');
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

}  // namespace

void add_case_options(CLI::App& command, Request& request) {
  command.add_option("CASE", request.case_file, "case file (TOML)")->required();
  command
      .add_option("--set", request.set,
                  "change the case: --set operation.speed=\"1500 rpm\"; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

CLI::Option* add_list(CLI::App& command, const std::string& name, std::vector<std::string>& list,
                      const std::string& words) {
  const auto take = [name, &list](const std::vector<std::string>& given) {
    list.clear();
    for (const std::string& text : given) {
      for (std::size_t begin = 0, end = 0; begin <= text.size(); begin = end + 1) {
        end = std::min(text.find(',', begin), text.size());
        list.push_back(without_blanks_around(text.substr(begin, end - begin)));
        if (!list.back().empty()) continue;
        throw CLI::ValidationError(
            name,
            in_quotes(text) + " has a part that is empty; give a value on each side of a comma");
      }
    }
  };
  return command.add_option_function<std::vector<std::string>>(name, take, words)
      ->type_name("A,B,...")
      ->allow_extra_args(false);
}

void add_threads(CLI::App& command, Request& request, const std::string& words) {
  command.add_option("-j", request.threads, words)
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

void add_cores(CLI::App& command, Request& request, const std::string& what) {
  command.add_option("-j", request.cores, what + " (default: all cores)")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

void add_force(CLI::App& command, Request& request) {
  command.add_flag("--force", request.force,
                   "let outputs replace files that are no results of shellback (never an input)");
}

void add_state(CLI::App& command, Request& request, const std::string& what) {
  command
      .add_option("--state", request.state,
                  "where " + what +
                      " keeps its state on the way (default: beside its first file, NAME.state)")
      ->type_name("FILE");
  command.add_flag("--resume", request.resume,
                   "go on from the state of " + what + " that was interrupted or killed");
}

}  // namespace shellback::program
