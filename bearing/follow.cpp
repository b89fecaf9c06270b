#include "bearing/follow.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bearing/newton.hpp"
#include "bearing/round_off.hpp"

namespace shellback::bearing {
namespace {

constexpr double kFirstStep = 0.5;       ///< of the path: load times 1.65 [-]
constexpr double kLongestStep = 1.5;     ///< [-]
constexpr double kShortestStep = 0.005;  ///< load known to half a per cent: a twentieth of what two
                                         ///< grids may differ in a limit [-]
/// Factors of the step where a state was found and where it was not. With 2 and 1/2 the branch of
/// the hot KS bearing is lost 0.9 % below where it is with these.
constexpr double kLongerStep = 1.6;
constexpr double kShorterStep = 0.4;
constexpr std::array kCloser{0.003, 0.01, 0.03};  ///< of the gap: a little closer [-]

/// What a state is, without what follows from it.
struct Reached {
  FilmEquilibrium film;
  HeatState heat;
};

/// Rigid surfaces and Barus oil, whose reduced pressure has a bound.
bool has_bound(const Solution& s) {
  return !s.model.physics.elastic && std::holds_alternative<rheology::Barus>(s.model.oil.pressure);
}

/// True if a little closer, in the load's direction, the reduced pressure exceeds its bound.
bool unbounded_closer(const Solution& s, const SolveControl& control) {
  OperatingPoint held = s.point;
  held.load.unknowns = 0;
  held.load.path.reset();
  EquilibriumCost cost;
  cost.most_work = 1e3 * s.model.domain.grid.cells();
  for (const double part : kCloser) {
    FilmEquilibrium f = s.film;
    const fluid::Wrench& force = held.load.force;
    for (int k = 0; k < 2; ++k) {
      f.position.q[k] -= part * room(s.model, f) * force[k] / std::hypot(force[0], force[1]);
    }
    const Verdict v = newton(s.model, held, s.heat.thermal_deformation, {}, f, cost, control.stop);
    if (v.status == Status::no_steady_state && !is_closed(s.model, f)) return true;
  }
  return false;
}

class LoadBranch {
 public:
  LoadBranch(Solution& s, const Corrector& correct, const SolveControl& control)
      : s_(s), correct_(correct), control_(control) {}

  Branch run(double begun);

 private:
  /// The row of the path for the next step from the last two states.
  [[nodiscard]] PathRow next_row(double length) const;
  void keep();
  void restore();
  /// Solves the whole load from the last state.
  [[nodiscard]] bool arrive();
  [[nodiscard]] Branch ended(BranchEnd end) const;

