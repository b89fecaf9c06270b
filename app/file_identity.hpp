#pragma once
/// Which file a path means, whatever it is called: `./a`, a symbolic and a hard link are one file.
#include <filesystem>
#include <iosfwd>
#include <string>

namespace shellback::app {

/// Where a write to `path` arrives: symbolic links are followed, also one that leads to a file that
/// is not there yet.
[[nodiscard]] std::filesystem::path target_of(const std::string& path);

/// Whether both mean one file, existing or to come.
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);

/// Standard output or error of this process if `path` means it (/dev/stdout, or the file it was
/// redirected into); else nullptr.
[[nodiscard]] std::ostream* own_stream(const std::string& path);

/// A device, a pipe or a stream of this process: written into, never replaced.
[[nodiscard]] bool is_stream(const std::string& path);

}  // namespace shellback::app
