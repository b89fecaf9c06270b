#include "validation/chart/chart_settings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bearing/bearing.hpp"
#include "bearing/judge/judge_case.hpp"
#include "bearing/possible_methods.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::validation {
namespace {

using namespace bearing;

/// Collects settings around the default of one case.
class Star {
 public:
  Star(const Case& c, const ChartGrids& grids) : c_(c), grids_(grids) {
    const Physics physics = physics_of(c, c.model.tier);
    thermal_ = physics.film_energy;
    elastic_ = physics.elastic;
  }

  std::vector<ChartSetting> take() {
    for (const auto& grid : grids_.ladder) {
      add(ChartFamily::grid, std::to_string(grid[0]), grid, [](ChartSetting&) {});
      if (c_.cycle) continue;
      add(ChartFamily::extrapolated, std::to_string(grid[0]), grid, [](ChartSetting&) {});
    }
    if (c_.cycle) add_steps();
    if (thermal_) add_nodes();
    if (thermal_ && !c_.cycle) add_other_profiles();
    add(ChartFamily::tier, "estimate", grids_.compared.front(),
        [](ChartSetting& s) { s.tier = Tier::estimate; });
    for (const auto& grid : grids_.compared) {
      add_tiers(grid);
      if (c_.cycle) continue;
      if (!elastic_) add_cavitation(grid);
      if (elastic_) add_elastic(grid);
    }
    return std::move(settings_);
  }

 private:
  template <class Change>
  void add(ChartFamily family, const std::string& mark, std::array<int, 2> grid, Change change) {
    ChartSetting s{family, mark, c_.model.tier, grid, c_.model.film_nodes, {}, 0.0};
    change(s);
    Case changed = with_setting(c_, s);
    if (impossible_methods(changed, physics_of(changed, s.tier)).empty()) {
      settings_.push_back(std::move(s));
    }
  }

  void add_steps() {
    for (const double tolerance : {0.1, 0.03, 0.01, 0.003}) {
      if (tolerance == c_.model.tolerance && !c_.cycle->step) continue;
      add(ChartFamily::steps, fmt::format("{:.3g} %", 100.0 * tolerance), grids_.compared.front(),
          [&](ChartSetting& s) { s.tolerance = tolerance; });
    }
  }

  void add_nodes() {
    const auto grid = grids_.compared.front();
    for (const int n : {3, 5, 7, 9}) {
      if (n == c_.model.film_nodes) continue;
      add(ChartFamily::nodes, std::to_string(n), grid, [&](ChartSetting& s) { s.film_nodes = n; });
    }
  }

  void add_other_profiles() {
    const auto grid = grids_.compared.front();
    for (const int n : {10, 20, 40}) {
      add(ChartFamily::layers, std::to_string(n), grid, [&](ChartSetting& s) {
        s.methods.across = AcrossFilm::layers;
        s.methods.layers = n;
      });
    }
    add(ChartFamily::mean, "mean", grid,
        [](ChartSetting& s) { s.methods.across = AcrossFilm::mean; });
  }

  /// Lumped heat does nothing to an oil of constant viscosity.
  [[nodiscard]] bool same_physics(Tier tier) const {
    return tier == Tier::lumped &&
           std::holds_alternative<rheology::ConstantViscosity>(c_.oil.temperature);
  }

  void add_tiers(std::array<int, 2> grid) {
    for (const Tier tier : bearing::possible_tiers(c_)) {
      if (tier >= c_.model.tier || same_physics(tier)) continue;
      add(ChartFamily::tier, to_string(tier), grid, [&](ChartSetting& s) { s.tier = tier; });
    }
  }

  void add_cavitation(std::array<int, 2> grid) {
    const auto method = [&](const char* mark, CavitationMethod m) {
      add(ChartFamily::cavitation, mark, grid, [&](ChartSetting& s) { s.methods.cavitation = m; });
    };
    method("FB", CavitationMethod::fischer_burmeister);
    method("p-θ", CavitationMethod::p_theta);
    method("S-S", CavitationMethod::swift_stieber);
  }

  void add_elastic(std::array<int, 2> grid) {
    for (const double relaxation : {0.0, 0.05}) {
      add(ChartFamily::elastic, relaxation > 0.0 ? "0.05" : "Aitken", grid, [&](ChartSetting& s) {
        s.methods.elastic = ElasticMethod::fixed_point;
        s.methods.relaxation = relaxation;
      });
    }
  }

  const Case& c_;
  const ChartGrids& grids_;
  bool thermal_ = false;
  bool elastic_ = false;
  std::vector<ChartSetting> settings_;
};

}  // namespace

ChartGrids quick_grids() {
  return {{{48, 7}, {100, 13}}, {{100, 13}}, {{{100, 13}, {200, 25}, {400, 50}}}};
}

ChartGrids cycle_grids() {
  return {
      {{24, 4}, {48, 7}, {100, 13}, {200, 25}}, {{100, 13}}, {{{100, 12}, {200, 24}, {400, 48}}}};
}

ChartGrids quick_cycle_grids() {
  return {{{24, 4}, {48, 7}}, {{48, 7}}, {{{24, 4}, {48, 8}, {96, 16}}}};
}

std::vector<ChartSetting> chart_settings(const Case& c, const ChartGrids& grids) {
  return Star(c, grids).take();
}

Case with_setting(const Case& c, const ChartSetting& setting) {
  Case changed = c;
  changed.model.tier = setting.tier;
  if (setting.tolerance > 0.0) {
    changed.model.tolerance = setting.tolerance;
    if (changed.cycle) changed.cycle->step.reset();
  }
  if (setting.family == ChartFamily::automatic) {
    changed.model.grid_given = false;
    return with_rivals(std::move(changed));
  }
  changed.model.grid = setting.grid;
  changed.model.grid_given = true;
  changed.model.film_nodes = setting.film_nodes;
  changed.model.methods = setting.methods;
  return with_rivals(std::move(changed));
}

const char* to_string(ChartFamily family) {
  switch (family) {
    case ChartFamily::grid:
      return "grid";
    case ChartFamily::extrapolated:
      return "extrapolated";
    case ChartFamily::nodes:
      return "nodes";
    case ChartFamily::layers:
      return "layers";
    case ChartFamily::mean:
      return "mean";
    case ChartFamily::tier:
      return "tier";
    case ChartFamily::cavitation:
      return "cavitation";
    case ChartFamily::elastic:
      return "elastic";
    case ChartFamily::steps:
      return "steps";
    case ChartFamily::automatic:
      return "auto";
  }
  return "";
}

}  // namespace shellback::validation
