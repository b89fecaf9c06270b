#pragma once
/// Indicator numbers: which effects a case asks for, from closed estimates alone.
///
/// Each number has two limits, below the first the effect is negligible, above the second it is
/// important; between them it shows. The limits are those of the solver's theory notes. The
/// estimates are coarse (rigid isothermal film), the numbers therefore orders of magnitude.
#include <string>
#include <vector>

#include "app/derived.hpp"

namespace shellback::app {

/// What a number says about an effect.
enum class Weight { negligible, between, important };

/// An effect's indicator number; evaluated at the closed-form estimate.
struct Indicator {
  std::string effect;
  std::string formula;
  double value = 0.0;  ///< [-]
  Weight weight = Weight::negligible;
  std::string advice;  ///< what the weight means for the model
};

/// Indicators of the case from its derived numbers.
[[nodiscard]] std::vector<Indicator> indicators(const bearing::Case& subject,
                                                const Derived& derived);

}  // namespace shellback::app
