#pragma once
/// A comparison as one page that needs nothing else: no network, no script, no other file.
#include <string>

#include "bearing/result.hpp"

namespace shellback::app {

/// The page as text. Works for one result as well as for several, and for tiers without
/// temperature fields; results that did not converge are announced at the top and marked in
/// every table and map.
[[nodiscard]] std::string comparison_html(const bearing::Case& c,
                                          const bearing::Comparison& comparison);

}  // namespace shellback::app
