#include "validation/chart/chart_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/did_you_mean.hpp"
#include "app/library.hpp"
#include "app/read_case.hpp"
#include "core/contract.hpp"

namespace shellback::validation {

std::vector<std::string> chart_scene_names() {
  return {"lightly-loaded", "raimondi-boyd", "hot-plain-bearing", "ks-rig-8kN", "ks-rig-80kN"};
}

bearing::Case chart_case(const std::string& name_or_path) {
  if (name_or_path.ends_with(".toml")) return app::read_case(name_or_path);
  const auto names = chart_scene_names();
  if (std::find(names.begin(), names.end(), name_or_path) == names.end()) {
    throw InputError(fmt::format("there is no scene {}{}", app::in_quotes(name_or_path),
                                 app::choices_for(name_or_path, names, "scenes are")));
  }
  const auto path = app::library_root() / "validation" / "chart" / (name_or_path + ".toml");
  return app::read_case(path.string());
}

}  // namespace shellback::validation
