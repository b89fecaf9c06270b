#pragma once
/// The state of a run over load cycles, of a running-in, a warm-up or a course in its file: written
/// on the way, gone on with, taken away at the end. A sweep has one for each of its points.
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "app/program/request.hpp"
#include "app/run_state.hpp"
#include "bearing/over_time/kept_run.hpp"

namespace shellback::program {

/// Where the run keeps its state: --state, else beside its first file, NAME.state; empty: it writes
/// no file and keeps none.
[[nodiscard]] std::string state_path(const Request& request);

/// The same request with that file named: the state of the run is one of its files, whoever names
/// it.
[[nodiscard]] Request with_state(Request request);

class RunKeeper {
 public:
  /// With --resume goes on from the file, if there is one. Throws InputError for a state of another
  /// case, FileError for one that is damaged.
  /// `options`: of the run, beside the case.
  RunKeeper(const Request& request, const bearing::Case& subject, app::RunOf run,
            const app::RunOptions& options = {});

  RunKeeper(const RunKeeper&) = delete;
  RunKeeper& operator=(const RunKeeper&) = delete;
  /// The same in the file `path`; without a word of whether there is one.
  RunKeeper(std::string path, bool resume, bearing::Case subject, app::RunOf run,
            app::RunOptions options);

  /// For SolveControl; none: nothing is kept.
  [[nodiscard]] bearing::KeptRun* kept() { return run_ ? &*run_ : nullptr; }
  /// For a search that follows when that run has ended; the state in which it did stays kept.
  [[nodiscard]] bearing::KeptRun* next();
  /// Takes the file away, unless the run was interrupted or one of its files was lost (`code`):
  /// then tells how to go on.
  void end(int code);
  /// The same without a word; true: a state of this run stays.
  bool leave(int code);

 private:
  /// What the file keeps.
  struct Kept {
    Tape::Content run;
    Tape::Content next;  ///< empty: not begun
  };
  /// Writes the file.
  void write(const std::function<std::string(const Tape::Content&)>& file);

  std::string path_;
  bearing::Case subject_;
  bool lost_ = false;         ///< the file cannot be written
  bool of_this_run_ = false;  ///< the file is no older run's
  Kept parts_;
  std::function<void()> save_;
  std::optional<bearing::KeptRun> run_, next_;
};

/// The states of a sweep over load cycles, or of a study: those of its points, or pieces of work,
/// each in a file beside its own, NAME.state.K. They may be solved in several threads.
class PointKeepers {
 public:
  /// Throws as RunKeeper does, and as app/output_rules.hpp says.
  PointKeepers(const Request& request, int points);
  /// For point k, which begins with the case `c`; none: nothing is kept.
  [[nodiscard]] bearing::KeptRun* kept(int k, const bearing::Case& c,
                                       app::RunOf run = app::RunOf::load_cycle,
                                       app::RunOptions options = {});
  /// When all threads have ended.
  void end(int code);

 private:
  [[nodiscard]] std::string file(int k) const;

  std::string path_;
  bool resume_;
  app::RunOptions options_;  ///< that every point has
  std::mutex guard_;
  std::map<int, RunKeeper> points_;
};

}  // namespace shellback::program
