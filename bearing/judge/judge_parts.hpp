#pragma once
/// The parts of judge(), in their order; each adds what it finds.
#include <string>

#include "bearing/case.hpp"
#include "bearing/case_limits.hpp"
#include "bearing/finding.hpp"

namespace shellback::bearing {

/// Refuses or suspects a number; `what` tells number and meaning, `cure` what to check.
void compare(Findings& to, const std::string& key, double value, const Limits& limits,
             const std::string& what, const std::string& cure);

/// Every value on its own: finite, in its range. The parts below rely on it.
void judge_values(const Case& c, Findings& to);
/// The laws' parameters; part of judge_values.
void judge_law_values(const rheology::Oil& oil, Findings& to);
/// Walls; part of judge_values.
void judge_solid_values(const Case& c, Findings& to);

/// Rows, period, mass and step of a load cycle; part of judge_values.
void judge_cycle_values(const LoadCycle& cycle, Findings& to);

/// Profile, shape, wear, edge relief and chamfer of the bore.
void judge_bore(const Bearing& b, Findings& to);
/// The cycle's load and speed against the bearing; a load that vanishes needs a mass.
void judge_cycle(const Case& c, Findings& to);
/// Supplies against bearing, cavitation pressure and one another.
void judge_supplies(const Case& c, Findings& to);
/// The laws of the oil, and the temperatures at which it is used.
void judge_oil(const Case& c, Findings& to);
/// Shell, housing and shaft against the bearing, in the tiers that are to be solved.
void judge_solids(const Case& c, const std::vector<Tier>& tiers, Findings& to);

}  // namespace shellback::bearing
