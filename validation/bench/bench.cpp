/// Speed of the steady solvers, as milliseconds and as multiples of one KLU refactorisation of
/// the same film's full-width Reynolds matrix in the same run (klu_yardstick.hpp).
///
/// Each task is repeated; the shortest repetition counts, for the task and for the yardstick
/// alike: what other programs take from the machine only makes a repetition longer. One core.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <gsl/gsl_spline.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/solids.hpp"
#include "bearing/steady/nested.hpp"
#include "bearing/steady/solve.hpp"
#include "core/freed_memory.hpp"
#include "validation/bench/klu_yardstick.hpp"
#include "validation/bench/scenes.hpp"

namespace {

using namespace shellback;
using namespace shellback::bearing;
using Grid = std::array<int, 2>;

constexpr int kRepetitions = 5;
constexpr std::array<Grid, 4> kGrids{{{100, 13}, {200, 25}, {400, 50}, {800, 100}}};
/// Multiples of the yardstick at 200 x 25 that are aimed at (project design, section 6).
const std::map<std::string, double> kTargets{
    {"cycle rigid", 1},  {"cycle elastic barus", 2.5}, {"cycle elastic mixed", 4},
    {"static cold", 12}, {"static warm", 4},           {"thd", 40},
    {"tehd", 80}};

constexpr Grid kCoarse{100, 13};  ///< of cycles with heat, in multiples of the elastic one there

std::string label(const std::string& task, const std::string& scene, Grid g) {
  return fmt::format("{}/{}/{}x{}", task, scene, g[0], g[1]);
}

void expect_good(const Solution& s, benchmark::State& state) {
  if (!s.verdict.good()) state.SkipWithError(app::reason_of(s.verdict).c_str());
}

void register_task(const std::string& name, std::function<void(benchmark::State&)> run) {
  benchmark::RegisterBenchmark(name.c_str(), [run](benchmark::State& s) { run(s); })
      ->Unit(benchmark::kMillisecond)
      ->Repetitions(kRepetitions)
      ->MinTime(0.02);
}

void yardsticks(const std::string& scene, Grid g) {
  register_task(label("klu refactor", scene, g), [=](benchmark::State& state) {
    bench::KluYardstick klu(bench::reynolds_matrix(bench::scene(scene, g), g[0], g[1]));
    for (auto _ : state) klu.refactor();
  });
  register_task(label("klu analyse and factor", scene, g), [=](benchmark::State& state) {
    bench::KluYardstick klu(bench::reynolds_matrix(bench::scene(scene, g), g[0], g[1]));
    for (auto _ : state) klu.factor_afresh();
  });
  register_task(label("ring factor, full width", scene, g), [=](benchmark::State& state) {
    const RingMatrix a = bench::reynolds_matrix(bench::scene(scene, g), g[0], g[1]);
    RingFactor ring;
    for (auto _ : state) benchmark::DoNotOptimize(ring.factorize(a));
  });
}

/// Load of the rigid isothermal film at a given eccentricity, for the accuracy beside the speed.
void film_at(double eps, Grid g) {
  const std::string task = fmt::format("film at eps {}", eps);
  register_task(label(task, "raimondi-boyd", g), [=](benchmark::State& state) {
    Case c = bench::scene("raimondi-boyd", g);
    auto& given = std::get<EccentricityGiven>(c.operation.position);
    given.ratio = eps;
    double load = 0.0;
    for (auto _ : state) {
      const Solution s = solve_tier(c, Tier::isothermal);
      expect_good(s, state);
      load = std::hypot(s.film.force[0], s.film.force[1]);
    }
    state.counters["load_N"] = load;
  });
}

void statics(const std::string& scene, Grid g) {
  register_task(label("static cold", scene, g), [=](benchmark::State& state) {
    const Case c = bench::scene(scene, g);
    for (auto _ : state) expect_good(solve_tier(c, Tier::isothermal), state);
  });
  register_task(label("static warm", scene, g), [=](benchmark::State& state) {
    const Solution s = solve_tier(bench::scene(scene, g), Tier::isothermal);
    expect_good(s, state);
    OperatingPoint more = s.point;
    for (double& f : more.load.force) f *= 1.02;
    EquilibriumCost cost;
    Verdict verdict;
    for (auto _ : state) {
      FilmEquilibrium film = s.film;
      cost = {};
      verdict = solve_equilibrium({s.model, more, {}}, film, cost);
      benchmark::DoNotOptimize(film);
    }
    if (!verdict.good()) state.SkipWithError("the film under more load was not found");
    state.counters["newton"] = cost.newton_iterations;
    state.counters["factorisations"] = cost.factorizations;
  });
}

void resolved(const std::string& scene, Tier tier, Grid g) {
  register_task(label(to_string(tier), scene, g), [=](benchmark::State& state) {
    Case c = bench::scene(scene, g);
    c.model.tier = tier;
    const Solution first = solve_tier(c, tier);  // builds the solids' operators of this grid
    expect_good(first, state);
    for (auto _ : state) expect_good(solve_tier(c, tier, {}, first.model.solids), state);
    state.counters["setup_ms"] = first.model.solids->setup_seconds() * 1e3;
  });
}

/// The cycles of the benchmark.
struct CycleTask {
  std::string name;
  std::string scene;
  double pulse = 0.0;  ///< [N]
  bool elastic = false;
  bool rough = true;  ///< false: smooth, without contact or thinning by shear
  Tier tier = Tier::isothermal;
};

Case case_of(const CycleTask& task, Grid g) {
  Case c = bench::scene(task.scene, g);
  c.cycle = bench::pulse_over_two_turns(c.operation.omega, task.pulse);
  c.model.switches.elastic_deformation = task.elastic;
  if (!task.rough) {
    c.surfaces = {};
    c.oil.shear = rheology::NoShearThinning{};
  }
  c.model.tolerance = 0.01;  // error of a step in the film: 1e-3
  return c;
}

/// Largest difference over the cycle of the smallest film from that with a tenth of the error per
/// step, over film and roughness [-]: what the tolerance of the row is worth. Between its instants
/// the finer film is a cubic spline (GSL).
double error_in_time(const CycleResult& r, Case c, Tier tier) {
  c.model.tolerance *= 0.1;
  const CycleResult fine = solve_cycle(c, tier);
  if (!fine.verdict.good()) return NAN;
  std::vector<double> t, h;
  for (const CycleInstant& i : fine.instants) {
    t.push_back(i.t);
    h.push_back(i.h_min);
  }
  const std::unique_ptr<gsl_spline, void (*)(gsl_spline*)> spline(
      gsl_spline_alloc(gsl_interp_cspline, t.size()), gsl_spline_free);
  gsl_spline_init(spline.get(), t.data(), h.data(), t.size());
  const double sigma = bearing::combined_roughness(c.surfaces);
  double worst = 0.0;
  for (const CycleInstant& i : r.instants) {
    const double film = gsl_spline_eval(spline.get(), std::min(i.t, t.back()), nullptr);
    worst = std::max(worst, std::abs(i.h_min - film) / (film + sigma));
  }
  return worst;
}

/// A cycle of two turns: a pulse over a load that turns. Time per degree of crank angle, of all the
/// cycles that the periodic state took.
void cycle(const CycleTask& task, Grid g) {
  const auto run = [=](benchmark::State& state) {
    const Case c = case_of(task, g);
    for (auto _ : state) {
      const CycleResult r = solve_cycle(c, task.tier);
      if (!r.verdict.good()) state.SkipWithError(app::reason_of(r.verdict).c_str());
      const double degrees = 720.0 * r.cycles;
      state.SetIterationTime(r.cost.wall_s / degrees);
      state.counters["factorisations_per_degree"] = r.cost.factorizations / degrees;
      state.counters["cycles"] = r.cycles;
      state.counters["steps"] = r.steps;
      state.counters["seconds"] = r.cost.wall_s;
      if (!task.elastic || g == kCoarse) {  // elsewhere it costs ten times the row
        state.counters["error_in_time"] = error_in_time(r, c, task.tier);
      }
    }
  };
  benchmark::RegisterBenchmark(label(task.name, task.scene, g).c_str(),
                               [run](benchmark::State& s) { run(s); })
      ->Unit(benchmark::kMillisecond)
      ->UseManualTime()
      ->Iterations(1);
}

/// Keeps the shortest repetition of every task besides printing as usual.
class Collector : public benchmark::ConsoleReporter {
 public:
  struct Row {
    double ms = INFINITY;
    std::map<std::string, double> counters;
  };
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      std::string name = run.run_name.function_name;
      if (!rows_.count(name)) order_.push_back(name);
      Row& row = rows_[name];
      row.ms = std::min(row.ms, run.GetAdjustedRealTime());
      for (const auto& [key, counter] : run.counters) row.counters[key] = counter.value;
    }
  }
  void print_table() const;

 private:
  std::vector<std::string> order_;
  std::map<std::string, Row> rows_;
};

