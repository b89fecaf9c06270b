#include <algorithm>
#include <cmath>

#include "bearing/bearing.hpp"
#include "bearing/film/follow.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/cycle_lumped.hpp"
#include "bearing/over_time/cycle_search.hpp"
#include "bearing/over_time/kept_run.hpp"
#include "bearing/steady/nested.hpp"
#include "bearing/steady/solve.hpp"
#include "core/contract.hpp"
#include "core/stopwatch.hpp"

namespace shellback::bearing {
namespace {

/// From what is kept of it, or by `begin`.
template <class Begin>
void begin_or_take_up(CycleSearch& search, const SolveControl& control, const Begin& begin) {
  Tape* tape = control.kept != nullptr ? control.kept->under_way() : nullptr;
  if (tape == nullptr) return begin();
  search.begin(*tape);
  control.kept->taken_up();
}

/// The lumped tier, on the case's own grid.
CycleResult at_one_temperature(const Case& c, const SolveControl& control) {
  CycleSearch search(c, Tier::lumped, control);
  begin_or_take_up(search, control, [&] { search.begin(mean_supply_temperature(c)); });
  Verdict v = settle_lumped_cycle(search, c);
  if (v.good()) v = search.judge_orbit();
  CycleResult r = search.result();
  r.verdict = v;
  return r;
}

/// Whether walls that a whole cycle warms are part of the periodic state.
bool walls_settle(const Case& c, Tier tier) {
  return physics_of(c, tier).film_energy && c.cycle->repeats();
}

constexpr std::array kFewestCells{24, 4};  ///< of a grid on which walls settle first
constexpr double kLonger = 2.0;            ///< the steps there, as the cells are

/// Levels on which walls settle: what they need is many cycles, neither many cells nor short steps
/// (the error of a step goes with its cube). The case itself is the last.
std::vector<Case> levels_of(const Case& c) {
  auto grids = grid_ladder(c);
  const std::array half{c.model.grid[0] / 2, (c.model.grid[1] + 1) / 2};
  const bool enough = half[0] >= kFewestCells[0] && half[1] >= kFewestCells[1];
  if (grids.size() == 1 && enough && holds_supplies(c, half)) grids.insert(grids.begin(), half);
  std::vector<Case> levels(grids.size(), c);
  for (std::size_t k = 0; k + 1 < grids.size(); ++k) {
    levels[k].model.grid = grids[k];
    levels[k].model.tolerance *= kLonger * kLonger * kLonger;
    if (levels[k].cycle->step) *levels[k].cycle->step *= kLonger;
  }
  return levels;
}

/// What a tape has kept of it.
CycleStart kept_start(const Case& c, Tier tier, Tape tape) {
  CycleStart start{make_bearing(c, physics_of(c, tier), c.model.grid), {}, {}, {}, 0, false};
  tape(start);
  return start;
}

Tape::Content kept(CycleStart start) {
  Tape tape;
  tape(start);
  return tape.content();
}

/// Each level begins where the one before has ended, the first from `start`; none: from rest. A
/// coarse one that fails is left out.
std::unique_ptr<CycleSearch> on_levels(const std::vector<Case>& levels, Tier tier,
                                       std::optional<CycleStart> start, const SolveControl& control,
                                       Cost& cost) {
  int k = 0;
  if (control.kept != nullptr) {
    k = control.kept->grid();
    cost = control.kept->cost();
    const int coarser = control.kept->coarser_grid();
    if (coarser >= 0) start = kept_start(levels[coarser], tier, control.kept->coarser());
  }
  for (;; ++k) {
    const bool last = k + 1 == static_cast<int>(levels.size());
    if (control.kept != nullptr) control.kept->on_grid(k, cost);
    auto search = std::make_unique<CycleSearch>(levels[k], tier, control);
    begin_or_take_up(*search, control, [&] {
      if (start) {
        search->begin(*start);
      } else {
        search->begin(equivalent_temperature(levels[k]));
      }
    });
    const Verdict& v = search->search(!last);
    if (last && v.good()) search->judge_orbit();
    cost.factorizations += search->cost().factorizations;
    cost.newton_iterations += search->cost().newton_iterations;
    if (last || v.status == Status::interrupted) return search;
    if (!v.good()) continue;
    start = search->start();
    if (control.kept != nullptr) control.kept->coarser(k, kept(*start));
  }
}

}  // namespace

std::unique_ptr<CycleSearch> search_cycle(const Case& c, Tier tier, const SolveControl& control,
                                          Cost& cost, const CycleStart* near) {
  EXPECTS(c.cycle.has_value() && tier != Tier::lumped);
  if (near != nullptr) return on_levels({c}, tier, *near, control, cost);
  return on_levels(walls_settle(c, tier) ? levels_of(c) : std::vector{c}, tier, {}, control, cost);
}

namespace {

SolvedCycle search_on_grid(const Case& c, Tier tier, const SolveControl& control,
                           const CycleStart* near) {
  if (tier == Tier::lumped) return {at_one_temperature(c, control), {}};
  Cost cost;
  const auto search = search_cycle(c, tier, control, cost, near);
  SolvedCycle solved{search->result(), {}};
  solved.result.cost = cost;
  if (solved.result.verdict.good() && walls_settle(c, tier)) solved.start = search->start();
  return solved;
}

/// A coarser grid, or one finer than the coarsest.
std::array<int, 2> another_grid(const Case& c, std::array<int, 2> grid) {
  const auto coarser = halved(grid);
  if (coarser && holds_supplies(c, *coarser)) return *coarser;
  return {2 * grid[0], std::min(2 * grid[1] - 1, most_axial_cells(c))};
}

/// Whether a journal heavier by the tenth within which two grids are to agree departs from its
/// orbit on another grid. `interrupted`: its verdict, if it was.
ending::UnstableOrbit::Elsewhere on_other_grid(Case c, Tier tier, const SolveControl& control,
                                               std::array<int, 2> grid, Cost& cost,
                                               Verdict& interrupted) {
  using Elsewhere = ending::UnstableOrbit::Elsewhere;
  c.model.grid = grid;
  c.cycle->journal_mass *= 1.0 + kAgree;
  CycleResult r;
  try {
    r = search_on_grid(c, tier, control, nullptr).result;
  } catch (const InputError&) {  // of the grid, which nobody gave: it does not hold the supplies
    return Elsewhere::no_orbit;
  }
  cost.factorizations += r.cost.factorizations;
  cost.newton_iterations += r.cost.newton_iterations;
  if (r.verdict.status == Status::interrupted) interrupted = r.verdict;
  if (r.verdict.as<ending::UnstableOrbit>() != nullptr) return Elsewhere::departs;
  if (!r.verdict.good()) return Elsewhere::no_orbit;
  const bool judged = std::none_of(r.warnings.begin(), r.warnings.end(), [](const Note& n) {
    const auto* plain = std::get_if<note::Plain>(&n);
    return plain != nullptr && *plain == note::Plain::orbit_not_judged;
  });
  return judged ? Elsewhere::keeps_to_it : Elsewhere::not_judged;
}

/// That no journal keeps to its orbit, where two grids agree on it; else not resolved. What may
/// cost so much and no more is not searched twice.
Verdict on_two_grids(ending::UnstableOrbit orbit, const Case& c, Tier tier, SolveControl control,
                     Cost& cost) {
  if (std::isfinite(control.most_work)) return {Status::iteration_limit, orbit};
  control.kept = nullptr;
  orbit.other = another_grid(c, orbit.grid);
  Verdict interrupted;
  orbit.elsewhere = on_other_grid(c, tier, control, orbit.other, cost, interrupted);
  if (!interrupted.good()) return interrupted;
  const bool departs = orbit.elsewhere == ending::UnstableOrbit::Elsewhere::departs;
  return {departs ? Status::no_steady_state : Status::iteration_limit, orbit};
}

}  // namespace

CycleResult solve_cycle(const Case& c, Tier tier, const SolveControl& control) {
  return solve_cycle_from(nullptr, c, tier, control).result;
}

SolvedCycle solve_cycle_from(const CycleStart* near, const Case& c, Tier tier,
                             const SolveControl& control) {
  if (!c.cycle) {
    throw InputError("load_cycle", "the case has none; take bearing::solve for a standing load");
  }
  if (tier == Tier::estimate || tier == Tier::automatic) {
    throw InputError("model.tier", std::string("the tier ") + to_string(tier) +
                                       " solves no film over a cycle by itself; take isothermal, "
                                       "lumped, thd or tehd, or fidelity::solve_cycle_case");
  }
  if (control.kept != nullptr) {
    if (auto ended = control.kept->next_ended()) {
      SolvedCycle solved{std::move(ended->result), {}};
      if (ended->start) solved.start = kept_start(c, tier, Tape(*std::move(ended->start)));
      return solved;
    }
  }
  const Stopwatch watch;
  SolvedCycle solved = search_on_grid(c, tier, control, near);
  CycleResult& r = solved.result;
  if (const auto* orbit = r.verdict.as<ending::UnstableOrbit>()) {
    r.verdict = on_two_grids(*orbit, c, tier, control, r.cost);
  }
  r.cost.wall_s = watch.seconds();
  if (control.kept == nullptr) return solved;
  r.cost.wall_s += control.kept->spent_before();
  if (r.verdict.status != Status::interrupted) {
    control.kept->end({r, solved.start ? std::optional(kept(*solved.start)) : std::nullopt});
  }
  return solved;
}

}  // namespace shellback::bearing
