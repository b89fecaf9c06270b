#pragma once
/// The scenes that come with the chart: case files in validation/chart/ and cases/ of the library.
#include <string>
#include <vector>

#include "bearing/case.hpp"

namespace shellback::validation {

/// Their names in the order in which the chart shows them, from the simplest to the hardest.
[[nodiscard]] std::vector<std::string> chart_scene_names();

/// A shipped scene by name, or any case file by its path (it ends in .toml). Throws InputError for
/// an unknown name and for anything wrong in the file, FileError if it cannot be read.
[[nodiscard]] bearing::Case chart_case(const std::string& name_or_path);

}  // namespace shellback::validation
