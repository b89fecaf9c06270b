#include "bearing/over_time/cycle_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/film/equilibrium.hpp"
#include "bearing/heat/heat_endings.hpp"
#include "bearing/over_time/tape_members.hpp"
#include "core/fixed_point.hpp"
#include "core/largest.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {
namespace {

constexpr int kVectors = 2;          ///< of the walls' acceleration: older ones are of other films
constexpr int kTurns = 15;           ///< of the walls, after which the oil is given time to follow
constexpr int kStalled = 2;          ///< rounds of walls and oil after which walls change no less
constexpr int kWornShapeTurns = 40;  ///< turns of the walls, and cycles, of a worn shape

constexpr int kSpan = 32;  ///< cycles after which they are to be where they were
constexpr int kSpans = 2;  ///< and so many times

}  // namespace

CycleSearch::CycleSearch(const Case& c, Tier tier, const SolveControl& control)
    : CycleSearch(c, tier, physics_of(c, tier), control) {}

CycleSearch::CycleSearch(const Case& c, Tier tier, const Physics& physics,
                         const SolveControl& control, std::shared_ptr<const Solids> solids)
    : passes_(c, tier, physics, control, std::move(solids)) {}

void CycleSearch::members(Tape& tape) {
  tape(closure_, left_, oil_, off_, mean_change_, wall_change_, held_, phase_, most_, settled_,
       round_change_, stalled_, growth_, led_, displaced_, layer_begun_, before_led_);
  tape(mark_, marked_, by_mark_, near_, near_at_, spans_);
  tape(walls_begun_, answers_);
}

void CycleSearch::ended(Tape& tape) {
  passes_.members(tape);
  tape(left_, spans_, answered_, off_, mean_change_, wall_change_, unsettled_, growth_, unseen_);
}

void CycleSearch::begin(const CycleStart& from) {
  passes_.begin(from);
  led_ = from.led;
}

CycleStart CycleSearch::start() const {
  CycleStart found = passes_.start();
  found.led = led_;
  return found;
}

void CycleSearch::begin(Tape& tape) {
  passes_.begin(tape, [this](Tape& rest) { members(rest); });
}

void CycleSearch::begin_between(const WallMeans& walls, double T) {
  held_ = true;
  passes_.begin_between(walls, T);
}

bool CycleSearch::begin_reshaped(const CycleSearch& other) {
  return passes_.begin_reshaped(other.passes_, other.answered_);
}

void CycleSearch::set_temperature(double T) {
  passes_.set_temperature(T);
  unsettled_ = {};
}

const Verdict& CycleSearch::verdict() const {
  return unsettled_.good() ? passes_.verdict() : unsettled_;
}

bool CycleSearch::pass(const WallMeans* between) {
  const int before = cycles();
  const bool from_another = before > 0 && !oil_.just_led();
  const auto rest = [this](Tape& tape) { members(tape); };
  if (!brought_back()) layer_begun_ = passes_.layer_depth();
  const bool good = between ? passes_.pass_between(*between, rest) : passes_.pass(rest);
  if (cycles() == before) return false;
  layer_grows_ = largest_difference(layer_begun_, passes_.layer_depth());
  if (good && from_another) closure_.add(passes_.difference());
  if (between != nullptr) forget_marks();
  if (good && from_another && mark_.empty() && closure_.last <= kClosed) {
    mark_ = told().mark();
    marked_ = cycles();
  }
  if (good && from_another && near_.empty() && closure_.last <= passes_.error()) {
    near_ = told().mark();
    near_at_ = cycles();
  }
  oil_.passed();
  return good;
}

void CycleSearch::until_closed(double within) {
  if (!brought_back()) oil_.begin(passes_.lasting());
  while ((pass() || come_back_from_led_oil()) && repeats() && !closed(within)) {
    const bool seen = std::isfinite(closure_.last);  // of a cycle that was not begun with led oil
    if ((cycles() >= most_ || passes_.spent()) && seen) return cycles_unsettled(within);
    lead_oil_on();
    if (!verdict().good()) return;
  }
}

bool CycleSearch::closed(double within) {
  left_ = closure_.left();
  const int since = cycles() - marked_;
  if (!mark_.empty() && since >= kApart) {  // twice: what swings may pass its mark once
    const double now = std::max(closure_.last, left_after(told().difference(mark_), since));
    left_ = std::min(left_, std::max(now, std::exchange(by_mark_, now)));
  } else {
    by_mark_ = INFINITY;
  }
  return (left_ <= within && std::min(closure_.last, told().drift()) <= within) || wander();
}

