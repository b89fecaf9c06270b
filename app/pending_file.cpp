#include "app/pending_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ostream>

#include "app/file_identity.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

[[noreturn]] void refuse(const std::string& path, int why) {
  throw FileError(
      fmt::format("cannot write {}: {}; choose another place or name", path, std::strerror(why)));
}

void write_all(int descriptor, std::string_view bytes, const std::string& path) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) refuse(path, errno);
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

/// Creates a file that was not there, in the folder of `target`, and names it in `name`. The name
/// is short, as that of the target may be as long as names can be; the process number keeps runs
/// apart, the count two files of one run and what a killed run of the same number left.
int create_beside(const std::filesystem::path& target, std::string& name) {
  constexpr int kTries = 1000;
  for (int k = 0; k < kTries; ++k) {
    name = target.parent_path() / fmt::format(".shellback-{}-{}.part", ::getpid(), k);
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

/// Into a device or pipe there is nothing to replace.
void write_into(const std::string& path, std::string_view bytes) {
  if (std::ostream* stream = own_stream(path); stream != nullptr) {
    stream->write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    if (!*stream) refuse(path, errno != 0 ? errno : EIO);
    return;
  }
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) refuse(path, errno);
  try {
    write_all(descriptor, bytes, path);
  } catch (const FileError&) {
    ::close(descriptor);
    throw;
  }
  if (::close(descriptor) != 0) refuse(path, errno);
}

}  // namespace

SignalsHeld::SignalsHeld() {
  sigset_t held;
  sigemptyset(&held);
  sigaddset(&held, SIGINT);
  sigaddset(&held, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &held, &before_);
}

SignalsHeld::~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

PendingFile::PendingFile(const std::string& path) : path_(path), target_(target_of(path)) {
  descriptor_ = create_beside(target_, temporary_);
  if (descriptor_ < 0) refuse(path_, errno);
  struct stat older {};
  if (::stat(target_.c_str(), &older) == 0) ::fchmod(descriptor_, older.st_mode & 07777U);
}

PendingFile::~PendingFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());  // a destructor can tell nobody
}

void PendingFile::write(std::string_view bytes) { write_all(descriptor_, bytes, path_); }

void PendingFile::commit() {
  // Some file systems cannot synchronise and say EINVAL (fsync(2)); they have done what they can.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) refuse(path_, errno);
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) refuse(path_, errno);
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) refuse(path_, errno);
  temporary_.clear();
}

void write_file(const std::string& path, std::string_view bytes) {
  if (is_stream(path)) {
    write_into(path, bytes);
    return;
  }
  PendingFile pending(path);
  pending.write(bytes);
  pending.commit();
}

}  // namespace shellback::app
