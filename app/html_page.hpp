#pragma once
/// What encloses our pages: head with title and scene, sections, provenance at the foot.
#include <functional>
#include <string>
#include <vector>

#include "app/pictures/svg.hpp"
#include "app/provenance.hpp"
#include "bearing/case.hpp"

namespace shellback::app {

/// What a page begins with, in plain text.
struct PageHead {
  std::string title{};
  std::string heading{};             ///< empty: the title
  std::vector<std::string> scene{};  ///< a line each; empty ones are left out
  std::string kind{};                ///< of page: "comparison", "result"
  std::string style{};               ///< of this page alone (CSS)
};
[[nodiscard]] std::string page_head(const PageHead& head);
[[nodiscard]] std::string page_head(const bearing::Case& c, const std::string& kind);

inline constexpr double kColumnWidth = 580.0;  ///< of a figure in a column [px]

/// A picture in the text, with the words below it; `label` is read aloud.
[[nodiscard]] std::string figure_html(const Svg& svg, const std::string& label,
                                      const std::string& caption);
/// The same, drawn into a box that leaves room for the title of an upright axis [px].
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
