#include "validation/rig/rig_scene.hpp"

#include <fmt/format.h>

#include "app/reading/library.hpp"
#include "app/reading/overrides.hpp"
#include "app/reading/read_case.hpp"
#include "validation/rig/rig_sum.hpp"

namespace shellback::validation {
namespace {

using app::Override;
using bearing::Case;

constexpr const char* kPlace = "study ks-rig";

std::string file_of(RigBearing bearing) {
  const char* name = bearing == RigBearing::test ? "ks-rig-cycle" : "ks-rig-support-bearing";
  return app::case_path(name).string();
}

Override changed(const std::string& key, const std::string& value) { return {key, value, kPlace}; }

Override on_grid(const std::array<int, 2>& grid) {
  return changed("model.grid", fmt::format("[{}, {}]", grid[0], grid[1]));
}

/// Load, speed, grid and the unknown input.
std::vector<Override> changes_of(RigBearing bearing, const RigSetting& s) {
  const auto loads = rig_loads(s.peak);
  const double load = bearing == RigBearing::test ? loads[1] : loads[0];
  std::vector<Override> set{changed("operation.speed", fmt::format("{:.10g} rpm", s.rpm)),
                            changed("load_cycle.factor", fmt::format("{:.10g}", load / kTracePeak)),
                            on_grid(s.grid)};
  if (s.unknown == nullptr) return set;
  const auto& words = bearing == RigBearing::test ? s.unknown->test : s.unknown->support;
  for (const std::string& change : words[static_cast<std::size_t>(s.end)]) {
    set.push_back(app::parse_override(change));
    set.back().place = kPlace;
  }
  return set;
}

/// The same course of the load, `factor` times as slow.
void stretch(Case& c, double factor) {
  for (double& t : c.cycle->t) t *= factor;
  c.cycle->period *= factor;
}

Case read(RigBearing bearing, const RigSetting& s, const std::vector<Override>& set) {
  Case c = app::read_case(file_of(bearing), set);
  if (s.unknown != nullptr) stretch(c, s.unknown->stretched[static_cast<std::size_t>(s.end)]);
  return c;
}

}  // namespace

const char* to_string(RigBearing bearing) {
  return bearing == RigBearing::test ? "test bearing" : "support bearing";
}

const char* to_string(OilModel model) {
  switch (model) {
    case OilModel::temperature:
      return "eta(T)";
    case OilModel::pressure:
      return "eta(T, p)";
    case OilModel::full:
      return "eta(T, p, shear rate)";
  }
  return "";
}

const std::vector<RigUnknown>& film_unknowns() {
  const auto both = [](const char* low, const char* high) {
    return std::array<std::vector<std::string>, 2>{{{low}, {high}}};
  };
  static const std::vector<RigUnknown> kUnknowns{
      {"clearance of all three bearings", "psi 0.8e-3 to 1.2e-3, taken 1e-3",
       both("bearing.radial_clearance=19.12 um", "bearing.radial_clearance=28.68 um"),
       both("bearing.radial_clearance=21.6 um", "bearing.radial_clearance=32.4 um")},
      {"film temperature", "10 K below to 10 K above that of the run-up", {}, {}, {-10.0, 10.0}},
      {"groove and hole", "3 to 8 mm, taken 5 mm",
       both("supply.0.diameter=3 mm", "supply.0.diameter=8 mm"),
       both("supply.0.width=3 mm", "supply.0.width=8 mm")},
      {"supply pressure", "1 to 5 bar gauge, taken 3 bar",
       both("supply.0.pressure=1 bar", "supply.0.pressure=5 bar"),
       both("supply.0.pressure=1 bar", "supply.0.pressure=5 bar")},
      {"frequency of the load", "160 to 40 Hz, taken 80 Hz", {}, {}, {0.0, 0.0}, {0.5, 2.0}}};
  return kUnknowns;
}

const std::vector<RigUnknown>& body_unknowns() {
  using Ends = std::array<std::vector<std::string>, 2>;
  const Ends supply{{{"supply.0.temperature=60 degC", "shell.back.ambient=40 degC"},
                     {"supply.0.temperature=100 degC", "shell.back.ambient=80 degC"}}};
  const Ends cooling{
      {{"shell.back.heat_transfer=50 W/(m2 K)"}, {"shell.back.heat_transfer=2000 W/(m2 K)"}}};
  static const std::vector<RigUnknown> kUnknowns{
      {"supply temperature", "60 to 100 degC (surroundings 40 to 80), taken 80 (60)", supply,
       supply},
      {"heat transfer at the back", "50 to 2000 W/(m2 K), taken 500", cooling, cooling}};
  return kUnknowns;
}

const RigUnknown& heavier_bodies() {
  static const RigUnknown kHeavier{"heat capacity of rod and brackets",
                                   "1 to 10 times that of the rings, taken 1",
                                   {{{}, {"shell.housing.material.heat_capacity=9000 J/(kg K)"}}},
                                   {{{}, {"shell.housing.material.heat_capacity=4600 J/(kg K)"}}}};
  return kHeavier;
}

Case rig_case(RigBearing bearing, const RigSetting& s) {
  return read(bearing, s, changes_of(bearing, s));
}

Case rig_isothermal_case(RigBearing bearing, const RigSetting& s, OilModel oil, double T) {
  std::vector<Override> set = changes_of(bearing, s);
  const double warmer =
      s.unknown == nullptr ? 0.0 : s.unknown->warmer[static_cast<std::size_t>(s.end)];
  set.push_back(changed("model.tier", "isothermal"));
  set.push_back(changed("model.elastic_deformation", "true"));
  set.push_back(changed("oil.temperature", fmt::format("{:.10g} K", T + warmer)));
  const bool pressure = oil != OilModel::temperature;
  const bool shear = oil == OilModel::full;
  set.push_back(changed("model.pressure_dependence", pressure ? "true" : "false"));
  set.push_back(changed("model.shear_thinning", shear ? "true" : "false"));
  return read(bearing, s, set);
}

Case rig_start_stop_case(RigBearing bearing, bool worn, double T, std::array<int, 2> grid) {
  const char* name = bearing == RigBearing::test ? "start-stop" : "start-stop-support";
  std::vector<Override> set{on_grid(grid), changed("oil.temperature", fmt::format("{:.10g} K", T))};
  if (worn) {  // Table 3
    set.push_back(changed("surfaces.shell.roughness", "0.26 um"));
    set.push_back(changed("surfaces.shell.summit_roughness", "0.23 um"));
    set.push_back(changed("surfaces.shell.summit_height", "0.19 um"));
  }
  return app::read_case(app::case_path(name).string(), set);
}

double rig_projected_area() {
  const Case c = app::read_case(file_of(RigBearing::test));
  return 2.0 * c.bearing.radius * c.bearing.width;
}

}  // namespace shellback::validation
