#include "validation/stress/stress_map.hpp"

#include "app/reading/read_case.hpp"
#include "core/contract.hpp"
#include "validation/stress/stress_judge.hpp"
#include "validation/stress/stress_question.hpp"

namespace shellback::validation {
namespace {

/// A solve that does not end at its limit has hung; a second more tells the signal from a kill [s].
constexpr double kGrace = 1.0;
/// Clock time over processor time after which a solve has hung: the machine may be busy [-].
constexpr double kPatience = 20.0;

struct Task {
  std::size_t row;
  std::size_t method;
  std::size_t step;
  std::vector<std::string> words;
};

/// Physics of a scene's first step that can be read; which methods apply follows from it.
bearing::Physics physics_of_scene(const StressScene& scene) {
  for (const StressStep& step : scene.steps) {
    try {
      std::vector<app::Override> changes;
      for (const std::string& word : words_of(scene, step, {})) {
        changes.push_back(app::parse_override(word));
      }
      return bearing::physics_of(app::read_case(scene.case_path, changes, {scene.tier}),
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
    const bearing::Physics physics = physics_of_scene(rows[r].scene);
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

}  // namespace

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

int StressMap::count_conventions(std::size_t method) const {
  int n = 0;
  for (const StressRow& row : rows) {
    for (const StressCell& cell : row.cells[method]) n += cell.convention ? 1 : 0;
  }
  return n;
}

int StressMap::count_questions() const {
  std::size_t n = 0;
  for (const StressRow& row : rows) {
    for (const auto& step : row.asked) n += step.size();
  }
  return static_cast<int>(n);
}

namespace {

/// Solves every cell; false if it was stopped.
bool solve_cells(const StressOptions& options, StressMap& map) {
  const std::vector<Task> tasks = tasks_for(map.rows, options.only_default);
  const int count = static_cast<int>(tasks.size());
  int finished = 0;
  return run_in_children(
      count, {options.at_once, options.limit_s, kGrace, kPatience, options.stop},
      [&](int k) {
        return to_text(solve_stress_case(map.rows[tasks[k].row].scene, tasks[k].words));
      },
      [&](int k, const ChildEnd& end) {
        const Task& task = tasks[k];
        map.rows[task.row].cells[task.method][task.step] = judge_end(end);
        if (options.tell) options.tell(full_name(map.rows[task.row].scene), ++finished, count);
      });
}

/// Asks what else there is to be asked; false if it was stopped.
bool ask_beside(const StressOptions& options, StressMap& map) {
  struct Asked {
    std::size_t row;
    std::size_t step;
    StressQuestion what;
  };
  std::vector<Asked> all;
  for (std::size_t r = 0; r < map.rows.size(); ++r) {
    for (std::size_t k = 0; k < map.rows[r].scene.steps.size(); ++k) {
      for (StressQuestion& q : questions_about(map.rows[r], k)) all.push_back({r, k, std::move(q)});
    }
  }
  const int count = static_cast<int>(all.size());
  int finished = 0;
  return run_in_children(
      count, {options.at_once, options.limit_s, kGrace, kPatience, options.stop},
      [&](int k) { return to_text(solve_stress_case(all[k].what.scene, all[k].what.words)); },
      [&](int k, const ChildEnd& end) {
        const Asked& asked = all[k];
        map.rows[asked.row].asked[asked.step].push_back(
            {asked.what.question, asked.what.name, judge_end(end)});
        const std::string name = full_name(map.rows[asked.row].scene) + ": " + asked.what.name;
        if (options.tell) options.tell(name, ++finished, count);
      });
}

}  // namespace

StressMap stress_map(const std::vector<StressScene>& scenes, const StressOptions& options) {
  StressMap map;
  for (const StressScene& scene : scenes) {
    const std::size_t steps = scene.steps.size();
    map.rows.push_back({scene});
    map.rows.back().cells.assign(stress_methods().size(), std::vector<StressCell>(steps));
    map.rows.back().asked.resize(steps);
  }
  map.complete = solve_cells(options, map) && ask_beside(options, map);
  for (StressRow& row : map.rows) judge_row(row);
  return map;
}

}  // namespace shellback::validation
