#pragma once
/// The stress scenes: validation/stress/scenes.toml, one key of a case driven to where films end.
#include <string>
#include <vector>

#include "app/reading/overrides.hpp"
#include "bearing/case.hpp"
#include "validation/stress/stress_expectation.hpp"

namespace shellback::validation {

/// One value of what a scene drives.
struct StressStep {
  std::string label;               ///< as in the file: "8 kN"
  std::vector<std::string> words;  ///< KEY=VALUE, as behind --set
};

/// A quantity that must go one way along the values.
struct StressTrend {
  std::string quantity;  ///< name in the result; empty: none
  bool falls = false;
};

/// One scene in one tier: a row of the map.
struct StressScene {
  std::string name;
  std::string title;
  std::string expect;     ///< what physics has in store, in words
  std::string axis;       ///< the key driven, in words
  std::string case_path;  ///< case file
  bearing::Tier tier = bearing::Tier::isothermal;
  std::vector<std::string> words;  ///< changes that hold throughout, KEY=VALUE
  std::vector<StressStep> steps;   ///< from harmless to beyond failing
  StressTrend trend;
  StressExpectation expects;  ///< what physics is known to have in store in this tier
  bool mirror = false;        ///< each step is solved mirrored as well
};

/// "scene/tier"
[[nodiscard]] std::string full_name(const StressScene& scene);

/// The rows that `text` describes, in its order; `folder` holds its case files. `quick` takes a
/// coarse grid where the scene does not choose its own. Throws InputError with place.
[[nodiscard]] std::vector<StressScene> parse_stress_scenes(const std::string& text,
                                                           const std::string& path,
                                                           const std::string& folder, bool quick);

/// The shipped rows.
[[nodiscard]] std::vector<StressScene> shipped_stress_scenes(bool quick);

/// Rows whose scene or scene/tier is among `names` (empty: all). Throws InputError for a name that
/// is none of them.
[[nodiscard]] std::vector<StressScene> chosen_stress_scenes(const std::vector<StressScene>& all,
                                                            const std::vector<std::string>& names);

}  // namespace shellback::validation
