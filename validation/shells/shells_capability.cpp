#include "validation/shells/shells_capability.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/running_in.hpp"

namespace shellback::validation {
namespace {

using bearing::Case;
using bearing::CycleResult;
using bearing::Profile;
using bearing::Tier;

double lining_limit(const Case& c) { return c.shell->layers.front().material.limit_temperature; }

/// What the cycle meets first: no periodic state, a lining too hot, a film too thin.
ShellLimit limit_of(const Case& c, const CycleResult& r) {
  if (!r.verdict.good()) return ShellLimit::state;
  const double T = bearing::value_of(r, "T_shell_max");
  if (std::isfinite(T) && T > lining_limit(c)) return ShellLimit::lining;
  return bearing::value_of(r, "h_min") < least_film(c) ? ShellLimit::film : ShellLimit::none;
}

LoadTried tried(double factor, const CycleResult& r) {
  if (!r.verdict.good()) return {factor, NAN, NAN};
  return {factor, bearing::value_of(r, "h_min"), bearing::value_of(r, "T_shell_max")};
}

/// The search for one capability.
class Search {
 public:
  Search(const ShellsPlan& plan, const StudyCrew& crew, int task, const Profile* wear,
         Capability& found)
      : plan_(plan),
        crew_(crew),
        wear_(wear),
        found_(found),
        control_(crew.control(task, subject(plan.coarse, 1.0))) {}

  void run() {
    for (double f = 1.0; f > 0.0 && !crew_.stopped(); f = next_load(plan_, found_, met(found_))) {
      try_load(f);
    }
    if (found_.good.factor > 0.0 && found_.bad.factor > 0.0) add_bar();
  }

 private:
  Case subject(const std::array<int, 2>& grid, double factor) const {
    Case c = shell_case(found_.shell, found_.tier, {grid, found_.rpm, factor});
    if (wear_ != nullptr) c.bearing.shape = *wear_;
    return c;
  }

  CycleResult solved(const Case& c) const {
    CycleResult r = bearing::solve_cycle(c, found_.tier, control_);
    StudyCrew::keep(control_, r.verdict);
    return r;
  }

  /// Solves the load `factor` and notes it as borne or not.
  void try_load(double factor) {
    const Case c = subject(plan_.coarse, factor);
    const CycleResult r = solved(c);
    if (crew_.stopped()) return;
    const ShellLimit limit = limit_of(c, r);
    if (limit != ShellLimit::none) {
      found_.bad = tried(factor, r);
      found_.limit = limit;
      found_.reason = app::reason_of(r.verdict);
      return;
    }
    found_.good = tried(factor, r);
    found_.peak = 0.0;
    for (const auto& i : r.instants) {
      found_.peak = std::max(found_.peak, std::hypot(i.load_x, i.load_y));
    }
  }

  double met(const ShellLimit limit, const LoadTried& good, const LoadTried& bad) const {
    const Case c = subject(plan_.coarse, 1.0);
    return load_met(limit, good, bad, least_film(c), lining_limit(c));
  }
  double met(const Capability& c) const { return met(c.limit, c.good, c.bad); }

  /// Where the limit is met between the loads that were tried. The last one may break both bounds:
  /// what is met first is at the lesser load.
  void find_met() {
    const LoadTried &good = found_.good, &bad = found_.bad;
    const bool hot =
        found_.limit == ShellLimit::lining && bad.h < least_film(subject(plan_.coarse, 1.0));
    if (hot && met(ShellLimit::film, good, bad) < met(found_.limit, good, bad)) {
      found_.limit = ShellLimit::film;
    }
    found_.met = met(found_.limit, good, bad);
  }

