#include "app/result_mark.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <regex>
#include <sstream>
#include <string_view>

#include "app/hdf5_parts.hpp"
#include "app/provenance_stamp.hpp"

namespace shellback::app {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kJsonBegin = "{\n  \"generator\": \"Shellback ";
constexpr std::string_view kCommentBegin = "<!-- Shellback ";
constexpr std::string_view kXmlBegin = "<?xml version=\"1.0\"?>\n<!--";
constexpr std::string_view kPageBegin = "<!DOCTYPE html>";
constexpr std::string_view kPageMark = "<p class=\"kicker\">Shellback ";
constexpr std::string_view kColumn = ",shellback";
constexpr std::string_view kPngMark = "tEXtSoftware\0Shellback "sv;
constexpr std::string_view kHdf5Begin = "\x89HDF\r\n\x1a\n";  // signature of the format

/// Signature and header chunk of a PNG file (ISO/IEC 15948, 5.2 and 11.2.2) [B]
constexpr std::size_t kPngHead = 8 + 25;

/// A new last column: its name in the header, the version in every row; comments ("# ...") stay. A
/// line ends where no quote is open.
std::string with_column(const std::string& table) {
  std::string out;
  bool quoted = false;
  bool header = true;
  bool comment = table.starts_with('#');
  for (std::size_t k = 0; k < table.size(); ++k) {
    const char c = table[k];
    if (c == '"' && !comment) quoted = !quoted;
    const bool ends = c == '\n' && !quoted;
    if (ends && !comment) {
      out += header ? std::string(kColumn) : fmt::format(",{}", kVersion);
      header = false;
    }
    if (ends) comment = k + 1 < table.size() && table[k + 1] == '#';
    out += c;
  }
  return out;
}

std::string big_endian(std::uint32_t x) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((x >> shift) & 0xFFU);
  return bytes;
}

/// Checksum of a PNG chunk, bit by bit (ISO/IEC 15948, annex D).
std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0U ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

std::string with_text_chunk(std::string png) {
  constexpr std::size_t kName = 4;  // of the chunk, not counted in its length [B]
  const std::string chunk = std::string(kPngMark) + kVersion;
  const auto length = static_cast<std::uint32_t>(chunk.size() - kName);
  return png.insert(kPngHead, big_endian(length) + chunk + big_endian(crc32(chunk)));
}

/// The begin of the file, as far as any mark reaches.
std::string begin_of(const std::string& path) {
  constexpr std::size_t kFarthest = 100'000;  // pages carry their style first, some 10 kB [B]
  std::string text(kFarthest, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

bool is_coefficient_table(const std::string& text) {
  static const std::regex row("-?[0-9.]+(e[+-][0-9]+)?(,-?[0-9]\\.[0-9]{8}e[+-][0-9]{2,3}){8}");
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  if (line != "frequency,kxx,kxy,kyx,kyy,cxx,cxy,cyx,cyy") return false;
  bool any = false;
  while (std::getline(lines, line)) {
    if (lines.eof() && any) return true;  // the last one may be cut off
    if (!std::regex_match(line, row)) return false;
    any = true;
  }
  return any;
}

}  // namespace

std::string marked(Format format, std::string content) {
  switch (format) {
    case Format::json:
      return content.replace(content.find('{'), 1, fmt::format("{}{}\",", kJsonBegin, kVersion));
    case Format::csv:
      return with_column(content);
    case Format::svg:
    case Format::markdown:
      return fmt::format("{}{} -->\n", kCommentBegin, kVersion) + content;
    case Format::vtk:  // an XML declaration stands first
      return content.insert(content.find('\n') + 1,
                            fmt::format("{}{} -->\n", kCommentBegin, kVersion));
    case Format::png:
      return with_text_chunk(std::move(content));
    case Format::hdf5:
    case Format::html:
    case Format::coefficients:
    case Format::toml:
      break;
  }
  return content;
}

bool is_result(const std::string& path) {
  const std::string text = begin_of(path);
  if (text.starts_with(kHdf5Begin)) return hdf5::format_of(path).starts_with("shellback ");
  if (text.starts_with(kJsonBegin) || text.starts_with(kCommentBegin)) return true;
  const std::size_t second_line = text.find('\n') + 1;
  if (text.starts_with(kXmlBegin)) return text.find(kCommentBegin) == second_line;
  if (text.starts_with(kPageBegin)) return text.find(kPageMark) != std::string::npos;
  constexpr std::size_t kLength = 4;  // of a chunk, before its name [B]
  if (text.find(kPngMark) == kPngHead + kLength) return true;
  std::string_view table = text;  // behind its comments
  while (table.starts_with('#') && table.find('\n') != std::string_view::npos) {
    table.remove_prefix(table.find('\n') + 1);
  }
  return table.substr(0, table.find('\n')).ends_with(kColumn) || is_coefficient_table(text);
}

}  // namespace shellback::app
