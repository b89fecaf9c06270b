#pragma once
/// What a fit of keys has found, in words.
#include <string>
#include <vector>

#include "app/reading/identify_case.hpp"
#include "bearing/case.hpp"

namespace shellback::app {

/// All that is shown of an identification.
struct IdentifyView {
  const bearing::Case& subject;
  const std::vector<FittedKey>& keys;
  const MeasuredTable& table;
  const study::Identification& end;
  std::vector<std::string> moving;  ///< keys with which cells of the film move
};

/// Why the keys are not to be believed, with the cure, one a line; empty: they are.
[[nodiscard]] std::vector<std::string> complaints(const IdentifyView& v);

/// That chi2 is larger than one in a thousand tables with such deviations would have (chi-square
/// distribution, textbook): the tier does not describe the data, or the deviations are too small.
/// Empty: it is not, or no deviations are given.
[[nodiscard]] std::string misfit(const IdentifyView& v);

/// That what is computed jumps where cells come and go with a key; empty: none moves them.
[[nodiscard]] std::string jumps(const IdentifyView& v);

/// "a x 1.58 with b x 0.397": what moves along the direction, to a tenth of its bounds in the key
/// that moves most.
[[nodiscard]] std::string direction_words(const IdentifyView& v, const study::FitDirection& d);

/// Standard deviation of one value where the table gives none, SI; NaN: it gives them.
[[nodiscard]] double found_deviation(const IdentifyView& v);

/// "SETTLED", "not settled", ... for tables and files.
[[nodiscard]] const char* to_string(study::FitStatus status);

}  // namespace shellback::app
