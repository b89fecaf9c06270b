#pragma once
/// The picture of a sweep: curves over the first numeric axis, or maps over two.
#include <string>
#include <vector>

#include "app/study/sweep.hpp"

namespace shellback::app {

/// Throws InputError unless one of the axes holds numbers, at least two of them.
void expect_drawable(const std::vector<study::Axis>& axes);

/// The picture (1200 x 780, white background) as an SVG document. Up to eight curves are drawn
/// as lines: friction torque with its part from asperities, smallest film (with the film of three
/// roughnesses if the surfaces are rough), temperatures, pressure; with measured values of the case
/// whose operating point lies on a curve. More curves of two numeric axes are drawn as maps of
/// friction torque and smallest film. Points that are not solved are marked and counted, and no
/// value is drawn for them. `text` is that of the case file.
[[nodiscard]] std::string sweep_svg(const std::string& text, const bearing::Case& subject,
                                    const study::Sweep& sweep);

}  // namespace shellback::app
