#pragma once
/// The state of a run over load cycles, of a running-in, a warm-up or a course in its file: written
/// on the way, gone on with, taken away at the end.
#include <functional>
#include <optional>
#include <string>

#include "app/program/request.hpp"
#include "app/run_state.hpp"
#include "bearing/kept_run.hpp"

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

  /// For SolveControl; none: nothing is kept.
  [[nodiscard]] bearing::KeptRun* kept() { return run_ ? &*run_ : nullptr; }
  /// For a search that follows when that run has ended; the state in which it did stays kept.
  [[nodiscard]] bearing::KeptRun* next();
  /// Takes the file away, unless the run was interrupted or one of its files was lost (`code`):
  /// then tells how to go on.
  void end(int code);

 private:
  /// What the file keeps.
  struct Kept {
    Tape::Content run;
    Tape::Content next;  ///< empty: not begun
  };
  /// Writes the file.
  void write(const std::function<std::string(const Tape::Content&)>& file);

  std::string path_;
  bool lost_ = false;         ///< the file cannot be written
  bool of_this_run_ = false;  ///< the file is no older run's
  Kept parts_;
  std::function<void()> save_;
  std::optional<bearing::KeptRun> run_, next_;
};

}  // namespace shellback::program
