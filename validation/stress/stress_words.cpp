#include "validation/stress/stress_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/reading/read_case.hpp"
#include "core/contract.hpp"

namespace shellback::validation {
namespace {

using app::Override;

std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

bearing::Physics physics_of_cell(const StressScene& scene, const StressStep& step) {
  std::vector<Override> changes;
  for (const std::string& word : words_of(scene, step, {})) {
    changes.push_back(app::parse_override(word));
  }
  try {
    return bearing::physics_of(app::read_case(scene.case_path, changes, {scene.tier}), scene.tier);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

const char* stress_mark(StressClass c) {
  switch (c) {
    case StressClass::converged:
      return "ok";
    case StressClass::no_steady_state:
      return "none";
    case StressClass::refused_input:
      return "inp";
    case StressClass::not_found:
      return "?";
    case StressClass::by_convention:
      return "conv";
    case StressClass::missed:
      return "**MISS**";
    case StressClass::wrong_refusal:
      return "🟥 **REFUSAL**";
    case StressClass::wrong:
      return "**WRONG**";
    case StressClass::not_a_number:
      return "**NaN**";
    case StressClass::crashed:
      return "**CRASH**";
    case StressClass::timed_out:
      return "**HANG**";
    case StressClass::not_run:
      break;
  }
  return "·";
}

std::string in_short(const std::string& why, std::size_t most) {
  std::string text = why.substr(0, why.find(" ("));
  if (text.size() <= most) return text;
  text = text.substr(0, text.rfind(' ', most - 1));
  return text + " …";
}

std::string end_of_row(const StressRow& row) {
  for (std::size_t k = 0; k < row.scene.steps.size(); ++k) {
    const StressCell& cell = row.cells.front()[k];
    if (cell.result == StressClass::converged || cell.result == StressClass::not_run) continue;
    return row.scene.steps[k].label + ": " + in_short(cell.why, 70);
  }
  return "";
}

std::string repeat_command(const StressScene& scene, const StressStep& step,
                           const StressMethod& method) {
  const auto words = words_for(method, physics_of_cell(scene, step));
  std::string out =
      fmt::format("shellback run {} --tier {}", scene.case_path, to_string(scene.tier));
  for (const std::string& word : words_of(scene, step, words)) out += " --set " + quoted(word);
  return out;
}

std::string faults_in_words(const StressMap& map) {
  std::string out = "Shellback as shipped:";
  const char* comma = "";
  for (const StressClass c : kStressClasses) {
    if (!is_fault(c)) continue;
    out += fmt::format("{} {} {}", comma, map.count(0, c), to_string(c));
    comma = ",";
  }
  int faulty = 0;
  for (const StressRow& row : map.rows) {
    for (const auto& step : row.asked) {
      faulty += static_cast<int>(std::count_if(
          step.begin(), step.end(), [](const auto& w) { return is_fault(w.cell.result); }));
    }
  }
  return out + fmt::format(
                   "; {} missed (not found, but there is one); {} solves asked beside, {} "
                   "of them hung or faulty",
                   map.count(0, StressClass::missed), map.count_questions(), faulty);
}

}  // namespace shellback::validation
