#pragma once
/// The look of our pages: one style sheet, light and dark after the reader's setting.
namespace shellback::app {

/// Content of the page's style element. Defines the variables that page_theme() (svg.hpp) uses.
[[nodiscard]] const char* page_style();

}  // namespace shellback::app
