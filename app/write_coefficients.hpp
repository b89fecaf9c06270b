#pragma once
/// Stiffness, damping and whirl threshold, for people and for rotordynamics programs.
#include <iosfwd>
#include <string>
#include <vector>

#include "bearing/result.hpp"

namespace shellback::app {

/// The block of the result table. Prints nothing if there are no coefficients.
void print_coefficients(std::ostream& out, const bearing::Result& result);

/// A table with a header line and a row a speed, rising:
///   frequency,kxx,kxy,kyx,kyy,cxx,cxy,cyx,cyy
/// speed in rad/s, N/m, N s/m, in the fixed frame (X right, Y up). Column names and units are those
/// that ROSS takes for a bearing (ross/utils.py, read_table_file). Negative speeds are kept.
[[nodiscard]] std::string coefficients_csv(std::vector<bearing::Coefficients> at_speeds);

}  // namespace shellback::app
