#pragma once
/// A sweep as a table for spreadsheets and scripts.
#include <string>

#include "app/study/sweep.hpp"

namespace shellback::app {

/// One line of names with units, then one line per point, curve after curve: values of the axes in
/// their units, status, tier, grid, start, tries, every quantity (SI, angles in degrees; empty
/// where a point is not solved or its tier does not know it) followed by its error bar where one is
/// known, audit, cost, reason of a failure. Comma-separated, texts quoted where needed (RFC 4180).
[[nodiscard]] std::string sweep_csv(const study::Sweep& sweep);

}  // namespace shellback::app
