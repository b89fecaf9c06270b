#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace shellback::test {

[[nodiscard]] inline std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace shellback::test
