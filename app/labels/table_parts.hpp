#pragma once
/// What our tables for the terminal have in common.
#include <iosfwd>
#include <string>
#include <vector>

#include "bearing/result.hpp"

namespace shellback::app {

/// "2.1e-13", or "n/a" if it does not apply.
[[nodiscard]] std::string audit_figure(double value);

/// Status, reason, place and cure of a result that did not converge; `meaning`: what its numbers
/// are. Nothing of one that did.
void print_failure(
    std::ostream& out, const std::string& name, const bearing::Result& result,
    const std::string& meaning = "The numbers are those of the last iterate, not a result.");

/// Nothing if there are no lines.
void print_list(std::ostream& out, const char* heading, const std::vector<std::string>& lines);

void print_limiters(std::ostream& out, const std::vector<bearing::Result>& results);
void print_cost(std::ostream& out, const bearing::Result& result);

/// What was solved: bearing, operating point, overrides.
void print_scene(std::ostream& out, const bearing::Case& c);

}  // namespace shellback::app
