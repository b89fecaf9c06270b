#pragma once
/// What study/bounded_fit.hpp solves; the numbers of equations are its.
#include <functional>
#include <optional>
#include <vector>

namespace shellback::study {

struct FitParameter {
  double start = 0.0;  ///< strictly between the bounds
  double low = 0.0;
  double high = 0.0;
  bool has_zero = true;  ///< a ratio of two values means something: not of temperatures, of angles
};

/// What an evaluation serves: a step of the search, or a difference of (4) beside it.
enum class Purpose { step, difference };

struct FitProblem {
  std::vector<FitParameter> parameters;
  /// r at x; nothing if it cannot be computed there: a step that leads there is not taken.
  std::function<std::optional<std::vector<double>>(const std::vector<double>& x, Purpose)>
      residuals;
  double accuracy = 1e-9;        ///< of what r is computed from, relative [-]
  double noise = 0.0;            ///< of r: of computing, in its deviations [-]
  bool deviations_known = true;  ///< s_data = 1
  int most_iterations = 60;
  std::function<bool()> stopped{};  ///< may be empty
};

/// True if (2) takes the logarithm.
[[nodiscard]] bool in_logarithms(const FitParameter& p);
/// (2) and back.
[[nodiscard]] double fit_coordinate(const FitParameter& p, double x);
[[nodiscard]] double fit_value(const FitParameter& p, double y);

}  // namespace shellback::study
