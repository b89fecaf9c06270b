#pragma once
/// A load cycle as a table for the terminal.
#include <iosfwd>

#include "bearing/over_time/cycle.hpp"

namespace shellback::app {

/// Scene and status, then means and extremes with their bars and the instant of each extreme, how
/// the cycle was run, audit, limiters that acted, warnings, assumptions, cost.
void write_cycle_table(std::ostream& out, const bearing::Case& c,
                       const bearing::CycleResult& cycle);

}  // namespace shellback::app
