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
  if (!c.good()) return json;
  json["film_power"] = with_unit(c.film_power, "W");
  json["asperity_power"] = with_unit(c.asperity_power, "W");
  json["load_power"] = with_unit(c.load_power, "W");
  const HardestInstant at = hardest_instant(c);
  for (const auto& [name, x, unit] :
       {std::tuple{"angle", at.angle, "deg"}, std::tuple{"pressure", at.pressure, "Pa"},
        std::tuple{"shear_stress_film", at.tau_film, "Pa"},
        std::tuple{"shear_stress_asperity", at.tau_asperity, "Pa"},
        std::tuple{"friction_power_per_area", at.friction, "W/m2"},
        std::tuple{"heat_flux_to_shell", at.heat, "W/m2"},
        std::tuple{"T_shell_max", at.T_shell, "K"}, std::tuple{"T_film_max", at.T_film, "K"}}) {
    if (std::isfinite(x)) json["at_largest_pressure"][name] = with_unit(x, unit);
  }
  for (const auto& q : c.result.quantities) {
    Json& told = json["quantities"][q.quantity.name];
    told = with_unit(q.quantity.value, q.quantity.unit);
    if (std::isfinite(q.quantity.error_grid)) told["error_grid"] = q.quantity.error_grid;
    if (std::isfinite(q.quantity.error_time)) told["error_time"] = q.quantity.error_time;
  }
  return json;
}

Json run_in_json(const RunInShell& r) {
  Json json;
  add_status(json, r.tried ? r.verdict : Verdict{Status::interrupted, ending::Plain::not_run});
  if (!r.good()) return json;
  json["time"] = with_unit(r.end.t, "s");
  json["depth"] = with_unit(r.end.depth, "m");
  json["volume"] = with_unit(r.end.volume, "m3");
  for (const auto& [name, at] : {std::pair{"new", &r.begin}, std::pair{"run_in", &r.end}}) {
    json[name] = {{"p_asperity_max", with_unit(at->p_asperity_max, "Pa")},
                  {"h_min", with_unit(at->h_min, "m")},
                  {"friction_torque", with_unit(at->torque, "N m")}};
  }
  return json;
}

Json capability_json(const Capability& c) {
  Json json;
  json["shell"] = shell_kinds()[c.shell].name;
  json["tier"] = to_string(c.tier);
  json["speed_rpm"] = c.rpm;
  json["run_in"] = c.worn;
  json["tried"] = c.tried;
  const auto known = [](double x, const char* unit) {
    return std::isfinite(x) ? with_unit(x, unit) : Json(nullptr);
  };
  for (const auto& [name, at] : {std::pair{"borne", &c.good}, std::pair{"not_borne", &c.bad}}) {
    json[name] = at->factor > 0.0 ? Json(at->factor) : Json(nullptr);
    json[std::string("h_min_") + name] = known(at->h, "m");
    json[std::string("T_shell_max_") + name] = known(at->T, "K");
  }
  json["peak_load"] = c.good.factor > 0.0 ? with_unit(c.peak, "N") : Json(nullptr);
  json["met"] = known(c.met, "1");
  json["met_error"] = known(c.met_error, "1");
  json["limit"] = c.tried ? Json(to_string(c.limit)) : Json(nullptr);
  if (!c.reason.empty()) json["reason"] = c.reason;
  return json;
}

}  // namespace

