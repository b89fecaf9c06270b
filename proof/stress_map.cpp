#include "proof/stress_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/read_case.hpp"
#include "core/contract.hpp"

namespace shellback::proof {
namespace {

/// How much the next value may go the wrong way: the grid's and the solve's error [-].
constexpr double kTrendSlack = 2e-3;
/// Gaps below are measured against this: a nominal gap may pass through zero [m].
constexpr double kSmallGap = 1e-7;

struct Task {
  std::size_t row;
  std::size_t method;
  std::size_t step;
  std::vector<std::string> words;
};

/// Physics of a scene's first step that can be read; which methods apply follows from it.
coupling::Physics physics_of_scene(const StressScene& scene) {
  for (const StressStep& step : scene.steps) {
    try {
      std::vector<app::Override> changes;
      for (const std::string& word : words_of(scene, step, {})) {
        changes.push_back(app::parse_override(word));
      }
      return coupling::physics_of(app::read_case(scene.case_path, changes, {scene.tier}),
                                  scene.tier);
    } catch (const InputError&) {
      continue;  // the reader refuses this step: the cell will say so
    }
  }
  return {};
}

std::vector<Task> tasks_for(const std::vector<StressRow>& rows, bool only_default) {
  std::vector<Task> tasks;
  const auto& methods = stress_methods();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const coupling::Physics physics = physics_of_scene(rows[r].scene);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (only_default && !methods[m].shipped) continue;
      const StressMethodWords method = words_for(methods[m], physics);
      if (!method.applies) continue;
      for (std::size_t k = 0; k < rows[r].scene.steps.size(); ++k) {
        tasks.push_back({r, m, k, words_of(rows[r].scene, rows[r].scene.steps[k], method)});
      }
    }
  }
  return tasks;
}

/// What differences of a quantity are measured against.
double size_of(const std::string& name, double value) {
  return std::max(std::abs(value), name == "h_min" ? kSmallGap : 1e-300);
}

void find_broken_trend(const StressScene& scene, std::vector<StressCell>& cells) {
  if (scene.trend.quantity.empty()) return;
  const double sign = scene.trend.falls ? -1.0 : 1.0;
  double before = NAN;
  for (StressCell& cell : cells) {
    if (cell.result != StressClass::converged) continue;
    const double x = cell.answer.value(scene.trend.quantity);
    if (sign * (x - before) < -kTrendSlack * size_of(scene.trend.quantity, before)) {
      cell.result = StressClass::wrong;
      cell.why = fmt::format("{} goes from {:.4g} to {:.4g}, against the trend",
                             scene.trend.quantity, before, x);
      continue;
    }
    before = x;
  }
}

void find_differences(const StressMethod& method, const std::vector<StressCell>& ours,
                      std::vector<StressCell>& theirs) {
  for (std::size_t k = 0; k < theirs.size(); ++k) {
    if (theirs[k].result != StressClass::converged) continue;
    if (ours[k].result != StressClass::converged) continue;
    for (const char* name : {"friction_torque", "h_min"}) {
      const double a = ours[k].answer.value(name);
      const double b = theirs[k].answer.value(name);
      const double off = std::abs(b - a) / size_of(name, a);
      if (off <= method.allowed) continue;
      theirs[k].result = StressClass::wrong;
      theirs[k].why = fmt::format("{} is {:.3g} % off", name, 100.0 * off);
      break;
    }
  }
}

}  // namespace

const char* to_string(StressClass c) {
  switch (c) {
    case StressClass::converged:
      return "converged and audited";
    case StressClass::no_steady_state:
      return "refused: no steady state";
    case StressClass::refused_input:
      return "refused: input";
    case StressClass::not_found:
      return "refused: not found";
    case StressClass::wrong:
      return "wrong";
    case StressClass::not_a_number:
      return "not a number";
    case StressClass::crashed:
      return "crash";
    case StressClass::timed_out:
      return "hang";
    case StressClass::not_run:
      break;
  }
  return "not run";
}

