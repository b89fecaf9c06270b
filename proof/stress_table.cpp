#include "proof/stress_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/read_case.hpp"
#include "core/contract.hpp"

namespace shellback::proof {
namespace {

using app::Override;

constexpr std::array kClasses{StressClass::converged,     StressClass::no_steady_state,
                              StressClass::refused_input, StressClass::not_found,
                              StressClass::wrong,         StressClass::not_a_number,
                              StressClass::crashed,       StressClass::timed_out};
constexpr const char* kLegend =
    "`ok` converged and audited · `phy` refused, physics has no steady state · `inp` refused as "
    "input · `?` refused, not found · `WRONG` · `NaN` · `CRASH` · `HANG` · `·` does not apply\n";

const char* mark_of(StressClass c) {
  switch (c) {
    case StressClass::converged:
      return "ok";
    case StressClass::no_steady_state:
      return "phy";
    case StressClass::refused_input:
      return "inp";
    case StressClass::not_found:
      return "?";
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

/// For Markdown table cells.
std::string cell_text(std::string text) {
  for (char& c : text) {
    if (c == '|' || c == '\n') c = ' ';
  }
  return text;
}

std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string csv_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c == '\n' ? ' ' : c;
  }
  return out + "\"";
}

coupling::Physics physics_of_cell(const StressScene& scene, const StressStep& step) {
  std::vector<Override> changes;
  for (const std::string& word : words_of(scene, step, {})) {
    changes.push_back(app::parse_override(word));
  }
  try {
    return coupling::physics_of(app::read_case(scene.case_path, changes, {scene.tier}), scene.tier);
  } catch (const InputError&) {
    return {};
  }
}

/// Rows of counts, one per method.
std::string counts(const StressMap& map) {
  std::string out = "| method | cells |";
  for (const StressClass c : kClasses) out += fmt::format(" {} |", to_string(c));
  out += "\n|---|---:|" + std::string("---:|");
  for (std::size_t k = 1; k < kClasses.size(); ++k) out += "---:|";
  out += "\n";
  const auto& methods = stress_methods();
  for (std::size_t m = 0; m < methods.size(); ++m) {
    int all = 0;
    std::string line;
    for (const StressClass c : kClasses) {
      all += map.count(m, c);
      line += fmt::format(" {} |", map.count(m, c));
    }
    if (all == 0) continue;
    const char* weight = methods[m].shipped ? "**" : "";
    out += fmt::format("| {0}{1}{0} | {2} |{3}\n", weight, methods[m].title, all, line);
  }
  return out;
}

std::string row_line(const StressRow& row, std::size_t m) {
  std::string line =
      fmt::format("| {} | {} |", to_string(row.scene.tier), stress_methods()[m].title);
  for (const StressCell& cell : row.cells[m]) line += fmt::format(" {} |", mark_of(cell.result));
  return line + "\n";
}

bool was_run(const std::vector<StressCell>& cells) {
  for (const StressCell& cell : cells) {
    if (cell.result != StressClass::not_run) return true;
  }
  return false;
}

/// What ended the default's row, value by value.
std::string endings(const StressRow& row) {
  std::string out;
  for (std::size_t k = 0; k < row.scene.steps.size(); ++k) {
    const StressCell& cell = row.cells.front()[k];
    if (cell.result == StressClass::converged || cell.result == StressClass::not_run) continue;
    out += fmt::format("- {}, {}: {}: {}\n", to_string(row.scene.tier), row.scene.steps[k].label,
                       to_string(cell.result), cell_text(in_short(cell.why, 160)));
  }
  return out;
}

}  // namespace

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

std::string stress_page(const StressMap& map, const std::string& picture,
                        const std::string& command) {
  std::string out = "# Stability map\n\n";
  out += fmt::format("Made by `{}`; not written by hand.\n\n", command);
  if (!map.complete) out += "**Stopped before the end: cells are missing.**\n\n";
  if (!picture.empty()) out += fmt::format("![Stability map]({})\n\n", picture);
  out += "## Counts\n\n" + counts(map) + "\n## Scenes\n\n" + kLegend;
  std::string before;
  for (std::size_t r = 0; r < map.rows.size(); ++r) {
    const StressRow& row = map.rows[r];
    if (row.scene.name != before) {
      before = row.scene.name;
      out += fmt::format("\n### {}: {}\n\nDriven: {}. Expected: {}.\n\n| tier | method |",
                         row.scene.name, row.scene.title, row.scene.axis, row.scene.expect);
      for (const StressStep& step : row.scene.steps) out += fmt::format(" {} |", step.label);
      out += "\n|---|---|";
      for (std::size_t k = 0; k < row.scene.steps.size(); ++k) out += "---|";
      out += "\n";
      for (std::size_t s = r; s < map.rows.size() && map.rows[s].scene.name == before; ++s) {
        for (std::size_t m = 0; m < map.rows[s].cells.size(); ++m) {
          if (was_run(map.rows[s].cells[m])) out += row_line(map.rows[s], m);
        }
      }
      out += "\n";
    }
    out += endings(row);
  }
  return out;
}

std::string stress_csv(const StressMap& map) {
  std::string out =
      "scene,tier,method,value,class,friction_torque_Nm,h_min_m,p_max_Pa,T_film_max_K,"
      "mass_audit,energy_audit,load_audit,moment_audit,seconds,why\n";
  for (const StressRow& row : map.rows) {
    for (std::size_t m = 0; m < row.cells.size(); ++m) {
      for (std::size_t k = 0; k < row.cells[m].size(); ++k) {
        const StressCell& cell = row.cells[m][k];
        if (cell.result == StressClass::not_run) continue;
        const StressAnswer& a = cell.answer;
        out += fmt::format("{},{},{},{},{}", row.scene.name, to_string(row.scene.tier),
                           stress_methods()[m].name, csv_text(row.scene.steps[k].label),
                           csv_text(to_string(cell.result)));
        const bool known = cell.result == StressClass::converged ||
                           cell.result == StressClass::wrong;  // no numbers without convergence
        for (const double x :
             {a.value("friction_torque"), a.value("h_min"), a.value("p_max"), a.value("T_film_max"),
              a.audit.mass, a.audit.energy, a.audit.load, a.audit.moment}) {
          out += known && std::isfinite(x) ? fmt::format(",{:.8g}", x) : std::string(",");
        }
        out += fmt::format(",{:.3g},{}\n", cell.seconds, csv_text(cell.why));
      }
    }
  }
  return out;
}

std::string stress_json(const StressMap& map) {
  nlohmann::json list = nlohmann::json::array();
  for (const StressRow& row : map.rows) {
    for (std::size_t m = 0; m < row.cells.size(); ++m) {
      for (std::size_t k = 0; k < row.cells[m].size(); ++k) {
        const StressCell& cell = row.cells[m][k];
        if (cell.result == StressClass::not_run) continue;
        nlohmann::json j{{"scene", row.scene.name},
                         {"tier", to_string(row.scene.tier)},
                         {"method", stress_methods()[m].name},
                         {"value", row.scene.steps[k].label},
                         {"class", to_string(cell.result)},
                         {"why", cell.why},
                         {"seconds", cell.seconds}};
        if (cell.result == StressClass::converged) {
          for (const auto& [name, x] : cell.answer.quantities) j["quantities"][name] = x;
        }
        if (is_fault(cell.result) || cell.result == StressClass::not_found) {
          j["repeat"] = repeat_command(row.scene, row.scene.steps[k], stress_methods()[m]);
        }
        list.push_back(std::move(j));
      }
    }
  }
  const nlohmann::json all{{"complete", map.complete}, {"cells", std::move(list)}};
  return all.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string stress_summary(const StressMap& map) {
  std::string out = fmt::format("{:<28}", "cells");
  for (const StressClass c : kClasses) out += fmt::format(" {:>9.9}", mark_of(c));
  out += "\n";
  for (std::size_t m = 0; m < stress_methods().size(); ++m) {
    int all = 0;
    std::string line;
    for (const StressClass c : kClasses) {
      all += map.count(m, c);
      line += fmt::format(" {:>9}", map.count(m, c));
    }
    if (all > 0) out += fmt::format("{:<28}{}\n", stress_methods()[m].title, line);
  }
  return out;
}

}  // namespace shellback::proof
