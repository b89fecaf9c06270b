#pragma once
/// A chart as a table of numbers.
#include <string>
#include <vector>

#include "validation/chart/chart.hpp"

namespace shellback::validation {

/// One line per point, after one line per scene (family "reference") that has the reference's
/// values and, as errors, its uncertainties. SI units, named in the heading.
[[nodiscard]] std::string chart_csv(const std::vector<ChartScene>& scenes);

}  // namespace shellback::validation
