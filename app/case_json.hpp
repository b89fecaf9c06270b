#pragma once
/// The case as it was solved, after overrides and defaults.
#include <nlohmann/json_fwd.hpp>

#include "bearing/case.hpp"

namespace shellback::app {

/// Sections and keys as in the case file; every number as {"value", "unit"}, SI, kelvin, angles in
/// degrees. Laws of the oil carry their parameters in the units of rheology/oil.hpp. Paths of
/// profiles are not repeated: a profile is told by its number of points.
[[nodiscard]] nlohmann::ordered_json case_json(const bearing::Case& c);

/// What the command line changed: keys with the values as given.
[[nodiscard]] nlohmann::ordered_json changes_json(const bearing::Case& c);

}  // namespace shellback::app
