#pragma once
/// What every study takes, and its work on several threads.
#include <atomic>
#include <functional>
#include <mutex>
#include <string>

#include "bearing/control.hpp"
#include "core/parallel.hpp"

namespace shellback::validation {

struct StudyOptions {
  bool quick = false;
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;
  /// Told after each piece of work, never twice at once; may be empty.
  std::function<void(const std::string& what, int done, int of)> tell;
};

/// Pieces of work that are told and can be stopped. The options must outlive it.
class StudyCrew {
 public:
  explicit StudyCrew(const StudyOptions& options) : options_(options) {
    control_.stop = options.stop;
  }

  /// task(0) ... task(count - 1), each once, on the threads of the options; none any more once it
  /// is stopped. Tasks must not share what they change.
  void work(const std::string& what, int count, const std::function<void(int)>& task) {
    int done = 0;
    tell(what, 0, count);
    parallel_for(count, options_.threads, [&](int k) {
      if (!stopped()) task(k);
      const std::lock_guard lock(guard_);
      tell(what, ++done, count);
    });
  }
  [[nodiscard]] bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }
  [[nodiscard]] const bearing::SolveControl& control() const { return control_; }

 private:
  void tell(const std::string& what, int done, int of) const {
    if (options_.tell) options_.tell(what, done, of);
  }
  const StudyOptions& options_;
  bearing::SolveControl control_;
  std::mutex guard_;
};

}  // namespace shellback::validation
