#pragma once
/// What a run over load cycles, a running-in or a warm-up has found so far, kept so that it can be
/// gone on with later.
///
/// A run solves cycles one after the other (the case's own, those of its bars). Kept are the
/// results of those that have ended and the whole state of the one under way, after a step that it
/// has accepted. Gone on with, a run makes the same steps as one that was never stopped: whatever
/// surrounds the steps (Anderson acceleration, root finders, the order of grids) is deterministic
/// and is led through what it was told before, up to the point where the state was kept.
#include <chrono>
#include <functional>
#include <optional>

#include "bearing/over_time/cycle.hpp"
#include "core/replay.hpp"
#include "core/tape.hpp"

namespace shellback::bearing {

class KeptRun {
 public:
  /// `save` is handed the content of a tape; from time to time, in the thread that solves.
  using Save = std::function<void(const Tape::Content&)>;
  explicit KeptRun(Save save);
  /// On from what was saved. Throws FileError where that is not sound.
  KeptRun(Save save, Tape::Content from);

  /// A cycle that was solved.
  struct Ended {
    CycleResult result;
    std::optional<Tape::Content> start;  ///< its CycleStart; none: no other search begins from it
    void members(Tape& tape);
  };
  /// The cycle that is to be solved next, if it had ended.
  [[nodiscard]] std::optional<Ended> next_ended();
  /// One that was not to be had from next_ended().
  void end(Ended ended);

  /// The state of the cycle under way, to be taken up by the search of the grid `grid()`; nothing:
  /// it begins.
  [[nodiscard]] Tape* under_way() { return tape_ ? &*tape_ : nullptr; }
  /// The search has read it.
  void taken_up();
  /// Grid of the sequence that is searched on, and what coarser ones and former runs have cost.
  [[nodiscard]] int grid() const { return grid_; }
  [[nodiscard]] const Cost& cost() const { return cost_; }
  void on_grid(int grid, const Cost& cost);
  /// What the finest of the coarser grids that were searched to the end has found, and which it is;
  /// -1: none.
  [[nodiscard]] int coarser_grid() const { return coarser_grid_; }
  [[nodiscard]] Tape coarser() const { return Tape(coarser_); }
  void coarser(int grid, Tape::Content found);
  /// Time that former runs have spent on the cycle under way [s].
  [[nodiscard]] double spent_before() const { return spent_before_; }

  /// True when it is time to keep the state: saving takes at most a fiftieth of the time, and the
  /// state is never more than half a minute old, as long as saving it takes less.
  [[nodiscard]] bool due() const;
  /// Keeps the state that `search` writes.
  void keep(const std::function<void(Tape&)>& search);
  /// The same where what follows cannot be undone when it is stopped: keeps it if it is time, else
  /// notes it for keep_noted().
  void note(const std::function<void(Tape&)>& search);
  /// Notes that all cycles so far have ended and none is under way.
  void note_ended();
  /// Keeps what was noted last, unless it is kept already.
  void keep_noted();

 private:
  using Clock = std::chrono::steady_clock;

  Tape::Content written(const std::function<void(Tape&)>& search);
  void save(const Tape::Content& content, Clock::time_point begin);

  Save save_;
  Replay<Ended> ended_;
  int grid_ = 0;
  Cost cost_;
  int coarser_grid_ = -1;
  Tape::Content coarser_;
  double spent_before_ = 0.0;
  std::optional<Tape> tape_;
  Clock::time_point begun_ = Clock::now();  ///< the cycle under way, in this run
  Clock::time_point kept_ = Clock::now();
  double saving_s_ = 0.0;  ///< that the last saving has taken
  std::optional<Tape::Content> noted_;
};

// For a run that notes; without `kept` they do nothing.

/// Reads the first part of what was noted; take_up_noted() reads the rest.
void begin_take_up(KeptRun* kept, const std::function<void(Tape&)>& search);
/// Reads what `search` has noted, which is called once more; false: it has not.
[[nodiscard]] bool take_up_noted(KeptRun* kept, const std::function<void(Tape&)>& search);
/// Notes both parts, to be kept when it is time.
void keep_between(KeptRun* kept, const std::function<void(Tape&)>& first,
                  const std::function<void(Tape&)>& rest);
/// Keeps what was noted if the run has been interrupted.
void keep_stopped(KeptRun* kept, const Verdict& verdict);

}  // namespace shellback::bearing
