#pragma once
/// A small check of HTML and SVG text: every element that opens also closes, in order.
#include <string>

namespace shellback::test {

/// Empty if all tags balance, else what is wrong. Void HTML elements need not close.
[[nodiscard]] std::string unbalanced_tag(const std::string& markup);

/// Occurrences of `part` in `text`.
[[nodiscard]] int count(const std::string& text, const std::string& part);

/// Content of a file; empty if there is none.
[[nodiscard]] std::string file_text(const std::string& path);

}  // namespace shellback::test
