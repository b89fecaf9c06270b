#include "validation/chart/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/judge/judge_case.hpp"
#include "bearing/steady/solve.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "fidelity/auto_cycle.hpp"
#include "fidelity/edge_error.hpp"
#include "fidelity/solve.hpp"
#include "fidelity/solve_case.hpp"
#include "validation/chart/pareto.hpp"

namespace shellback::validation {
namespace {

using namespace bearing;

constexpr int kReferenceNodes = 9;

ChartValues values_of(const Solution& s, Tier tier) {
  const auto q = quantities_of(s, tier);
  const double T = s.model.physics.film_energy ? value_in(q, "T_film_max") : s.T_film;
  return {value_in(q, "friction_torque"), value_in(q, "h_min"), T};
}

ChartValues values_of(const Result& r) {
  const double T = value_in(r.quantities, r.has("T_film_max") ? "T_film_max" : "T_equivalent");
  return {value_in(r.quantities, "friction_torque"), value_in(r.quantities, "h_min"), T};
}

bool stopped(const ChartOptions& o) { return o.stop && o.stop->load(); }

bool has_heat(const Case& c) { return physics_of(c, c.model.tier).film_energy; }

/// One solve of a case, steady or over its cycle.
struct Solved {
  Verdict verdict;
  ChartValues value{};
  long factorizations = 0;
  long sweeps = 0;
  double edge = 0.0;  ///< fidelity/edge_error.hpp, of a steady film [m]
};

/// What the grids of the bars of a steady film lead to.
Solved led_on(const Solution& s, Tier tier, const SolveControl& control) {
  const Result r = fidelity::summarize(s, tier, control, fidelity::WantedBars::grid);
  Solved out{r.verdict, values_of(r), s.cost.factorizations, s.cost.sweeps, 0.0};
  const std::array names{"friction_torque", "h_min", r.has("T_film_max") ? "T_film_max" : ""};
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (const Quantity& q : r.quantities) {
      if (q.name == names[k] && std::isfinite(q.limit)) out.value[k] = q.limit;
    }
  }
  return out;
}

Solved solved(const Case& c, Tier tier, const SolveControl& control, bool extrapolated = false) {
  const bool chosen = tier == Tier::automatic || tier == Tier::estimate;
  if (!c.cycle && !chosen) {
    const Solution s = solve_tier(c, tier, control);
    if (extrapolated && s.verdict.good()) return led_on(s, tier, control);
    return {s.verdict, s.verdict.good() ? values_of(s, tier) : ChartValues{}, s.cost.factorizations,
            s.cost.sweeps,
            fidelity::edge_error(s)};
  }
  const auto over_cycle = [&] {
    return as_result(chosen ? fidelity::solve_cycle_case(c, control)
                            : solve_cycle(c, tier, control));
  };
  const Result r = c.cycle ? over_cycle() : fidelity::solve_case(c, control);
  return {r.verdict, values_of(r), r.cost.factorizations, 0, 0.0};
}

const ChartGrids& grids_for(const Case& c, const ChartOptions& options) {
  return c.cycle ? options.of_cycles : options.grids;
}

void find_reference(const Case& c, const ChartOptions& options, ChartScene& scene) {
  constexpr double kSteps = 1e-3;         // tolerance of a cycle's steps [-]
  constexpr double kCoarserSteps = 3e-3;  // of those that tell what steps leave [-]
  const int solves = c.cycle ? 4 : 3;
  std::array<Solved, 4> found;
  SolveControl control;
  control.stop = options.stop;
  // The costliest first.
  parallel_for(solves, options.threads, [&](int task) {
    const int k = task < 3 ? 2 - task : 3;
    ChartSetting setting;
    setting.tier = c.model.tier;
    setting.grid = grids_for(c, options).reference[k % 3];
    setting.film_nodes = kReferenceNodes;
    if (c.cycle) setting.tolerance = k < 3 ? kSteps : kCoarserSteps;
    found[k] = solved(with_setting(c, setting), c.model.tier, control);
  });
  for (int k = 0; k < solves; ++k) {
    if (!found[k].verdict.good()) scene.verdict = found[k].verdict;
  }
  if (!scene.verdict.good()) return;
  for (int q = 0; q < kChartQuantities; ++q) {
    const double coarse = found[0].value[q];
    ReferenceValue& r = scene.reference[q];
    r = reference_value(coarse, found[1].value[q], found[2].value[q]);
    if (q == static_cast<int>(ChartQuantity::h_min)) r.uncertainty += found[2].edge;
    if (c.cycle) r.uncertainty += std::abs(found[3].value[q] - coarse);
    const bool relative = q != static_cast<int>(ChartQuantity::T_max);
    scene.floor[q] = r.uncertainty / (relative ? std::abs(r.value) : 1.0);
  }
}

/// One solve; false if it was stopped.
bool measure_once(const Case& c, const ChartOptions& options, ChartPoint& p) {
  SolveControl control;
  control.stop = options.stop;
  const Stopwatch watch;
  const Solved s =
      solved(c, p.setting.tier, control, p.setting.family == ChartFamily::extrapolated);
  const double wall = watch.seconds();
  p.verdict = s.verdict;
  p.value = s.value;
  p.factorizations = s.factorizations;
  p.sweeps = s.sweeps;
  p.wall_s = p.wall_s > 0.0 ? std::min(p.wall_s, wall) : wall;
  return p.verdict.status != Status::interrupted;
}

bool measure(const Case& c, const ChartOptions& options, ChartPoint& p) {
  const Case changed = with_setting(c, p.setting);
  double spent = 0.0;
  for (int k = 0; k < options.repeats && (k == 0 || spent < options.enough_s); ++k) {
    if (!measure_once(changed, options, p)) return false;
    spent += p.wall_s;
    if (!p.verdict.good()) break;
  }
  return true;
}

void judge(const ChartScene& scene, bool heat, ChartPoint& p) {
  for (int q = 0; q < kChartQuantities; ++q) {
    const bool temperature = q == static_cast<int>(ChartQuantity::T_max);
    const double off = std::abs(p.value[q] - scene.reference[q].value);
    p.error[q] = temperature ? off : off / std::abs(scene.reference[q].value);
    if (!p.verdict.good() || (temperature && !heat)) p.error[q] = NAN;
  }
}

void mark_fronts(ChartScene& scene) {
  for (int q = 0; q < kChartQuantities; ++q) {
    std::vector<CostError> points;
    for (const ChartPoint& p : scene.points) points.push_back({p.wall_s, p.error[q]});
    for (const int k : pareto_front(points, scene.floor[q])) scene.points[k].on_front[q] = true;
  }
}

/// True if no richer tier that the case has the data for adds physics.
bool is_richest(const Case& c) {
  const Physics own = physics_of(c, c.model.tier);
  const auto tiers = bearing::possible_tiers(c);
  return std::all_of(tiers.begin(), tiers.end(), [&](Tier tier) {
    const Physics p = physics_of(c, tier);
    return p.film_energy <= own.film_energy && p.elastic <= own.elastic &&
           p.thermal_deformation <= own.thermal_deformation;
  });
}

std::vector<ChartSetting> all_settings(const Case& c, const ChartOptions& options) {
  auto settings = chart_settings(c, grids_for(c, options));
  if (!is_richest(c)) return settings;
  for (const double tolerance : options.tolerances) {
    ChartSetting s;
    s.family = ChartFamily::automatic;
    s.mark = fmt::format("{:.3g} %", 100.0 * tolerance);
    s.tier = Tier::automatic;
    s.tolerance = tolerance;
    settings.push_back(s);
  }
  return settings;
}

std::string words_of(const ChartSetting& s) {
  if (s.family == ChartFamily::automatic) return "auto to " + s.mark;
  return fmt::format("{} {} on {} x {}", to_string(s.family), s.mark, s.grid[0], s.grid[1]);
}

}  // namespace

ChartScene chart_scene(const std::string& name, const Case& c, const ChartOptions& options) {
  ChartScene scene;
  scene.name = name;
  scene.title = c.title;
  scene.floor.fill(NAN);
  const auto settings = all_settings(c, options);
  const int count = static_cast<int>(settings.size()) + 1;
  if (options.tell) options.tell(name + ": reference", 0, count);
  find_reference(c, options, scene);
  if (!scene.verdict.good()) return scene;
  for (const ChartSetting& setting : settings) {
    const int done = static_cast<int>(scene.points.size()) + 1;
    if (options.tell) options.tell(name + ": " + words_of(setting), done, count);
    ChartPoint p;
    p.setting = setting;
    if (stopped(options) || !measure(c, options, p)) {
      scene.verdict = {Status::interrupted};
      break;
    }
    judge(scene, has_heat(c), p);
    scene.points.push_back(std::move(p));
  }
  mark_fronts(scene);
  return scene;
}

const char* to_string(ChartQuantity quantity) {
  switch (quantity) {
    case ChartQuantity::friction_torque:
      return "friction_torque";
    case ChartQuantity::h_min:
      return "h_min";
    case ChartQuantity::T_max:
      return "T_film_max";
  }
  return "";
}

}  // namespace shellback::validation
