/// study plan, run, submit, status, merge: studies of many cases.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <thread>

#include "app/json_parts.hpp"
#include "app/labels/csv_text.hpp"
#include "app/pending_file.hpp"
#include "app/program/commands.hpp"
#include "app/program/many_cases.hpp"
#include "app/program/outputs.hpp"
#include "app/program/session.hpp"
#include "core/contract.hpp"
#include "core/parallel.hpp"

extern char** environ;

namespace shellback::program {

using namespace app;
using json_parts::Json;
namespace fs = std::filesystem;

namespace {

constexpr auto kLook = std::chrono::milliseconds(20);  ///< between two looks at what runs

std::string folder_of(const Request& request) {
  if (request.names.size() == 1) return request.names.front();
  throw InputError("FOLDER", fmt::format("study {} works on one folder; give that of a study that "
                                         "`study plan` has made",
                                         request.name));
}

int plan_study(const Request& request) {
  if (request.names.empty()) {
    throw InputError("CASE",
                     "no case is named; write study plan CASE.toml --vary KEY=VALUES -o "
                     "FOLDER");
  }
  if (request.output.empty()) throw InputError("-o", "the study's folder is missing");
  const ManyCases study = plan_cases(request);
  write_plan(study, request.force);
  std::cout << fmt::format("{} point{} of {} case{} in {}: study run {}\n", study.points.size(),
                           study.points.size() == 1 ? "" : "s", study.cases.size(),
                           study.cases.size() == 1 ? "" : "s", study.folder, study.folder);
  return kDone;
}

// --- run ---

/// Every count-th point, from the one at `first`.
struct Part {
  std::size_t first = 0, count = 1;
};

Part part_of(const std::string& words) {
  if (words.empty()) return {};
  const std::size_t slash = words.find('/');
  int number = 0, of = 0;
  const char* text = words.c_str();
  const auto read = [](const char* from, const char* to, int& x) {
    const auto [end, error] = std::from_chars(from, to, x);
    return error == std::errc{} && end == to;
  };
  const bool good = slash != std::string::npos && read(text, text + slash, number) &&
                    read(text + slash + 1, text + words.size(), of) && number >= 1 && number <= of;
  if (!good) throw InputError("--part", in_quotes(words) + " is no part; write I/N, 1/8 to 8/8");
  return {static_cast<std::size_t>(number - 1), static_cast<std::size_t>(of)};
}

/// This program's own file.
std::string own_program() {
  std::error_code refused;
  const fs::path self = fs::read_symlink("/proc/self/exe", refused);
  if (refused) throw FileError("/proc/self/exe: " + refused.message());
  return self.string();
}

/// Starts the run of point k; its messages go to a file of their own.
pid_t start_point(const ManyCases& study, std::size_t k, const std::string& program) {
  const PlannedPoint& point = study.points[k];
  std::vector<std::string> words{program, "run", study.cases[point.of_case]};
  const auto add = [&](const std::string& option, const std::string& value) {
    words.push_back(option);
    words.push_back(value);
  };
  for (const std::string& set : study.set) add("--set", set);
  for (const auto& [key, value] : point.varied) add("--set", key + "=" + value);
  if (!study.tier.empty()) add("--tier", study.tier);
  add("--json", study.file(k, "json"));
  words.emplace_back("--force");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  const std::string messages = study.file(k, "txt");
  posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, 2, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  pid_t pid = 0;
  const int error = posix_spawn(&pid, program.c_str(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw FileError(program + ": cannot be started: " + std::strerror(error));
  return pid;
}

/// Runs open points, so many at a time, until all have ended or somebody interrupts.
class PointRunner {
 public:
  PointRunner(const ManyCases& study, std::vector<std::size_t> open, std::size_t together)
      : study_(study), open_(std::move(open)), together_(together), program_(own_program()) {}

  /// False: interrupted.
  bool run() {
    const std::atomic<bool>& stop = catch_interrupt();
    ProgressLine line;
    while (!stop && (next_ < open_.size() || !running_.empty())) {
      while (next_ < open_.size() && running_.size() < together_) {
        const std::size_t k = open_[next_++];
        running_.emplace(start_point(study_, k, program_), k);
      }
      if (!gather(WNOHANG)) std::this_thread::sleep_for(kLook);
      line.show(fmt::format("{} of {} points", ended_, open_.size()));
    }
    for (const auto& [pid, k] : running_) kill(pid, SIGTERM);
    while (!running_.empty()) gather(0);
    return !stop;
  }

 private:
  /// Notes one point that has ended; false if there is none.
  bool gather(int how) {
    int status = 0;
    const pid_t pid = waitpid(-1, &status, how);
    const auto point = running_.find(pid);
    if (point == running_.end()) return false;
    const std::size_t k = point->second;
    running_.erase(point);
    ++ended_;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (code != kInterrupted && WIFEXITED(status)) {
      write_file(study_.file(k, "code"), fmt::format("{}\n", code));
    }
    return true;
  }

  const ManyCases& study_;
  std::vector<std::size_t> open_;
  std::size_t together_;
  std::string program_;
  std::map<pid_t, std::size_t> running_;
  std::size_t next_ = 0, ended_ = 0;
};

/// The first line of a point's messages that says why.
std::string why_of_point(const ManyCases& study, std::size_t k) {
  std::ifstream file(study.file(k, "txt"));
  constexpr const char* kError = "error: ";
  std::string line, last;
  while (std::getline(file, line)) {
    if (line.starts_with(kError)) return line.substr(std::strlen(kError));
    if (!line.empty()) last = line;
  }
  return last;
}

/// How many points ended how.
using Count = std::map<PointEnd, std::size_t>;

Count count_points(const ManyCases& study) {
  Count count;
  for (std::size_t k = 0; k < study.points.size(); ++k) ++count[end_of_point(study, k)];
  return count;
}

std::string words_of(const Count& count) {
  std::string words;
  for (const PointEnd end : {PointEnd::converged, PointEnd::not_converged, PointEnd::refused,
                             PointEnd::failed, PointEnd::open}) {
    const auto at = count.find(end);
    if (at == count.end()) continue;
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", at->second, to_string(end));
  }
  return words.empty() ? "no points" : words;
}

/// 0 only if every point has converged.
int code_of(const Count& count, std::size_t points) {
  const auto converged = count.find(PointEnd::converged);
  return converged != count.end() && converged->second == points ? kDone : kNotConverged;
}

int run_points(const Request& request) {
  const ManyCases study = read_plan(folder_of(request));
  const Part part = part_of(request.part);
  expect_cases_as_planned(study);
  std::vector<std::size_t> own, open;
  for (std::size_t k = part.first; k < study.points.size(); k += part.count) {
    own.push_back(k);
    const PointEnd end = end_of_point(study, k);
    if (end == PointEnd::open || end == PointEnd::failed) open.push_back(k);
  }
  const int together = request.cores > 0 ? request.cores : hardware_threads();
  const bool whole = PointRunner(study, open, static_cast<std::size_t>(together)).run();
  Count count;
  for (const std::size_t k : own) ++count[end_of_point(study, k)];
  std::cout << words_of(count) << "\n";
  if (!whole) {
    std::cerr << "interrupted: points that have ended are kept; study run goes on with the rest\n";
    return kInterrupted;
  }
  return code_of(count, own.size());
}

// --- submit ---

int submit_points(const Request& request) {
  const ManyCases study = read_plan(folder_of(request));
  expect_cases_as_planned(study);
  const std::size_t points = study.points.size();
  const std::size_t tasks =
      request.tasks > 0 ? std::min<std::size_t>(request.tasks, points) : points;
  const int cores = std::max(request.cores, 1);
  const std::string folder = fs::absolute(study.folder).lexically_normal().string();
  std::string script = fmt::format(
      "#!/bin/sh\n#SBATCH --job-name=shellback\n#SBATCH --array=1-{}\n#SBATCH --cpus-per-task={}\n"
      "#SBATCH --output={}/slurm-%a.txt\n",
      tasks, cores, folder);
  for (const std::string& option : request.slurm) script += "#SBATCH " + option + "\n";
  script += fmt::format("exec '{}' study run '{}' --part \"$SLURM_ARRAY_TASK_ID/{}\" -j {}\n",
                        own_program(), folder, tasks, cores);
  const std::string path = (fs::path(folder) / "submit.sh").string();
  write_file(path, script);
  pid_t pid = 0;
  std::string command = "sbatch";
  std::string file = path;
  char* const arguments[] = {command.data(), file.data(), nullptr};
  const int error = posix_spawnp(&pid, "sbatch", nullptr, nullptr, arguments, environ);
  int status = 0;
  const bool handed = error == 0 && waitpid(pid, &status, 0) == pid && WIFEXITED(status) &&
                      WEXITSTATUS(status) == 0;
  if (handed) return kDone;
  throw FileError(fmt::format(
      "sbatch: {}; hand in {} where Slurm is, or run it here with `study "
      "run {}`",
      error != 0 || WEXITSTATUS(status) == 127 ? std::string("there is no such program here")
                                               : "it did not take the script",
      path, study.folder));
}

// --- status and merge ---

int tell_status(const Request& request) {
  const ManyCases study = read_plan(folder_of(request));
  const Count count = count_points(study);
  std::cout << fmt::format("{} points: {}\n", study.points.size(), words_of(count));
  for (std::size_t k = 0; k < study.points.size(); ++k) {
    const PointEnd end = end_of_point(study, k);
    if (end == PointEnd::converged || end == PointEnd::open) continue;
    std::cout << fmt::format("{:4} {}, {}: {}\n", k + 1, study.points[k].words(study.cases),
                             to_string(end), why_of_point(study, k));
  }
  return kDone;
}

/// What `run` wrote of a point; nothing where there is none.
std::optional<Json> result_of(const ManyCases& study, std::size_t k) {
  std::ifstream file(study.file(k, "json"));
  if (!file) return std::nullopt;
  Json result = Json::parse(file, nullptr, false);
  if (result.is_discarded()) return std::nullopt;
  return result;
}

Json merged_json(const ManyCases& study) {
  Json all{{"cases", study.cases}, {"set", study.set}, {"points", Json::array()}};
  for (std::size_t k = 0; k < study.points.size(); ++k) {
    const PlannedPoint& p = study.points[k];
    Json point{{"point", k + 1}, {"case", study.cases[p.of_case]}};
    for (const auto& [key, value] : p.varied) point["varied"][key] = value;
    const PointEnd end = end_of_point(study, k);
    point["end"] = to_string(end);
    if (end != PointEnd::converged && end != PointEnd::open)
      point["reason"] = why_of_point(study, k);
    const auto result = end == PointEnd::converged ? result_of(study, k) : std::nullopt;
    if (result) {  // the last iterate of another is no result, and stays in the file of its point
      for (const char* key : {"status", "tier", "quantities", "audit", "grid", "cost"}) {
        if (result->contains(key)) point[key] = (*result)[key];
      }
    }
    all["points"].push_back(std::move(point));
  }
  return all;
}

/// Of the columns of a table the quantities that any point has, with their units.
std::vector<std::pair<std::string, std::string>> quantities_in(const Json& points) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Json& point : points) {
    if (!point.contains("quantities")) continue;
    for (const auto& [name, q] : point["quantities"].items()) {
      const auto known = [&](const auto& other) { return other.first == name; };
      if (std::any_of(all.begin(), all.end(), known)) continue;
      all.emplace_back(name, q.value("unit", ""));
    }
  }
  return all;
}

/// A row a point; bars, where they are known, in columns of their own.
std::string merged_csv(const ManyCases& study) {
  const Json points = merged_json(study)["points"];
  const auto quantities = quantities_in(points);
  std::string csv = "point,case";
  for (const auto& [key, value] : study.points.front().varied) csv += "," + csv_text(key);
  csv += ",end";
  for (const auto& [name, unit] : quantities) {
    csv += fmt::format(",{0} [{1}],{0}_bar [{1}]", name, unit);
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Json& point = points[k];
    csv += fmt::format("\n{},{}", k + 1, csv_text(point["case"].get<std::string>()));
    for (const auto& [key, value] : study.points[k].varied) csv += "," + csv_text(value);
    csv += "," + point["end"].get<std::string>();
    for (const auto& [name, unit] : quantities) {
      const bool has = point.contains("quantities") && point["quantities"].contains(name);
      const Json q = has ? point["quantities"][name] : Json::object();
      for (const char* part : {"value", "error"}) {
        const bool number = q.contains(part) && q[part].is_number();
        csv += "," + (number ? csv_number(q[part].get<double>()) : std::string());
      }
    }
  }
  return csv + "\n";
}

int merge_points(const Request& request) {
  const ManyCases study = read_plan(folder_of(request));
  Outputs outputs(request, {(fs::path(study.folder) / "study.json").string()});
  if (request.csv.empty() && request.json.empty()) {
    throw InputError("--csv", "nothing is to be written; give --csv FILE or --json FILE");
  }
  const Count count = count_points(study);
  std::cerr << fmt::format("{} points: {}\n", study.points.size(), words_of(count));
  outputs.give("--csv", [&] { return merged_csv(study); });
  outputs.give("--json", [&] { return json_parts::dump(merged_json(study)); });
  return outputs.code(code_of(count, study.points.size()));
}

}  // namespace

int study_of_many(const Request& request) {
  if (request.name == "plan") return plan_study(request);
  if (request.name == "run") return run_points(request);
  if (request.name == "submit") return submit_points(request);
  return request.name == "status" ? tell_status(request) : merge_points(request);
}

}  // namespace shellback::program
