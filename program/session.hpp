#pragma once
/// What the commands share: options to overrides, files, messages, exit codes.
#include <string>
#include <vector>

#include "app/overrides.hpp"
#include "app/progress.hpp"
#include "coupling/control.hpp"
#include "coupling/result.hpp"
#include "program/cli.hpp"

namespace shellback::program {

/// --set and --tier as overrides of the case file. Throws InputError.
[[nodiscard]] std::vector<app::Override> overrides_of(const Request& request);

/// Refuses an output file that cannot come about, before the work and not after it (FileError).
/// Empty and "-" pass.
void expect_folder(const std::string& path);

/// Throws FileError if the file cannot be written.
void write_text_file(const std::string& path, const std::string& text);

/// Writes `json` where --json wants it, if it does.
void give_json(const Request& request, const std::string& json);

/// The case's warnings, on standard error.
void tell_warnings(const coupling::Case& subject);

[[nodiscard]] int code_of(const Verdict& verdict);

/// Why there is no result, on standard error.
void tell_verdict(const coupling::Result& result);

/// Progress on `line`, Ctrl-C caught. The line must outlive the solve.
[[nodiscard]] coupling::SolveControl control_for(app::ProgressLine& line);

}  // namespace shellback::program
