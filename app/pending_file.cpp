#include "app/pending_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/contract.hpp"

namespace shellback::app {

// The process number keeps two runs that write the same name apart.
PendingFile::PendingFile(std::string path)
    : path_(std::move(path)), temporary_(fmt::format("{}.part{}", path_, ::getpid())) {}

PendingFile::~PendingFile() {
  std::error_code ignored;  // nothing is left to be told from a destructor
  std::filesystem::remove(temporary_, ignored);
}

void PendingFile::commit() {
  std::error_code failure;
  std::filesystem::rename(temporary_, path_, failure);
  if (failure) {
    throw FileError(
        fmt::format("cannot write {}: {}; choose another place or name", path_, failure.message()));
  }
}

void write_file(const std::string& path, std::string_view text) {
  PendingFile pending(path);
  std::ofstream out(pending.temporary(), std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) {
    throw FileError(fmt::format("cannot write {}: {}; choose another place or name", path,
                                std::strerror(errno)));
  }
  pending.commit();
}

}  // namespace shellback::app
