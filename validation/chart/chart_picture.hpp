#pragma once
/// A chart as one picture: a column per scene, a row per quantity, error over wall time.
#include <string>
#include <vector>

#include "validation/chart/chart.hpp"

namespace shellback::validation {

/// A complete SVG file. Marks tell the methods by shape, colour and word; the dotted stairs are
/// the Pareto front, the grey band is the reference's own uncertainty, crosses at the upper rim
/// are solves that failed. Where tiers and methods are compared on two grids, the finer is drawn.
[[nodiscard]] std::string chart_svg(const std::vector<ChartScene>& scenes);

}  // namespace shellback::validation
