#include "app/reading/read_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/reading/did_you_mean.hpp"
#include "app/reading/units.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

using study::Spacing;

constexpr const char* kExamples =
    "write for example --vary operation.speed=\"3000 rpm..50 rpm/30log\" or --vary "
    "operation.load=\"4 kN,8 kN\"";

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

bool all_digits(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
}

/// The one unit of all values.
std::string common_unit(const std::vector<NumberAndUnit>& values, const std::string& place) {
  std::string unit;
  for (const NumberAndUnit& w : values) {
    if (w.unit.empty() || w.unit == unit) continue;
    if (!unit.empty()) {
      throw InputError(place, fmt::format("the values are in {} and in {}; write all in the same "
                                          "unit",
                                          in_quotes(unit), in_quotes(w.unit)));
    }
    unit = w.unit;
  }
  return unit;
}

/// What stands behind TO: "/30log", "/30", "log", or nothing. Cut off from `range`.
struct Tail {
  int count = kUsualPoints;
  Spacing spacing = Spacing::linear;
};
Tail cut_tail(std::string& range, const std::string& place) {
  constexpr std::size_t kMostDigits = 7;
  Tail tail;
  range = trimmed(range);
  if (range.ends_with("log")) {
    tail.spacing = Spacing::logarithmic;
    range = trimmed(range.substr(0, range.size() - 3));
    if (range.ends_with('/')) range.pop_back();
  }
  const std::size_t slash = range.rfind('/');
  if (slash == std::string::npos) return tail;
  const std::string digits = trimmed(range.substr(slash + 1));
  const bool of_a_count = digits.find_first_of("0123456789+-.") == 0;
  if (!of_a_count) return tail;  // the slash of a unit
  if (!all_digits(digits)) {
    throw InputError(place, fmt::format("{} behind the \"/\" is no whole number of points; write "
                                        "/30, or /30log for equal ratios",
                                        in_quotes(digits)));
  }
  if (digits.size() > kMostDigits) throw InputError(place, "so many points are no sweep");
  tail.count = std::stoi(digits);
  if (tail.count < 2) {
    throw InputError(place, fmt::format("a range of {} points; it needs at least 2, as in \"3000 "
                                        "rpm..50 rpm/30log\"",
                                        tail.count));
  }
  range = trimmed(range.substr(0, slash));
  return tail;
}

study::Axis range_axis(const std::string& key, std::string text, const std::string& place) {
  const Tail tail = cut_tail(text, place);
  const std::size_t dots = text.find("..");
  const std::string parts[]{trimmed(text.substr(0, dots)), trimmed(text.substr(dots + 2))};
  std::vector<NumberAndUnit> ends;
  for (const std::string& part : parts) {
    const auto end = number_in_front(part);
    if (!end || part.starts_with('.')) {
      throw InputError(
          place, fmt::format("{} does not begin with a number; {}", in_quotes(part), kExamples));
    }
    ends.push_back(*end);
  }
  const std::string unit = common_unit(ends, place);
  const double from = ends[0].number;
  const double to = ends[1].number;
  if (from == to) throw InputError(place, "both ends of the range are the same");
  if (tail.spacing == Spacing::logarithmic) {
    if (unit.starts_with("deg") || unit.starts_with("°")) {
      throw InputError(place, fmt::format("equal ratios make no sense in {}, whose zero is "
                                          "arbitrary; leave out \"log\"",
                                          unit));
    }
    if (!(from > 0.0 && to > 0.0)) {
      throw InputError(place, "equal ratios need two positive ends; leave out \"log\"");
    }
  }
  return study::spaced_axis(key, from, to, tail.count, tail.spacing, unit);
}

/// The values between commas that stand outside of brackets and quotes.
std::vector<std::string> list_entries(const std::string& text) {
  std::vector<std::string> entries(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '[' || c == '{')) ++depth;
    if (!quoted && (c == ']' || c == '}')) --depth;
    if (c == ',' && depth == 0 && !quoted) {
      entries.emplace_back();
    } else {
      entries.back() += c;
    }
  }
  for (std::string& entry : entries) {
    entry = trimmed(entry);
    const bool in_marks = entry.size() >= 2 && entry.front() == '"' && entry.back() == '"';
    if (in_marks) entry = entry.substr(1, entry.size() - 2);
  }
  return entries;
}

