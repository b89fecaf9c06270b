#pragma once
/// Command lines as a user would type them, and what the command line changed in a case.
#include <string>
#include <vector>

#include "app/study/axis.hpp"
#include "bearing/case.hpp"

namespace shellback::app {

/// The word in quotes if a shell would take it apart.
[[nodiscard]] std::string shell_word(const std::string& word);

/// --set KEY=VALUE for a shell.
[[nodiscard]] std::string set_words(const std::string& key, const std::string& value);

/// "shellback COMMAND CASE", the changes that led to the case, and `more`. A change of a key that
/// `replaced` names is left out.
[[nodiscard]] std::string command_line(const std::string& command, const bearing::Case& c,
                                       const std::string& more,
                                       const std::vector<std::string>& replaced);

/// --vary for an axis, as it may be typed again.
[[nodiscard]] std::string vary_words(const study::Axis& axis);

/// "changed on the command line: operation.speed = 1500 rpm, model.tier = thd"; empty: nothing was.
[[nodiscard]] std::string describe_changes(const bearing::Case& c);

}  // namespace shellback::app
