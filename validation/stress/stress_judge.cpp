#include "validation/stress/stress_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "validation/stress/stress_refusal.hpp"

namespace shellback::validation {
namespace {

/// How much the next value may go the wrong way: the grid's and the solve's error [-].
constexpr double kTrendSlack = 2e-3;
/// Gaps below are measured against this: a nominal gap may pass through zero [m].
constexpr double kSmallGap = 1e-7;
/// What is compared: the one quantity that follows the whole film, and its most delicate one.
constexpr const char* kCompared[] = {"friction_torque", "h_min"};

/// What differences of a quantity are measured against.
double size_of(const std::string& name, double value) {
  return std::max(std::abs(value), name == "h_min" ? kSmallGap : 1e-300);
}

void find_broken_trend(const StressScene& scene, std::vector<StressCell>& cells) {
  const StressTrend& trend = scene.trend;
  if (trend.quantity.empty()) return;
  const double sign = trend.falls ? -1.0 : 1.0;
  double before = NAN;
  for (StressCell& cell : cells) {
    if (cell.result != StressClass::converged) continue;
    const double x = cell.answer.value(trend.quantity);
    const bool follows =
        std::isnan(before) || sign * (x - before) >= -kTrendSlack * size_of(trend.quantity, before);
    if (!std::isnan(x) && follows) {
      before = x;
      continue;
    }
    cell.result = StressClass::wrong;
    cell.why = std::isnan(x) ? fmt::format("{} has no value to follow the trend", trend.quantity)
                             : fmt::format("{} goes from {:.4g} to {:.4g}, against the trend",
                                           trend.quantity, before, x);
  }
}

/// The first compared quantity in which b is farther from a than allowed.
struct Difference {
  const char* name;
  double share;  ///< of a [-]
};
std::optional<Difference> difference(const StressCell& a, const StressCell& b, double allowed) {
  for (const char* name : kCompared) {
    const double x = a.answer.value(name);
    const double off = std::abs(b.answer.value(name) - x) / size_of(name, x);
    if (!(off <= allowed)) return Difference{name, off};
  }
  return std::nullopt;
}

/// The default's result at the step with the cavitated film sheared in full; none if not asked.
const StressCell* in_full_shear(const StressRow& row, std::size_t step) {
  if (step >= row.asked.size()) return nullptr;
  for (const StressWitness& w : row.asked[step]) {
    const bool meant = w.question == QuestionKind::full_shear;
    if (meant && w.cell.result == StressClass::converged) return &w.cell;
  }
  return nullptr;
}

/// A difference of a method that shears its cavitated film in full, told in its parts.
void judge_convention(const StressMethod& method, const Difference& d, const StressCell& full,
                      StressCell& cell) {
  const auto rest = difference(full, cell, method.allowed);
  const bool audited = cell.result == StressClass::converged;
  const std::string words =
      rest ? fmt::format("{} is {:.3g} % off, {} {:.3g} % with the cavitated film sheared in full",
                         d.name, 100.0 * d.share, rest->name, 100.0 * rest->share)
           : fmt::format("{} is {:.3g} % off by convention: the cavitated film is sheared in full",
                         d.name, 100.0 * d.share);
  cell.convention = !rest;
  cell.why = audited ? words : cell.why + "; " + words;
  if (audited) cell.result = rest ? StressClass::wrong : StressClass::by_convention;
}

void find_differences(const StressMethod& method, StressRow& row, std::vector<StressCell>& theirs) {
  for (std::size_t k = 0; k < theirs.size(); ++k) {
    const StressCell& ours = row.cells.front()[k];
    const bool told = theirs[k].result == StressClass::converged ||
                      (method.full_shear && theirs[k].answer.converged());
    if (!told || ours.result != StressClass::converged) continue;
    const auto d = difference(ours, theirs[k], method.allowed);
    if (!d) continue;
    const StressCell* full = method.full_shear ? in_full_shear(row, k) : nullptr;
    if (full != nullptr) {
      judge_convention(method, *d, *full, theirs[k]);
    } else if (theirs[k].result == StressClass::converged) {
      theirs[k].result = StressClass::wrong;
      theirs[k].why = fmt::format("{} is {:.3g} % off", d->name, 100.0 * d->share);
    }
  }
}

/// Two others on the same equations that agree with each other, and neither with the default.
void find_outvoted(const StressRow& row, std::vector<StressCell>& ours) {
  const auto& methods = stress_methods();
  for (std::size_t k = 0; k < ours.size(); ++k) {
    if (ours[k].result != StressClass::converged) continue;
    std::vector<std::size_t> against;
    for (std::size_t m = 1; m < row.cells.size(); ++m) {
      if (!methods[m].same_equations || row.cells[m][k].result != StressClass::converged) continue;
      if (difference(row.cells[m][k], ours[k], methods[m].allowed)) against.push_back(m);
    }
    for (std::size_t i = 0; i < against.size(); ++i) {
      for (std::size_t j = i + 1; j < against.size(); ++j) {
        const std::size_t a = against[i], b = against[j];
        if (difference(row.cells[a][k], row.cells[b][k], methods[b].allowed)) continue;
        ours[k].result = StressClass::wrong;
        ours[k].why =
            fmt::format("{} and {} agree on another state", methods[a].title, methods[b].title);
      }
    }
  }
}

}  // namespace

void judge_row(StressRow& row) {
  find_broken_trend(row.scene, row.cells.front());
  find_contradicted(row);
  find_unexpected(row);
  std::vector<StressCell> ours = row.cells.front();
  find_outvoted(row, ours);
  const auto& methods = stress_methods();
  for (std::size_t m = 1; m < row.cells.size(); ++m) {
    find_differences(methods[m], row, row.cells[m]);
  }
  row.cells.front() = std::move(ours);
}

}  // namespace shellback::validation
