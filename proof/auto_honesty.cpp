#include "proof/auto_honesty.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <ostream>

#include "core/parallel.hpp"
#include "coupling/solve.hpp"
#include "fidelity/auto_tier.hpp"
#include "proof/honesty.hpp"
#include "proof/population.hpp"

namespace shellback::proof {
namespace {

using namespace coupling;

constexpr int kTruthNodes = 7;  ///< across the film [-]

/// Processor time of this thread [s]: the wall's clock also counts what others do.
double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Scalars {
  double friction = NAN;
  double h_min = NAN;
};

/// Full TEHD on a grid.
struct Full {
  bool good = false;
  Scalars scalars;
  double seconds = 0.0;
  int factorizations = 0;
};

Full solve_full(Case c, std::array<int, 2> grid, const SolveControl& control) {
  c.model.grid = grid;
  c.model.film_nodes = kTruthNodes;
  const double begin = thread_seconds();
  const Solution s = solve_tier(c, Tier::tehd, control);
  Full full{s.verdict.good(), {}, thread_seconds() - begin, s.cost.factorizations};
  if (!full.good) return full;
  const Friction f = friction_of(s.model, s.film);
  full.scalars = {f.viscous + f.asperity, s.film.least.h};
  return full;
}

/// The truth carried to the limit of fine grids, from 400 x 50 and 800 x 100 cells.
Scalars limit_of(const Full& usual, const Full& truth) {
  const double gain = 1.0 / (std::pow(2.0, kLimitOrder) - 1.0);
  const auto onward = [gain](double u, double t) { return t + (t - u) * gain; };
  return {onward(usual.scalars.friction, truth.scalars.friction),
          onward(usual.scalars.h_min, truth.scalars.h_min)};
}

/// True if a value with its bars holds `truth`; also where there is no truth to hold.
bool holds(const Result& r, const char* name, double truth) {
  for (const Quantity& q : r.quantities) {
    if (q.name == name) return !(std::abs(q.value - truth) > q.error());
  }
  return false;
}

AutoAnswer answer(Case c, double tolerance, const Scalars& truth, const Scalars& limit,
                  const SolveControl& control) {
  c.model.tier = Tier::automatic;
  c.model.tolerance = tolerance;
  const double begin = thread_seconds();
  const Result r = fidelity::solve_auto(c, control);
  AutoAnswer a;
  a.seconds = thread_seconds() - begin;
  a.tolerance = tolerance;
  a.converged = r.verdict.good();
  a.factorizations = r.cost.factorizations;
  a.off_friction = r.value("friction_torque") / truth.friction - 1.0;
  a.off_h_min = r.value("h_min") / truth.h_min - 1.0;
  a.holds_limit = holds(r, "friction_torque", limit.friction) && holds(r, "h_min", limit.h_min);
  if (r.choice) {
    a.met = r.choice->met;
    a.bar_friction = r.choice->bar_friction;
    a.bar_h_min = r.choice->bar_h_min;
  }
  a.chosen = fmt::format("{} {}x{}", to_string(r.tier), r.grid[0], r.grid[1]);
  return a;
}

AutoTrial trial(int seed, const std::vector<double>& tolerances, const SolveControl& control) {
  const Case c = random_case(static_cast<std::uint64_t>(seed));
  AutoTrial t;
  t.seed = seed;
  const Full usual = solve_full(c, {400, 50}, control);
  if (!usual.good) return t;  // nor would the truth: a refusal costs more than a solution
  const Full truth = solve_full(c, {800, 100}, control);
  t.truth_converged = truth.good;
  if (!truth.good) return t;
  t.truth_seconds = truth.seconds;
  t.usual_seconds = usual.seconds;
  t.truth_factorizations = truth.factorizations;
  t.usual_friction = usual.scalars.friction / truth.scalars.friction - 1.0;
  t.usual_h_min = usual.scalars.h_min / truth.scalars.h_min - 1.0;
  for (const double tolerance : tolerances) {
    t.answers.push_back(answer(c, tolerance, truth.scalars, limit_of(usual, truth), control));
  }
  return t;
}

double median(std::vector<double> x) {
  if (x.empty()) return NAN;
  std::nth_element(x.begin(), x.begin() + static_cast<long>(x.size() / 2), x.end());
  return x[x.size() / 2];
}

/// Cost of auto over that of the truth: its mean, turned over, is no sum that one hard case rules.
double tamed(const AutoTrial& t, const AutoAnswer& a) { return a.seconds / t.truth_seconds; }

bool stopped(const std::atomic<bool>* stop) { return stop != nullptr && stop->load(); }

}  // namespace

bool AutoAnswer::within() const {
  return converged && std::abs(off_friction) <= tolerance && std::abs(off_h_min) <= tolerance;
}

std::vector<AutoTrial> judge_auto(const AutoStudy& study) {
  std::vector<AutoTrial> trials;
  std::mutex gate;
  SolveControl control;
  control.stop = study.stop;
  parallel_for(study.cases, study.threads, [&](int k) {
    if (stopped(study.stop)) return;
    AutoTrial t = trial(study.first_seed + k, study.tolerances, control);
    if (stopped(study.stop)) return;  // half a trial is none
    const std::lock_guard<std::mutex> lock(gate);
    trials.push_back(std::move(t));
    if (study.told) study.told(static_cast<int>(trials.size()), study.cases);
  });
  std::sort(trials.begin(), trials.end(),
            [](const AutoTrial& a, const AutoTrial& b) { return a.seed < b.seed; });
  return trials;
}

std::vector<AutoSummary> summarize(const std::vector<AutoTrial>& trials) {
  std::vector<AutoSummary> list;
  for (const AutoTrial& t : trials) {
    for (std::size_t k = list.size(); k < t.answers.size(); ++k) {
      list.push_back({});
      list.back().tolerance = t.answers[k].tolerance;
    }
  }
  for (std::size_t k = 0; k < list.size(); ++k) {
    AutoSummary& s = list[k];
    double truth = 0.0;
    double usual = 0.0;
    int met_within = 0;
    std::vector<double> seconds, to_usual, to_truth;
    for (const AutoTrial& t : trials) {
      if (!t.truth_converged) continue;
      const AutoAnswer& a = t.answers[k];
      ++s.trials;
      s.within += a.within();
      s.met += a.met;
      met_within += a.met && a.within();
      s.holds_limit += a.holds_limit;
      s.mean_tamed += tamed(t, a);
      s.mean_seconds += a.seconds;
      truth += t.truth_seconds;
      usual += t.usual_seconds;
      seconds.push_back(a.seconds);
      to_usual.push_back(t.usual_seconds / a.seconds);
      to_truth.push_back(t.truth_seconds / a.seconds);
    }
    s.met_within = s.met > 0.0 ? met_within / s.met : NAN;
    s.cheaper_usual = usual / s.mean_seconds;
    s.cheaper_truth = truth / s.mean_seconds;
    s.median_seconds = median(seconds);
    s.median_usual = median(to_usual);
    s.median_truth = median(to_truth);
    s.holds_limit /= s.trials;
    s.mean_tamed = s.trials / s.mean_tamed;
    s.within /= s.trials;
    s.met /= s.trials;
    s.mean_seconds /= s.trials;
  }
  return list;
}

void write_auto_honesty(std::ostream& out, const std::vector<AutoTrial>& trials) {
  const auto left_out = std::count_if(trials.begin(), trials.end(),
                                      [](const AutoTrial& t) { return !t.truth_converged; });
  out << fmt::format(
      "tier auto on {} random bearings ({} without a converged truth left out)\n"
      "cheaper: cost of full TEHD over that of auto; sums of all, mean share, median\n\n"
      "tolerance  cases  within  claimed  of these within  limit held  mean [ms]  median [ms]  "
      "cheaper than 400x50       than 800x100\n",
      trials.size(), left_out);
  for (const AutoSummary& s : summarize(trials)) {
    out << fmt::format(
        "{:>8.2g}%  {:>5}  {:>5.1f}%  {:>6.1f}%  {:>14.1f}%  {:>9.1f}%  {:>9.1f}  {:>11.1f}  "
        "{:>9.1f} ({:>6.1f})  {:>7.1f} {:>5.1f} ({:>6.1f})\n",
        100.0 * s.tolerance, s.trials, 100.0 * s.within, 100.0 * s.met, 100.0 * s.met_within,
        100.0 * s.holds_limit, 1e3 * s.mean_seconds, 1e3 * s.median_seconds, s.cheaper_usual,
        s.median_usual, s.cheaper_truth, s.mean_tamed, s.median_truth);
  }
  out << "\nmisses: seed, tolerance, distance to the truth and claimed bar (friction, film)\n";
  for (const AutoTrial& t : trials) {
    for (const AutoAnswer& a : t.answers) {
      if (a.within()) continue;
      out << fmt::format("{:>6}  {:>4.2g}%  {:>+8.2f}% {:>+8.2f}%  {:>7.2f}% {:>7.2f}%  {}  {}\n",
                         t.seed, 100.0 * a.tolerance, 100.0 * a.off_friction, 100.0 * a.off_h_min,
                         100.0 * a.bar_friction, 100.0 * a.bar_h_min,
                         a.met ? "claimed" : "not claimed", a.chosen);
    }
  }
}

}  // namespace shellback::proof
