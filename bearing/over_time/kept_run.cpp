#include "bearing/over_time/kept_run.hpp"

#include <algorithm>

#include "bearing/over_time/tape_members.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {
namespace {

double seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

void KeptRun::Ended::members(Tape& tape) { tape(result, start); }

KeptRun::KeptRun(Save save) : save_(std::move(save)) {}

KeptRun::KeptRun(Save save, Tape::Content from) : save_(std::move(save)), tape_(std::move(from)) {
  (*tape_)(ended_, grid_, cost_, coarser_grid_, coarser_, spent_before_);
  if (tape_->ended()) tape_.reset();  // no cycle was under way
}

std::optional<KeptRun::Ended> KeptRun::next_ended() {
  auto ended = ended_.next();
  if (!ended) begun_ = Clock::now();
  return ended;
}

void KeptRun::end(Ended ended) {
  ended_.add(std::move(ended));
  grid_ = 0;
  cost_ = {};
  coarser_grid_ = -1;
  coarser_ = {};
  spent_before_ = 0.0;
  begun_ = Clock::now();
}

void KeptRun::taken_up() {
  if (!tape_->ended()) throw FileError("a kept state goes on after all of it is read");
  tape_.reset();
}

void KeptRun::on_grid(int grid, const Cost& cost) {
  grid_ = grid;
  cost_ = cost;
}

void KeptRun::coarser(int grid, Tape::Content found) {
  coarser_grid_ = grid;
  coarser_ = std::move(found);
}

bool KeptRun::due() const {
  constexpr double kShare = 0.02;   // of the time may go into saving
  constexpr double kSoonest = 0.1;  // [s]
  constexpr double kLatest = 30.0;  // [s]
  const double wait = std::clamp(saving_s_ / kShare, kSoonest, std::max(kLatest, saving_s_));
  return seconds(Clock::now() - kept_) >= wait;
}

Tape::Content KeptRun::written(const std::function<void(Tape&)>& search) {
  Tape tape;
  double spent = spent_before_ + seconds(Clock::now() - begun_);
  tape(ended_, grid_, cost_, coarser_grid_, coarser_, spent);
  search(tape);
  return tape.content();
}

void KeptRun::keep(const std::function<void(Tape&)>& search) {
  const auto begin = Clock::now();
  save(written(search), begin);
}

void KeptRun::save(const Tape::Content& content, Clock::time_point begin) {
  save_(content);
  kept_ = Clock::now();
  saving_s_ = seconds(kept_ - begin);
}

void KeptRun::note(const std::function<void(Tape&)>& search) {
  noted_ = written(search);
  if (due()) keep_noted();
}

void KeptRun::note_ended() {
  note([](Tape&) {});
}

void KeptRun::keep_noted() {
  if (!noted_) return;
  save(*noted_, Clock::now());
  noted_.reset();
}

void begin_take_up(KeptRun* kept, const std::function<void(Tape&)>& search) {
  if (kept != nullptr && kept->under_way() != nullptr) search(*kept->under_way());
}

bool take_up_noted(KeptRun* kept, const std::function<void(Tape&)>& search) {
  if (kept == nullptr || kept->under_way() == nullptr) return false;
  search(*kept->under_way());
  kept->taken_up();
  return true;
}

void keep_between(KeptRun* kept, const std::function<void(Tape&)>& first,
                  const std::function<void(Tape&)>& rest) {
  if (kept == nullptr) return;
  kept->note([&](Tape& tape) {
    first(tape);
    rest(tape);
  });
}

void keep_stopped(KeptRun* kept, const Verdict& verdict) {
  if (kept != nullptr && verdict.status == Status::interrupted) kept->keep_noted();
}

}  // namespace shellback::bearing
