#pragma once
/// Which ways to solve a scene the chart compares: a star around the default, and the grids.
#include <array>
#include <string>
#include <vector>

#include "bearing/case.hpp"

namespace shellback::validation {

/// What a point varies; the rest is as in the default.
enum class ChartFamily {
  grid,
  extrapolated,  ///< the same grids, led on to fine ones by those of their bars
  nodes,
  layers,
  mean,
  tier,
  cavitation,
  elastic,
  steps,
  automatic
};

struct ChartSetting {
  ChartFamily family = ChartFamily::grid;
  std::string mark;  ///< short, for the picture: "200", "FB"
  bearing::Tier tier = bearing::Tier::isothermal;
  std::array<int, 2> grid{200, 25};
  int film_nodes = 5;
  bearing::Methods methods;
  double tolerance = 0.0;  ///< of tier `auto`, or of a cycle's steps in time; 0: the case's [-]
};

/// The grids of a chart.
struct ChartGrids {
  std::vector<std::array<int, 2>> ladder{{48, 7}, {100, 13}, {200, 25}, {400, 50}};
  /// On which tiers and methods are compared; the first is that of the nodal sets too.
  std::vector<std::array<int, 2>> compared{{200, 25}, {100, 13}};
  /// Of the reference: each twice as fine as the one before.
  std::array<std::array<int, 2>, 3> reference{{{200, 25}, {400, 50}, {800, 100}}};
};
[[nodiscard]] ChartGrids quick_grids();
/// The same for load cycles, of which each instant is a solve.
[[nodiscard]] ChartGrids cycle_grids();
[[nodiscard]] ChartGrids quick_cycle_grids();

/// The settings that make sense for the case, whose own tier is the richest. Methods to compare
/// with know no time: a load cycle is charted over grids, steps, nodes and tiers.
[[nodiscard]] std::vector<ChartSetting> chart_settings(const bearing::Case& c,
                                                       const ChartGrids& grids);

/// The case as a setting has it.
[[nodiscard]] bearing::Case with_setting(const bearing::Case& c, const ChartSetting& setting);

[[nodiscard]] const char* to_string(ChartFamily family);

}  // namespace shellback::validation
