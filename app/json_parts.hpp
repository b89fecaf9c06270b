#pragma once
/// What our JSON files have in common.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bearing/result.hpp"

namespace shellback::app::json_parts {

using Json = nlohmann::ordered_json;

/// There is no NaN in JSON: null, and what is no number is read as one.
[[nodiscard]] Json number(double value);
[[nodiscard]] double number_from(const Json& json);

/// {value, unit}. Inside angles are radians; the contract of the file is degrees.
[[nodiscard]] Json with_unit(double value, const std::string& unit);

/// status, converged, and if it is not good reason, place and cure.
void add_status(Json& json, const Verdict& verdict);

[[nodiscard]] Json cost_json(const bearing::Cost& k);
[[nodiscard]] Json effects_json(const std::vector<bearing::Effect>& effects);
[[nodiscard]] Json limiters_json(const std::vector<bearing::LimiterCount>& limiters);
[[nodiscard]] Json provenance_json(const bearing::Case& c);

/// What was asked for, whether the bars are within it, and the command that is expected to meet it.
[[nodiscard]] Json tolerance_json(const bearing::Case& c, const bearing::Result& result);

/// `entry` gets what is known of the bars of a quantity, in its own unit.
void add_bars(Json& entry, const bearing::Quantity& q);

/// How a result was found and what it is of: from status to title.
void add_head(Json& json, const bearing::Case& c, const bearing::Result& result);

/// What it says of itself: limiters, warnings, assumptions, grid and cost.
void add_notes(Json& json, const bearing::Result& result);

/// The case as solved, and what the command line changed in the file.
void add_case(Json& json, const bearing::Case& c);

/// Text from elsewhere may hold broken UTF-8; it is shown with replacement characters.
[[nodiscard]] std::string dump(const Json& json);

}  // namespace shellback::app::json_parts
