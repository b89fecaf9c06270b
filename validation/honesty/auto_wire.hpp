#pragma once
/// A trial of tier auto as JSON: between processes, and for other programs.
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "validation/honesty/auto_record.hpp"

namespace shellback::validation {

[[nodiscard]] nlohmann::ordered_json trial_json(const AutoTrial& trial);

[[nodiscard]] std::string to_text(const AutoTrial& trial);
/// Throws nlohmann::json::exception for other texts.
[[nodiscard]] AutoTrial auto_trial_from(const std::string& text);

}  // namespace shellback::validation
