#include "validation/shells/shells_case.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/reading/library.hpp"
#include "app/reading/overrides.hpp"
#include "app/reading/read_case.hpp"

namespace shellback::validation {

using bearing::Case;
using bearing::Tier;

const std::array<ShellKind, kShells>& shell_kinds() {
  static const std::array<ShellKind, kShells> kKinds{
      {{"AlSn, plain", "shell-plain", {0.02, 0.02, 0.005}, 102.5},
       {"AlSn, grooved", "shell-grooved", {0.02, 0.015, 0.007}, 96.2},
       {"polymer", "shell-polymer", {0.005, 0.0025, 0.01}, 71.5}}};
  return kKinds;
}

ShellsPlan shells_plan(bool quick) {
  ShellsPlan plan;
  plan.quick = quick;
  if (!quick) return plan;
  plan.grid = {100, 13};
  plan.left_open = {60, 9};
  plan.coarse = {48, 7};
  plan.rpm = {2000.0};
  plan.width = 1.2;
  return plan;
}

Case shell_case(int shell, Tier tier, const ShellSetting& s) {
  constexpr const char* kPlace = "study shells";
  const std::vector<app::Override> set{
      {"model.grid", fmt::format("[{}, {}]", s.grid[0], s.grid[1]), kPlace},
      {"model.tier", tier == Tier::tehd ? "tehd" : "isothermal", kPlace},
      {"operation.speed", fmt::format("{:.10g} rpm", s.rpm), kPlace},
      {"load_cycle.factor", fmt::format("{:.10g}", s.factor), kPlace}};
  return app::read_case(app::case_path(shell_kinds()[shell].file).string(), set);
}

double least_film(const Case& c) { return bearing::combined_roughness(c.surfaces); }

}  // namespace shellback::validation