std::string shells_json(const ShellsStudy& study) {
  Json json;
  json["status"] = study.interrupted ? "interrupted" : "finished";
  json["study"] = "shells";
  json["quick"] = study.plan.quick;
  json["grid"] = {{"cycles", study.plan.grid},
                  {"left_open", study.plan.left_open},
                  {"running_in_and_capability", study.plan.coarse}};
  for (int k = 0; k < kShells; ++k) {
    const ShellKind& kind = shell_kinds()[k];
    Json shell;
    shell["name"] = kind.name;
    shell["case"] = kind.file;
    shell["tehd"] = cycle_json(study.cycles[k][0]);
    shell["isothermal"] = cycle_json(study.cycles[k][1]);
    shell["running_in"] = {{"tehd", run_in_json(study.run_in[k][0])},
                           {"isothermal", run_in_json(study.run_in[k][1])}};
    shell["paper_power"] = with_unit(kind.power, "W");
    const solid::FrictionParts& p = study.parts[k];
    shell["friction_at_the_papers_point"] = {{"abrasive", p.abrasive},
                                             {"adhesive", p.adhesive},
                                             {"micro_hydrodynamic", p.micro_hydrodynamic}};
    for (int v = 0; v < kVariants; ++v) {
      shell["isothermal_with"][shell_variants()[v].name] = cycle_json(study.variants[v][k]);
    }
    json["shells"].push_back(shell);
  }
  json["capability"] = Json::array();
  for (const Capability& c : study.capability) json["capability"].push_back(capability_json(c));
  json["wall_s"] = study.wall_s;
  return json.dump(2) + "\n";
}

namespace {

std::string with_bar(double v, double error, int decimals) {
  const std::string value = fmt::format("{:.{}f}", v, decimals);
  return std::isfinite(error) ? fmt::format("{} +-{:.2g}", value, error) : value;
}

void write_variants(std::ostream& out, const ShellsStudy& study) {
  out << "\nisothermal, what the paper leaves open taken otherwise: asperities and sum [W], sum "
         "over "
         "plain\n";
  for (int v = 0; v < kVariants; ++v) {
    out << fmt::format("{:<42}", shell_variants()[v].name);
    for (int k = 0; k < kShells; ++k) {
      const ShellCycle& c = study.variants[v][k];
      const ShellCycle& plain = study.variants[v][0];
      if (!c.good()) {
        out << fmt::format("{:>24}", c.tried ? "not found" : "not run");
        continue;
      }
      out << fmt::format("{:>8.1f} {:>7.1f}", c.asperity_power, c.power());
      out << (k > 0 && plain.good() ? fmt::format("{:>8.3f}", c.power() / plain.power())
                                    : std::string(8, ' '));
    }
    out << '\n';
  }
}

void write_run_in(std::ostream& out, const ShellsStudy& study) {
  out << fmt::format("\n{:<16} {:<11} {:>8} {:>10} {:>24} {:>22} {:>24}\n", "running-in", "tier",
                     "time [s]", "wear [um]", "contact [MPa], new: worn", "h_min [um], new: worn",
                     "torque [N m], new: worn");
  for (int k = 0; k < kShells; ++k) {
    for (int t = 0; t < 2; ++t) {
      const RunInShell& r = study.run_in[k][t];
      out << fmt::format("{:<16} {:<11} ", shell_kinds()[k].name, t == 0 ? "tehd" : "isothermal");
      if (!r.good()) {
        out << (r.tried ? app::reason_of(r.verdict) : "not run") << '\n';
        continue;
      }
      const auto both = [](double begin, double end) {
        return fmt::format("{:.3f}: {:.3f}", begin, end);
      };
      out << fmt::format("{:>8.0f} {:>10.3f} {:>24} {:>22} {:>24}\n", r.end.t, 1e6 * r.end.depth,
                         both(1e-6 * r.begin.p_asperity_max, 1e-6 * r.end.p_asperity_max),
                         both(1e6 * r.begin.h_min, 1e6 * r.end.h_min),
                         both(r.begin.torque, r.end.torque));
    }
  }
}

void write_capability(std::ostream& out, const ShellsStudy& study) {
  out << fmt::format("\n{:<16} {:<7} {:<11} {:>7} {:>8} {:>10} {:>10} {:>10} {:>10} {:>14}  {}\n",
                     "shell", "", "tier", "rpm", "borne", "peak [kN]", "h_min [um]", "not borne",
                     "h_min [um]", "limit met at", "met first");
  const auto film = [](double h) { return std::isfinite(h) ? fmt::format("{:.3f}", 1e6 * h) : ""; };
  for (const Capability& c : study.capability) {
    if (!c.tried) continue;
    const std::string met = !std::isfinite(c.met) ? ""
                            : std::isfinite(c.met_error)
                                ? fmt::format("{:.2f} +-{:.2g}", c.met, c.met_error)
                                : fmt::format("{:.2f} +- ?", c.met);
    out << fmt::format(
        "{:<16} {:<7} {:<11} {:>7.0f} {:>8.2f} {:>10.0f} {:>10} {:>10.2f} {:>10} {:>14}  {}\n",
        shell_kinds()[c.shell].name, c.worn ? "run in" : "new", to_string(c.tier), c.rpm,
        c.good.factor, 1e-3 * c.peak, film(c.good.h), c.bad.factor, film(c.bad.h), met,
        to_string(c.limit));
  }
}

}  // namespace