study::Axis list_axis(const std::string& key, const std::string& text, const std::string& place) {
  const std::vector<std::string> entries = list_entries(text);
  std::vector<NumberAndUnit> values;
  bool numbers_meant = false;  // else all are words that begin with digits: 0W20, 1500rpm.csv
  for (const std::string& entry : entries) {
    if (entry.empty()) {
      throw InputError(place, fmt::format("a value between two commas is missing; {}", kExamples));
    }
    if (const auto value = number_in_front(entry)) values.push_back(*value);
    numbers_meant = numbers_meant || number_and_unit(entry);
  }
  study::Axis axis = study::word_axis(key, entries);
  if (numbers_meant && values.size() == entries.size()) {
    std::vector<double> numbers;
    for (const NumberAndUnit& w : values) numbers.push_back(w.number);
    const bool apart = text.find(", ") != std::string::npos;  // no number is written so
    if (!apart) expect_no_commas_in_numbers(entries, place);
    axis = study::listed_axis(key, std::move(numbers), common_unit(values, place));
  }
  for (std::size_t k = 0; k < axis.words.size(); ++k) {
    if (std::find(axis.words.begin(), axis.words.begin() + k, axis.words[k]) !=
        axis.words.begin() + k) {
      throw InputError(place, fmt::format("the value {} is named twice", in_quotes(axis.words[k])));
    }
  }
  return axis;
}

}  // namespace

void expect_no_commas_in_numbers(const std::vector<std::string>& values, const std::string& place) {
  std::size_t with = 0, numbers = 0;
  for (const std::string& value : values) {
    const auto number = number_in_front(value);
    if (!number) return;
    ++numbers;
    if (!number->unit.empty()) ++with;
  }
  if (with == 0 || with == numbers || (with == 1 && numbers > 2)) return;
  throw InputError(place, fmt::format("{} beside {}: is that one number? Write each value with its "
                                      "unit, and decimals after a point",
                                      in_quotes(values[0]), in_quotes(values[1])));
}

study::Axis parse_axis(const std::string& key_and_values) {
  const std::size_t equal = key_and_values.find('=');
  if (equal == std::string::npos || equal == 0) {
    throw InputError("--vary",
                     fmt::format("{} is not KEY=VALUES; {}", in_quotes(key_and_values), kExamples));
  }
  const std::string key = trimmed(key_and_values.substr(0, equal));
  const std::string values = trimmed(key_and_values.substr(equal + 1));
  const std::string place = "--vary " + key;
  if (values.empty()) throw InputError(place, fmt::format("it has no values; {}", kExamples));
  // Words in quotes and paths to a folder above have dots, too.
  const bool words = values.front() == '"' || values.find("../") != std::string::npos;
  const bool range = !words && values.find("..") != std::string::npos;
  return range ? range_axis(key, values, place) : list_axis(key, values, place);
}

std::vector<study::Axis> parse_axes(const std::vector<std::string>& vary,
                                    const std::vector<Override>& set) {
  constexpr double kMostPoints = 1e6;
  std::vector<study::Axis> axes;
  double points = 1.0;
  for (const std::string& words : vary) {
    study::Axis axis = parse_axis(words);
    const auto same = [&](const auto& other) { return other.key == axis.key; };
    if (std::any_of(axes.begin(), axes.end(), same)) {
      throw InputError("--vary " + axis.key, "the key is varied twice; give all values at once");
    }
    const auto fixed = std::find_if(set.begin(), set.end(), same);
    if (fixed != set.end()) {
      throw InputError("--vary " + axis.key,
                       fmt::format("the key is also given by {}; keep one of them", fixed->place));
    }
    points *= axis.size();
    axes.push_back(std::move(axis));
  }
  if (axes.empty()) throw InputError("--vary", fmt::format("nothing is varied; {}", kExamples));
  if (points > kMostPoints) {
    throw InputError("--vary",
                     fmt::format("{:.3g} points are too many; a million is the most", points));
  }
  return axes;
}

}  // namespace shellback::app
