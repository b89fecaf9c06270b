#include "app/init.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <vector>

#include "app/file_identity.hpp"
#include "app/output_rules.hpp"
#include "app/pending_file.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/library.hpp"
#include "app/reading/read_case.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

/// The file's first line without its comment mark.
std::string description_of(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  const std::size_t begin = line.find_first_not_of("# ");
  return begin == std::string::npos ? "" : line.substr(begin);
}

/// A file of a shipped case and where its copy goes.
struct Copy {
  std::string target;
  std::string text;
};

/// The tables that the shipped case refers to, to lie beside its copy as they do in the library. A
/// copy that is there already, letter by letter, is left out.
std::vector<Copy> tables_beside(const std::string& text, const std::string& source,
                                const std::string& target) {
  namespace fs = std::filesystem;
  std::vector<Copy> copies;
  if (is_stream(target)) return copies;
  for (const std::string& table : tables_of_case(text, source)) {
    const fs::path beside = fs::path(table).lexically_relative(fs::path(source).parent_path());
    Copy copy{(fs::path(target).parent_path() / beside).string(),
              read_text_file(table, TextKind::table_of_case)};
    if (!fs::exists(copy.target)) {
      copies.push_back(std::move(copy));
    } else if (!fs::is_regular_file(copy.target) ||
               read_text_file(copy.target, TextKind::table_of_case) != copy.text) {
      throw FileError(
          fmt::format("{}: exists already and is left as it is; the case needs a table "
                      "of this name beside it: write it into another folder with -o",
                      copy.target));
    }
  }
  return copies;
}

}  // namespace

void list_cases(std::ostream& out) {
  out << "Cases to start from; \"shellback init NAME\" writes one into this folder:\n\n";
  for (const std::string& name : shipped_cases()) {
    const std::string text = read_text_file(case_path(name).string());
    out << fmt::format("  {:<24} {}\n", name, description_of(text));
  }
}

void write_case(const std::string& name, const std::string& path, std::ostream& out) {
  const std::string source = case_path(name).string();
  const std::string text = read_text_file(source);
  const std::string target = path.empty() ? name + ".toml" : path;
  if (target == "-") {
    throw InputError("-o",
                     "a case is written into a file, beside the tables that it refers to; "
                     "name one in place of -");
  }
  if (std::filesystem::exists(target) && !is_stream(target)) {
    throw FileError(
        fmt::format("{}: exists already and is left as it is; choose another name "
                    "with -o",
                    target));
  }
  expect_sound({{"-o", target, Format::toml}}, {}, false);
  const std::vector<Copy> tables = tables_beside(text, source, target);
  write_file(target, text);
  for (const Copy& table : tables) {
    write_file(table.target, table.text);
    out << table.target << " written, which the case refers to\n";
  }
  out << fmt::format("{} written; next: shellback check {}\n", target, target);
}

}  // namespace shellback::app
