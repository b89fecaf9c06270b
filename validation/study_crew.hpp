#pragma once
/// What every study takes, and its work on several threads.
#include <atomic>
#include <functional>
#include <mutex>
#include <string>

#include "app/run_state.hpp"
#include "bearing/control.hpp"
#include "bearing/over_time/kept_run.hpp"
#include "core/parallel.hpp"

namespace shellback::validation {

struct StudyOptions {
  bool quick = false;
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;
  /// Told after each piece of work, never twice at once; may be empty.
  std::function<void(const std::string& what, int done, int of)> tell;
  /// Where piece `piece` of the study, counted from 0, keeps its state; `first`: its first case.
  /// Called by several threads; none, or empty: nothing is kept.
  std::function<bearing::KeptRun*(int piece, const bearing::Case& first, app::RunOf run,
                                  const app::RunOptions& options)>
      kept;
};

/// Pieces of work that are told and can be stopped. The options must outlive it.
class StudyCrew {
 public:
  explicit StudyCrew(const StudyOptions& options) : options_(options) {}

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
    before_ += count;
  }
  [[nodiscard]] bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }
  /// For task k, whose first case is `first`: goes on from the state in which it was kept.
  [[nodiscard]] bearing::SolveControl control(int k, const bearing::Case& first,
                                              app::RunOf run = app::RunOf::load_cycle,
                                              const app::RunOptions& options = {}) const {
    bearing::SolveControl control;
    control.stop = options_.stop;
    if (options_.kept) control.kept = options_.kept(before_ + k, first, run, options);
    return control;
  }
  /// A cycle of a task has ended: that is kept at once.
  static void keep(const bearing::SolveControl& control, const Verdict& ended) {
    if (control.kept == nullptr || ended.status == Status::interrupted) return;
    control.kept->note_ended();
    control.kept->keep_noted();
  }

 private:
  void tell(const std::string& what, int done, int of) const {
    if (options_.tell) options_.tell(what, done, of);
  }
  const StudyOptions& options_;
  int before_ = 0;  ///< pieces of work that have ended
  std::mutex guard_;
};

}  // namespace shellback::validation
