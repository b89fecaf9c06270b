#pragma once
/// A file that appears under its name only when it is complete.
#include <csignal>
#include <string>
#include <string_view>

namespace shellback::app {

/// SIGINT and SIGTERM wait while the object lives.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_{};
};

/// Owns a temporary file beside `path`; `commit()` moves it to `path`, the destructor removes it
/// if that has not happened. A failed write therefore never leaves a broken file behind, nor
/// destroys an older good one; nor does an interrupt, which waits meanwhile. A symbolic link stays
/// one: what it leads to is replaced. All throw FileError.
class PendingFile {
 public:
  explicit PendingFile(const std::string& path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  void write(std::string_view bytes);
  /// On the disk, not only on its way there, before the older file goes.
  void commit();

 private:
  SignalsHeld held_;
  std::string path_;    ///< as the user wrote it
  std::string target_;  ///< with links followed
  std::string temporary_;
  int descriptor_ = -1;
};

/// Writes `bytes` to `path` through a PendingFile; to a device, a pipe or standard output straight.
/// Throws FileError.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace shellback::app