void write_shells_tables(std::ostream& out, const ShellsStudy& study) {
  const ShellsPlan& plan = study.plan;
  out << fmt::format(
      "Shells of a big end, 2000 rpm, full load (substitute engine){}\n"
      "cells: {} x {}, what is left open {} x {}, running-in and capability {} x {}\n\n",
      plan.quick ? ", quick" : "", plan.grid[0], plan.grid[1], plan.left_open[0], plan.left_open[1],
      plan.coarse[0], plan.coarse[1]);
  out << fmt::format("{:<16} {:<11} {:>9} {:>13} {:>15} {:>11} {:>14} {:>16} {:>10}\n", "shell",
                     "tier", "film [W]", "asperity [W]", "sum [W]", "over plain", "squeezing [W]",
                     "h_min [um]", "p [MPa]");
  for (int k = 0; k < kShells; ++k) {
    for (int t = 0; t < 2; ++t) {
      const ShellCycle& c = study.cycles[k][t];
      const char* tier = t == 0 ? "tehd" : "isothermal";
      if (!c.good()) {
        out << fmt::format("{:<16} {:<11} {}\n", shell_kinds()[k].name, tier,
                           c.tried ? app::reason_of(c.result.verdict) : "not run");
        continue;
      }
      const ShellCycle& plain = study.cycles[0][t];
      out << fmt::format(
          "{:<16} {:<11} {:>9.1f} {:>13.1f} {:>15} {:>11.2f} {:>14.1f} {:>16} {:>10.0f}\n",
          shell_kinds()[k].name, tier, c.film_power, c.asperity_power,
          with_bar(c.power(), c.power_error(), 1), plain.good() ? c.power() / plain.power() : NAN,
          c.load_power,
          with_bar(1e6 * bearing::value_of(c.result, "h_min"), 1e6 * error_of(c.result, "h_min"),
                   3),
          1e-6 * bearing::value_of(c.result, "p_max"));
    }
  }
  out << "\nfilm, asperity: torque times speed; squeezing, left out of the sum: work of the load "
         "on "
         "the moving pin\n";
  write_variants(out, study);
  out << fmt::format("\n{:<16} {:>9} {:>7} {:>14} {:>18} {:>18} {:>14} {:>8}\n", "hardest, tehd",
                     "at [deg]", "[MPa]", "film tau [kPa]", "asperity tau [kPa]",
                     "friction [kW/m2]", "heat [kW/m2]", "T [degC]");
  for (int k = 0; k < kShells; ++k) {
    const ShellCycle& c = study.cycles[k][0];
    if (!c.good()) continue;
    const HardestInstant at = hardest_instant(c);
    out << fmt::format(
        "{:<16} {:>9.0f} {:>7.1f} {:>14.1f} {:>18.2f} {:>18.1f} {:>14.1f} {:>8.1f}\n",
        shell_kinds()[k].name, at.angle, 1e-6 * at.pressure, 1e-3 * at.tau_film,
        1e-3 * at.tau_asperity, 1e-3 * at.friction, 1e-3 * at.heat, at.T_shell - kZeroCelsius);
  }
  write_run_in(out, study);
  write_capability(out, study);
}

}  // namespace shellback::validation
