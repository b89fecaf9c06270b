#pragma once
/// What the commands share: options to overrides, messages, exit codes.
#include <string>
#include <vector>

#include "app/program/request.hpp"
#include "app/progress.hpp"
#include "app/reading/overrides.hpp"
#include "app/reading/units.hpp"
#include "bearing/case.hpp"
#include "bearing/control.hpp"
#include "bearing/result.hpp"

namespace shellback::program {

/// --set and --tier as overrides of the case file. Throws InputError.
[[nodiscard]] std::vector<app::Override> overrides_of(const Request& request);

/// What an option says, for example --until "20 min", in SI. Throws InputError.
[[nodiscard]] double given(const std::string& option, const std::string& text,
                           const app::Kind& kind);

/// Stiffness and damping are those of a steady state. Throws InputError if they are asked for;
/// `instead` says what is solved in its place.
void expect_no_coefficients(const Request& request, const bearing::Case& subject,
                            const std::string& instead);

/// The case's warnings, on standard error.
void tell_warnings(const bearing::Case& subject);

[[nodiscard]] int code_of(const Verdict& verdict);
/// Of two: a defect of the program is not hidden by what was not found.
[[nodiscard]] int worse_code(int a, int b);
/// The same of a result whose error bars were cut off: what is finished is kept, but it was
/// interrupted.
[[nodiscard]] int code_of(const Verdict& verdict, const std::vector<bearing::Note>& warnings);

/// Why there is no result, on standard error.
void tell_verdict(bearing::Tier tier, const Verdict& verdict);
void tell_verdict(const bearing::Result& result);
/// How a run in time has ended: why, where in the film, and what to try.
void tell_end(const char* run, const std::string& why, const Verdict& verdict);

/// Progress on `line`, Ctrl-C and SIGTERM caught. The line must outlive the solve.
[[nodiscard]] bearing::SolveControl control_for(app::ProgressLine& line);

}  // namespace shellback::program
