#include "bearing/film/follow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bearing/film/film_motion.hpp"
#include "bearing/film/newton.hpp"
#include "core/round_off.hpp"
#include "fluid/film_update.hpp"

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
/// Longest step in which a branch is seen to turn, the load between being known as well as that
/// [-].
constexpr double kTurn = 0.1;
/// Cosine of the largest angle between the steps before and after a state: 60 degrees, so that a
/// turn takes three steps and more [-].
constexpr double kBend = 0.5;
constexpr std::array kCloser{0.003, 0.01, 0.03};  ///< of the gap: a little closer [-]

/// Carries temperatures, growth, surfaces and journal of `s`, which stands at `last`, on in a
/// straight line from `before`, by `part` of the way between the two.
void carry_on(const Reached& before, const Reached& last, double part, Solution& s) {
  const auto carry = [&](const Field& from, const Field& to, Field& x) {
    if (from.size() != x.size()) return;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += part * (to[k] - from[k]);
  };
  carry(before.film.columns.T, last.film.columns.T, s.film.columns.T);
  carry(before.heat.thermal_deformation, last.heat.thermal_deformation, s.heat.thermal_deformation);
  carry(before.film.elastic, last.film.elastic, s.film.elastic);
  for (int k = 0; k < s.point.load.unknowns; ++k) {
    s.film.position.q[k] += part * (last.film.position.q[k] - before.film.position.q[k]);
  }
  s.film.ln_load += part * (last.film.ln_load - before.film.ln_load);
}

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
    const Verdict v =
        newton({s.model, held, s.heat.thermal_deformation, {}, control.stop}, f, cost);
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
  /// Change of the journal's place among its grown surfaces from the state before the last to it
  /// [m], [rad].
  [[nodiscard]] std::array<double, 4> moved() const;
  /// True if the state found lies far from the straight line on which it was looked for, or back on
  /// the way to the last one: the plane of the path (operating_point.hpp (4)) meets other parts of
  /// the branch, and other branches, too.
  [[nodiscard]] bool strayed() const;
  /// True if journal, load, temperatures and growth together go on as in the step before.
  [[nodiscard]] bool goes_on() const;
  /// Carries the state on along the secant.
  void predict(double length);
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
  double length_ = 0.0;  ///< of the last step [-]
  bool among_ = true;    ///< places are those among the surfaces, not those in space
  double most_ = 0.0;    ///< highest ln of the load's factor [-]
  double h_min_ = 0.0;   ///< there [m]
  Verdict failure_;
};

std::array<double, 4> LoadBranch::moved() const {
  const int unknowns = s_.point.load.unknowns;
  const auto grown = [](const Reached& at) {  // without what goes with the film
    Field d = at.heat.thermal_deformation;
    for (std::size_t c = 0; c < at.heat.contact_deformation.size(); ++c) {
      d[c] -= at.heat.contact_deformation[c];
    }
    return d;
  };
  std::array<double, 4> q{};
  Field change = grown(last_);
  if (among_ && !change.empty()) {
    const Field before = grown(before_);
    for (std::size_t c = 0; c < change.size(); ++c) change[c] -= before[c];
    q = motion_of(s_.model, unknowns, carrying_force(s_.model, last_.film), change);
  }
  for (int k = 0; k < unknowns; ++k) {
    q[k] += last_.film.position.q[k] - before_.film.position.q[k];
  }
  return q;
}

bool LoadBranch::strayed() const {
  if (!secant_) return false;  // there is no line yet
  const PathRow& row = *s_.point.load.path;
  double way = std::pow(s_.film.ln_load - row.from_load, 2);
  for (int k = 0; k < s_.point.load.unknowns; ++k) {
    way += std::pow((s_.film.position.q[k] - row.from.q[k]) / row.unit[k], 2);
  }
  return !(std::sqrt(way) * kBend <= row.length && goes_on());
}

bool LoadBranch::goes_on() const {
  const PathRow& row = *s_.point.load.path;
  const auto along = [](const Field& before, const Field& last, const Field& now, double unit) {
    double sum = 0.0;
    for (std::size_t k = 0; k < now.size(); ++k) sum += (now[k] - last[k]) * (last[k] - before[k]);
    return now.empty() ? 0.0 : sum / (unit * unit * static_cast<double>(now.size()));
  };
  double on = (s_.film.ln_load - last_.film.ln_load) * (last_.film.ln_load - before_.film.ln_load);
  for (int k = 0; k < s_.point.load.unknowns; ++k) {
    const double last = last_.film.position.q[k];
    on += (s_.film.position.q[k] - last) * (last - before_.film.position.q[k]) /
          (row.unit[k] * row.unit[k]);
  }
  on += along(before_.film.columns.T, last_.film.columns.T, s_.film.columns.T, kHeatUnit);
  on += along(before_.heat.thermal_deformation, last_.heat.thermal_deformation,
              s_.heat.thermal_deformation, row.unit[0]);
  return on > 0.0;
}

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
  row.moves = among_;
  if (!secant_) return row;
  const std::array<double, 4> way = moved();
  double norm = std::pow(now.ln_load - before_.film.ln_load, 2);
  for (int k = 0; k < s_.point.load.unknowns; ++k) {
    row.along[k] = way[k] / row.unit[k];
    norm += row.along[k] * row.along[k];
  }
  norm = std::sqrt(norm);
  row.along_load = (now.ln_load - before_.film.ln_load) / norm;
  for (double& a : row.along) a /= norm;
  return row;
}

