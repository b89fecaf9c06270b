#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "app/json_parts.hpp"
#include "app/words/ending_words.hpp"
#include "core/constants.hpp"
#include "validation/shells/shells_page.hpp"

namespace shellback::validation {
namespace {

using namespace app::json_parts;
using bearing::Tier;

Json cycle_json(const ShellCycle& c) {
  Json json;
  add_status(json,
             c.tried ? c.result.verdict : Verdict{Status::interrupted, ending::Plain::not_run});
  if (!c.tried || !c.result.verdict.good()) return json;
  json["film_power"] = with_unit(c.film_power, "W");
  json["asperity_power"] = with_unit(c.asperity_power, "W");
  json["load_power"] = with_unit(c.load_power, "W");
  for (const auto& q : c.result.quantities) {
    json["quantities"][q.quantity.name] = with_unit(q.quantity.value, q.quantity.unit);
  }
  return json;
}

Json capability_json(const Capability& c) {
  Json json;
  json["shell"] = shell_kinds()[c.shell].name;
  json["tier"] = to_string(c.tier);
  json["speed_rpm"] = c.rpm;
  json["tried"] = c.tried;
  json["borne"] = c.good > 0.0 ? Json(c.good) : Json(nullptr);
  json["not_borne"] = c.bad > 0.0 ? Json(c.bad) : Json(nullptr);
  json["peak_load"] = c.good > 0.0 ? with_unit(c.peak, "N") : Json(nullptr);
  json["h_min_borne"] = std::isfinite(c.h_good) ? with_unit(c.h_good, "m") : Json(nullptr);
  json["h_min_not_borne"] = std::isfinite(c.h_bad) ? with_unit(c.h_bad, "m") : Json(nullptr);
  json["limit"] = to_string(c.limit);
  if (!c.reason.empty()) json["reason"] = c.reason;
  return json;
}

}  // namespace

std::string shells_json(const ShellsStudy& study) {
  Json json;
  json["status"] = study.interrupted ? "interrupted" : "finished";
  json["study"] = "shells";
  for (int k = 0; k < kShells; ++k) {
    const ShellKind& kind = shell_kinds()[k];
    Json shell;
    shell["name"] = kind.name;
    shell["case"] = kind.file;
    shell["tehd"] = cycle_json(study.cycles[k][0]);
    shell["isothermal"] = cycle_json(study.cycles[k][1]);
    shell["paper_power"] = with_unit(kind.power, "W");
    const solid::FrictionParts& p = study.parts[k];
    shell["friction_at_the_papers_point"] = {{"abrasive", p.abrasive},
                                             {"adhesive", p.adhesive},
                                             {"micro_hydrodynamic", p.micro_hydrodynamic}};
    json["shells"].push_back(shell);
  }
  json["capability"] = Json::array();
  for (const Capability& c : study.capability) json["capability"].push_back(capability_json(c));
  json["wall_s"] = study.wall_s;
  return json.dump(2) + "\n";
}

void write_shells_tables(std::ostream& out, const ShellsStudy& study) {
  out << "Shells of a big end, 2000 rpm, full load (substitute engine)\n\n";
  out << fmt::format("{:<16} {:<11} {:>9} {:>13} {:>9} {:>11} {:>14} {:>10} {:>10}\n", "shell",
                     "tier", "film [W]", "asperity [W]", "sum [W]", "over plain", "squeezing [W]",
                     "h_min [um]", "p [MPa]");
  for (int k = 0; k < kShells; ++k) {
    for (int t = 0; t < 2; ++t) {
      const ShellCycle& c = study.cycles[k][t];
      const char* tier = t == 0 ? "tehd" : "isothermal";
      if (!c.result.verdict.good() || !c.tried) {
        out << fmt::format("{:<16} {:<11} {}\n", shell_kinds()[k].name, tier,
                           c.tried ? app::reason_of(c.result.verdict) : "not run");
        continue;
      }
      const ShellCycle& plain = study.cycles[0][t];
      const double sum = c.film_power + c.asperity_power;
      out << fmt::format(
          "{:<16} {:<11} {:>9.1f} {:>13.1f} {:>9.1f} {:>11.2f} {:>14.1f} {:>10.3f} {:>10.0f}\n",
          shell_kinds()[k].name, tier, c.film_power, c.asperity_power, sum,
          sum / (plain.film_power + plain.asperity_power), c.load_power,
          1e6 * bearing::value_of(c.result, "h_min"), 1e-6 * bearing::value_of(c.result, "p_max"));
    }
  }
  out << "\nfilm, asperity: torque times speed; squeezing, left out of the sum: work of the load "
         "on "
         "the moving pin\n";
  out << fmt::format("\n{:<16} {:<11} {:>7} {:>8} {:>10} {:>10} {:>10} {:>10}  {}\n", "shell",
                     "tier", "rpm", "borne", "peak [kN]", "h_min [um]", "not borne", "h_min [um]",
                     "met first");
  const auto film = [](double h) { return std::isfinite(h) ? fmt::format("{:.3f}", 1e6 * h) : ""; };
  for (const Capability& c : study.capability) {
    if (!c.tried) continue;
    out << fmt::format("{:<16} {:<11} {:>7.0f} {:>8.2f} {:>10.0f} {:>10} {:>10.2f} {:>10}  {}\n",
                       shell_kinds()[c.shell].name, to_string(c.tier), c.rpm, c.good, 1e-3 * c.peak,
                       film(c.h_good), c.bad, film(c.h_bad), to_string(c.limit));
  }
}

}  // namespace shellback::validation