  /// Where the limit is met; what the load solved there moves it by, and what it is moved by on two
  /// thirds of the cells. Edges and mouths leave an error of first order: what is missing on this
  /// grid is twice the difference.
  void add_bar() {
    constexpr double kCells = 1.5, kBar = 2.0;  // h/(1.5 h - h)
    find_met();
    const double straight = found_.met;
    if (!std::isfinite(straight)) return;
    const ShellLimit limit = found_.limit;  // of the two loads, far enough apart for a slope
    const LoadTried good = found_.good, bad = found_.bad;
    try_load(straight);
    if (crew_.stopped()) return;
    find_met();
    if (!std::isfinite(found_.met)) return;
    std::array<int, 2> grid = plan_.coarse;
    for (int& n : grid) n = std::max(3, static_cast<int>(std::lround(n / kCells)));
    const auto coarser = [&](const LoadTried& at) {
      if (crew_.stopped()) return LoadTried{};
      return tried(at.factor, solved(subject(grid, at.factor)));
    };
    const LoadTried coarse_good = coarser(good), coarse_bad = coarser(bad);
    found_.met_error = kBar * std::abs(met(limit, coarse_good, coarse_bad) - straight) +
                       std::abs(found_.met - straight);
  }

  const ShellsPlan& plan_;
  const StudyCrew& crew_;
  const Profile* wear_;
  Capability& found_;
  bearing::SolveControl control_;
};

}  // namespace

const char* to_string(ShellLimit limit) {
  switch (limit) {
    case ShellLimit::lining:
      return "lining too hot";
    case ShellLimit::film:
      return "film too thin";
    case ShellLimit::state:
      return "no periodic state found";
    case ShellLimit::none:
      break;
  }
  return "none met";
}

double load_met(ShellLimit limit, const LoadTried& a, const LoadTried& b, double h_least,
                double T_most) {
  const auto beyond = [&](const LoadTried& at) {
    return limit == ShellLimit::film     ? at.h - h_least
           : limit == ShellLimit::lining ? T_most - at.T
                                         : NAN;
  };
  const double m = beyond(a), n = beyond(b);
  if (!(a.factor > 0.0) || !(b.factor > 0.0) || !std::isfinite(m - n) || m == n) return NAN;
  return a.factor * std::pow(b.factor / a.factor, m / (m - n));
}

double next_load(const ShellsPlan& plan, const Capability& c, double met) {
  const double good = c.good.factor, bad = c.bad.factor;
  const auto [least, most] = plan.factors;
  const double away = good == 1.0 || bad == 1.0 ? std::numbers::sqrt2 : 2.0;
  if (bad == 0.0) return good < most ? std::min(away * good, most) : 0.0;
  if (good == 0.0) return bad > least ? std::max(bad / away, least) : 0.0;
  const double between = bad / good;
  if (between <= plan.width) return 0.0;
  if (!std::isfinite(met)) return std::sqrt(good * bad);
  // Half of what is wanted to the other side of the root than the nearer end: of two such loads one
  // is borne, one not. Never nearer to an end than an eighth: curves do not hold it up.
  const double half = std::sqrt(plan.width);
  const double beside = met / good < bad / met ? met * half : met / half;
  const double eighth = std::pow(between, 0.125);
  return std::clamp(beside, good * eighth, bad / eighth);
}

RunInShell run_shell_in(const ShellsPlan& plan, const StudyCrew& crew, int task, int shell,
                        Tier tier) {
  const Case c = shell_case(shell, tier, {plan.coarse});
  const bearing::RunningInRun run =
      bearing::run_in(c, tier, crew.control(task, c, app::RunOf::running_in));
  RunInShell found;
  found.tried = !crew.stopped();
  found.verdict = run.verdict;
  if (run.states.empty()) return found;
  found.begin = run.states.front();
  found.end = run.states.back();
  found.wear = bearing::wear_table(run.grid, run.wear);
  return found;
}

void find_capability(const ShellsPlan& plan, const StudyCrew& crew, int task, const Profile* wear,
                     Capability& c) {
  Search(plan, crew, task, wear, c).run();
  c.tried = !crew.stopped();
}

}  // namespace shellback::validation
