#pragma once
/// A line on the terminal while a solve runs, and the interrupt key.
#include <atomic>
#include <string>

#include "bearing/control.hpp"

namespace shellback::app {

/// Shows the progress on standard error if that is a terminal and the solve has lasted a second.
/// Owns the line: it is wiped when the object goes.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const bearing::Progress& progress);
  /// The same with words of one's own.
  void show(const std::string& words);
  /// Clears the line, for what is to be printed now.
  void wipe();

 private:
  bool terminal_;
  bool shown_ = false;
  double begin_s_;
  double last_s_;
};

/// Catches Ctrl-C and SIGTERM from now on: the first one sets the flag that solvers poll, a second
/// one ends the program at once.
[[nodiscard]] const std::atomic<bool>& catch_interrupt();

}  // namespace shellback::app
