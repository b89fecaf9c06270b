#include "validation/stress/stress_list.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "validation/stress/stress_words.hpp"

namespace shellback::validation {
namespace {

std::string csv_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c == '\n' ? ' ' : c;
  }
  return out + "\"";
}

/// Numbers, time and reason; no numbers without convergence.
std::string csv_rest(const StressCell& cell) {
  const StressAnswer& a = cell.answer;
  std::string out;
  for (const double x :
       {a.value("friction_torque"), a.value("h_min"), a.value("p_max"), a.value("T_film_max"),
        a.audit.mass, a.audit.energy, a.audit.load, a.audit.moment}) {
    out += a.converged() && std::isfinite(x) ? fmt::format(",{:.8g}", x) : std::string(",");
  }
  return out + fmt::format(",{:.3g},{}", cell.seconds, csv_text(cell.why));
}

using Sorted = nlohmann::json;

Sorted cell_json(const StressRow& row, std::size_t m, std::size_t k) {
  const StressCell& cell = row.cells[m][k];
  Sorted j{{"scene", row.scene.name},
           {"tier", to_string(row.scene.tier)},
           {"method", stress_methods()[m].name},
           {"value", row.scene.steps[k].label},
           {"class", to_string(cell.result)},
           {"why", cell.why},
           {"seconds", cell.seconds}};
  if (cell.convention) j["convention"] = true;
  if (cell.result == StressClass::converged) {
    for (const auto& [name, x] : cell.answer.quantities) j["quantities"][name] = x;
  }
  const bool open = cell.result == StressClass::not_found || cell.result == StressClass::missed;
  if (is_fault(cell.result) || open) {
    j["repeat"] = repeat_command(row.scene, row.scene.steps[k], stress_methods()[m]);
  }
  return j;
}

Sorted asked_json(const StressRow& row, std::size_t k) {
  Sorted list = Sorted::array();
  for (const StressWitness& w : row.asked[k]) {
    list.push_back({{"asked", w.name},
                    {"class", to_string(w.cell.result)},
                    {"why", w.cell.why},
                    {"seconds", w.cell.seconds}});
  }
  return list;
}

}  // namespace

std::string stress_csv(const StressMap& map) {
  std::string out =
      "scene,tier,method,value,class,friction_torque_Nm,h_min_m,p_max_Pa,T_film_max_K,"
      "mass_audit,energy_audit,load_audit,moment_audit,seconds,why\n";
  for (const StressRow& row : map.rows) {
    for (std::size_t m = 0; m < row.cells.size(); ++m) {
      for (std::size_t k = 0; k < row.cells[m].size(); ++k) {
        const StressCell& cell = row.cells[m][k];
        if (cell.result == StressClass::not_run) continue;
        out += fmt::format("{},{},{},{},{}{}\n", row.scene.name, to_string(row.scene.tier),
                           stress_methods()[m].name, csv_text(row.scene.steps[k].label),
                           csv_text(to_string(cell.result)), csv_rest(cell));
      }
    }
  }
  return out;
}

std::string stress_json(const StressMap& map) {
  Sorted list = Sorted::array();
  for (const StressRow& row : map.rows) {
    for (std::size_t m = 0; m < row.cells.size(); ++m) {
      for (std::size_t k = 0; k < row.cells[m].size(); ++k) {
        if (row.cells[m][k].result == StressClass::not_run) continue;
        list.push_back(cell_json(row, m, k));
        const bool beside = m == 0 && k < row.asked.size() && !row.asked[k].empty();
        if (beside) list.back()["beside"] = asked_json(row, k);
      }
    }
  }
  Sorted counts;
  for (const StressClass c : kStressClasses) counts[to_string(c)] = map.count(0, c);
  const Sorted all{
      {"complete", map.complete}, {"shipped", std::move(counts)}, {"cells", std::move(list)}};
  return all.dump(1, ' ', false, Sorted::error_handler_t::replace) + "\n";
}

}  // namespace shellback::validation
