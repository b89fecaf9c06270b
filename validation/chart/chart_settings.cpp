#include "validation/chart/chart_settings.hpp"

#include <algorithm>

#include "bearing/bearing.hpp"
#include "bearing/judge_case.hpp"
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
    }
    if (thermal_) add_nodal_sets();
    add(ChartFamily::tier, "estimate", grids_.compared.front(),
        [](ChartSetting& s) { s.tier = Tier::estimate; });
    for (const auto& grid : grids_.compared) {
      add_tiers(grid);
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

  void add_nodal_sets() {
    const auto grid = grids_.compared.front();
    for (const int n : {3, 5, 7, 9}) {
      if (n == c_.model.film_nodes) continue;
      add(ChartFamily::nodes, std::to_string(n), grid, [&](ChartSetting& s) { s.film_nodes = n; });
    }
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

std::vector<ChartSetting> chart_settings(const Case& c, const ChartGrids& grids) {
  return Star(c, grids).take();
}

Case with_setting(const Case& c, const ChartSetting& setting) {
  Case changed = c;
  changed.model.tier = setting.tier;
  if (setting.family == ChartFamily::automatic) {
    changed.model.tolerance = setting.tolerance;
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
    case ChartFamily::automatic:
      return "auto";
  }
  return "";
}

}  // namespace shellback::validation
