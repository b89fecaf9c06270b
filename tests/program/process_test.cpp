/// The program as a process: full disks, closed pipes, signals.
#include "tests/program/process.hpp"

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include "app/program/cli.hpp"
#include "tests/app/sample_case.hpp"
#include "tests/program/run_words.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::program;
using namespace shellback::program::tests;

namespace {

namespace fs = std::filesystem;
/// Whether the process is the program already, and has a handler for `signal` (proc(5), SigCgt).
bool catches(pid_t pid, int signal) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/" + std::to_string(pid) + "/exe", error);
  if (error || program.filename() != "shellback") return false;
  std::istringstream status(text_of("/proc/" + std::to_string(pid) + "/status"));
  std::string line;
  while (std::getline(status, line)) {
    if (!line.starts_with("SigCgt:")) continue;
    return ((std::stoull(line.substr(7), nullptr, 16) >> (signal - 1)) & 1U) != 0;
  }
  return false;
}

/// Files in the folder that no one asked for.
int count_leftovers(const std::string& folder) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    count += entry.path().filename().string().starts_with(".shellback-") ? 1 : 0;
  }
  return count;
}

/// A file system of 64 kB while the object lives.
class SmallDisk {
 public:
  explicit SmallDisk(std::string folder) : folder_(std::move(folder)) {
    fs::create_directories(folder_);
    mounted_ = mount("tmpfs", folder_.c_str(), "tmpfs", 0, "size=64k") == 0;
  }
  ~SmallDisk() {
    if (mounted_) umount2(folder_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  [[nodiscard]] bool mounted() const { return mounted_; }

 private:
  std::string folder_;
  bool mounted_ = false;
};

/// That fields which do not fit are told of, with the table printed and the JSON file written.
void check_lost_fields(const ScratchFolder& scratch, const std::string& folder,
                       const std::function<void()>& prepare) {
  const std::string file = scratch.write("case.toml", kSampleCase);
  const std::string json = scratch.path("x.json");
  const Process process(
      {"run", file, "--tier", "isothermal", "--json", json, "-o", folder + "/x.h5"},
      scratch.path("out"), scratch.path("err"), prepare);
  CHECK(process.wait() == kBadFile);
  check_parts(text_of(scratch.path("err")), {"error: cannot write ", "x.h5", "choose another"});
  check_parts(text_of(scratch.path("out")), {"sample", "torque"});
  check_parts(text_of(json), {"\"converged\": true"});
  CHECK_FALSE(fs::exists(folder + "/x.h5"));
  CHECK(count_leftovers(folder) == 0);
}

}  // namespace

TEST_CASE("FieldsBeyondTheSizeLimitAreToldAndNothingElseIsLost") {
  const ScratchFolder scratch;
  check_lost_fields(scratch, scratch.path("."), [] {
    const rlimit small{50'000, 50'000};  // between the size of the JSON file and that of the fields
    setrlimit(RLIMIT_FSIZE, &small);
  });
}

TEST_CASE("FieldsOnAFullDiskAreToldAndNothingElseIsLost") {
  const ScratchFolder scratch;
  const SmallDisk disk(scratch.path("disk"));
  if (!disk.mounted()) {
    WARN("not tested: no file system may be mounted here: " << std::strerror(errno));
    return;
  }
  check_lost_fields(scratch, scratch.path("disk"), [] {});
}

TEST_CASE("AFullStandardOutputIsToldAndTheFilesAreWritten") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", kSampleCase);
  const Process process(
      {"run", file, "--tier", "isothermal", "--set", kCoarse, "--json", scratch.path("x.json")},
      "/dev/full", scratch.path("err"));
  CHECK(process.wait() == kBadFile);
  check_parts(text_of(scratch.path("err")), {"error: cannot write to standard output"});
  check_parts(text_of(scratch.path("x.json")), {"\"converged\": true"});
}

TEST_CASE("AClosedPipeIsToldAndTheFilesAreWritten") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", kSampleCase);
  const Process process(
      {"run", file, "--tier", "isothermal", "--set", kCoarse, "--json", scratch.path("x.json")},
      "/dev/null", scratch.path("err"), [] {
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0) _exit(126);
        close(ends[0]);
        dup2(ends[1], STDOUT_FILENO);
      });
  CHECK(process.wait() == kBadFile);
  check_parts(text_of(scratch.path("err")), {"error: cannot write to standard output"});
  check_parts(text_of(scratch.path("x.json")), {"\"converged\": true"});
}

TEST_CASE("TerminationKeepsWhatTheInterruptKeyKeeps") {
  for (const int signal : {SIGINT, SIGTERM}) {
    const ScratchFolder scratch;
    const std::string file = scratch.write("case.toml", kSampleCase);
    const Process process(
        {"sweep", file, "--tier", "tehd", "--vary", "operation.speed=3000 rpm..1000 rpm/3000", "-j",
         "1", "--csv", scratch.path("x.csv")},
        scratch.path("out"), scratch.path("err"));
    while (!catches(process.pid(), signal)) std::this_thread::yield();
    kill(process.pid(), signal);
    INFO(strsignal(signal));
    CHECK(process.wait() == kInterrupted);
    check_parts(text_of(scratch.path("err")), {"interrupted: "});
    const std::string table = text_of(scratch.path("x.csv"));
    CHECK(std::count(table.begin(), table.end(), '\n') == 1 + 3000);
    CHECK(count_leftovers(scratch.path(".")) == 0);
  }
}
