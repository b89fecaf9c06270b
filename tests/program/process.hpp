#pragma once
/// The program as a process of its own.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace shellback::program::tests {

using Words = std::vector<std::string>;

inline std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// The program at work on `words`, its messages in a file.
class Process {
 public:
  /// `prepare` runs in the child just before the program.
  Process(
      const Words& words, const std::string& output, const std::string& messages,
      const std::function<void()>& prepare = [] {}) {
    std::vector<const char*> arguments{SHELLBACK_BINARY_DIR "/shellback"};
    for (const std::string& word : words) arguments.push_back(word.c_str());
    arguments.push_back(nullptr);
    pid_ = fork();
    if (pid_ != 0) return;
    for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_DFL);
    dup2(open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDOUT_FILENO);
    dup2(open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO);
    prepare();
    execv(arguments.front(), const_cast<char* const*>(arguments.data()));
    _exit(127);
  }

  /// Its exit code; 1000 and more: the signal that killed it.
  [[nodiscard]] int wait() const {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFSIGNALED(status) ? 1000 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  [[nodiscard]] bool ended() const {
    siginfo_t how{};
    const auto id = static_cast<id_t>(pid_);
    return waitid(P_PID, id, &how, WEXITED | WNOHANG | WNOWAIT) == 0 && how.si_pid == pid_;
  }
  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  pid_t pid_;
};

}  // namespace shellback::program::tests
