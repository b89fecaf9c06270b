#pragma once
/// The methods of the stability map: what Shellback does by itself, and what others do.
#include <string>
#include <vector>

#include "bearing/bearing.hpp"

namespace shellback::validation {

/// One column block of the map.
struct StressMethod {
  std::string name;   ///< word in tables: "p-theta"
  std::string title;  ///< in the picture
  /// Friction torque and smallest film may differ so far from the default's: the same equations
  /// leave next to nothing, another discretisation its error, another model more [-].
  double allowed = 0.0;
  bool shipped = false;         ///< what Shellback does unless told otherwise
  bool same_equations = false;  ///< the default's, and its discretisation
  bool less_physics = false;    ///< a poorer model: its results contradict no refusal
  bool full_shear = false;      ///< no fill ratio: cavitated film is sheared as if it were full
};

/// The default first.
[[nodiscard]] const std::vector<StressMethod>& stress_methods();

/// KEY=VALUE words that make a case with this physics use the method; `applies` is false where the
/// method is the default itself (no elasticity for an elastic method, ...).
struct StressMethodWords {
  bool applies = false;
  std::vector<std::string> words;
};
[[nodiscard]] StressMethodWords words_for(const StressMethod& method,
                                          const bearing::Physics& physics);

}  // namespace shellback::validation
