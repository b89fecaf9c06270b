#include "app/reading/case_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/contract.hpp"

namespace shellback::app {
namespace {

constexpr std::size_t kLargestFile = 10'000'000;  ///< [B]; a case is a few kB, a profile some 100

/// Cures for a file that is not what it is to be.
struct TextWords {
  const char* absent;
  const char* folder;
  const char* large;
  const char* empty;
  const char* binary;
};

TextWords words_for(TextKind kind) {
  if (kind == TextKind::case_file) {
    return {"\"shellback init\" lists cases to start from", "give the case file in it",
            "which no case needs; a measured profile belongs into a file of its own "
            "(bearing.profile)",
            "\"shellback init\" lists cases to start from",
            "is this a case file? Case files are UTF-8 text"};
  }
  return {kind == TextKind::table_of_case
              ? "a table named in a case is looked for from the folder of the case"
              : "a table named on the command line is looked for from the current folder",
          "give the table in it", "which no table needs; leave out columns, or every second row",
          "the first line of a table names columns and units",
          "is this a table? Tables are UTF-8 text, a spreadsheet's are exported as CSV"};
}

[[noreturn]] void refuse_size(const std::string& name, TextKind kind) {
  throw InputError(name, fmt::format("the file is larger than 10 MB, {}", words_for(kind).large));
}

/// Bytes of the UTF-8 character at text[i], 0 if there is none (overlong forms, surrogates and
/// values above U+10FFFF included; RFC 3629).
std::size_t utf8_length(const std::string& text, std::size_t i) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
  };
  const unsigned first = byte(i);
  const unsigned second = byte(i + 1);
  const auto follows = [&](std::size_t k) { return (byte(i + k) & 0xC0U) == 0x80U; };
  if (first < 0x80U) return 1;
  if (first < 0xC2U) return 0;
  if (first < 0xE0U) return follows(1) ? 2 : 0;
  if (first < 0xF0U) {
    const bool bad = (first == 0xE0U && second < 0xA0U) || (first == 0xEDU && second > 0x9FU);
    return !bad && follows(1) && follows(2) ? 3 : 0;
  }
  const bool bad =
      first > 0xF4U || (first == 0xF0U && second < 0x90U) || (first == 0xF4U && second > 0x8FU);
  return !bad && follows(1) && follows(2) && follows(3) ? 4 : 0;
}

/// Whether `c` may be part of a dotted key (quotes included, so that quoted parts count).
bool in_key(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '"' ||
         c == '\'';
}

/// Refuses keys such as a.a.a.a...: tables nest as deep, and destroying them recurses.
void expect_shallow_keys(const std::string& text, const std::string& name) {
  int line = 1;
  int dots = 0;
  char previous = '\n';  // last character that is no blank
  for (const char c : text) {
    if (c == '\n') ++line;
    if (c == ' ' || c == '\t') continue;
    if (c == '.' && in_key(previous)) {
      if (++dots >= kDeepestKey) {
        throw InputError(fmt::format("{}:{}:1", name, line),
                         "a key is nested deeper than any case needs; keys have two or three "
                         "parts, such as viscosity.temperature");
      }
    } else if (!in_key(c)) {
      dots = 0;
    }
    previous = c;
  }
}

/// What the parser says, what we say.
struct Wording {
  std::string_view parser;
  std::string_view ours;
};
constexpr std::array<Wording, 7> kWordings{{
    {"expected value, saw", "there is no value after \"=\"; write key = \"23.9 um\", or remove it"},
    {"expected a comment or whitespace, saw",
     "unexpected text after a value; a value with a unit stands in quotes: key = \"23.9 um\""},
    {"unescaped control characters",
     "a quote is not closed on its line (or a control character stands inside the quotes)"},
    {"cannot redefine existing", "this key or section is given twice; keep one"},
    {"expected '=', saw",
     "there is no \"=\" after this key; a line holds key = value, [section] or # comment"},
    {"encountered end-of-file",
     "the file ends in the middle of this; close its brackets or quotes"},
    {"expected keys, tables",
     "this begins no key; a line holds key = value, [section] or # comment"},
}};

/// toml++ says "Error while parsing a key-value pair: expected ..."; we say what to do.
std::string reworded(std::string_view description) {
  for (const Wording& wording : kWordings) {
    if (description.find(wording.parser) != std::string_view::npos) {
      return std::string(wording.ours);
    }
  }
  const std::size_t colon = description.find(": ");
  if (!description.starts_with("Error while parsing ") || colon == std::string_view::npos) {
    return std::string(description);
  }
  return fmt::format("{}; check quotes, brackets and commas here and just before",
                     description.substr(colon + 2));
}

}  // namespace

std::string read_text_file(const std::string& path, TextKind kind) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error || status.type() == std::filesystem::file_type::not_found) {
    throw FileError(fmt::format("{}: there is no such file; {}", path, words_for(kind).absent));
  }
  if (std::filesystem::is_directory(status)) {
    throw FileError(fmt::format("{}: this is a folder; {}", path, words_for(kind).folder));
  }
  std::size_t most = kLargestFile;  // pipes, and files of the system, have no size beforehand
  if (std::filesystem::is_regular_file(status)) {
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (size > kLargestFile) refuse_size(path, kind);
    if (size > 0) most = static_cast<std::size_t>(size);
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  std::string text(most + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw FileError(fmt::format("{}: reading it failed", path));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > most && most < kLargestFile) {
    throw FileError(
        fmt::format("{}: it grew while it was read; once it is complete, try again", path));
  }
  expect_text(text, path, kind);
  return text;
}

void expect_text(const std::string& text, const std::string& name, TextKind kind) {
  if (text.size() > kLargestFile) refuse_size(name, kind);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError(name, fmt::format("the file is empty; {}", words_for(kind).empty));
  }
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw InputError(name, "the file is UTF-16; save it as UTF-8");
  }
  int line = 1;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (text[i] == '\0' || length == 0) {
      throw InputError(fmt::format("{}:{}:{}", name, line, i - begin + 1),
                       fmt::format("byte 0x{:02X} is no text: {}",
                                   static_cast<unsigned char>(text[i]), words_for(kind).binary));
    }
    i += length;
    if (text[i - 1] == '\n') {
      ++line;
      begin = i;
    }
  }
}

toml::table parse_toml(const std::string& text, const std::string& name) {
  expect_shallow_keys(text, name);
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    throw InputError(place_of(error.source()), reworded(error.description()));
  }
}

namespace {

/// "data.csv:2:1": what stands in a table has its place there.
bool is_place(std::string_view file) {
  for (int k = 0; k < 2; ++k) {
    const std::size_t colon = file.find_last_not_of("0123456789");
    const bool number = colon != std::string_view::npos && colon + 1 < file.size();
    if (!number || file[colon] != ':') return false;
    file = file.substr(0, colon);
  }
  return true;
}

}  // namespace

std::string place_of(const toml::source_region& region) {
  const std::string file = region.path ? *region.path : "";
  if (region.begin.line == 0 || file.starts_with("--") || is_place(file)) return file;
  return fmt::format("{}:{}:{}", file, region.begin.line, region.begin.column);
}

}  // namespace shellback::app
