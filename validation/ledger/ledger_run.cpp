#include "validation/ledger/ledger_run.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "core/parallel.hpp"
#include "core/stopwatch.hpp"

namespace shellback::validation {
namespace {

/// Number at the fraction u from a to b, along the logarithm if that is asked for and possible.
double mixed(double a, double b, double u, bool logarithmic) {
  if (a == b) return a;  // a series' value stays itself, to the last digit
  if (logarithmic && a > 0.0 && b > 0.0) return a * std::pow(b / a, u);
  return (1.0 - u) * a + u * b;
}

RowNumbers between(const FigureSpec& figure, const RowNumbers& a, const RowNumbers& b, double u) {
  RowNumbers p;
  for (const auto& [column, value] : a) {
    const auto other = b.find(column);
    if (other == b.end()) continue;
    p[column] = mixed(value, other->second, u, figure.x_logarithmic && column == figure.x);
  }
  return p;
}

/// One of our values to be computed, and where it belongs.
struct Task {
  const RowNumbers* point;
  const Changes* changes;
  Values* into;
};

std::vector<Task> tasks_of(EntryReport& report, bool bands) {
  static const Changes kNoChanges;
  std::vector<Task> tasks;
  for (Evaluated& e : report.points) tasks.push_back({&e.point, &kNoChanges, &e.values});
  if (!bands) return tasks;
  const std::size_t rows = report.entry.table->lines().size();
  for (const Unknown& unknown : report.entry.unknowns) {
    report.bands.push_back({unknown.name, {std::vector<Values>(rows), std::vector<Values>(rows)}});
  }
  for (std::size_t k = 0; k < report.bands.size(); ++k) {
    const Unknown& unknown = report.entry.unknowns[k];
    for (std::size_t row = 0; row < rows; ++row) {
      tasks.push_back({&report.points[row].point, &unknown.low, &report.bands[k].side[0][row]});
      tasks.push_back({&report.points[row].point, &unknown.high, &report.bands[k].side[1][row]});
    }
  }
  return tasks;
}

void place_points(EntryReport& report, bool curves) {
  std::vector<RowNumbers> rows;
  const Table& table = *report.entry.table;
  for (std::size_t k = 0; k < table.lines().size(); ++k) rows.push_back(table.numbers(k));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    report.points.push_back({rows[k], static_cast<int>(k), {}});
  }
  if (!curves) return;
  for (RowNumbers& p : points_between(report.entry, rows))
    report.points.push_back({std::move(p), -1, {}});
}

void work(EntryReport& report, const std::vector<Task>& tasks, const LedgerOptions& options) {
  const Evaluator& evaluator = *find_evaluator(report.entry.evaluator);
  const std::any prepared =
      evaluator.prepare == nullptr ? std::any{} : evaluator.prepare(report.entry);
  std::mutex telling;
  int done = 0;
  std::atomic<bool> stopped{false};
  const int count = static_cast<int>(tasks.size());
  parallel_for(count, options.threads, [&](int k) {
    if (bearing::stopped(options.control)) stopped = true;
    if (stopped) return;
    const Task& task = tasks[static_cast<std::size_t>(k)];
    *task.into =
        evaluator.values({report.entry, *task.point, *task.changes, options.control, prepared});
    if (task.into->interrupted) stopped = true;
    const std::lock_guard<std::mutex> lock(telling);
    ++done;
    if (options.progress) options.progress(report.entry.name, done, count);
  });
  report.interrupted = stopped;
}

}  // namespace

std::vector<RowNumbers> points_between(const Entry& entry, const std::vector<RowNumbers>& rows) {
  const FigureSpec& figure = entry.figure;
  std::map<double, std::vector<const RowNumbers*>> series;
  for (const RowNumbers& row : rows) {
    if (!row.contains(figure.x)) continue;
    const bool split = !figure.series.empty() && row.contains(figure.series);
    series[split ? row.at(figure.series) : 0.0].push_back(&row);
  }
  std::vector<RowNumbers> points;
  for (auto& [value, line] : series) {
    std::stable_sort(line.begin(), line.end(), [&](const RowNumbers* a, const RowNumbers* b) {
      return a->at(figure.x) < b->at(figure.x);
    });
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      if (line[k]->at(figure.x) == line[k + 1]->at(figure.x)) continue;
      for (int m = 1; m <= figure.between; ++m) {
        points.push_back(
            between(figure, *line[k], *line[k + 1], static_cast<double>(m) / (figure.between + 1)));
      }
    }
  }
  return points;
}

EntryReport run_entry(const Entry& entry, const LedgerOptions& options) {
  const Stopwatch watch;
  EntryReport report;
  report.entry = entry;
  place_points(report, options.curves);
  work(report, tasks_of(report, options.bands), options);
  if (!report.interrupted) judge(report);
  report.wall_s = watch.seconds();
  return report;
}

}  // namespace shellback::validation
