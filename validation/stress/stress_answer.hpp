#pragma once
/// One solve of the stability map: what it gives, looked through for what cannot be.
#include <string>
#include <utility>
#include <vector>

#include "bearing/result.hpp"
#include "validation/stress/stress_scenes.hpp"

namespace shellback::validation {

/// Status of a case that is refused before the solve.
inline constexpr const char* kRefusedInput = "refused input";

/// What a child tells of its solve.
struct StressAnswer {
  std::string status;  ///< core/outcome.hpp's words, or kRefusedInput
  std::string reason;
  std::string place;
  bearing::Audit audit;
  std::vector<std::pair<std::string, double>> quantities;  ///< SI
  std::vector<std::string> faults;  ///< what cannot be, in words; empty: nothing
  bool not_a_number = false;        ///< one of the faults is that
  /// Refused where the film's equations meet their bound on this grid, be it that another grid was
  /// not found to agree.
  bool meets_bound = false;
  double wall_s = 0.0;

  [[nodiscard]] bool converged() const;
  /// Not-a-number if it is not there.
  [[nodiscard]] double value(const std::string& name) const;
};

/// The case turned over at the X axis: phi -> -phi, speed reversed, the tilt's and
/// moment's component along X (an axial vector) reversed. Its solution is the mirror image.
[[nodiscard]] bearing::Case mirrored(const bearing::Case& c);

/// What cannot be in a converged result: numbers that are none; theta outside [0, 1]; pressure
/// below that of cavitation; smooth surfaces that touch; temperatures below all given ones or
/// beyond those at which oil is a liquid; audits out of bounds (mass 1e-8, energy 1e-4 of
/// the largest heat stream, load 1e-6; moment: the error of the grid, 5 %) or not a number where
/// the tier has that balance.
void look_through(const bearing::Case& c, const bearing::Result& result, StressAnswer& answer);

/// Reads the case, solves it and looks through the result; with `mirror` solves its mirror image
/// too and compares. InputError becomes an answer, all else is thrown.
[[nodiscard]] StressAnswer solve_stress_case(const StressScene& scene,
                                             const std::vector<std::string>& words);

/// As text between processes.
[[nodiscard]] std::string to_text(const StressAnswer& answer);
[[nodiscard]] StressAnswer answer_from(const std::string& text);

}  // namespace shellback::validation
