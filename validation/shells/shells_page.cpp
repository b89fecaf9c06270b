#include "validation/shells/shells_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/html_page.hpp"
#include "app/html_tables.hpp"
#include "app/pictures/svg.hpp"
#include "app/words/ending_words.hpp"
#include "core/constants.hpp"

namespace shellback::validation {
namespace {

using app::escape_markup;
using app::figures_html;
using app::page_section;
using bearing::Tier;

constexpr const char* kStyle = R"css(
td.left, th.left { text-align: left; white-space: normal; }
.note { border-left: 4px solid var(--total); background: var(--panel); padding: 8px 14px;
  max-width: 96ch; }
)css";

constexpr const char* kIntroduction =
    "<p class=\"note\"><strong>The engine is a substitute.</strong> The paper's engine, oil, "
    "bearing sizes, temperatures and the constants of its friction law are not published. Surfaces "
    "(its Tables 1 to 3) are the paper's; engine, oil and cooling are those of the case big-end, "
    "constants of friction follow from its Table 4 with choices that the table leaves open. What "
    "can be compared is the order of the shells and their ratios, not the watts; how far their "
    "bars allow that stands below the first table.</p>\n";

std::string head() {
  return app::page_head(
      {.title = "Shells of a big end",
       .heading = "AlSn against polymer shells",
       .scene = {"After Offner and Knaus, Lubricants 3 (2015) 522-538: plain AlSn, grooved AlSn "
                 "and polymer-coated shell in the big end of a Diesel, 2000 rpm, full load"},
       .kind = "study",
       .style = kStyle});
}

std::string met_of(const Capability& c) {
  return std::isfinite(c.met_error) ? fmt::format("{:.2f} &plusmn;{:.2g}", c.met, c.met_error)
                                    : fmt::format("{:.2f} &plusmn; ?", c.met);
}

std::string cell(double v, int decimals, bool tried = true) {
  if (std::isfinite(v)) return fmt::format("<td>{:.{}f}</td>", v, decimals);
  return tried ? "<td class=\"bad\">not found</td>" : "<td>not run</td>";
}

/// Where the figures of a table come from.
std::string on_cells(const std::array<int, 2>& grid, const std::string& more) {
  return fmt::format("<p class=\"scene\">On {} x {} cells{}</p>\n", grid[0], grid[1], more);
}

std::string table(const std::string& header, const std::string& rows) {
  return fmt::format(
      "<div class=\"scroll\"><table>\n<thead><tr><th></th>{}</tr></thead>\n<tbody>\n{}</tbody>"
      "</table></div>\n",
      header, rows);
}

double value(const ShellCycle& c, const char* name) {
  return c.good() ? bearing::value_of(c.result, name) : NAN;
}

double power(const ShellCycle& c) { return c.good() ? c.power() : NAN; }

std::string barred(double v, double error, int decimals, bool tried) {
  if (!std::isfinite(v) || !std::isfinite(error)) return cell(v, decimals, tried);
  return fmt::format("<td>{:.{}f} &plusmn;{:.2g}</td>", v, decimals, error);
}

/// A quantity of the cycle with the bars of grid and steps.
std::string barred(const ShellCycle& c, const char* name, double scale, int decimals) {
  return barred(scale * value(c, name), scale * error_of(c.result, name), decimals, c.tried);
}

/// The same of a temperature, in degC.
std::string warm(const ShellCycle& c, const char* name) {
  return barred(value(c, name) - kZeroCelsius, error_of(c.result, name), 1, c.tried);
}

/// Friction power of a shell over that of the plain one; its bar is the worst that both bars make.
struct OverPlain {
  double ratio = NAN;
  double error = NAN;
};

OverPlain over_plain(const ShellsStudy& study, int shell, int tier) {
  const ShellCycle& c = study.cycles[shell][tier];
  const ShellCycle& plain = study.cycles[0][tier];
  const double ratio = power(c) / power(plain);
  if (shell == 0) return {ratio, 0.0};
  const double least = power(plain) - plain.power_error();
  return {ratio, least > 0.0 ? (power(c) + c.power_error()) / least - ratio : NAN};
}

std::string ratio_html(const ShellsStudy& study, int shell, int tier) {
  const OverPlain r = over_plain(study, shell, tier);
  const bool tried = study.cycles[shell][tier].tried && study.cycles[0][tier].tried;
  if (shell == 0) return cell(r.ratio, 2, tried);
  return barred(r.ratio, r.error, 2, tried);
}

/// What the ratios say of the paper's result, by their own bars.
std::string verdict_html(const ShellsStudy& study) {
  std::string html;
  for (int k = 1; k < kShells; ++k) {
    const OverPlain r = over_plain(study, k, 0);
    const double paper = shell_kinds()[k].power / shell_kinds()[0].power;
    if (!study.cycles[k][0].tried || !study.cycles[0][0].tried) {
      html += fmt::format("<li>{}: not run.</li>\n", shell_kinds()[k].name);
      continue;
    }
    if (!std::isfinite(r.error)) {
      html += fmt::format(
          "<li>{}: no bar is known, and nothing can be said of the paper's {:.2f}.</li>\n",
          shell_kinds()[k].name, paper);
      continue;
    }
    const bool apart = std::abs(r.ratio - 1.0) > r.error;
    const bool met = std::abs(r.ratio - paper) <= r.error;
    html += fmt::format(
        "<li>{}: {:.2f} &plusmn;{:.2g} of the plain shell{}; the paper's {:.2f} is {}.</li>\n",
        shell_kinds()[k].name, r.ratio, r.error,
        apart ? "" : ", from which these cells cannot tell it apart", paper,
        met ? "within the bar"
            : "<strong>not reproduced</strong> by the cases as they are (what "
              "it may hang on: next table)");
  }
  return "<ul>\n" + html + "</ul>\n";
}

std::string powers_html(const ShellsStudy& study) {
  std::string rows;
  for (int k = 0; k < kShells; ++k) {
    const ShellCycle& hot = study.cycles[k][0];
    const ShellCycle& even = study.cycles[k][1];
    const ShellKind& kind = shell_kinds()[k];
    rows += fmt::format("<tr><td class=\"left\">{}</td>", kind.name);
    const bool good = hot.good();
    rows += cell(good ? hot.film_power : NAN, 1, hot.tried);
    rows +=
        barred(good ? hot.asperity_power : NAN, good ? hot.asperity_error() : NAN, 1, hot.tried);
    rows += barred(power(hot), hot.power_error(), 1, hot.tried) + ratio_html(study, k, 0);
    rows += cell(kind.power, 1) + cell(kind.power / shell_kinds()[0].power, 2);
    rows += barred(power(even), even.power_error(), 1, even.tried) + ratio_html(study, k, 1);
    rows += cell(good ? hot.load_power : NAN, 1, hot.tried) + "</tr>\n";
  }
  return table(
             "<th>film [W]</th><th>asperities [W]</th><th>sum [W]</th><th>over plain</th>"
             "<th>paper, Table 5 [W]</th><th>over plain</th><th>isothermal [W]</th>"
             "<th>over plain</th><th>squeezing [W]</th>",
             rows) +
         "<p class=\"scene\">Torque on the pin times its speed. Left out of the sums is "
         "squeezing: what the load spends on the film by moving the pin.</p>\n" +
         on_cells(study.plan.grid, ", with the bars of cells and steps where there are some.") +
         verdict_html(study);
}

/// Isothermal friction of the shells with what the paper leaves open taken otherwise.
std::string variants_html(const ShellsStudy& study) {
  std::string rows;
  for (int v = 0; v < kVariants; ++v) {
    rows += fmt::format("<tr><td class=\"left\">{}</td>", shell_variants()[v].name);
    for (int k = 0; k < kShells; ++k) {
      const ShellCycle& c = study.variants[v][k];
      const bool tried = c.tried && study.variants[v][0].tried;
      rows += cell(c.good() ? c.asperity_power : NAN, 1, c.tried) + cell(power(c), 1, c.tried);
      if (k > 0) rows += cell(power(c) / power(study.variants[v][0]), 3, tried);
    }
    rows += "</tr>\n";
  }
  std::string header = "<th>plain: asperities [W]</th><th>sum [W]</th>";
  for (const char* name : {"grooved", "polymer"}) {
    header += fmt::format("<th>{}: asperities [W]</th><th>sum [W]</th><th>over plain</th>", name);
  }
  return table(header, rows) +
         "<p class=\"scene\">Isothermal. The paper has 1, 0.94 and 0.70. It tells that a drilling "
         "of "
         "the pin opens 20 degrees beside the rod's axis when the film presses hardest (4.2), not "
         "on "
         "which side nor how large; the cases feed through the shell, beside the load. Nor does it "
         "tell how warm the oil is.</p>\n" +
         on_cells(
             study.plan.left_open,
             ", without bars: rows are to be compared with each other, not with other tables.");
}

std::string films_html(const ShellsStudy& study) {
  std::string rows;
  for (int k = 0; k < kShells; ++k) {
    for (int t = 0; t < 2; ++t) {
      const ShellCycle& c = study.cycles[k][t];
      rows += fmt::format("<tr><td class=\"left\">{}, {}</td>", shell_kinds()[k].name,
                          t == 0 ? "tehd" : "isothermal");
      rows += barred(c, "h_min", 1e6, 2) + barred(c, "p_max", 1e-6, 0);
      rows += barred(c, "p_asperity_max", 1e-6, 1);
      if (t == 0) {
        rows += warm(c, "T_film_max") + warm(c, "T_shell_max");
      } else {
        rows += "<td></td><td></td>";
      }
      rows += "</tr>\n";
    }
  }
  return table(
             "<th>smallest film [&micro;m]</th><th>film pressure [MPa]</th><th>contact [MPa]</th>"
             "<th>film [&deg;C]</th><th>lining [&deg;C]</th>",
             rows) +
         on_cells(study.plan.grid, ", with the bars of cells and steps.");
}

std::string parts_html(const ShellsStudy& study) {
  std::string rows;
  for (int k = 0; k < kShells; ++k) {
    const solid::FrictionParts& p = study.parts[k];
    const auto& t = shell_kinds()[k].coefficients;
    rows += fmt::format("<tr><td class=\"left\">{}</td>", shell_kinds()[k].name);
    for (const auto& [ours, theirs] :
         {std::pair{p.abrasive, t[0]}, std::pair{p.adhesive, t[1]},
          std::pair{p.micro_hydrodynamic, t[2]}, std::pair{p.sum(), t[0] + t[1] + t[2]}}) {
      rows += cell(ours, 4) + cell(theirs, 4);
    }
    rows += "</tr>\n";
  }
  return table(
             "<th>abrasive</th><th>paper</th><th>adhesive</th><th>paper</th>"
             "<th>micro-hydrodynamic</th><th>paper</th><th>sum</th><th>paper</th>",
             rows) +
         "<p class=\"scene\">At 10 MPa contact pressure, 0.01 Pa s, 10 m/s. The constants were "
         "identified from this table: it is a check of the law, not evidence for it.</p>\n";
}

std::string capability_html(const ShellsStudy& study) {
  const auto film = [](double h) {
    return std::isfinite(h) ? cell(1e6 * h, 2) : std::string("<td></td>");
  };
  std::string rows;
  for (const Capability& c : study.capability) {
    rows += fmt::format("<tr><td class=\"left\">{}, {}, {}, {:.0f} rpm</td>",
                        shell_kinds()[c.shell].name, c.worn ? "run in" : "new", to_string(c.tier),
                        c.rpm);
    if (!c.tried) {
      rows +=
          "<td class=\"bad\">not "
          "run</td><td></td><td></td><td></td><td></td><td></td><td></td></tr>\n";
      continue;
    }
    const double good = c.good.factor;
    rows += good > 0.0 ? cell(good, 2) + cell(1e-3 * c.peak, 0) + film(c.good.h)
                       : fmt::format("<td class=\"bad\">below {:.2f}</td><td></td><td></td>",
                                     study.plan.factors[0]);
    rows += c.bad.factor > 0.0 ? cell(c.bad.factor, 2) : fmt::format("<td>above {:.2f}</td>", good);
    rows += film(c.bad.h);
    rows += std::isfinite(c.met) ? fmt::format("<td>{}</td>", met_of(c)) : "<td></td>";
    rows += fmt::format("<td class=\"left\">{}{}</td></tr>\n", to_string(c.limit),
                        c.reason.empty() ? "" : ": " + escape_markup(c.reason));
  }
  return table(
      "<th>borne, of the load</th><th>peak [kN]</th><th>smallest film [&micro;m]</th>"
      "<th>not borne</th><th>smallest film [&micro;m]</th><th>limit met at</th>"
      "<th class=\"left\">met first</th>",
      rows);
}

std::string run_in_html(const ShellsStudy& study) {
  std::string rows;
  for (int k = 0; k < kShells; ++k) {
    for (int t = 0; t < 2; ++t) {
      const RunInShell& r = study.run_in[k][t];
      rows += fmt::format("<tr><td class=\"left\">{}, {}</td>", shell_kinds()[k].name,
                          t == 0 ? "tehd" : "isothermal");
      const bool good = r.good();
      rows += cell(good ? r.end.t : NAN, 0, r.tried) +
              cell(good ? 1e6 * r.end.depth : NAN, 2, r.tried) +
              cell(good ? 1e9 * r.end.volume : NAN, 4, r.tried);
      for (const bearing::RunningInState* at : {&r.begin, &r.end}) {
        rows += cell(good ? 1e-6 * at->p_asperity_max : NAN, 2, r.tried) +
                cell(good ? 1e6 * at->h_min : NAN, 2, r.tried) +
                cell(good ? at->torque : NAN, 3, r.tried);
      }
      rows += "</tr>\n";
    }
  }
  return table(
             "<th>time [s]</th><th>wear [&micro;m]</th><th>volume [mm&sup3;]</th>"
             "<th>new: contact [MPa]</th><th>smallest film [&micro;m]</th><th>torque [N m]</th>"
             "<th>run in: contact [MPa]</th><th>smallest film [&micro;m]</th><th>torque [N m]</th>",
             rows) +
         "<p class=\"scene\">Under the full load at 2000 rpm, on the cells of the capability. "
         "Contact and film are extremes of the cycle, torque is its mean. The wear coefficient is "
         "that of another bearing on 13 even cells, the time a choice: see [running_in] of the "
         "cases.</p>\n" +
         on_cells(study.plan.coarse,
                  ", without bars: contact at a sharp edge, and so wear, grows several times with "
                  "more cells along; the tables above have the new shells on more.");
}

std::string hardest_html(const ShellsStudy& study) {
  std::string rows;
  for (int k = 0; k < kShells; ++k) {
    const ShellCycle& c = study.cycles[k][0];
    const bool good = c.good();
    const HardestInstant at = good ? hardest_instant(c) : HardestInstant{};
    rows += fmt::format("<tr><td class=\"left\">{}</td>", shell_kinds()[k].name);
    for (const auto& [x, decimals] :
         {std::pair{at.angle, 0}, std::pair{1e-6 * at.pressure, 1},
          std::pair{1e-3 * at.tau_film, 1}, std::pair{1e-3 * at.tau_asperity, 2},
          std::pair{1e-3 * at.friction, 1}, std::pair{1e-3 * at.heat, 1},
          std::pair{at.T_shell - kZeroCelsius, 1}, std::pair{at.T_film - kZeroCelsius, 1}}) {
      rows += cell(good ? x : NAN, decimals, c.tried);
    }
    rows += "</tr>\n";
  }
  return table(
             "<th>crank [&deg;]</th><th>film and contact [MPa]</th><th>shear, film [kPa]</th>"
             "<th>shear, asperities [kPa]</th><th>friction [kW/m&sup2;]</th>"
             "<th>heat into the shell [kW/m&sup2;]</th><th>lining [&deg;C]</th><th>film "
             "[&deg;C]</th>",
             rows) +
         "<p class=\"scene\">Tier tehd. Shear, friction power and heat are means over the whole "
         "bore, pressures and temperatures the largest of it.</p>\n" +
         on_cells(study.plan.grid, "; for bars see the tables of power and film.");
}

std::string failures_html(const ShellsStudy& study) {
  std::string html;
  const bool any = std::any_of(study.cycles.begin(), study.cycles.end(),
                               [](const auto& shell) { return shell[0].tried || shell[1].tried; });
  if (!any) return "<p class=\"scene\">No cycle has been run to its end yet.</p>\n";
  for (int k = 0; k < kShells; ++k) {
    for (const ShellCycle& c : study.cycles[k]) {
      if (!c.tried || c.good()) continue;
      html += fmt::format("<li>{}, {}: {}</li>\n", shell_kinds()[k].name, to_string(c.result.tier),
                          escape_markup(app::reason_of(c.result.verdict)));
    }
    for (int t = 0; t < 2; ++t) {
      const RunInShell& r = study.run_in[k][t];
      if (!r.tried || r.good()) continue;
      html += fmt::format("<li>{}, {}, running-in: {}</li>\n", shell_kinds()[k].name,
                          t == 0 ? "tehd" : "isothermal", escape_markup(app::reason_of(r.verdict)));
    }
    for (int v = 0; v < kVariants; ++v) {
      const ShellCycle& c = study.variants[v][k];
      if (!c.tried || c.good()) continue;
      html += fmt::format("<li>{}, {}: {}</li>\n", shell_kinds()[k].name, shell_variants()[v].name,
                          escape_markup(app::reason_of(c.result.verdict)));
    }
  }
  return html.empty() ? "<p class=\"scene\">Every cycle that was run was found.</p>\n"
                      : "<ul>\n" + html + "</ul>\n";
}

}  // namespace

