#include "app/study/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"

namespace shellback::study {
namespace {

constexpr int kFigures = 10;  ///< of values that were computed, not given

/// The number and its unit, such that it is read back as the same number.
std::string written(double number, const std::string& unit) {
  return unit.empty() ? fmt::format("{}", number) : fmt::format("{} {}", number, unit);
}

double rounded(double number) { return std::stod(fmt::format("{:.{}g}", number, kFigures)); }

/// Number at a fractional index, interpolated in the coordinate.
double number_at(const Axis& axis, double index) {
  const auto low = static_cast<std::size_t>(std::floor(index));
  const double part = index - static_cast<double>(low);
  if (part == 0.0) return axis.numbers[low];
  const double a = axis.numbers[low];
  const double b = axis.numbers[low + 1];
  if (is_logarithmic(axis)) return a * std::pow(b / a, part);
  return a + part * (b - a);
}

}  // namespace

const char* to_string(Spacing spacing) {
  switch (spacing) {
    case Spacing::listed:
      return "listed";
    case Spacing::linear:
      return "linear";
    case Spacing::logarithmic:
      return "logarithmic";
  }
  return "";
}

Axis listed_axis(std::string key, std::vector<double> numbers, std::string unit) {
  EXPECTS(!numbers.empty());
  Axis axis{std::move(key), std::move(unit), Spacing::listed, std::move(numbers), {}};
  for (const double x : axis.numbers) axis.words.push_back(written(x, axis.unit));
  return axis;
}

Axis spaced_axis(std::string key, double from, double to, int count, Spacing spacing,
                 std::string unit) {
  EXPECTS(count >= 2);
  EXPECTS(spacing != Spacing::logarithmic || (from > 0.0 && to > 0.0));
  std::vector<double> numbers{from};
  for (int k = 1; k + 1 < count; ++k) {
    const double part = static_cast<double>(k) / (count - 1);
    numbers.push_back(rounded(spacing == Spacing::logarithmic ? from * std::pow(to / from, part)
                                                              : from + part * (to - from)));
  }
  numbers.push_back(to);
  Axis axis = listed_axis(std::move(key), std::move(numbers), std::move(unit));
  axis.spacing = spacing;
  return axis;
}

Axis word_axis(std::string key, std::vector<std::string> words) {
  return {std::move(key), "", Spacing::listed, {}, std::move(words)};
}

bool is_logarithmic(const Axis& axis) {
  constexpr double kWide = 2.0;  // ratio from which equal ratios are the better measure
  if (axis.spacing != Spacing::listed) return axis.spacing == Spacing::logarithmic;
  if (axis.numbers.empty() || axis.unit.starts_with("deg")) return false;
  const auto [low, high] = std::minmax_element(axis.numbers.begin(), axis.numbers.end());
  return *low > 0.0 && *high > kWide * *low;
}

double coordinate(const Axis& axis, double index) {
  if (axis.numbers.empty()) return index;
  const double x = number_at(axis, index);
  return is_logarithmic(axis) ? std::log(x) : x;
}

std::string word_at(const Axis& axis, double index) {
  const double whole = std::round(index);
  if (index == whole) return axis.words[static_cast<std::size_t>(whole)];
  EXPECTS(axis.has_between());
  return written(rounded(number_at(axis, index)), axis.unit);
}

}  // namespace shellback::study
