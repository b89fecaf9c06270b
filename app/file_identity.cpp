#include "app/file_identity.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <iostream>

namespace shellback::app {

namespace fs = std::filesystem;

fs::path target_of(const std::string& path) {
  constexpr int kMostLinks = 40;  // in a row; the kernel's own limit (path_resolution(7))
  std::error_code error;
  fs::path target = fs::absolute(path);
  for (int k = 0; k < kMostLinks && fs::is_symlink(target, error); ++k) {
    target = target.parent_path() / fs::read_symlink(target, error);
  }
  // As the system goes there: through a folder that is not there no way leads back ("nosuch/../x").
  const fs::path folder = fs::canonical(target.parent_path(), error);
  return error ? target : folder / target.filename();
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  const bool same = fs::equivalent(a, b, error);
  return error ? target_of(a) == target_of(b) : same;
}

std::ostream* own_stream(const std::string& path) {
  struct stat file {};
  if (::stat(path.c_str(), &file) != 0) return nullptr;
  const auto is_open_as = [&file](int descriptor) {
    struct stat open {};
    return ::fstat(descriptor, &open) == 0 && open.st_dev == file.st_dev &&
           open.st_ino == file.st_ino;
  };
  if (is_open_as(STDOUT_FILENO)) return &std::cout;
  return is_open_as(STDERR_FILENO) ? &std::cerr : nullptr;
}

bool is_stream(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status) || fs::is_directory(status)) return false;
  return !fs::is_regular_file(status) || own_stream(path) != nullptr;
}

}  // namespace shellback::app