std::string shells_page(const ShellsStudy& study) {
  std::string html = head() + kIntroduction;
  if (study.plan.quick) {
    html +=
        "<p class=\"note\"><strong>Quick study:</strong> few cells and one speed; what it says of "
        "contact, wear and the order of the shells may change with more (the same command without "
        "<code>--quick</code>).</p>\n";
  }
  if (study.interrupted) {
    html +=
        "<p class=\"note\"><strong>Interrupted:</strong> what was finished is shown, the rest as "
        "\"not run\"; the same command with <code>--resume</code> goes on.</p>\n";
  }
  html += page_section("Friction power (Table 5)", powers_html(study));
  html += page_section("What the order of the shells hangs on", variants_html(study));
  html += page_section("Film and temperatures", films_html(study));
  html += page_section("Over the cycle", figures_html(shell_curves(study)));
  html += page_section("On the shell", figures_html(shell_maps(study)));
  html += page_section("At the instant of the largest pressure", hardest_html(study));
  html += page_section("Boundary friction at one point (Table 4)", parts_html(study));
  html += page_section("Running-in", run_in_html(study));
  const bool sought = std::any_of(study.capability.begin(), study.capability.end(),
                                  [](const Capability& c) { return c.tried; });
  html +=
      page_section("Thermal load capability",
                   (sought ? figures_html(capability_figures(study)) : "") +
                       capability_html(study) + on_cells(study.plan.coarse, ".") +
                       "<p class=\"scene\">Limits assumed: lining 170 &deg;C (AlSn), 200 &deg;C "
                       "(polymer); smallest film the combined roughness of the pair. The limit is "
                       "met where what it names goes through its bound between the last two loads; "
                       "its bar is twice what two thirds of the cells move it by (one difference, "
                       "which may be small by chance). Films at sharp edges become thinner with "
                       "cells along: the loads are bounds from above, and where the table of films "
                       "has less than that smallest film, the load itself is not borne on its "
                       "cells.</p>\n");
  html += page_section("Not found", failures_html(study));
  html += fmt::format(
      "<footer>\n<h2>Provenance</h2>\n<p>Cycles on {} x {}, what is left open on {} x {}, "
      "running-in and capability on {} x {} cells, {} threads, {:.0f} s (of the last session, "
      "where "
      "it was resumed). Cases shell-plain.toml, "
      "shell-grooved.toml, "
      "shell-polymer.toml; below, "
      "the first.</p>\n{}</footer>\n</main>\n</body>\n</html>\n",
      study.plan.grid[0], study.plan.grid[1], study.plan.left_open[0], study.plan.left_open[1],
      study.plan.coarse[0], study.plan.coarse[1], study.threads, study.wall_s,
      app::provenance_html(study.cycles[0][0].input));
  return html;
}

}  // namespace shellback::validation
