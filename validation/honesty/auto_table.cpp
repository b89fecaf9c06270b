#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>

#include "app/labels/text_table.hpp"
#include "validation/honesty/auto_report.hpp"

namespace shellback::validation {
namespace {

/// "95.8 % [90.1, 98.2]"
std::string words(const Share& s) {
  if (s.of == 0) return "-";
  const ShareInterval i = s.interval();
  return fmt::format("{:.1f} % [{:.1f}, {:.1f}]", 100.0 * s.value(), 100.0 * i.low, 100.0 * i.high);
}

std::string tolerance_in_words(double tolerance) {
  return fmt::format("{:.2g} %", 100.0 * tolerance);
}

void write_cases(std::ostream& out, const std::vector<AutoTrial>& trials, double budget_s) {
  std::map<std::string, int> ends;
  Share judged;
  for (const AutoTrial& t : trials) {
    judged.held += t.truth_converged;
    ++judged.of;
    if (t.truth_converged) continue;
    ++ends[t.end == CaseEnd::done ? "truth refused" : to_string(t.end)];
  }
  out << fmt::format(
      "tier auto on {} random bearings of at most {:.0f} s of processor time; with a truth: {}\n",
      trials.size(), budget_s, words(judged));
  for (const auto& [name, n] : ends) out << fmt::format("  {:>4} {}\n", n, name);
}

void write_shares(std::ostream& out, const std::vector<AutoSummary>& summaries) {
  app::TextTable table(1);
  table.add({"tolerance", "judged", "no truth", "no answer", "within", "claimed", "of these within",
             "truth held", "limit held"});
  table.rule();
  for (const AutoSummary& s : summaries) {
    table.add({tolerance_in_words(s.tolerance), std::to_string(s.within.of), words(s.without_truth),
               words(s.no_answer), words(s.within), words(s.met), words(s.met_within),
               words(s.holds_truth), words(s.holds_limit)});
  }
  table.print(out);
}

void write_costs(std::ostream& out, const std::vector<AutoSummary>& summaries) {
  app::TextTable table(1);
  table.add({"cost of full TEHD over auto", "mean [ms]", "median [ms]", "400x50: sums", "median",
             "800x100: sums", "mean share", "median"});
  table.rule();
  const auto one = [](double x) { return std::isfinite(x) ? fmt::format("{:.1f}", x) : "-"; };
  for (const AutoSummary& s : summaries) {
    table.add({tolerance_in_words(s.tolerance), one(1e3 * s.mean_seconds),
               one(1e3 * s.median_seconds), one(s.cheaper_usual), one(s.median_usual),
               one(s.cheaper_truth), one(s.mean_tamed), one(s.median_truth)});
  }
  table.print(out);
}

/// Answers of all tolerances by the tier that was chosen.
void write_tiers(std::ostream& out, const std::vector<AutoTrial>& trials) {
  struct Counts {
    Share without_truth, within, holds_truth, holds_limit;
  };
  std::map<std::string, Counts> tiers;
  const auto add = [](bool holds, Share& s) {
    s.held += holds;
    ++s.of;
  };
  for (const AutoTrial& t : trials) {
    for (const AutoAnswer& a : t.answers) {
      if (!a.converged) continue;
      Counts& c = tiers[a.tier];
      add(!t.truth_converged, c.without_truth);
      if (!t.truth_converged) continue;
      add(a.within(), c.within);
      add(a.holds_truth, c.holds_truth);
      add(a.holds_limit, c.holds_limit);
    }
  }
  app::TextTable table(1);
  table.add({"tier chosen", "answers", "no truth", "within", "truth held", "limit held"});
  table.rule();
  for (const auto& [tier, c] : tiers) {
    table.add({tier, std::to_string(c.without_truth.of), words(c.without_truth), words(c.within),
               words(c.holds_truth), words(c.holds_limit)});
  }
  table.print(out);
}

void write_not_judged(std::ostream& out, const std::vector<AutoTrial>& trials) {
  out << "\nnot judged: seed, end, processor time, reason\n";
  for (const AutoTrial& t : trials) {
    if (t.truth_converged) continue;
    out << fmt::format("{:>6}  {}  {:.0f} s  {}\n", t.seed, to_string(t.end), t.processor_s, t.why);
  }
}

void write_misses(std::ostream& out, const std::vector<AutoTrial>& trials) {
  out << "\nmisses: seed, tolerance, distance to the truth and claimed bar (friction, film)\n";
  for (const AutoTrial& t : trials) {
    if (!t.truth_converged) continue;
    for (const AutoAnswer& a : t.answers) {
      if (a.within()) continue;
      out << fmt::format("{:>6}  {:>4.2g}%  {:>+8.2f}% {:>+8.2f}%  {:>7.2f}% {:>7.2f}%  {}  {}\n",
                         t.seed, 100.0 * a.tolerance, 100.0 * a.off_friction, 100.0 * a.off_h_min,
                         100.0 * a.bar_friction, 100.0 * a.bar_h_min,
                         a.met ? "claimed" : "not claimed", a.converged ? a.chosen : "no result");
    }
  }
}

}  // namespace

void write_auto_honesty(std::ostream& out, const std::vector<AutoTrial>& trials,
                        const AutoStudy& study) {
  const auto summaries = summarize(trials, study.tolerances);
  write_cases(out, trials, study.budget_s);
  out << "\nshares with [Wilson interval, 95 %]; no truth: of the answers; no answer: of the "
         "cases\n\n";
  write_shares(out, summaries);
  out << '\n';
  write_tiers(out, trials);
  out << '\n';
  write_costs(out, summaries);
  write_not_judged(out, trials);
  write_misses(out, trials);
}

}  // namespace shellback::validation
