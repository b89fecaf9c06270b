#pragma once
/// Words of warnings and assumptions.
#include <string>
#include <vector>

#include "bearing/note.hpp"

namespace shellback::app {

/// "within 2.5 %" of a bar over its value [-]; of one that is not known "without a bar".
[[nodiscard]] std::string known_within(double part);
[[nodiscard]] std::string words_of(const bearing::Note& note);
[[nodiscard]] std::vector<std::string> words_of(const std::vector<bearing::Note>& notes);

}  // namespace shellback::app