bool CycleSearch::wander() {
  const int since = cycles() - near_at_;
  if (near_.empty() || std::isnan(closure_.last) || since < kSpan * (spans_ + 1)) return false;
  const double left = left_after(told().difference(near_), since);
  if (std::max(left, closure_.last) > passes_.error() || !stayed_near(near_, near_at_)) {
    near_.clear();
    spans_ = 0;
    return false;
  }
  if (++spans_ < kSpans) return false;
  left_ = std::max(left, closure_.last);
  return true;
}

void CycleSearch::forget_marks() {
  mark_.clear();
  near_.clear();
  spans_ = 0;
}

void CycleSearch::come_back() {
  passes_.put_back(displaced_->from);
  displaced_.reset();
}

const Verdict& CycleSearch::judge_orbit() {
  // Turns, or cycles that are longer, in which all but the slowest dies out, and after: a journal
  // whirls once in two turns.
  constexpr std::size_t kDying = 2, kSeen = 10;
  if (!verdict().good() || !may_depart()) return verdict();
  unseen_ = true;
  if (!displaced_) {
    displaced_ = Displaced{passes_.stand(), {}};
    if (!passes_.displace()) {
      come_back();
      return verdict();
    }
  }
  const auto rest = [this](Tape& tape) { members(tape); };
  const int apart = passes_.cycles_of_turn();
  while (displaced_->ends.size() < (kDying + kSeen) * apart && passes_.pass(rest)) {
    displaced_->ends.push_back(passes_.journal());
  }
  const bool interrupted = passes_.verdict().status == Status::interrupted;
  std::vector<JournalState> seen;
  for (std::size_t k = 0; k < displaced_->ends.size(); ++k) {
    if ((k + 1) % apart == 0) seen.push_back(displaced_->ends[k]);
  }
  const double displaced = passes_.displacement();
  come_back();
  if (interrupted) unsettled_ = {Status::interrupted};  // what is told is the orbit
  if (seen.size() < kDying + kSeen) return verdict();   // displaced, it does not pass the cycle
  seen.erase(seen.begin(), seen.begin() + kDying);
  growth_ = std::pow(growth_per_cycle(seen, displaced).value_or(NAN), 1.0 / apart);
  unseen_ = std::isnan(growth_);
  if (growth_ >= 1.0) {
    unsettled_ = {Status::iteration_limit,
                  ending::UnstableOrbit{growth_, film().model().input.model.grid}};
  }
  return verdict();
}

void CycleSearch::lead_oil_on() {
  before_led_.reset();
  if (passes_.has_marks()) return;
  const auto leads_to = oil_.after(passes_.lasting(), cycles());
  if (!leads_to || by_chance()) return;
  before_led_ = passes_.stand();
  if (!passes_.put_lasting(*leads_to)) return passes_.put_back(*before_led_);
  oil_.led_to(passes_.lasting());
  led_ = true;
  closure_.lead_on();
  mark_.clear();  // what stays near a mark, though oil is led on, is near it all the same
}

bool CycleSearch::by_chance() const {
  constexpr int kFollowed = 3;  // cycles: oil is led on every five
  return !mark_.empty() && cycles() - marked_ >= kFollowed && stayed_near(mark_, marked_);
}

bool CycleSearch::stayed_near(const std::vector<double>& mark, int at) const {
  return told().difference(mark) < 0.5 * (cycles() - at) * closure_.last;
}

bool CycleSearch::come_back_from_led_oil() {
  if (!before_led_ || verdict().status != Status::iteration_limit) return false;
  passes_.put_back(*before_led_);
  oil_.begin(passes_.lasting());  // what has led there counts no more
  oil_.led_to(passes_.lasting());
  return pass();
}

bool CycleSearch::answer_walls(const std::vector<double>& x, std::vector<double>& g) {
  const double clearance = film().model().clearance;
  WallMeans walls = *passes_.walls();
  unpack(x, clearance, walls);
  if (!pass(&walls)) return false;
  wall_change_ = change_of_walls();
  passes_.swing_about(answered_->flux);
  g = packed(*answered_, clearance);
  return true;
}

bool CycleSearch::settle_walls(const WallMeans& from, bool rough, int turns) {
  const BearingModel& model = film().model();
  const double T = mean_supply_temperature(model.input);
  const double by_T = -rheology::viscosity_slopes(model.oil, T, 0.0, 0.0).dln_dT;
  const bool coarsely = rough || !(by_T > 0.0);
  const double enough = coarsely ? kWallsOff : std::min(kWallsOff, passes_.error() / by_T);
  if (!brought_back()) {
    walls_begun_ = packed(from, model.clearance);
    answers_.clear();
  }
  std::vector<double> x = walls_begun_;
  const auto map = [this](const std::vector<double>& at, std::vector<double>& g) {
    if (auto known = answers_.next()) {
      g = *std::move(known);
      return true;
    }
    if (!answer_walls(at, g)) return false;
    answers_.add(g);
    return true;
  };
  return fixed_point(map, {kVectors, 1, turns, enough / kHeatUnit}, x) == FixedPointEnd::converged;
}

