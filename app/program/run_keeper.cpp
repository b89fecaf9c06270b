#include "app/program/run_keeper.hpp"

#include <filesystem>
#include <iostream>

#include "app/file_identity.hpp"
#include "app/pending_file.hpp"
#include "app/result_mark.hpp"
#include "core/contract.hpp"

namespace shellback::program {

using namespace app;
using bearing::KeptRun;

std::string state_path(const Request& request) {
  if (!request.state.empty()) return request.state;
  for (const std::string& file :
       {request.output, request.json, request.page, request.picture, request.profile}) {
    if (!file.empty() && file != "-" && !is_stream(file)) return file + ".state";
  }
  return "";
}

Request with_state(Request request) {
  request.state = state_path(request);
  return request;
}

RunKeeper::RunKeeper(const Request& request, const bearing::Case& subject, RunOf run,
                     const RunOptions& options)
    : path_(state_path(request)) {
  if (path_.empty() && request.resume) {
    throw InputError("--resume",
                     "a run that writes no file keeps no state; give --state FILE, or the files of "
                     "the run that was interrupted");
  }
  if (path_.empty()) return;
  save_ = [this, &subject, run, options] {
    write([&](const Tape::Content& kept) { return run_state(subject, run, kept, options); });
  };
  const auto saved = [this](const Tape::Content& state) {
    parts_.run = state;
    save_();
  };
  std::error_code error;
  const bool there = std::filesystem::exists(path_, error);
  if (!request.resume || !there) {
    if (request.resume) std::cerr << "note: there is no " << path_ << ": the run begins anew\n";
    run_.emplace(saved);
    return;
  }
  Tape kept(read_run_state(path_, subject, run, options));
  kept(parts_);
  if (!kept.ended()) throw FileError(path_ + " goes on after all of it is read");
  run_.emplace(saved, parts_.run);
  of_this_run_ = true;
  std::cerr << "note: the run goes on from " << path_ << "\n";
}

KeptRun* RunKeeper::next() {
  if (!run_) return nullptr;
  run_->keep_noted();
  const auto saved = [this](const Tape::Content& state) {
    parts_.next = state;
    save_();
  };
  if (parts_.next.counts.empty()) {
    next_.emplace(saved);
  } else {
    next_.emplace(saved, parts_.next);
  }
  return &*next_;
}

void RunKeeper::write(const std::function<std::string(const Tape::Content&)>& file) {
  if (lost_) return;
  try {
    Tape kept;
    kept(parts_);
    write_file(path_, file(kept.content()));
    of_this_run_ = true;
  } catch (const FileError& why) {  // the run itself is none the worse for it
    lost_ = true;
    std::cerr << "warning: the state of the run is no longer kept: " << why.what() << "\n";
  }
}

void RunKeeper::end(int code) {
  if (run_ && (code == kInterrupted || code == kBadFile)) run_->keep_noted();
  if (!of_this_run_) {  // a file that is there is another run's, and stays
    if (run_ && code == kInterrupted) {
      std::cerr << "note: nothing had been found yet: the run keeps no state\n";
    }
    return;
  }
  if (code == kInterrupted || code == kBadFile) {
    std::cerr << "the state of the run is kept in " << path_
              << "; the same command with --resume goes on from there\n";
    return;
  }
  std::error_code error;
  if (is_result(path_)) std::filesystem::remove(path_, error);
}

}  // namespace shellback::program
