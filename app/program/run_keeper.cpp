#include "app/program/run_keeper.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "app/file_identity.hpp"
#include "app/output_rules.hpp"
#include "app/pending_file.hpp"
#include "app/result_mark.hpp"
#include "core/contract.hpp"

namespace shellback::program {

using namespace app;
using bearing::KeptRun;

std::string state_path(const Request& request) {
  if (!request.state.empty()) return request.state;
  for (const std::string& file : {request.output, request.json, request.csv, request.page,
                                  request.picture, request.profile}) {
    if (!file.empty() && file != "-" && !is_stream(file)) return file + ".state";
  }
  return "";
}

Request with_state(Request request) {
  request.state = state_path(request);
  return request;
}

namespace {

/// The state that the request names. Throws where it wants to go on from none.
std::string judged_path(const Request& request) {
  const std::string path = state_path(request);
  if (!path.empty() || !request.resume) return path;
  throw InputError("--resume",
                   "a run that writes no file keeps no state; give --state FILE, or the files of "
                   "the run that was interrupted");
}

std::mutex hdf5_use;  // HDF5 is not to be called from two threads

Tape::Content read_state(const std::string& path, const bearing::Case& c, RunOf run,
                         const RunOptions& options) {
  const std::lock_guard lock(hdf5_use);
  return read_run_state(path, c, run, options);
}

bool is_there(const std::string& path) {
  std::error_code error;
  return std::filesystem::exists(path, error);
}

}  // namespace

RunKeeper::RunKeeper(const Request& request, const bearing::Case& subject, RunOf run,
                     const RunOptions& options)
    : RunKeeper(judged_path(request), request.resume, subject, run, options) {
  if (!request.resume) return;
  std::cerr << (of_this_run_ ? "note: the run goes on from " + path_ + "\n"
                             : "note: there is no " + path_ + ": the run begins anew\n");
}

RunKeeper::RunKeeper(std::string path, bool resume, bearing::Case subject, RunOf run,
                     RunOptions options)
    : path_(std::move(path)), subject_(std::move(subject)) {
  if (path_.empty()) return;
  save_ = [this, run, options] {
    write([&](const Tape::Content& kept) { return run_state(subject_, run, kept, options); });
  };
  const auto saved = [this](const Tape::Content& state) {
    parts_.run = state;
    save_();
  };
  if (!resume || !is_there(path_)) {
    run_.emplace(saved);
    return;
  }
  Tape kept(read_state(path_, subject_, run, options));
  kept(parts_);
  if (!kept.ended()) throw FileError(path_ + " goes on after all of it is read");
  run_.emplace(saved, parts_.run);
  of_this_run_ = true;
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
  const std::lock_guard lock(hdf5_use);
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

bool RunKeeper::leave(int code) {
  const bool stays = code == kInterrupted || code == kBadFile;
  if (run_ && stays) run_->keep_noted();
  if (!of_this_run_) return false;  // a file that is there is another run's, and stays
  if (stays) return true;
  std::error_code error;
  if (is_result(path_)) std::filesystem::remove(path_, error);
  return false;
}

namespace {

void tell_nothing_found() {
  std::cerr << "note: nothing had been found yet: the run keeps no state\n";
}

void tell_kept(const std::string& path) {
  std::cerr << "the state of the run is kept in " << path
            << "; the same command with --resume goes on from there\n";
}

}  // namespace

void RunKeeper::end(int code) {
  if (leave(code)) {
    tell_kept(path_);
  } else if (run_ && code == kInterrupted) {
    tell_nothing_found();
  }
}

PointKeepers::PointKeepers(const Request& request, int points)
    : path_(judged_path(request)),
      resume_(request.resume),
      options_{{"--no-bars", {request.no_bars ? 1.0 : 0.0}},
               {"--quick", {request.quick ? 1.0 : 0.0}}} {
  if (path_.empty()) return;
  std::vector<Output> files;
  int there = 0;
  for (int k = 0; k < points; ++k) {
    files.push_back({"--state", file(k), Format::hdf5});
    if (is_there(file(k))) ++there;
  }
  expect_sound(files, {}, request.force);
  if (resume_) {
    std::cerr << fmt::format("note: {} of {} points go on from their states ({}.0 and so on)\n",
                             there, points, path_);
  }
}

std::string PointKeepers::file(int k) const { return path_ + "." + std::to_string(k); }

KeptRun* PointKeepers::kept(int k, const bearing::Case& c, RunOf run, RunOptions options) {
  if (path_.empty()) return nullptr;
  options.insert(options.end(), options_.begin(), options_.end());
  const std::lock_guard lock(guard_);
  const auto at = points_.try_emplace(k, file(k), resume_, c, run, std::move(options));
  return at.first->second.kept();
}

void PointKeepers::end(int code) {
  bool any = false;
  for (auto& [k, keeper] : points_) any = keeper.leave(code) || any;
  if (any) {
    tell_kept(path_ + ".0 and so on, one a point");
  } else if (!points_.empty() && code == kInterrupted) {
    tell_nothing_found();
  }
}

}  // namespace shellback::program