bool is_fault(StressClass c) {
  return c == StressClass::wrong || c == StressClass::not_a_number || c == StressClass::crashed ||
         c == StressClass::timed_out;
}

StressCell judge_end(const ChildEnd& end) {
  StressCell cell;
  cell.seconds = end.seconds;
  cell.why = end.answer;
  switch (end.how) {
    case ChildEnd::How::timed_out:
      cell.result = StressClass::timed_out;
      cell.why = fmt::format("no end after {:.0f} s", end.seconds);
      return cell;
    case ChildEnd::How::crashed:
    case ChildEnd::How::threw:
      cell.result = StressClass::crashed;
      return cell;
    case ChildEnd::How::answered:
      break;
  }
  try {
    cell.answer = answer_from(end.answer);
  } catch (const std::exception& error) {
    cell.result = StressClass::crashed;
    cell.why = fmt::format("the answer cannot be read: {}", error.what());
    return cell;
  }
  const StressAnswer& a = cell.answer;
  cell.why = a.reason;
  if (!a.faults.empty()) {
    cell.result = a.not_a_number ? StressClass::not_a_number : StressClass::wrong;
    cell.why = fmt::format("{}", fmt::join(a.faults, "; "));
  } else if (a.converged()) {
    cell.result = StressClass::converged;
  } else if (a.status == shellback::to_string(Status::no_steady_state)) {
    cell.result = StressClass::no_steady_state;
  } else if (a.status == shellback::to_string(Status::iteration_limit)) {
    cell.result = StressClass::not_found;
  } else if (a.status == shellback::to_string(Status::invalid_number)) {
    cell.result = StressClass::not_a_number;
  } else {
    cell.result = StressClass::refused_input;
  }
  return cell;
}

void judge_row(StressRow& row) {
  find_broken_trend(row.scene, row.cells.front());
  const auto& methods = stress_methods();
  for (std::size_t m = 1; m < row.cells.size(); ++m) {
    find_differences(methods[m], row.cells.front(), row.cells[m]);
  }
}

std::vector<std::string> words_of(const StressScene& scene, const StressStep& step,
                                  const StressMethodWords& method) {
  std::vector<std::string> words = scene.words;
  words.insert(words.end(), step.words.begin(), step.words.end());
  words.insert(words.end(), method.words.begin(), method.words.end());
  return words;
}

bool StressMap::shipped_is_sound() const {
  for (const StressRow& row : rows) {
    for (const StressCell& cell : row.cells.front()) {
      if (is_fault(cell.result)) return false;
    }
  }
  return true;
}

int StressMap::count(std::size_t method, StressClass c) const {
  int n = 0;
  for (const StressRow& row : rows) {
    for (const StressCell& cell : row.cells[method]) n += cell.result == c ? 1 : 0;
  }
  return n;
}

StressMap stress_map(const std::vector<StressScene>& scenes, const StressOptions& options) {
  StressMap map;
  for (const StressScene& scene : scenes) {
    map.rows.push_back(
        {scene, std::vector<std::vector<StressCell>>(stress_methods().size(),
                                                     std::vector<StressCell>(scene.steps.size()))});
  }
  const std::vector<Task> tasks = tasks_for(map.rows, options.only_default);
  const int count = static_cast<int>(tasks.size());
  int finished = 0;
  map.complete = run_in_children(
      count, {options.at_once, options.limit_s, options.stop},
      [&](int k) { return to_text(solve_stress_case(scenes[tasks[k].row], tasks[k].words)); },
      [&](int k, const ChildEnd& end) {
        const Task& task = tasks[k];
        map.rows[task.row].cells[task.method][task.step] = judge_end(end);
        if (options.tell) options.tell(full_name(scenes[task.row]), ++finished, count);
      });
  for (StressRow& row : map.rows) judge_row(row);
  return map;
}

}  // namespace shellback::proof
