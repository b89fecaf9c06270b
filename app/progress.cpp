#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>

namespace shellback::app {
namespace {

constexpr double kQuietTime = 1.0;         ///< shorter solves need no comfort [s]
constexpr double kInterval = 0.1;          ///< between two lines [s]
constexpr const char* kWipe = "\r\x1b[K";  ///< back to the line's begin, clear it

/// The same wish told twice: `timeout` signals its child and then its whole group, a hurried finger
/// comes again after 0.1 s or more [ns].
constexpr std::int64_t kOnce = 100'000'000;

// A signal handler can reach nothing else than a lock-free global.
std::atomic<bool> interrupted{false};
std::atomic<std::int64_t> first_signal{0};  ///< [ns]
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

/// The interrupt key, and what `kill`, batch systems and a machine going down send.
constexpr std::array kInterrupts{SIGINT, SIGTERM};

/// The first ends the work in good order, one that comes later ends the program.
void on_interrupt(int signal) {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);  // a handler may call it
  const std::int64_t now = std::int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec;
  if (!interrupted.exchange(true)) {
    first_signal.store(now);
  } else if (now - first_signal.load() > kOnce) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

double now_s() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(since).count();
}

}  // namespace

ProgressLine::ProgressLine()
    : terminal_(isatty(STDERR_FILENO) == 1), begin_s_(now_s()), last_s_(begin_s_) {}

ProgressLine::~ProgressLine() { wipe(); }

void ProgressLine::wipe() {
  if (shown_) std::fputs(kWipe, stderr);
  shown_ = false;
}

void ProgressLine::show(const bearing::Progress& progress) {
  show(fmt::format("{} step {}: change {:.1e}, friction {:.4g} N m, smallest film {:.3g} um",
                   progress.stage, progress.step, progress.residual, progress.friction_torque,
                   1e6 * progress.h_min));
}

void ProgressLine::show(const std::string& words) {
  if (!terminal_) return;
  const double now = now_s();
  if (now - begin_s_ < kQuietTime || now - last_s_ < kInterval) return;
  fmt::print(stderr, "{}{}", kWipe, words);
  std::fflush(stderr);
  shown_ = true;
  last_s_ = now;
}

const std::atomic<bool>& catch_interrupt() {
  for (const int each : kInterrupts) std::signal(each, on_interrupt);
  return interrupted;
}

}  // namespace shellback::app
