#pragma once
/// What encloses our pages: head with title and scene, sections, provenance at the foot.
#include <string>

#include "bearing/case.hpp"

namespace shellback::app {

/// Up to the scene; `kind` of page: "comparison", "result", ...
[[nodiscard]] std::string page_head(const bearing::Case& c, const std::string& kind);

/// Empty if there is no content.
[[nodiscard]] std::string page_section(const std::string& heading, const std::string& content);

/// Provenance, and the end.
[[nodiscard]] std::string page_foot(const bearing::Case& c);

}  // namespace shellback::app
