#pragma once
/// Identified keys drawn.
#include <string>

#include "app/labels/identify_words.hpp"

namespace shellback::app {

/// Measured points with their deviations, computed curves at the start (dashed) and fitted.
[[nodiscard]] std::string identify_svg(const IdentifyView& v);

}  // namespace shellback::app
