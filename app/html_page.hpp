#pragma once
/// What encloses our pages: head with title and scene, sections, provenance at the foot.
#include <functional>
#include <string>
#include <vector>

#include "app/pictures/svg.hpp"
#include "app/provenance.hpp"
#include "bearing/case.hpp"

namespace shellback::app {

/// Up to the scene, a line each (empty ones are left out); `kind` of page: "comparison", "result".
[[nodiscard]] std::string page_head(const std::string& title, const std::vector<std::string>& scene,
                                    const std::string& kind);
[[nodiscard]] std::string page_head(const bearing::Case& c, const std::string& kind);

inline constexpr double kColumnWidth = 580.0;  ///< of a figure in a column [px]

/// A picture in the text, drawn into a box that leaves room for the title of an upright axis;
/// `label` is read aloud. [px]
[[nodiscard]] std::string figure_html(double width, double height, const std::string& label,
                                      const std::string& caption,
                                      const std::function<void(Svg&, const Box&)>& draw);

/// Figures side by side where there is room; empty if there are none.
[[nodiscard]] std::string figures_html(const std::string& figures, const char* kind = "figures");

/// Empty if there is no content.
[[nodiscard]] std::string page_section(const std::string& heading, const std::string& content);

/// Provenance, and the end.
[[nodiscard]] std::string page_foot(const bearing::Case& c);
[[nodiscard]] std::string page_foot(const Provenance& origin, const std::string& verbatim);

}  // namespace shellback::app
