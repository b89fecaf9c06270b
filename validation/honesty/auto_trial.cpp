#include "validation/honesty/auto_trial.hpp"

#include <fmt/format.h>
#include <time.h>

#include <cmath>

#include "app/words/ending_words.hpp"
#include "bearing/steady/solve.hpp"
#include "fidelity/auto_tier.hpp"
#include "validation/honesty/population.hpp"

namespace shellback::validation {
namespace {

using namespace bearing;

constexpr int kTruthNodes = 7;  ///< across the film [-]
/// Below this tolerance auto refines to the truth's own grid and costs what the truth does: such
/// answers come after it, so that a budget that does not reach them still judges the others [-].
constexpr double kAsDearAsTruth = 0.005;

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
  Verdict verdict;
  Scalars scalars;
  double seconds = 0.0;
  int factorizations = 0;
};

Full solve_full(Case c, std::array<int, 2> grid, const SolveControl& control) {
  c.model.grid = grid;
  c.model.film_nodes = kTruthNodes;
  const double begin = thread_seconds();
  const Solution s = solve_tier(c, Tier::tehd, control);
  Full full{s.verdict, {}, thread_seconds() - begin, s.cost.factorizations};
  if (!full.verdict.good()) return full;
  const Friction f = friction_of(s.model, s.point, s.film);
  full.scalars = {f.torque(), s.film.least.h};
  return full;
}

/// The truth carried to the limit of fine grids, from 400 x 50 and 800 x 100 cells.
Scalars limit_of(const Full& usual, const Full& truth) {
  const double gain = 1.0 / (std::pow(2.0, kLimitOrder) - 1.0);
  const auto onward = [gain](double u, double t) { return t + (t - u) * gain; };
  return {onward(usual.scalars.friction, truth.scalars.friction),
          onward(usual.scalars.h_min, truth.scalars.h_min)};
}

/// The whole bar of a quantity; not-a-number if there is none.
double bar_of(const Result& r, const char* name) {
  for (const Quantity& q : r.quantities) {
    if (q.name == name) return q.error();
  }
  return NAN;
}

AutoAnswer answer(Case c, double tolerance, const SolveControl& control) {
  c.model.tier = Tier::automatic;
  c.model.tolerance = tolerance;
  const double begin = thread_seconds();
  const Result r = fidelity::solve_auto(c, control);
  AutoAnswer a;
  a.seconds = thread_seconds() - begin;
  a.tolerance = tolerance;
  a.converged = r.verdict.good();
  a.factorizations = r.cost.factorizations;
  if (!a.converged) return a;
  a.friction = r.value("friction_torque");
  a.h_min = r.value("h_min");
  a.error_friction = bar_of(r, "friction_torque");
  a.error_h_min = bar_of(r, "h_min");
  if (r.choice) {
    a.met = r.choice->met;
    a.bar_friction = r.choice->bar_friction;
    a.bar_h_min = r.choice->bar_h_min;
  }
  a.tier = to_string(r.tier);
  a.chosen = fmt::format("{} {}x{}", a.tier, r.grid[0], r.grid[1]);
  return a;
}

/// An unknown bar holds nothing.
bool holds(const AutoAnswer& a, const Scalars& s) {
  return std::abs(a.friction - s.friction) <= a.error_friction &&
         std::abs(a.h_min - s.h_min) <= a.error_h_min;
}

void compare(const Scalars& truth, const Scalars& limit, AutoAnswer& a) {
  if (!a.converged) return;
  a.off_friction = a.friction / truth.friction - 1.0;
  a.off_h_min = a.h_min / truth.h_min - 1.0;
  a.holds_truth = holds(a, truth);
  a.holds_limit = holds(a, limit);
}

/// Full TEHD on both grids, and their costs; nothing of it if one of them is refused.
struct Truth {
  Scalars truth;
  Scalars limit;
};
Truth find_truth(const Case& c, const SolveControl& control, AutoTrial& t) {
  const Full usual = solve_full(c, {400, 50}, control);
  t.why = app::reason_of(usual.verdict);
  if (!usual.verdict.good())
    return {};  // nor would the truth: a refusal costs more than a solution
  const Full truth = solve_full(c, {800, 100}, control);
  t.why = app::reason_of(truth.verdict);
  t.truth_converged = truth.verdict.good();
  if (!t.truth_converged) return {};
  t.truth_seconds = truth.seconds;
  t.usual_seconds = usual.seconds;
  t.truth_factorizations = truth.factorizations;
  t.usual_friction = usual.scalars.friction / truth.scalars.friction - 1.0;
  t.usual_h_min = usual.scalars.h_min / truth.scalars.h_min - 1.0;
  return {truth.scalars, limit_of(usual, truth)};
}

}  // namespace

AutoTrial try_auto(int seed, const std::vector<double>& tolerances, const std::atomic<bool>* stop) {
  const Case c = random_case(static_cast<std::uint64_t>(seed));
  const auto stopped = [stop] { return stop != nullptr && stop->load(); };
  SolveControl control;
  control.stop = stop;
  AutoTrial t;
  t.seed = seed;
  const auto answer_from = [&](double low, double high) {
    for (const double tolerance : tolerances) {
      if (stopped() || tolerance < low || tolerance >= high) continue;
      AutoAnswer a = answer(c, tolerance, control);
      if (!stopped()) t.answers.push_back(std::move(a));  // half an answer is none
    }
  };
  answer_from(kAsDearAsTruth, INFINITY);
  Truth found;
  if (!stopped()) found = find_truth(c, control, t);
  answer_from(0.0, kAsDearAsTruth);
  t.end = stopped() ? CaseEnd::over_budget : CaseEnd::done;
  if (!t.truth_converged) return t;
  for (AutoAnswer& a : t.answers) compare(found.truth, found.limit, a);
  return t;
}

}  // namespace shellback::validation
