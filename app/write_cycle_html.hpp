#pragma once
/// A load cycle as one page that needs nothing else: no network, no other file.
#include <string>

#include "bearing/over_time/cycle.hpp"

namespace shellback::app {

/// Quantities, pictures, the film as an animation (by a script within the page; without one the
/// first frame shows), provenance. Below 3 MB.
[[nodiscard]] std::string cycle_html(const bearing::Case& c, const bearing::CycleResult& cycle);

}  // namespace shellback::app
