#pragma once
/// Work in child processes: a crash, a hang or an exception ends the child, not the program.
#include <atomic>
#include <functional>
#include <string>

namespace shellback::validation {

/// How a child ended.
struct ChildEnd {
  enum class How { answered, threw, crashed, timed_out };
  How how = How::answered;
  std::string answer;  ///< what the work returned; the message of what it threw; the signal's name
  double seconds = 0.0;      ///< from fork to end
  double processor_s = 0.0;  ///< processor time of the child
};

struct ChildPoolOptions {
  int at_once = 1;        ///< children that run at the same time
  double limit_s = 60.0;  ///< processor time of a child
  double grace_s = 1.0;   ///< processor time beyond it for a child that ends by itself at the limit
  /// Clock time granted over processor time: for children that sleep, and for busy machines [-].
  double wait_factor = 4.0;
  const std::atomic<bool>* stop = nullptr;  ///< set from outside: end the children and return
};

/// For work in a child: from now on reaching the limit does not end the child but sets this flag;
/// the work then has the grace to give the answer that it has.
[[nodiscard]] const std::atomic<bool>& stop_at_limit();

/// Calls work(k) for k = 0 ... count - 1, each in a child of its own, and done(k, end) in this
/// process as they end, in any order. False if it was stopped; work that has not ended then has
/// no end. Must be called while this process has one thread (fork). Throws std::runtime_error
/// if no process can be started.
bool run_in_children(int count, const ChildPoolOptions& options,
                     const std::function<std::string(int)>& work,
                     const std::function<void(int, const ChildEnd&)>& done);

}  // namespace shellback::validation
