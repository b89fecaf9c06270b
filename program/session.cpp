#include "program/session.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>

#include "app/read_case.hpp"
#include "core/contract.hpp"

namespace shellback::program {

using namespace app;
using namespace coupling;

std::vector<Override> overrides_of(const Request& request) {
  std::vector<Override> overrides;
  for (const std::string& words : request.set) overrides.push_back(parse_override(words));
  if (!request.tier.empty()) {
    static_cast<void>(tier_named(request.tier, "--tier"));
    overrides.push_back({"model.tier", "\"" + request.tier + "\"", "--tier"});
  }
  if (request.coefficients || !request.coefficients_table.empty()) {
    overrides.push_back({"model.coefficients", "true", "--coefficients"});
  }
  return overrides;
}

void expect_folder(const std::string& path) {
  if (path.empty() || path == "-") return;
  const auto folder = std::filesystem::absolute(path).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw FileError(fmt::format("{}: there is no folder {}", path, folder.string()));
  }
  if (std::filesystem::is_directory(path)) {
    throw FileError(fmt::format("{}: this is a folder; give a file in it", path));
  }
}

void write_text_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw FileError(fmt::format("{}: cannot be written", path));
}

void give_json(const Request& request, const std::string& json) {
  const std::string text = json.ends_with('\n') ? json : json + "\n";
  if (request.json == "-") std::cout << text;
  if (!request.json.empty() && request.json != "-") write_text_file(request.json, text);
}

void tell_warnings(const Case& subject) {
  for (const std::string& warning : subject.warnings) {
    std::cerr << "warning: " << warning << "\n";
  }
}

int code_of(const Verdict& verdict) {
  if (verdict.good()) return kDone;
  if (verdict.status == Status::invalid_number) return kDefect;
  return verdict.status == Status::interrupted ? kInterrupted : kNotConverged;
}

void tell_verdict(const Result& result) {
  const Verdict& verdict = result.verdict;
  if (verdict.good()) return;
  std::cerr << "error: " << to_string(result.tier) << ": " << to_string(verdict.status);
  if (!verdict.reason.empty()) std::cerr << ": " << verdict.reason;
  std::cerr << "\n";
  if (!verdict.place.empty()) std::cerr << "  where: " << verdict.place << "\n";
  if (!verdict.cure.empty()) std::cerr << "  cure:  " << verdict.cure << "\n";
}

SolveControl control_for(ProgressLine& line) {
  SolveControl control;
  control.progress = [&line](const Progress& progress) { line.show(progress); };
  control.stop = &catch_interrupt();
  return control;
}

}  // namespace shellback::program