  Solution& s_;
  const Corrector& correct_;
  const SolveControl& control_;
  Reached last_, before_;
  bool secant_ = false;  ///< `before_` is known
  double most_ = 0.0;    ///< highest ln of the load's factor [-]
  double h_min_ = 0.0;   ///< there [m]
  Verdict failure_;
};

PathRow LoadBranch::next_row(double length) const {
  PathRow row;
  const FilmEquilibrium& now = last_.film;
  // Surfaces in each other give as they overlap: what is left between their summits is no measure.
  const double gap = std::hypot(now.least.h, s_.model.domain.rough.sigma);
  for (int k = 0; k < 4; ++k) {
    row.unit[k] = k < 2 ? gap : gap / (0.5 * s_.model.domain.grid.width);
  }
  row.from = now.position;
  row.from_load = now.ln_load;
  row.length = length;
  if (!secant_) return row;
  double norm = std::pow(now.ln_load - before_.film.ln_load, 2);
  for (int k = 0; k < s_.point.load.unknowns; ++k) {
    row.along[k] = (now.position.q[k] - before_.film.position.q[k]) / row.unit[k];
    norm += row.along[k] * row.along[k];
  }
  norm = std::sqrt(norm);
  row.along_load = (now.ln_load - before_.film.ln_load) / norm;
  for (double& a : row.along) a /= norm;
  return row;
}

void LoadBranch::keep() {
  before_ = std::move(last_);
  last_ = {s_.film, s_.heat};
  if (last_.film.ln_load > most_) {
    most_ = last_.film.ln_load;
    h_min_ = s_.film.least.h;
  }
}

void LoadBranch::restore() {
  s_.film = last_.film;
  s_.heat = last_.heat;
}

bool LoadBranch::arrive() {
  s_.point.load.path.reset();
  s_.film.ln_load = 0.0;
  const Verdict v = correct_(s_, Accuracy::result);
  if (v.good()) return true;
  failure_ = v;
  restore();
  return false;
}

Branch LoadBranch::ended(BranchEnd end) const {
  return {Raised::load, end, std::exp(most_), h_min_, failure_};
}

Branch LoadBranch::run(double begun) {
  s_.film.ln_load = most_ = std::log(begun);
  h_min_ = s_.film.least.h;
  last_ = {s_.film, s_.heat};
  double step = kFirstStep;
  for (int k = 0; k < kMostIterations && step > kShortestStep; ++k) {
    s_.point.load.path = next_row(step);
    const Verdict v = correct_(s_, Accuracy::way_point);
    if (v.status == Status::interrupted || stopped(control_)) {
      failure_ = {Status::interrupted};
      return ended(BranchEnd::interrupted);
    }
    if (!v.good()) {
      failure_ = v;
      restore();
      step *= kShorterStep;
      continue;
    }
    if (s_.film.ln_load >= 0.0) {
      if (arrive()) return ended(BranchEnd::reached);
      step *= kShorterStep;
      continue;
    }
    keep();
    if (thinner_than_a_molecule(s_.model, s_.film)) return ended(BranchEnd::molecule);
    const bool falls = secant_ && last_.film.ln_load < before_.film.ln_load;
    if (falls && last_.film.ln_load < most_ - kShortestStep) return ended(BranchEnd::turned);
    secant_ = true;
    step = std::min(kLongerStep * step, kLongestStep);
  }
  restore();
  if (failure_.good()) failure_ = {Status::iteration_limit, ending::Plain::endless_branch};
  const bool bound = has_bound(s_) && unbounded_closer(s_, control_);
  return ended(bound ? BranchEnd::unbounded : BranchEnd::lost);
}

}  // namespace

Branch follow_load(Solution& s, double begun, const Corrector& correct,
                   const SolveControl& control) {
  const LoadTarget goal = s.point.load;
  const Branch branch = LoadBranch(s, correct, control).run(begun);
  s.point.load = goal;
  if (branch.end != BranchEnd::reached) s.film.ln_load = 0.0;
  return branch;
}

Part::Part(OperatingPoint& point, Raised raised)
    : point_(point), raised_(raised), force_(point.load.force), speed_(point.scene.speed) {}

void Part::take(double part) {
  if (raised_ == Raised::load) {
    for (int k = 0; k < 4; ++k) point_.load.force[k] = part * force_[k];
  } else {
    point_.scene.speed = part * speed_;
  }
}

Branch follow_parts(Solution& s, Raised raised, double begun, const Corrector& correct,
                    const SolveControl& control) {
  Part of(s.point, raised);
  Branch branch{raised, BranchEnd::lost, begun, s.film.least.h, {}};
  Reached last{s.film, s.heat};
  double step = kFirstStep;
  for (int k = 0; k < kMostIterations && step > kShortestStep; ++k) {
    const double next = begun < 1.0 ? std::min(1.0, branch.carried * std::exp(step))
                                    : std::max(1.0, branch.carried * std::exp(-step));
    of.take(next);
    const Verdict v = correct(s, next == 1.0 ? Accuracy::result : Accuracy::way_point);
    if (v.status == Status::interrupted || stopped(control)) {
      branch.end = BranchEnd::interrupted;
      branch.last = {Status::interrupted};
      break;
    }
    if (v.good()) {
      branch.carried = next;
      branch.h_min = s.film.least.h;
      last = {s.film, s.heat};
      step = std::min(kLongerStep * step, kLongestStep);
      if (next == 1.0) branch.end = BranchEnd::reached;
      if (next == 1.0) break;
    } else {
      branch.last = v;
      s.film = last.film;
      s.heat = last.heat;
      step *= kShorterStep;
    }
  }
  of.take(1.0);
  return branch;
}

std::optional<Branch> follow_from(Solution& s, Raised raised, std::span<const double> parts,
                                  const std::function<Verdict()>& start, const Corrector& correct,
                                  const SolveControl& control) {
  Part part(s.point, raised);
  for (const double begun : parts) {
    part.take(begun);
    const Verdict v = start();
    part.take(1.0);
    if (v.status == Status::interrupted) return Branch{raised, BranchEnd::interrupted, 0.0, 0.0, v};
    if (!v.good()) continue;
    const bool by_path = raised == Raised::load && begun < 1.0;
    return by_path ? follow_load(s, begun, correct, control)
                   : follow_parts(s, raised, begun, correct, control);
  }
  return std::nullopt;
}

std::optional<Branch> follow_loads(Solution& s, const std::function<Verdict()>& start,
                                   const Corrector& correct, const SolveControl& control) {
  std::optional<Branch> light = follow_from(s, Raised::load, kLight, start, correct, control);
  const bool open = !light || light->end == BranchEnd::turned || light->end == BranchEnd::lost;
  if (!open || s.cost.spent()) return light;
  const Reached last{s.film, s.heat};
  std::optional<Branch> heavy = follow_from(s, Raised::load, kHeavy, start, correct, control);
  const bool answers =
      heavy && (heavy->end == BranchEnd::reached || heavy->end == BranchEnd::interrupted);
  if (answers) return heavy;
  s.film = last.film;
  s.heat = last.heat;
  return light;
}

bool has_own_limit(const Solution& s) {
  const FilmGrid& g = s.model.domain.grid;
  return !s.limits.empty() && s.limits.back().grid == std::array<int, 2>{g.nt, g.full_nz()};
}

void note_limit(Solution& s, const Branch& branch, bool proven) {
  const FilmGrid& g = s.model.domain.grid;
  s.limits.push_back({{g.nt, g.full_nz()},
                      branch.raised == Raised::speed,
                      branch.carried,
                      proven,
                      branch.end == BranchEnd::unbounded || branch.end == BranchEnd::molecule});
}

}  // namespace shellback::bearing
