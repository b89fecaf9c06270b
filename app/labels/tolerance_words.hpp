#pragma once
/// Where error bars exceed what the case asks for (model.tolerance): how far, and a command line
/// that is expected to meet it.
#include <string>
#include <vector>

#include "app/study/sweep.hpp"
#include "bearing/result.hpp"

namespace shellback::app {

/// What is missed and what would help; nothing where the tolerance is met or no bar is known.
struct Missed {
  std::string words;    ///< "friction torque +-3.2 %, smallest film +-5.1 %"
  std::string outlook;  ///< what is to be expected of the command
  std::string command;  ///< "shellback run CASE --set model.grid=\"[480,60]\""; empty: none helps
  [[nodiscard]] explicit operator bool() const { return !words.empty(); }
};

[[nodiscard]] Missed missed_tolerance(const bearing::Case& c, const bearing::Result& result);
[[nodiscard]] Missed missed_tolerance(const bearing::Case& c,
                                      const bearing::Comparison& comparison);
[[nodiscard]] Missed missed_tolerance(const bearing::Case& subject, const study::Sweep& sweep);

/// The lines of a table: the tolerance, what is missed, the command.
[[nodiscard]] std::vector<std::string> tolerance_lines(const bearing::Case& c,
                                                       const Missed& missed);

/// "not determined by these grids: largest film pressure (bars of 3.4 times the value)": pressures,
/// the smallest film and the torque of asperities, if it counts beside the whole, whose bars are
/// larger than they; empty: none, or tier estimate, which has no grid.
[[nodiscard]] std::string undetermined_words(const bearing::Result& result);

}  // namespace shellback::app
