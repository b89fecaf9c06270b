#include <fmt/format.h>

#include <iostream>

#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/progress.hpp"
#include "app/reading/library.hpp"
#include "validation/ledger/ledger_deviation.hpp"
#include "validation/ledger/ledger_json.hpp"
#include "validation/ledger/ledger_page.hpp"
#include "validation/ledger/ledger_read.hpp"
#include "validation/ledger/ledger_run.hpp"
#include "validation/ledger/ledger_text.hpp"

namespace shellback::program {
namespace {

using namespace validation;

void list_entries(const std::vector<Entry>& entries, const std::vector<UnrunDataset>& gaps) {
  for (const Entry& entry : entries) {
    std::cout << fmt::format("{:<32} {}\n", entry.name, entry.title);
  }
  if (!gaps.empty()) std::cout << "\nnot runnable:\n";
  for (const UnrunDataset& gap : gaps)
    std::cout << fmt::format("  {}: {}\n", gap.title, gap.reason);
}

/// The ledger's files, and the cases that lie elsewhere.
std::vector<std::string> inputs_of(const std::string& ledger, const std::vector<Entry>& entries) {
  std::vector<std::string> inputs = app::files_below(ledger);
  for (const Entry& entry : entries) {
    if (entry.table) inputs.push_back(entry.table->path());
    for (const BearingPart& bearing : entry.bearings) inputs.push_back(bearing.file);
  }
  return inputs;
}

/// Runs the entries one after the other, each printed as soon as it is done. Ends early when
/// interrupted; the interrupted entry is left out.
std::vector<EntryReport> run_entries(const Request& request, const std::vector<Entry>& entries) {
  app::ProgressLine line;
  LedgerOptions options;
  options.threads = request.threads;
  options.curves = options.bands = !request.output.empty();
  options.control.stop = &app::catch_interrupt();
  options.progress = [&line](const std::string& entry, int done, int of) {
    line.show(fmt::format("{}: {} of {}", entry, done, of));
  };
  std::vector<EntryReport> reports;
  for (const Entry& entry : entries) {
    EntryReport report = run_entry(entry, options);
    line.wipe();
    if (report.interrupted) break;
    if (prints_tables(request)) {
      write_entry_table(std::cout, report, request.all_rows ? RowsShown::all : RowsShown::worst);
      std::cout.flush();
    }
    reports.push_back(std::move(report));
  }
  return reports;
}

/// What is outside, without a result or not as its entry documents, on standard error; the exit
/// code.
int tell_verdicts(const std::vector<EntryReport>& reports, std::size_t wanted) {
  int code = kDone;
  for (const EntryReport& report : reports) {
    const Judgement verdict = report.verdict();
    if (as_expected(verdict)) continue;
    code = kNotConverged;
    std::cerr << fmt::format("error: {}: {}", report.entry.name, to_string(verdict));
    std::string which;
    const auto add = [&which](const std::string& name) {
      which += (which.empty() ? ": " : ", ") + name;
    };
    for (const QuantityReport& q : report.quantities) {
      if (!as_expected(q.verdict)) add(q.spec.name);
    }
    for (const FeatureReport& f : report.features) {
      if (!as_expected(f.verdict)) add(f.feature.name);
    }
    std::cerr << which << "\n";
    for (const DeviationReport& d : report.deviations) {
      if (d.complaint.empty()) continue;
      std::cerr << fmt::format(
          "  {}. Find out why; then set from and to of this [[deviation]] anew, or take it out, in "
          "{}/entry.toml\n",
          describe(d), report.entry.folder);
    }
  }
  if (reports.size() < wanted) {
    std::cerr << fmt::format("interrupted: {} of {} entries are finished\n", reports.size(),
                             wanted);
    return kInterrupted;
  }
  return code;
}

}  // namespace

int validate(const Request& request) {
  const std::string ledger = ledger_folder(request.ledger);
  const std::vector<Entry> entries = read_entries(ledger, request.names);
  const std::vector<UnrunDataset> gaps =
      request.names.empty() ? read_unrun(ledger) : std::vector<UnrunDataset>{};
  if (request.list) {
    refuse_outputs_of_a_list(request);
    list_entries(entries, gaps);
    return kDone;
  }
  Outputs outputs(request, inputs_of(ledger, entries));
  const std::vector<EntryReport> reports = run_entries(request, entries);
  if (prints_tables(request)) write_summary(std::cout, reports, gaps);
  const int code = tell_verdicts(reports, entries.size());
  outputs.give("--json", [&] { return ledger_json(reports, gaps); });
  outputs.give("--csv", [&] { return ledger_csv(reports); });
  outputs.give("-o", [&] { return ledger_page(reports, gaps); });
  return outputs.code(code);
}

}  // namespace shellback::program
