#pragma once
/// The study as a page, as JSON and on the terminal.
#include <ostream>
#include <string>

#include "validation/rig/rig_study.hpp"

namespace shellback::validation {

/// One HTML file: statements, figures, tables, what was not found, unknowns, assumptions.
[[nodiscard]] std::string rig_page(const RigStudy& study);

/// plan, statements, courses, points, starts, effects of the unknowns, provenance; what was not
/// found has its reason in place of numbers.
[[nodiscard]] std::string rig_json(const RigStudy& study);

/// Torques over speed and the statements.
void write_rig_tables(std::ostream& out, const RigStudy& study);

/// What was not found, one line each: where and why.
[[nodiscard]] std::vector<std::string> rig_failures(const RigStudy& study);

}  // namespace shellback::validation
