/// A file is there as a whole or not at all.
#include "app/pending_file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <sstream>

#include "tests/app/sample_case.hpp"

using namespace shellback;
using namespace shellback::app;

namespace {

namespace fs = std::filesystem;

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::ptrdiff_t count_files(const ScratchFolder& scratch) {
  return std::distance(fs::directory_iterator(scratch.path(".")), fs::directory_iterator());
}

/// No file grows beyond `bytes` while the object lives: a full disk for one process.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

volatile std::sig_atomic_t terminated = 0;

}  // namespace

TEST_CASE("WhatDoesNotFitLeavesTheOlderFileAndNothingElse") {
  const ScratchFolder scratch;
  const std::string path = scratch.write("result.json", "older");
  {
    const SmallFiles full(1000);
    CHECK_THROWS_AS(write_file(path, std::string(5000, 'x')), FileError);
    CHECK_THROWS_AS(write_file(scratch.path("new.json"), std::string(5000, 'x')), FileError);
  }
  CHECK(text_of(path) == "older");
  CHECK(count_files(scratch) == 1);
}

TEST_CASE("ADeviceIsWrittenIntoAndStaysADevice") {
  write_file("/dev/null", "text");
  CHECK(fs::is_character_file("/dev/null"));
  CHECK_THROWS_AS(write_file("/dev/full", "text"), FileError);
  CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("ALinkStaysALinkAndItsFileKeepsItsRights") {
  const ScratchFolder scratch;
  const std::string path = scratch.write("result.json", "older");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("result.json", scratch.path("link.json"));
  write_file(scratch.path("link.json"), "newer");
  CHECK(fs::is_symlink(scratch.path("link.json")));
  CHECK(text_of(path) == "newer");
  CHECK(fs::status(path).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("TheLongestNameCanBeWritten") {
  const ScratchFolder scratch;
  const std::string path = scratch.path(std::string(255, 'n'));  // NAME_MAX of common file systems
  write_file(path, "text");
  CHECK(text_of(path) == "text");
}

TEST_CASE("ASignalWaitsUntilTheFileIsThere") {
  const ScratchFolder scratch;
  const std::string path = scratch.path("result.json");
  auto* before = std::signal(SIGTERM, [](int) { terminated = 1; });
  {
    PendingFile pending(path);
    std::raise(SIGTERM);
    CHECK(terminated == 0);
    pending.write("whole");
    pending.commit();
  }
  CHECK(terminated == 1);
  CHECK(text_of(path) == "whole");
  std::signal(SIGTERM, before);
}
