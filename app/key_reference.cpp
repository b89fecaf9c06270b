#include "app/key_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "app/reading/did_you_mean.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

constexpr std::size_t kWidest = 92;  ///< columns of a line on a terminal

/// Without the signs of Markdown: code, emphasis, links by their words.
std::string plain(std::string text) {
  static const std::regex link("\\[([^\\]]*)\\]\\([^)]*\\)");
  text = std::regex_replace(text, link, "$1");
  std::erase(text, '`');
  const auto blank = [](char c) { return c == ' '; };
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), blank));
  text.erase(std::find_if_not(text.rbegin(), text.rend(), blank).base(), text.end());
  return text;
}

/// `text` in lines that begin with `indent` blanks.
std::string in_lines(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string out, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > kWidest) {
      out += std::string(indent, ' ') + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? out : out + std::string(indent, ' ') + line + "\n";
}

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream in(row.substr(1));
  for (std::string cell; std::getline(in, cell, '|');) cells.push_back(plain(cell));
  return cells;
}

/// A row of a table: key, example, meaning, default.
std::string entry_of(const std::vector<std::string>& cells) {
  constexpr std::size_t kColumns = 4;
  if (cells.size() < kColumns) return "";
  const bool one = cells[0].find_first_of(", ") == std::string::npos;  // else: examples of several
  const std::string& example = cells[1];
  std::string head = cells[0];
  if (!example.empty()) head += (one ? " = " : " for example ") + example;
  std::string told = cells[2];
  const std::string& by_default = cells[3];
  if (by_default.starts_with("-")) {
    told += fmt::format("{}must be given{}", told.empty() ? "" : "; ", by_default.substr(1));
  } else if (!by_default.empty()) {
    told += fmt::format("{}(default: {})", told.empty() ? "" : " ", by_default);
  }
  return in_lines(head, 2) + in_lines(told, 6);
}

struct Part {
  std::vector<std::string> names;  ///< empty: before the first heading
  std::string heading;
  std::vector<std::string> lines;
};

std::vector<Part> parts_of(const std::string& page) {
  static const std::regex name("`\\[+([a-z_]+)\\]+`");
  std::vector<Part> parts{{}};
  std::istringstream in(page);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("# ")) continue;
    if (!line.starts_with("## ")) {
      parts.back().lines.push_back(line);
      continue;
    }
    parts.push_back({{}, plain(line.substr(3)), {}});
    for (std::sregex_iterator k(line.begin(), line.end(), name), end; k != end; ++k) {
      parts.back().names.push_back((*k)[1]);
    }
  }
  return parts;
}

/// Tables as entries, the rest as paragraphs.
std::string text_of(const Part& part) {
  std::string out = part.heading.empty() ? "" : part.heading + "\n\n";
  std::string paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) out += in_lines(plain(paragraph), 2) + "\n";
    paragraph.clear();
  };
  bool in_table = false;
  for (const std::string& line : part.lines) {
    const bool row = line.starts_with("|");
    if (in_table && !row) out += "\n";
    if (!row) {
      if (line.empty()) end_paragraph();
      paragraph += line + " ";
      if (paragraph == " ") paragraph.clear();
    } else if (in_table && !line.starts_with("|---")) {
      out += entry_of(cells_of(line));
    } else if (!in_table) {
      end_paragraph();
      const std::string head = cells_of(line).front();
      if (head != "key") out += "  " + head + "\n";
    }
    in_table = row;
  }
  end_paragraph();
  while (out.ends_with("\n\n")) out.pop_back();
  return out;
}

}  // namespace

std::vector<std::string> sections_of(const std::string& page) {
  std::vector<std::string> names;
  for (const Part& part : parts_of(page)) {
    names.insert(names.end(), part.names.begin(), part.names.end());
  }
  return names;
}

std::string key_reference(const std::string& page, const std::vector<std::string>& sections) {
  const std::vector<std::string> known = sections_of(page);
  for (const std::string& asked : sections) {
    if (std::find(known.begin(), known.end(), asked) != known.end()) continue;
    throw InputError("help keys", fmt::format("a case has no section \"{}\"{}", asked,
                                              choices_for(asked, known, "it has")));
  }
  std::string out;
  for (const Part& part : parts_of(page)) {
    const bool asked = sections.empty() ||
                       std::any_of(part.names.begin(), part.names.end(), [&](const auto& name) {
                         return std::find(sections.begin(), sections.end(), name) != sections.end();
                       });
    if (asked) out += (out.empty() ? "" : "\n") + text_of(part);
  }
  return out;
}

}  // namespace shellback::app
