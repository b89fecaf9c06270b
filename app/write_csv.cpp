#include "app/write_csv.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/labels/csv_text.hpp"
#include "app/labels/sweep_columns.hpp"
#include "app/words/ending_words.hpp"

namespace shellback::app {

using study::Sweep;
using study::SweepPoint;

namespace {

std::string line(const std::vector<std::string>& cells) {
  std::string text;
  for (std::size_t k = 0; k < cells.size(); ++k) text += (k == 0 ? "" : ",") + cells[k];
  return text + "\n";
}

std::string head(const Sweep& sweep, const std::vector<SweepQuantity>& quantities) {
  std::vector<std::string> cells;
  for (const auto& axis : sweep.axes) {
    cells.push_back(
        csv_text(axis.unit.empty() ? axis.key : fmt::format("{} [{}]", axis.key, axis.unit)));
  }
  for (const char* name : {"status", "tier", "grid", "start", "tries"}) cells.emplace_back(name);
  for (const auto& q : quantities) {
    cells.push_back(csv_text(fmt::format("{} [{}]", q.name, q.unit)));
    if (q.with_error) cells.push_back(csv_text(fmt::format("{} error [{}]", q.name, q.unit)));
  }
  for (const char* name :
       {"audit mass", "audit energy", "audit load", "audit moment", "outer iterations",
        "newton iterations", "factorizations", "wall [s]", "reason"}) {
    cells.emplace_back(name);
  }
  return line(cells);
}

std::string row(const Sweep& sweep, int index, const std::vector<SweepQuantity>& quantities) {
  const SweepPoint& point = sweep.points[index];
  const std::vector<int> at = indices_of(sweep, index);
  std::vector<std::string> cells;
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    const auto& axis = sweep.axes[a];
    cells.push_back(axis.numbers.empty() ? csv_text(axis.words[at[a]])
                                         : csv_number(axis.numbers[at[a]]));
  }
  const auto& result = point.result;
  cells.push_back(status_word(point));
  cells.emplace_back(point.tried() ? to_string(result.tier) : "");
  cells.push_back(point.good() && result.grid[0] > 0
                      ? fmt::format("{} x {}", result.grid[0], result.grid[1])
                      : "");
  cells.emplace_back(to_string(point.start));
  cells.push_back(std::to_string(point.tries));
  for (const auto& q : quantities) {
    cells.push_back(csv_number(value_at(point, q)));
    if (q.with_error) cells.push_back(csv_number(error_at(point, q)));
  }
  const auto& a = result.audit;
  const auto& k = result.cost;
  const bool good = point.good();
  for (const double x : {a.mass, a.energy, a.load, a.moment})
    cells.push_back(good ? csv_number(x) : "");
  for (const int x : {k.outer_iterations, k.newton_iterations, k.factorizations}) {
    cells.push_back(good ? std::to_string(x) : "");
  }
  cells.push_back(csv_number(point.wall_s));
  cells.push_back(good ? "" : csv_text(reason_of(result.verdict)));
  return line(cells);
}

}  // namespace

std::string sweep_csv(const Sweep& sweep) {
  const auto quantities = sweep_quantities(sweep);
  std::string text = head(sweep, quantities);
  for (const int index : reading_order(sweep)) text += row(sweep, index, quantities);
  return text;
}

}  // namespace shellback::app
