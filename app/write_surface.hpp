#pragma once
/// What `shellback surface` found, as a table, as JSON and as the table of factors for a case.
#include <iosfwd>
#include <string>

#include "app/reading/surface_report.hpp"

namespace shellback::app {

void write_surface_table(std::ostream& out, const SurfaceReport& report);

/// SI values with their units beside them, angles in degrees.
[[nodiscard]] std::string surface_json(const SurfaceReport& report);

/// What surfaces.flow_factors of a case takes: sigma and factors of the gaps that are open. Throws
/// InputError if a case could not take them (fluid::fault_of).
[[nodiscard]] std::string surface_csv(const SurfaceReport& report);

}  // namespace shellback::app
