#include "app/labels/sweep_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/words/note_words.hpp"
#include "bearing/over_time/cycle_numbers.hpp"
#include "core/constants.hpp"

namespace shellback::app {

using study::Sweep;
using study::SweepPoint;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

const bearing::Quantity* known(const SweepPoint& point, const std::string& name) {
  return point.good() ? quantity_in(point.result.quantities, name) : nullptr;
}

SweepQuantity column_of(const bearing::Quantity& q) {
  if (q.unit == "rad") return {q.name, "deg", 180.0 / kPi, false};
  return {q.name, q.unit, 1.0, false};
}

}  // namespace

std::vector<SweepQuantity> sweep_quantities(const Sweep& sweep) {
  std::vector<SweepQuantity> all;
  for (const SweepPoint& point : sweep.points) {
    if (!point.good()) continue;
    for (const auto& q : point.result.quantities) {
      auto it =
          std::find_if(all.begin(), all.end(), [&](const auto& x) { return x.name == q.name; });
      if (it == all.end()) it = all.insert(all.end(), column_of(q));
      if (std::isfinite(q.error())) it->with_error = true;
    }
  }
  return all;
}

double value_at(const SweepPoint& point, const SweepQuantity& q) {
  const auto* found = known(point, q.name);
  return found == nullptr ? kUnknown : q.factor * found->value;
}

double bar_at(const SweepPoint& point, const SweepQuantity& q, const Bar& bar) {
  const auto* found = known(point, q.name);
  return found == nullptr ? kUnknown : q.factor * bar(*found);
}

double error_at(const SweepPoint& point, const SweepQuantity& q) {
  return bar_at(point, q, &bearing::Quantity::error);
}

bool known_somewhere(const Sweep& sweep, const SweepQuantity& q, const Bar& bar) {
  return std::any_of(sweep.points.begin(), sweep.points.end(),
                     [&](const SweepPoint& point) { return std::isfinite(bar_at(point, q, bar)); });
}

std::vector<int> indices_of(const Sweep& sweep, int index) {
  std::vector<int> indices{index / sweep.curves()};
  for (const int k : study::across(sweep.axes, index % sweep.curves())) indices.push_back(k);
  return indices;
}

std::vector<int> reading_order(const Sweep& sweep) {
  std::vector<int> order;
  for (int c = 0; c < sweep.curves(); ++c) {
    for (int k = 0; k < sweep.axes.front().size(); ++k) order.push_back(k * sweep.curves() + c);
  }
  return order;
}

std::string status_word(const SweepPoint& point) {
  return point.tried() ? to_string(point.result.verdict.status) : "not started";
}

std::string count_words(const Sweep& sweep) {
  const int total = static_cast<int>(sweep.points.size());
  const int good = sweep.count_good();
  const int failed = sweep.count_failed();
  std::string words = fmt::format("{} point{}, {} converged", total, total == 1 ? "" : "s", good);
  if (failed > 0) words += fmt::format(", {} not", failed);
  if (good + failed < total)
    words += fmt::format(", {} left by the interrupt", total - good - failed);
  return words;
}

std::string describe_subject(const bearing::Case& c, const Sweep& sweep, Writing writing) {
  const auto swept = [&](const std::string& key) {
    return std::any_of(sweep.axes.begin(), sweep.axes.end(),
                       [&](const auto& axis) { return axis.key == key; });
  };
  const bool set = writing == Writing::typeset;
  std::string words = "bearing";
  if (!swept("bearing.diameter") && !swept("bearing.width")) {
    words += fmt::format(" {:.4g} {} {:.4g} mm", 2e3 * c.bearing.radius, set ? "×" : "x",
                         1e3 * c.bearing.width);
  }
  if (!swept("bearing.radial_clearance")) {
    words += fmt::format(", radial clearance {:.4g} {}", 1e6 * c.bearing.radial_clearance,
                         set ? "µm" : "um");
  }
  if (!swept("operation.speed")) {
    words += ", " + speed_words(c);
  }
  if (c.cycle) {
    words += fmt::format(", load {}", c.cycle->repeats() ? "cycle" : "event");
    // A load of [crank] goes with the speed, one of a table with its file.
    const bool goes_with = std::any_of(sweep.axes.begin(), sweep.axes.end(), [](const auto& axis) {
      return axis.key == "operation.speed" || axis.key.starts_with("load_cycle.") ||
             axis.key.starts_with("crank.");
    });
    if (!goes_with) {
      words +=
          fmt::format(", largest load {:.4g} kN", 1e-3 * bearing::largest_load(*c.cycle).force);
    }
  }
  const auto* load = std::get_if<bearing::LoadGiven>(&c.operation.position);
  if (!c.cycle && load != nullptr && !swept("operation.load")) {
    words += fmt::format(", load {:.4g} kN", 1e-3 * load->force);
  }
  const auto* given = std::get_if<bearing::EccentricityGiven>(&c.operation.position);
  if (given != nullptr && !swept("operation.eccentricity_ratio")) {
    words += fmt::format(", eccentricity ratio {:.4g}", given->ratio);
  }
  if (!c.oil.name.empty() && !swept("oil.name")) words += ", oil " + c.oil.name;
  return words;
}

std::vector<std::string> sweep_warnings(const Sweep& sweep) {
  std::vector<std::string> all;
  for (const SweepPoint& point : sweep.points) {
    for (const std::string& warning : words_of(point.result.warnings)) {
      if (std::find(all.begin(), all.end(), warning) == all.end()) all.push_back(warning);
    }
  }
  return all;
}

}  // namespace shellback::app
