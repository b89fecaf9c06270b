#pragma once
/// Work in child processes: a crash, a hang or an exception ends the child, not the program.
#include <atomic>
#include <functional>
#include <string>

namespace shellback::proof {

/// How a child ended.
struct ChildEnd {
  enum class How { answered, threw, crashed, timed_out };
  How how = How::answered;
  std::string answer;  ///< what the work returned; the message of what it threw; the signal's name
  double seconds = 0.0;  ///< from fork to end
};

struct ChildPoolOptions {
  int at_once = 1;        ///< children that run at the same time
  double limit_s = 60.0;  ///< processor time of a child; four times as long on the clock
  const std::atomic<bool>* stop = nullptr;  ///< set from outside: end the children and return
};

/// Calls work(k) for k = 0 ... count - 1, each in a child of its own, and done(k, end) in this
/// process as they end, in any order. False if it was stopped; work that has not ended then has
/// no end. Must be called while this process has one thread (fork). Throws std::runtime_error
/// if no process can be started.
bool run_in_children(int count, const ChildPoolOptions& options,
                     const std::function<std::string(int)>& work,
                     const std::function<void(int, const ChildEnd&)>& done);

}  // namespace shellback::proof
