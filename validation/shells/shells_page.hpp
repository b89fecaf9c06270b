#pragma once
/// The study of the shells as a page, as JSON and as lines of text.
#include <iosfwd>
#include <string>

#include "validation/shells/shells_study.hpp"

namespace shellback::validation {

/// Pressures and friction power over the cycle of all shells.
[[nodiscard]] std::string shell_curves(const ShellsStudy& study);
/// Friction power, surface temperature and heat into the shell on the unrolled bearing.
[[nodiscard]] std::string shell_maps(const ShellsStudy& study);
/// Highest load over speed, with and without temperatures, of the new and of the run-in shells.
[[nodiscard]] std::string capability_figures(const ShellsStudy& study);

/// One page (HTML).
[[nodiscard]] std::string shells_page(const ShellsStudy& study);
/// Every number (JSON).
[[nodiscard]] std::string shells_json(const ShellsStudy& study);
/// The tables, for a terminal.
void write_shells_tables(std::ostream& out, const ShellsStudy& study);

}  // namespace shellback::validation
