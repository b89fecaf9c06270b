#pragma once
/// What the values of a case are to one another: geometry that can exist, data that suffice.
///
/// Absurd input (a clearance of a tenth of the radius, a groove wider than the bearing) throws
/// InputError; possible but unusual input becomes a warning in the case. The limits are those
/// of journal bearings as built, with a wide margin; each is named in judge_case.cpp.
#include "app/toml_reader.hpp"
#include "coupling/case.hpp"

namespace shellback::app {

/// Judges the case as read; `reader` knows the places. Appends to `Case::warnings`.
void judge_case(coupling::Case& subject, const Reader& reader);

/// Supplies against bearing and cavitation pressure; part of judge_case.
void judge_supplies(coupling::Case& subject, const Reader& reader);

/// Shell, housing and shaft against the bearing; part of judge_case.
void judge_solids(coupling::Case& subject, const Reader& reader);

/// Throws InputError unless the case holds the data that the tier needs.
void expect_possible(const coupling::Case& subject, coupling::Tier tier, const Reader& reader);

/// Tiers whose data the case holds, cheapest first.
[[nodiscard]] std::vector<coupling::Tier> possible_tiers(const coupling::Case& subject);

/// Error at the place of the key.
[[noreturn]] void refuse(const Reader& reader, const std::string& key, const std::string& problem);

/// Warning with the place of the key.
void warn(coupling::Case& subject, const Reader& reader, const std::string& key,
          const std::string& problem);

}  // namespace shellback::app