void Collector::print_table() const {
  fmt::print("\n{:<48}{:>12}{:>12}{:>10}\n", "task/scene/grid (shortest of repetitions)", "ms",
             "/ KLU", "target");
  for (const std::string& name : order_) {
    const auto first = name.find('/');
    const auto last = name.rfind('/');
    const std::string task = name.substr(0, first);
    const auto yard = rows_.find("klu refactor" + name.substr(first));
    const Row& row = rows_.at(name);
    std::string ratio = "-";
    std::string target = "-";
    if (yard != rows_.end()) ratio = fmt::format("{:.2f}", row.ms / yard->second.ms);
    const auto aim = kTargets.find(task);
    if (aim != kTargets.end() && name.substr(last) == "/200x25")
      target = fmt::format("{}", aim->second);
    fmt::print("{:<48}{:>12.3f}{:>12}{:>10}", name, row.ms, ratio, target);
    for (const auto& [key, value] : row.counters) fmt::print("  {} {:.6g}", key, value);
    fmt::print("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  benchmark::Initialize(&argc, argv);
  for (const Grid g : kGrids) {
    for (const std::string scene : {"raimondi-boyd", "thd-plain-bearing", "ks-rig-test-bearing"}) {
      yardsticks(scene, g);
    }
    for (const double eps : {0.6, 0.9, 0.95}) film_at(eps, g);
    for (const std::string scene : {"thd-plain-bearing", "ks-rig-test-bearing"}) {
      statics(scene, g);
      resolved(scene, Tier::thd, g);
      if (g[0] <= 400) resolved(scene, Tier::tehd, g);
    }
    if (g[0] != 200) continue;
    cycle({"cycle rigid", "thd-plain-bearing", 20e3}, g);
    for (const bool rough : {false, true}) {
      const std::string name = rough ? "cycle elastic mixed" : "cycle elastic barus";
      cycle({name, "ks-rig-test-bearing", 40e3, true, rough}, g);
    }
  }
  yardsticks("ks-rig-test-bearing", kCoarse);
  for (const Tier tier : {Tier::isothermal, Tier::tehd}) {
    const std::string name = tier == Tier::tehd ? "cycle tehd" : "cycle elastic mixed";
    cycle({name, "ks-rig-test-bearing", 40e3, true, true, tier}, kCoarse);
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  collector.print_table();
  return 0;
}
