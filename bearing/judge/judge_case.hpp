#pragma once
/// Whether a case can be solved: numbers that can be computed with, geometry that can exist, data
/// that suffice.
///
/// Absurd input (a clearance of a tenth of the radius, a groove wider than the bearing) is refused;
/// possible but unusual input is told. The limits are those of journal bearings as built
/// (case_limits.hpp). Keys are those of a case file, whoever filled the case: app/reading/read_case
/// adds file and line.
#include <optional>
#include <string>
#include <vector>

#include "bearing/case.hpp"
#include "bearing/finding.hpp"

namespace shellback::bearing {

/// All findings, those of the tiers last. Where a value cannot be computed with, what follows from
/// it is not judged.
[[nodiscard]] std::vector<Finding> judge(const Case& c, const std::vector<Tier>& tiers);

/// In the tier of the case.
[[nodiscard]] std::vector<Finding> judge(const Case& c);

/// Throws InputError with key, problem and cure of the first refusal, if there is one.
void expect_solvable(const Case& c);

/// What the tier needs and the case does not hold.
[[nodiscard]] std::optional<Finding> lack_for(const Case& c, Tier tier);

/// Tiers whose data the case holds, cheapest first; tiers `estimate` and `auto` are left out.
[[nodiscard]] std::vector<Tier> possible_tiers(const Case& c);

}  // namespace shellback::bearing
