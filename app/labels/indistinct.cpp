#include "app/labels/indistinct.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/labels/quantity_label.hpp"
#include "app/labels/sweep_columns.hpp"
#include "fidelity/tolerance.hpp"

namespace shellback::app {

using bearing::Comparison;
using bearing::Quantity;
using bearing::Result;
using study::Sweep;

namespace {

constexpr const char* kJudged[] = {"friction_torque", "h_min"};

const Quantity* found(const Result& r, const std::string& name) {
  return r.verdict.good() ? quantity_in(r.quantities, name) : nullptr;
}

bool open(const Result& a, const Result& b, const std::string& name) {
  const Quantity* first = found(a, name);
  const Quantity* second = found(b, name);
  return first != nullptr && second != nullptr && !fidelity::told_apart(*first, *second);
}

/// "0.5398 +-0.011 against 0.5385 +-0.013 N m"
std::string both(const Result& a, const Result& b, const std::string& name) {
  const Quantity& first = *found(a, name);
  const Quantity& second = *found(b, name);
  const DisplayUnit unit = display_unit(name, first.unit, std::abs(first.value));
  return fmt::format("{} {} against {} {} {}", figures(unit(first.value)),
                     bar_figures(unit.scale * first.discretisation()), figures(unit(second.value)),
                     bar_figures(unit.scale * second.discretisation()), unit.unit);
}

/// Calls with each pair of indices that differ on this axis alone, in order.
void each_pair(const Sweep& sweep, int axis, const std::function<void(int, int)>& call) {
  int stride = 1;  // of Sweep::points: the first axis is the slowest
  for (std::size_t a = static_cast<std::size_t>(axis) + 1; a < sweep.axes.size(); ++a) {
    stride *= sweep.axes[a].size();
  }
  const bool neighbours = !sweep.axes[axis].numbers.empty();
  for (const int index : reading_order(sweep)) {
    const int at = indices_of(sweep, index)[axis];
    const int last =
        neighbours ? std::min(at + 2, sweep.axes[axis].size()) : sweep.axes[axis].size();
    for (int other = at + 1; other < last; ++other) call(index, index + (other - at) * stride);
  }
}

/// What a sentence calls a quantity.
std::string judged_word(const std::string& name) {
  return name == "h_min" ? "smallest film" : quantity_label(name);
}

/// " at operation.load = 8 kN": where both points stand on the other axes.
std::string elsewhere(const Sweep& sweep, const std::vector<int>& at, int axis) {
  std::string words;
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    if (static_cast<int>(a) == axis) continue;
    words += fmt::format("{}{} = {}", words.empty() ? " at " : ", ", sweep.axes[a].key,
                         sweep.axes[a].words[at[a]]);
  }
  return words;
}

std::string pair_sentence(const Sweep& sweep, const Indistinct& pair) {
  const auto& axis = sweep.axes[pair.axis];
  const std::vector<int> first = indices_of(sweep, pair.first);
  const std::vector<int> second = indices_of(sweep, pair.second);
  return fmt::format(
      "{}: {} = {} and {}{} ({})", judged_word(pair.quantity), axis.key,
      axis.words[first[pair.axis]], axis.words[second[pair.axis]],
      elsewhere(sweep, first, pair.axis),
      both(sweep.points[pair.first].result, sweep.points[pair.second].result, pair.quantity));
}

/// Neighbours along an axis of numbers, counted.
std::string count_sentence(const Sweep& sweep, const std::vector<Indistinct>& pairs, int axis,
                           const std::string& name) {
  const auto count = std::count_if(pairs.begin(), pairs.end(), [&](const Indistinct& p) {
    return p.axis == axis && p.quantity == name;
  });
  if (count == 0) return "";
  int total = 0;
  each_pair(sweep, axis, [&](int a, int b) {
    if (sweep.points[a].good() && sweep.points[b].good()) ++total;
  });
  return fmt::format("{}: {} of {} pairs of neighbours along {}", judged_word(name), count, total,
                     sweep.axes[axis].key);
}

}  // namespace

std::vector<Indistinct> indistinct(const Comparison& comparison) {
  std::vector<Indistinct> pairs;
  const auto& results = comparison.results;
  for (const char* name : kJudged) {
    for (std::size_t a = 0; a < results.size(); ++a) {
      for (std::size_t b = a + 1; b < results.size(); ++b) {
        if (!open(results[a], results[b], name)) continue;
        pairs.push_back({name, static_cast<int>(a), static_cast<int>(b)});
      }
    }
  }
  return pairs;
}

std::vector<Indistinct> indistinct(const Sweep& sweep) {
  std::vector<Indistinct> pairs;
  for (const char* name : kJudged) {
    for (int axis = 0; axis < static_cast<int>(sweep.axes.size()); ++axis) {
      each_pair(sweep, axis, [&](int a, int b) {
        if (!sweep.points[a].tried() || !sweep.points[b].tried()) return;
        if (open(sweep.points[a].result, sweep.points[b].result, name)) {
          pairs.push_back({name, a, b, axis});
        }
      });
    }
  }
  return pairs;
}

std::vector<std::string> indistinct_words(const Comparison& comparison) {
  const auto names = column_names(comparison.results);
  std::vector<std::string> lines;
  for (const Indistinct& pair : indistinct(comparison)) {
    lines.push_back(fmt::format(
        "{}: {} and {} ({})", judged_word(pair.quantity), names[pair.first], names[pair.second],
        both(comparison.results[pair.first], comparison.results[pair.second], pair.quantity)));
  }
  return lines;
}

std::vector<std::string> indistinct_words(const Sweep& sweep) {
  constexpr int kMostLines = 12;  // beyond, a list is no answer
  const auto pairs = indistinct(sweep);
  std::vector<std::string> lines;
  for (int axis = 0; axis < static_cast<int>(sweep.axes.size()); ++axis) {
    if (sweep.axes[axis].numbers.empty()) continue;
    for (const char* name : kJudged) {
      const std::string line = count_sentence(sweep, pairs, axis, name);
      if (!line.empty()) lines.push_back(line);
    }
  }
  int left = 0;
  for (const Indistinct& pair : pairs) {
    if (!sweep.axes[pair.axis].numbers.empty()) continue;
    if (static_cast<int>(lines.size()) < kMostLines) {
      lines.push_back(pair_sentence(sweep, pair));
    } else {
      ++left;
    }
  }
  if (left > 0) lines.push_back(fmt::format("and {} pairs more (--json has all)", left));
  return lines;
}

}  // namespace shellback::app
