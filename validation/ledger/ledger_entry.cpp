#include "validation/ledger/ledger_entry.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace shellback::validation {

const char* to_string(Evidence evidence) {
  switch (evidence) {
    case Evidence::measurement:
      return "published measurement";
    case Evidence::calculation:
      return "published calculation";
    case Evidence::exact:
      return "exact solution";
    case Evidence::recomputed:
      return "recomputed by an independent program";
    case Evidence::own:
      return "own regression";
  }
  return "";
}

bool holds(const Condition& condition, const RowNumbers& point) {
  constexpr double kSlack = 1e-9;  // printed numbers are equal or not
  const auto value = [&point](const std::string& column) {
    const auto found = point.find(column);
    return found == point.end() ? std::optional<double>{} : found->second;
  };
  const auto all = [&value](const std::map<std::string, double>& wanted, auto fits) {
    return std::all_of(wanted.begin(), wanted.end(), [&](const auto& pair) {
      const auto there = value(pair.first);
      return there && fits(*there, pair.second);
    });
  };
  return all(condition.at,
             [](double a, double b) {
               return std::abs(a - b) <= kSlack * std::max(1.0, std::abs(b));
             }) &&
         all(condition.above, [](double a, double b) { return a > b + kSlack * std::abs(b); }) &&
         all(condition.below, [](double a, double b) { return a < b - kSlack * std::abs(b); });
}

std::string row_label(const Entry& entry, const RowNumbers& point) {
  std::string label;
  const auto add = [&](const std::string& column, const std::string& title) {
    const auto found = point.find(column);
    if (column.empty() || found == point.end()) return;
    label += fmt::format("{}{} {:.6g}", label.empty() ? "" : ", ", title, found->second);
  };
  add(entry.figure.series, entry.figure.series_title);
  add(entry.figure.x, entry.figure.x);
  return label;
}

}  // namespace shellback::validation
