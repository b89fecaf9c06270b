#pragma once
/// The film over a load cycle, frame by frame, for a page that shows one after another.
#include <string>
#include <vector>

#include "bearing/over_time/cycle.hpp"

namespace shellback::app {

/// Inline SVG whose groups of class `frame` are the frames: pressure on the unrolled bearing, the
/// journal on its path, what the instant is. The first is also of class `now`. Fields are thinned
/// out and frames left out evenly until all of it takes at most `most_bytes`. Empty: no frames.
[[nodiscard]] std::string animation_svg(const bearing::Case& c, const bearing::CycleResult& cycle,
                                        std::size_t most_bytes = 2'000'000);

}  // namespace shellback::app
