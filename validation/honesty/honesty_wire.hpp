#pragma once
/// What one case gave, as text between processes.
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "validation/honesty/honesty_record.hpp"

namespace shellback::validation {

/// A bar as JSON; what is not finite is null.
[[nodiscard]] nlohmann::ordered_json bar_json(const BarSample& s);

[[nodiscard]] std::string to_text(const HonestySubject& subject);
/// Throws nlohmann::json::exception for other texts.
[[nodiscard]] HonestySubject honesty_subject_from(const std::string& text);

}  // namespace shellback::validation