void LoadBranch::predict(double length) {
  if (!secant_) return;
  const double part = length / length_;
  carry_on(before_, last_, part, s_);
  if (!among_) return;
  // The path begins where the journal stood, among the surfaces as they are now.
  const std::array<double, 4> way = moved();
  for (int k = 0; k < s_.point.load.unknowns; ++k) {
    const double change = last_.film.position.q[k] - before_.film.position.q[k];
    s_.point.load.path->from.q[k] += part * (change - way[k]);
  }
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
  bool failed = false;  // the step before: then as long a one once more
  for (int k = 0; k < kMostIterations && step > kShortestStep; ++k) {
    s_.point.load.path = next_row(step);
    predict(step);
    const Verdict v = correct_(s_, Accuracy::way_point);
    if (v.status == Status::interrupted || stopped(control_)) {
      failure_ = {Status::interrupted};
      return ended(BranchEnd::interrupted);
    }
    if (!v.good() || strayed()) {
      failure_ = v.good() ? Verdict{Status::iteration_limit, ending::Plain::strayed} : v;
      restore();
      step *= kShorterStep;
      failed = true;
      among_ = !among_;
      continue;
    }
    if (s_.film.ln_load >= 0.0) {
      if (arrive()) return ended(BranchEnd::reached);
      step *= kShorterStep;
      continue;
    }
    const bool falls =
        secant_ && s_.film.ln_load < std::min(last_.film.ln_load, most_ - kShortestStep);
    if (falls && step <= kTurn) return ended(BranchEnd::turned);
    if (falls) {  // the load at which it turns lies between: looked for in shorter steps
      restore();
      step *= kShorterStep;
      failed = true;
      continue;
    }
    keep();
    if (thinner_than_a_molecule(s_.model, s_.film)) return ended(BranchEnd::molecule);
    secant_ = true;
    length_ = step;
    if (!failed) step = std::min(kLongerStep * step, kLongestStep);
    failed = false;
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

Part::Part(Solution& s, Raised raised)
    : s_(s),
      raised_(raised),
      force_(s.point.load.force),
      speed_(s.point.scene.speed),
      place_(s.film.position.q) {
  for (const fluid::SupplyPatch& patch : s.point.scene.supply.patches) {
    pressure_.push_back(patch.pressure);
  }
}

void Part::take(double part) {
  for (int k = 0; k < 4; ++k) {
    if (raised_ == Raised::load) s_.point.load.force[k] = part * force_[k];
    if (raised_ == Raised::place) s_.film.position.q[k] = part * place_[k];
  }
  if (raised_ == Raised::speed) s_.point.scene.speed = part * speed_;
  if (raised_ != Raised::supply) return;
  for (std::size_t k = 0; k < pressure_.size(); ++k) {
    s_.point.scene.supply.patches[k].pressure = part * pressure_[k];
  }
  fluid::impose_supply(s_.point.scene.supply, s_.film.film);
}

Branch follow_parts(Solution& s, Raised raised, double begun, const Corrector& correct,
                    const SolveControl& control) {
  Part of(s, raised);
  Branch branch{raised, BranchEnd::lost, begun, s.film.least.h, {}};
  Reached last{s.film, s.heat}, before;
  double step = kFirstStep;
  double length = 0.0;  // from `before` to `last`; 0: there is none
  for (int k = 0; k < kMostIterations && step > kShortestStep; ++k) {
    const double next = begun < 1.0 ? std::min(1.0, branch.carried * std::exp(step))
                                    : std::max(1.0, branch.carried * std::exp(-step));
    const double way = std::abs(std::log(next / branch.carried));
    of.take(next);
    if (length > 0.0) carry_on(before, last, way / length, s);
    const Verdict v = correct(s, next == 1.0 ? Accuracy::result : Accuracy::way_point);
    if (v.status == Status::interrupted || stopped(control)) {
      branch.end = BranchEnd::interrupted;
      branch.last = {Status::interrupted};
      break;
    }
    if (v.good()) {
      branch.carried = next;
      branch.h_min = s.film.least.h;
      before = std::exchange(last, {s.film, s.heat});
      length = way;
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
  Part part(s, raised);
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

namespace {

/// Those of kLight that lie before the end of the branch on the last grid, the lightest in any
/// case: from beyond it none may begin, and to look for one costs as much as to follow it.
std::span<const double> light_loads(const std::vector<Limit>& limits) {
  std::span<const double> parts = kLight;
  if (limits.empty() || limits.back().raised != Raised::load) return parts;
  while (parts.size() > 1 && parts.front() > limits.back().part) parts = parts.subspan(1);
  return parts;
}

}  // namespace

std::optional<Branch> follow_loads(Solution& s, const std::function<Verdict()>& start,
                                   const Corrector& correct, const SolveControl& control) {
  const std::span<const double> parts = light_loads(s.limits);
  std::optional<Branch> light = follow_from(s, Raised::load, parts, start, correct, control);
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
                      branch.raised,
                      branch.carried,
                      proven,
                      branch.end == BranchEnd::unbounded});
}

}  // namespace shellback::bearing
