#pragma once
/// Words of warnings and assumptions that have no numbers.
#include <string>

#include "bearing/note.hpp"

namespace shellback::app {

[[nodiscard]] std::string plain_words(bearing::note::Plain note);

}  // namespace shellback::app
