#pragma once
/// Words of warnings and assumptions.
#include <string>
#include <vector>

#include "bearing/note.hpp"

namespace shellback::app {

[[nodiscard]] std::string words_of(const bearing::Note& note);
[[nodiscard]] std::vector<std::string> words_of(const std::vector<bearing::Note>& notes);

}  // namespace shellback::app
