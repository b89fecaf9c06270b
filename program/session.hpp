#pragma once
/// What the commands share: options to overrides, messages, exit codes.
#include <string>
#include <vector>

#include "app/overrides.hpp"
#include "app/progress.hpp"
#include "coupling/control.hpp"
#include "coupling/result.hpp"
#include "program/request.hpp"

namespace shellback::program {

/// --set and --tier as overrides of the case file. Throws InputError.
[[nodiscard]] std::vector<app::Override> overrides_of(const Request& request);

/// The case's warnings, on standard error.
void tell_warnings(const coupling::Case& subject);

[[nodiscard]] int code_of(const Verdict& verdict);

/// Why there is no result, on standard error.
void tell_verdict(const coupling::Result& result);

/// Progress on `line`, Ctrl-C and SIGTERM caught. The line must outlive the solve.
[[nodiscard]] coupling::SolveControl control_for(app::ProgressLine& line);

}  // namespace shellback::program
