#include "app/reading/map_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "app/reading/did_you_mean.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

constexpr std::uintmax_t kLargestMap = 200'000'000;  ///< [B]; 4 million points of 50 letters
constexpr std::string_view kBlanks = " \t\r";

std::string_view stripped(std::string_view text, std::string_view blanks = kBlanks) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

std::string read_all(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw FileError(fmt::format("{}: this is a folder; give the map's file", path));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  const bool regular = std::filesystem::is_regular_file(path, error);
  if (regular && std::filesystem::file_size(path, error) > kLargestMap) {
    throw InputError(path,
                     "the map is larger than 200 MB; export a part of it, or every second "
                     "point");
  }
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (file.bad()) throw FileError(fmt::format("{}: reading it failed", path));
  if (text.find('\0') != std::string::npos) {
    throw InputError(path,
                     "this is no text; export the map as ASCII (Gwyddion: ASCII data "
                     "matrix), which holds numbers as text");
  }
  return text;
}

}  // namespace

MapText::MapText(const std::string& path) : path_(path), text_(read_all(path)) {
  std::string_view rest(text_);
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // some programs begin with it
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::string_view content = stripped(line);
    if (content.starts_with('#')) {
      comments_.push_back({number, content.substr(1)});
    } else if (!content.empty() || line.find('\t') != std::string_view::npos) {
      lines_.push_back({number, line.ends_with('\r') ? line.substr(0, line.size() - 1) : line});
    }
  }
  if (lines_.empty()) throw InputError(path + ":1:1", "the map holds no heights");
}

HeaderValue MapText::header(const std::string& name) const {
  HeaderValue value;
  for (const MapLine& comment : comments_) {
    const std::size_t colon = comment.text.find(':');
    if (colon == std::string_view::npos) continue;
    if (lower(stripped(comment.text.substr(0, colon))) != lower(name)) continue;
    if (value.line > 0) {
      throw InputError(
          fmt::format("{}:{}:1", path_, comment.number),
          fmt::format("{} is given in line {} already; keep one of them", name, value.line));
    }
    value = {comment.number, std::string(stripped(comment.text.substr(colon + 1)))};
  }
  return value;
}

std::string MapText::place(const MapLine& line, std::string_view field) const {
  const auto column = field.data() >= line.text.data() ? field.data() - line.text.data() + 1 : 1;
  return fmt::format("{}:{}:{}", path_, line.number, column);
}

std::vector<std::string_view> map_fields(std::string_view line) {
  std::vector<std::string_view> fields;
  // Where something else parts the fields, a comma is one of a number's, and refused with it.
  const bool apart = line.find_first_of(";\t") != std::string_view::npos;
  const char* const marks = apart ? ";\t" : ",";
  const bool separated = line.find_first_of(marks) != std::string_view::npos;
  if (!separated) {
    for (std::size_t at = line.find_first_not_of(' '); at < line.size();) {
      const std::size_t end = std::min(line.find(' ', at), line.size());
      fields.push_back(line.substr(at, end - at));
      at = line.find_first_not_of(' ', end);
    }
    return fields;
  }
  for (std::size_t at = 0;;) {
    const std::size_t end = std::min(line.find_first_of(marks, at), line.size());
    const std::string_view raw = line.substr(at, end - at), inner = stripped(raw, " ");
    fields.push_back(inner.empty() ? raw.substr(0, 0) : inner);
    if (end == line.size()) return fields;
    at = end + 1;
  }
}

double map_height(std::string_view field, double factor, const MapText& text, const MapLine& line) {
  constexpr std::size_t kLongestMark = 3;
  if (field.size() <= kLongestMark) {
    const std::string word = lower(field);
    if (word.empty() || word == "nan" || word == "bad") {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }
  const std::string_view digits = field.starts_with('+') ? field.substr(1) : field;
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool more = error == std::errc{} && end != digits.data() + digits.size() && *end == ' ';
  if (more || field.find(',') != std::string_view::npos) {
    throw InputError(text.place(line, field),
                     fmt::format("{} has a comma within a number, or blanks beside commas; write "
                                 "decimals after a point and part the heights by one mark",
                                 in_quotes(field)));
  }
  if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value)) {
    throw InputError(text.place(line, field),
                     fmt::format("{} is no height; write a number with its decimals after a point, "
                                 "or nan, bad or nothing for a point that was not measured",
                                 in_quotes(field)));
  }
  return value * factor;
}

}  // namespace shellback::app
