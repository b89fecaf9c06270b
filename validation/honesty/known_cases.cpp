#include "validation/honesty/known_cases.hpp"

#include <algorithm>

#include "app/reading/library.hpp"

namespace shellback::validation {

namespace fs = std::filesystem;

std::vector<fs::path> known_cases() {
  std::vector<fs::path> files;
  for (const std::string& name : app::shipped_cases()) files.push_back(app::case_path(name));
  for (const auto& folder : fs::directory_iterator(app::library_root() / "validation")) {
    if (!folder.is_directory() || folder.path().filename() == "stress") continue;
    for (const auto& file : fs::directory_iterator(folder.path())) {
      const fs::path& p = file.path();
      if (p.extension() == ".toml" && p.filename() != "entry.toml") files.push_back(p);
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace shellback::validation
