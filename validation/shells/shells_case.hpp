#pragma once
/// The shells of the study as cases, and on which grids and speeds they are solved.
#include <array>
#include <string>
#include <vector>

#include "bearing/case.hpp"

namespace shellback::validation {

/// One of the shells, and what the paper has of it.
struct ShellKind {
  const char* name;                    ///< as shown
  const char* file;                    ///< shipped case
  std::array<double, 3> coefficients;  ///< Table 4: abrasive, adhesive, micro-hydrodynamic [-]
  double power;                        ///< Table 5 [W]
};
inline constexpr int kShells = 3;
[[nodiscard]] const std::array<ShellKind, kShells>& shell_kinds();

struct ShellsPlan {
  std::array<int, 2> grid{100, 25};       ///< of the cycles
  std::array<int, 2> left_open{100, 13};  ///< of the variants
  std::array<int, 2> coarse{60, 9};       ///< of the capability
  std::vector<double> rpm{1000.0, 2000.0, 3000.0};
  std::array<double, 2> factors{0.25, 4.0};  ///< multiples of the load between which is looked [-]
  double width = 1.09;  ///< ratio of the last load not borne to the last borne [-]
  bool quick = false;   ///< told on the page
};
[[nodiscard]] ShellsPlan shells_plan(bool quick);

struct ShellSetting {
  std::array<int, 2> grid;
  double rpm = 2000.0;
  double factor = 1.0;  ///< of the load [-]
};

/// The shipped case of a shell so. Errors: InputError where it does not read.
[[nodiscard]] bearing::Case shell_case(int shell, bearing::Tier tier, const ShellSetting& setting);

/// Smallest film of the capability: the combined roughness of the pair (textbook: below it film and
/// asperities share the load) [m].
[[nodiscard]] double least_film(const bearing::Case& c);

}  // namespace shellback::validation
