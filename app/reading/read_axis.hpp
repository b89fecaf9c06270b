#pragma once
/// Ranges of keys on the command line: --vary operation.speed="3000 rpm..50 rpm/30log".
#include <string>
#include <vector>

#include "app/reading/overrides.hpp"
#include "app/study/axis.hpp"

namespace shellback::app {

/// Points of a range that does not tell their number.
inline constexpr int kUsualPoints = 11;

/// KEY=FROM..TO[/N][log], equal differences or ratios; or KEY=A,B,C, numbers or words. One unit
/// serves all values; a value may leave it out if another one has it ("4,8 kN"). Commas within
/// brackets or quotes do not part values ("[100,13],[200,25]"). Throws InputError, with an
/// example: no key, no value, ends that are no numbers, two units, less than two points, a
/// logarithm of what is not positive or of a temperature scale, a value named twice.
[[nodiscard]] study::Axis parse_axis(const std::string& key_and_values);

/// All axes of a sweep. Throws InputError where two have one key, where a key is also set, or
/// where the points are more than a million.
[[nodiscard]] std::vector<study::Axis> parse_axes(const std::vector<std::string>& vary,
                                                  const std::vector<Override>& set);

/// One unit serves all values of a list. Refused is what may be a number with commas: two values of
/// which one has a unit ("1,5 kN"), or several of which some have ("1,500 rpm,2,000 rpm").
/// InputError at `place`.
void expect_no_commas_in_numbers(const std::vector<std::string>& values, const std::string& place);

}  // namespace shellback::app
