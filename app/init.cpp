#include "app/init.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>

#include "app/case_text.hpp"
#include "app/file_identity.hpp"
#include "app/library.hpp"
#include "app/output_rules.hpp"
#include "app/pending_file.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

/// The file's first line without its comment mark.
std::string description_of(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  const std::size_t begin = line.find_first_not_of("# ");
  return begin == std::string::npos ? "" : line.substr(begin);
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
  const std::string text = read_text_file(case_path(name).string());
  const std::string target = path.empty() ? name + ".toml" : path;
  if (std::filesystem::exists(target) && !is_stream(target)) {
    throw FileError(
        fmt::format("{}: exists already and is left as it is; choose another name "
                    "with -o",
                    target));
  }
  expect_sound({{"-o", target, Format::toml}}, {}, false);
  write_file(target, text);
  out << fmt::format("{} written; next: shellback check {}\n", target, target);
}

}  // namespace shellback::app
