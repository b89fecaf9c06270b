#pragma once
/// What is wrong with the words of a command line, in ours and not in those of CLI11.
#include <CLI/CLI.hpp>
#include <string>

namespace shellback::program {

/// True of nothing but blanks.
[[nodiscard]] bool is_blank(const std::string& text);

/// Throws CLI::ValidationError for an option whose value is blank: it would count as not given.
void expect_values(const CLI::App& command);

/// Of words that `app` could not parse.
[[nodiscard]] std::string complaint(const CLI::App& app, const CLI::ParseError& error);

}  // namespace shellback::program
