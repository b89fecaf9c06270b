#pragma once
/// A text file in memory: read within limits, known to be text, parsed as TOML.
#include <string>

#include "app/reading/toml.hpp"

namespace shellback::app {

inline constexpr int kDeepestKey = 16;  ///< names in a dotted key; the parser recurses on them

/// What a text is to be, so that a message can say what to give.
enum class TextKind {
  case_file,
  table_of_case,  ///< named in a case
  table,          ///< named on the command line
};

/// Text of the file. Throws FileError if it cannot be read (exit 4) and InputError if it is
/// larger than 10 MB, empty, or not UTF-8 text.
[[nodiscard]] std::string read_text_file(const std::string& path,
                                         TextKind kind = TextKind::case_file);

/// Throws InputError unless `text` is non-empty UTF-8 without control bytes and no larger than
/// 10 MB; `name` is the file named in the message.
void expect_text(const std::string& text, const std::string& name,
                 TextKind kind = TextKind::case_file);

/// The table that `text` writes. Positions in it carry `name`. Throws InputError at the place
/// of the first syntax error.
[[nodiscard]] toml::table parse_toml(const std::string& text, const std::string& name);

/// "file:line:column" of a node or key; without the numbers if it stands on the command line.
[[nodiscard]] std::string place_of(const toml::source_region& region);

}  // namespace shellback::app
