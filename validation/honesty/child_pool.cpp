#include "validation/honesty/child_pool.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <vector>

namespace shellback::validation {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kThrew = 3;  ///< exit code of a child whose work threw
/// Of the limit: from here on a killed child had spent it. The kernel counts what it limits and
/// what it reports in two ways, 13 % apart at a limit of 1 s (measured) [-].
constexpr double kSpent = 0.8;
constexpr int kPollMs = 100;  ///< between looks at the clock

struct Child {
  int number = 0;
  pid_t pid = 0;
  int pipe = -1;
  Clock::time_point begin;
  std::string said;
};

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void say(int pipe, const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t n = write(pipe, text.data() + written, text.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;
    written += static_cast<std::size_t>(n);
  }
}

/// Set by the signal of the processor-time limit.
std::atomic<bool> at_limit{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

void note_limit(int) { at_limit = true; }

rlimit processor_limit(const ChildPoolOptions& options) {
  const auto soft = static_cast<rlim_t>(std::ceil(options.limit_s));
  return {soft, soft + static_cast<rlim_t>(std::ceil(std::max(options.grace_s, 1.0)))};
}

/// What the child does; it ends in here, without the destructors and buffers of its parent.
[[noreturn]] void live(int pipe, const ChildPoolOptions& options, int number,
                       const std::function<std::string(int)>& work) {
  for (const int signal : {SIGINT, SIGTERM, SIGSEGV, SIGABRT, SIGFPE}) {
    std::signal(signal, SIG_DFL);
  }
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const rlimit processor = processor_limit(options);
  setrlimit(RLIMIT_CPU, &processor);
  int code = EXIT_SUCCESS;
  std::string text;
  try {
    text = work(number);
  } catch (const std::exception& error) {
    text = error.what();
    code = kThrew;
  } catch (...) {
    text = "something that is no std::exception";
    code = kThrew;
  }
  say(pipe, text);
  close(pipe);
  _exit(code);
}

Child start(int number, const std::vector<Child>& others, const ChildPoolOptions& options,
            const std::function<std::string(int)>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) {
    throw std::runtime_error(fmt::format("no pipe to a child process: {}", std::strerror(errno)));
  }
  const pid_t pid = fork();
  if (pid < 0) {
    const int why = errno;
    close(ends[0]);
    close(ends[1]);
    throw std::runtime_error(fmt::format("no child process: {}", std::strerror(why)));
  }
  if (pid == 0) {
    close(ends[0]);
    for (const Child& other : others) close(other.pipe);
    live(ends[1], options, number, work);
  }
  close(ends[1]);
  return {number, pid, ends[0], Clock::now(), ""};
}

/// Exit status and processor time of a child that has ended.
struct Ended {
  int status = 0;
  double processor_s = 0.0;
};
Ended wait_for(pid_t pid) {
  Ended ended;
  rusage used{};
  while (wait4(pid, &ended.status, 0, &used) < 0 && errno == EINTR) {
  }
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  ended.processor_s = seconds(used.ru_utime) + seconds(used.ru_stime);
  return ended;
}

void end_child(const Child& child) {
  kill(child.pid, SIGKILL);
  wait_for(child.pid);
  close(child.pipe);
}

ChildEnd end_of(Child& child, const ChildPoolOptions& options) {
  using How = ChildEnd::How;
  const auto [status, processor_s] = wait_for(child.pid);
  close(child.pipe);
  ChildEnd end{How::answered, std::move(child.said), seconds_since(child.begin), processor_s};
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    // Beyond the grace the limit kills.
    const bool spent = signal == SIGKILL && processor_s >= kSpent * options.limit_s;
    end.how = signal == SIGXCPU || spent ? How::timed_out : How::crashed;
    end.answer = strsignal(signal);
  } else if (WEXITSTATUS(status) == kThrew) {
    end.how = How::threw;
  } else if (WEXITSTATUS(status) != EXIT_SUCCESS) {
    end.how = How::crashed;
    end.answer = fmt::format("exit code {}", WEXITSTATUS(status));
  }
  return end;
}

/// Reads what the child says; false when it has said all.
bool listen(Child& child) {
  std::array<char, 4096> buffer{};
  const ssize_t n = read(child.pipe, buffer.data(), buffer.size());
  if (n < 0) return errno == EINTR || errno == EAGAIN;
  child.said.append(buffer.data(), static_cast<std::size_t>(n));
  return n > 0;
}

void wait_for_words(const std::vector<Child>& children) {
  std::vector<pollfd> watched;
  watched.reserve(children.size());
  for (const Child& child : children) watched.push_back({child.pipe, POLLIN, 0});
  poll(watched.data(), watched.size(), kPollMs);
}

/// A child without anything to read now has not ended.
bool has_words(const Child& child) {
  pollfd watched{child.pipe, POLLIN, 0};
  return poll(&watched, 1, 0) > 0;
}

}  // namespace

const std::atomic<bool>& stop_at_limit() {
  std::signal(SIGXCPU, note_limit);
  return at_limit;
}

bool run_in_children(int count, const ChildPoolOptions& options,
                     const std::function<std::string(int)>& work,
                     const std::function<void(int, const ChildEnd&)>& done) {
  std::vector<Child> children;
  int next = 0;
  while (next < count || !children.empty()) {
    if (options.stop != nullptr && options.stop->load()) {
      for (const Child& child : children) end_child(child);
      return false;
    }
    while (next < count && static_cast<int>(children.size()) < std::max(1, options.at_once)) {
      children.push_back(start(next, children, options, work));
      ++next;
    }
    wait_for_words(children);
    for (std::size_t k = 0; k < children.size();) {
      Child& child = children[k];
      const bool late =
          seconds_since(child.begin) > options.wait_factor * (options.limit_s + options.grace_s);
      if (!late && (!has_words(child) || listen(child))) {
        ++k;
        continue;
      }
      if (late) kill(child.pid, SIGKILL);
      ChildEnd end = end_of(child, options);
      if (late) end = {ChildEnd::How::timed_out, "", end.seconds, end.processor_s};
      const int number = child.number;
      children.erase(children.begin() + static_cast<std::ptrdiff_t>(k));
      done(number, end);
    }
  }
  return true;
}

}  // namespace shellback::validation
