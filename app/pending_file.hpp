#pragma once
/// A file that appears under its name only when it is complete.
#include <string>
#include <string_view>

namespace shellback::app {

/// Owns a temporary file beside `path`; `commit()` moves it to `path`, the destructor removes it
/// if that has not happened. A failed write therefore never leaves a broken file behind, nor
/// destroys an older good one.
class PendingFile {
 public:
  explicit PendingFile(std::string path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Where to write meanwhile.
  [[nodiscard]] const std::string& temporary() const { return temporary_; }
  /// Throws FileError if the file cannot be moved into place.
  void commit();

 private:
  std::string path_;
  std::string temporary_;
};

/// Writes `text` to `path` through a PendingFile. Throws FileError.
void write_file(const std::string& path, std::string_view text);

}  // namespace shellback::app