void CycleSearch::settle_walls_and_oil(bool rough) {
  while (true) {
    const bool to_walls = !brought_back() || phase_ != Phase::closing;
    if (to_walls) {
      phase_ = Phase::walls;
      settled_ = settle_walls(*passes_.walls(), rough, kTurns);
      if (!verdict().good() || (settled_ && (rough || closed(kClosed)))) return;
    }
    phase_ = Phase::closing;
    until_closed(settled_ ? kClosed : passes_.error());
    if (!verdict().good()) return;
    wall_change_ = change_of_walls();
    if (settled_ && wall_change_ <= kWallsOff) return;
    stalled_ = wall_change_ < round_change_ ? 0 : stalled_ + 1;
    round_change_ = wall_change_;
    if (cycles() >= most_ || stalled_ == kStalled) return walls_unsettled();
  }
}

double CycleSearch::change_of_walls() {
  const FilmSteps& steps = film();
  const WallMeans& walls = *passes_.walls();
  BodiesAnswer answer = answer_of_bodies(steps.model(), walls, passes_.heat(), passes_.response(),
                                         steps.heat()->skin().nodes());
  const HeatTaken taken = told().heat_taken();
  off_ = {answer.solids.shell.heat_in - taken.shell, answer.solids.shaft.heat_in - taken.shaft};
  answered_ = std::move(answer.walls);
  mean_change_ = mean_difference(steps.model().domain.grid, *answered_, walls);
  const double clearance = steps.model().clearance;
  return answer.left +
         kHeatUnit * largest_difference(packed(*answered_, clearance), packed(walls, clearance));
}

void CycleSearch::walls_unsettled() {
  unsettled_ = {Status::iteration_limit,
                ending::Unsettled{ending::Iteration::walls_of_cycles, cycles(), wall_change_}};
}

void CycleSearch::cycles_unsettled(double within) {
  // Cycles are compared by their smallest film, which a layer opens by what it flows: more than
  // they may differ by, or most of what they do, and more than the oil that gathers beside it.
  const Field& gap = told().smallest_gap();
  const double least =
      yielding_gap(*std::min_element(gap.begin(), gap.end()), film().model().domain.rough.sigma);
  const double by_layer = layer_grows_ / least;
  const double counts = std::min(within, 0.5 * closure_.last);
  if (passes_.has_marks() && by_layer > std::max(counts, std::abs(told().oil_gathered()))) {
    unsettled_ = {Status::iteration_limit,
                  ending::Unsettled{ending::Iteration::layer_of_cycles, cycles(), layer_grows_}};
    return;
  }
  unsettled_ = {Status::iteration_limit,
                ending::Unsettled{ending::Iteration::cycles, cycles(), closure_.last, false,
                                  told().oil_gathered()}};
}

const Verdict& CycleSearch::search(bool rough) {
  if (!verdict().good() || displaced_) return verdict();  // displaced: found before
  if (!brought_back()) {
    most_ = cycles() + kMostCycles;
    closure_ = {};
    forget_marks();
    round_change_ = INFINITY;
    stalled_ = 0;
  }
  if (!heat() || held_ || !repeats()) {
    until_closed(kClosed);
    return verdict();
  }
  if (!brought_back()) phase_ = passes_.measured() == 0 ? Phase::orbit : Phase::walls;
  if (phase_ == Phase::orbit && !pass()) return verdict();  // before heat is looked at
  settle_walls_and_oil(rough);
  return verdict();
}

const Verdict& CycleSearch::follow() {
  for (int k = 0; k < kWornShapeTurns && verdict().good(); ++k) {
    if (heat()) {
      settled_ = settle_walls(answered_ ? *answered_ : *passes_.walls(), true, kWornShapeTurns);
      if (!settled_ && verdict().good()) walls_unsettled();
    } else {
      pass();
    }
    if (!verdict().good()) return verdict();
    left_ = told().drift();
    if (left_ <= passes_.error()) return verdict();
  }
  if (verdict().good()) cycles_unsettled(passes_.error());
  return verdict();
}

CycleResult CycleSearch::result() const {
  CycleResult r = passes_.result();
  r.verdict = verdict();
  r.closure = left_;
  r.growth = growth_;
  if (r.verdict.good() && spans_ >= kSpans) {
    r.warnings.emplace_back(note::CyclesWander{left_});
  }
  if (r.verdict.good() && unseen_) {
    r.warnings.emplace_back(note::Plain::orbit_not_judged);
  }
  r.audit.walls = wall_change_;
  r.audit.walls_mean = mean_change_;
  r.audit.to_shell = off_.shell;
  r.audit.to_shaft = off_.shaft;
  return r;
}

}  // namespace shellback::bearing
