#pragma once
/// One swept key of a case and the values that it takes.
#include <string>
#include <vector>

namespace shellback::study {

/// How the values of an axis follow one another.
enum class Spacing { listed, linear, logarithmic };
[[nodiscard]] const char* to_string(Spacing spacing);

/// A key of the case file with its values. Numbers are in `unit`, as the user wrote them; how they
/// become SI is the business of the case's reader.
struct Axis {
  std::string key;   ///< dotted: operation.speed
  std::string unit;  ///< of the numbers: "rpm"; empty: plain numbers, or words
  Spacing spacing = Spacing::listed;
  std::vector<double> numbers;     ///< empty: the values are words (tiers, grids, names)
  std::vector<std::string> words;  ///< every value as the case file would have it: "1500 rpm"

  [[nodiscard]] int size() const { return static_cast<int>(words.size()); }
  /// Whether there is something between two neighbouring values.
  [[nodiscard]] bool has_between() const { return !numbers.empty(); }
};

/// Axis of listed numbers, written out in `unit`. `numbers` must not be empty.
[[nodiscard]] Axis listed_axis(std::string key, std::vector<double> numbers, std::string unit);

/// `count` >= 2 values from `from` to `to` (both included, in this order), with equal differences
/// or, if logarithmic, equal ratios (both ends positive). Values between the ends are rounded to
/// ten figures, so that what a table prints can be given to --set again.
[[nodiscard]] Axis spaced_axis(std::string key, double from, double to, int count, Spacing spacing,
                               std::string unit);

/// Axis of words, taken as they are.
[[nodiscard]] Axis word_axis(std::string key, std::vector<std::string> words);

/// Where the value at `index` lies for interpolation: the logarithm if the axis is logarithmic or
/// all its listed numbers are positive with a largest ratio beyond 2, else the number itself; the
/// index itself for words. `index` in [0, size - 1], a fraction lies between two values.
[[nodiscard]] double coordinate(const Axis& axis, double index);

/// The value at `index` as the case file would have it; a fraction is interpolated in
/// `coordinate` (only if has_between).
[[nodiscard]] std::string word_at(const Axis& axis, double index);

/// Whether the axis is best drawn on a logarithmic scale.
[[nodiscard]] bool is_logarithmic(const Axis& axis);

}  // namespace shellback::study
