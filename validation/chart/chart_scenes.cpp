#include "validation/chart/chart_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/reading/did_you_mean.hpp"
#include "app/reading/library.hpp"
#include "app/reading/read_case.hpp"
#include "core/contract.hpp"

namespace shellback::validation {

namespace {

struct Shipped {
  const char* name;
  const char* folder;  ///< of the library
};
const std::array<Shipped, 6> kScenes{{{"lightly-loaded", "validation/chart"},
                                      {"raimondi-boyd", "validation/chart"},
                                      {"hot-plain-bearing", "validation/chart"},
                                      {"ks-rig-8kN", "validation/chart"},
                                      {"ks-rig-80kN", "validation/chart"},
                                      {"flores-slider-crank", "cases"}}};

}  // namespace

std::vector<std::string> chart_scene_names() {
  std::vector<std::string> names;
  for (const Shipped& s : kScenes) names.emplace_back(s.name);
  return names;
}

bearing::Case chart_case(const std::string& name_or_path) {
  if (name_or_path.ends_with(".toml")) return app::read_case(name_or_path);
  const auto scene = std::find_if(kScenes.begin(), kScenes.end(),
                                  [&](const Shipped& s) { return name_or_path == s.name; });
  if (scene == kScenes.end()) {
    throw InputError(
        fmt::format("there is no scene {}{}", app::in_quotes(name_or_path),
                    app::choices_for(name_or_path, chart_scene_names(), "scenes are")));
  }
  return app::read_case((app::library_root() / scene->folder / (name_or_path + ".toml")).string());
}

}  // namespace shellback::validation
