#include "bearing/cycle_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/fixed_point.hpp"
#include "bearing/heat_endings.hpp"
#include "bearing/kept_run.hpp"
#include "bearing/solve.hpp"
#include "bearing/step_control.hpp"
#include "bearing/tape_members.hpp"
#include "bearing/told_ranges.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {
namespace {

constexpr int kTurns = 15;           ///< of the walls, after which the oil is given time to follow
constexpr int kStalled = 2;          ///< rounds of walls and oil after which walls change no less
constexpr int kWornShapeTurns = 40;  ///< turns of the walls, and cycles, of a worn shape
constexpr int kOrbits = 3;           ///< cycles in which the journal finds its orbit
/// Behind each time that oil is led on: cycles in which the film follows, and those that count.
constexpr int kFollowing = 2;
constexpr int kCounted = 3;
constexpr std::size_t kLeading = 8;    ///< last cycles that lead on
constexpr double kAfterJump = 3600.0;  ///< steps of a turn, behind a jump: 0.1 degrees (methods 4)
constexpr double kSkinSteps = 8.0;     ///< longest step over the one that skins resolve

/// All lengths go with the error allowed, as steps do that it chooses.
StepOptions step_options(const Case& c, const LoadCourse& course, double length) {
  const double longer = std::cbrt(c.model.tolerance / Model{}.tolerance);
  StepOptions o;
  o.error = kOfTolerance * c.model.tolerance;
  o.longest = longer * length / kFewestSteps;
  o.shortest = kStepShortest * length;
  for (const Supply& s : c.supplies) {
    constexpr double kOfMouth = 0.5;  // of its width: no place that it passes over is left out
    const double speed = course.largest_speed() * c.bearing.radius;
    if (s.kind != SupplyKind::drilling || !(speed > 0.0)) continue;
    o.longest = std::min(o.longest, kOfMouth * s.diameter / speed);
  }
  o.after_jump = longer * (1.0 / (2.0 * kAfterJump)) * length;
  if (course.largest_speed() > 0.0) {
    o.after_jump =
        std::min(o.after_jump, longer * (2.0 * kPi / kAfterJump) / course.largest_speed());
  }
  o.fixed = c.cycle->step.value_or(0.0);
  return o;
}

/// Of the film in a step with this error; oil is conserved in any case.
EquilibriumOptions film_options(double error) {
  EquilibriumOptions o;
  o.film_tolerance = o.load_tolerance = kFilmPart * error;
  o.elastic_tolerance = o.viscosity_tolerance = kFilmPart * error;
  return o;
}

}  // namespace

CycleSearch::CycleSearch(const Case& c, Tier tier, const SolveControl& control)
    : CycleSearch(c, tier, physics_of(c, tier), control) {}

CycleSearch::CycleSearch(const Case& c, Tier tier, const Physics& physics,
                         const SolveControl& control, std::shared_ptr<const Solids> solids)
    : c_(c),
      tier_(tier),
      control_(control),
      length_(c_.cycle->length()),
      course_(*c_.cycle, c_.operation.omega, solid::BoundaryFriction::kSliding / c_.bearing.radius),
      steps_(step_options(c_, course_, length_)),
      film_(make_bearing(c_, physics, c_.model.grid, std::move(solids)), course_,
            c_.cycle->journal_mass, film_options(steps_.error)),
      periods_(film_, course_, length_, steps_),
      told_(film_, course_, length_) {}

void CycleSearch::members(Tape& tape) {
  film_.members(tape, length_, steps_.longest / kSkinSteps);
  tape(periods_, cost_, now_, told_, closure_, heat_, response_, looked_, walls_, held_);
  tape(wall_change_, from_rest_, begun_cold_, phase_, most_, oil_, oil_begun_, plain_, settled_,
       round_change_, stalled_, walls_begun_, answers_, r_, *passing_);
}

void CycleSearch::ended(Tape& tape) {
  film_.members(tape, length_, steps_.longest / kSkinSteps);
  tape(periods_, cost_, now_, told_, closure_, heat_, response_, looked_, walls_, answered_);
  tape(wall_change_, r_);
  if (tape.reads()) periods_.begin_next();
}

void CycleSearch::found(Tape& tape) { tape(now_, walls_, response_, looked_); }

void CycleSearch::keep(bool in_any_case) {
  if (control_.kept == nullptr || !(in_any_case || control_.kept->due())) return;
  control_.kept->keep([this](Tape& tape) { members(tape); });
}

std::optional<std::vector<double>> CycleSearch::remembered() {
  if (given_ == answers_.size()) return std::nullopt;
  return answers_[given_++];
}

void CycleSearch::remember(std::vector<double> answer) {
  answers_.push_back(std::move(answer));
  given_ = answers_.size();
}

void CycleSearch::begin_between(const WallMeans& walls, double T) {
  begin_film(T);
  walls_ = walls;
  held_ = true;
  put_walls();
}

void CycleSearch::set_temperature(double T) {
  if (!c_.cycle->repeats()) return begin(T);
  std::fill(now_.film.columns.T.begin(), now_.film.columns.T.end(), T);
  if (!now_.layer.now.empty()) {  // marks of another temperature are none of this one
    now_.layer = {Columns(now_.layer.now.size()), {}, 0.0};
    now_.oil_slope.clear();
  }
  r_.verdict = {};
}

void CycleSearch::begin_pass() {
  passing_ = Passing{CycleRecord(film_, course_, length_)};
  passing_->record.begin(now_);
  const bool heat = film_.heat() != nullptr;
  heat_ = {};
  if (heat) heat_.begin(now_);
  passing_->look = heat && c_.cycle->repeats() && looked_ < kCyclesOfAnswer;
}

void CycleSearch::add(const FilmStep& step, double dt) {
  constexpr int kLooks = 24;  // of a cycle, at the film's response to its walls
  passing_->record.add(step, dt, control_);
  if (film_.heat() == nullptr) return;
  heat_.add(step, dt);
  if (!passing_->look || heat_.time() < passing_->next_look) return;
  heat_.look_at(film_.model(), film_.point(), step.after.film);
  passing_->next_look += length_ / kLooks;
}

bool CycleSearch::pass() {
  if (r_.verdict.status == Status::interrupted) return false;  // before it had begun
  if (!std::exchange(brought_back_, false)) begin_pass();
  const PeriodEnd end = periods_.pass(
      now_, cost_, control_, [this](const FilmStep& step, double dt) { add(step, dt); },
      [this] { keep(false); });
  if (end.verdict.status == Status::interrupted) keep(true);
  Passing passed = *std::move(passing_);
  passing_.reset();
  r_.verdict = end.verdict;
  if (end.verdict.status == Status::interrupted && r_.cycles > 0) return false;
  const bool from_another = r_.cycles > 0 && plain_ > 0;
  if (end.verdict.good() && from_another) closure_.add(passed.record.difference(told_));
  if (passed.look && heat_.looked()) {
    response_ = heat_.response();
    ++looked_;
  }
  ++r_.cycles;
  ++plain_;
  r_.steps = end.accepted;
  r_.rejected_steps = end.rejected;
  r_.limiters.clear();
  if (end.over > 0) r_.limiters.push_back({Limiter::steps_too_long, end.over});
  told_ = std::move(passed.record);
  if (!r_.verdict.good()) r_.verdict = at_instant(r_.verdict, told_.told(), c_.cycle->crank_speed);
  return r_.verdict.good();
}

void CycleSearch::until_closed(double within) {
  if (!brought_back_) {
    closure_ = {};
    oil_.clear();
    oil_begun_ = film_.oil_of(now_);
  }
  while (pass() && c_.cycle->repeats() && !closure_.closed(within)) {
    const bool seen = std::isfinite(closure_.last);  // of a cycle that was not begun with led oil
    lead_oil_on();
    if (r_.cycles < most_ || !seen) continue;
    r_.verdict = {Status::iteration_limit,
                  ending::Unsettled{ending::Iteration::cycles, r_.cycles, closure_.last, false,
                                    told_.oil_gathered()}};
    return;
  }
}

void CycleSearch::lead_oil_on() {
  if (!now_.layer.now.empty()) return;  // marks of what has flowed are not of the oil alone
  std::vector<double> oil = film_.oil_of(now_);
  const bool followed = plain_ > kFollowing && r_.cycles > kOrbits;
  if (followed) oil_.push_back({std::move(oil_begun_), oil});
  if (oil_.size() > kLeading) oil_.erase(oil_.begin());
  oil_begun_ = std::move(oil);
  if (plain_ < kFollowing + kCounted || static_cast<int>(oil_.size()) < kCounted) return;
  const auto leads_to = extrapolated(oil_);
  if (!leads_to) return;
  film_.put_oil(*leads_to, now_);
  oil_begun_ = film_.oil_of(now_);
  closure_.lead_on();
  plain_ = 0;
}

std::vector<double> CycleSearch::packed(const WallMeans& w) const {
  std::vector<double> x;
  x.reserve(w.shell.size() + w.shaft.size() + w.thermal_deformation.size());
  for (const double T : w.shell) x.push_back(T / kHeatUnit);
  for (const double T : w.shaft) x.push_back(T / kHeatUnit);
  for (const double d : w.thermal_deformation) x.push_back(d / film_.model().clearance);
  return x;
}

void CycleSearch::unpack(const std::vector<double>& x, WallMeans& w) const {
  auto at = x.begin();
  for (double& T : w.shell) T = kHeatUnit * *at++;
  for (double& T : w.shaft) T = kHeatUnit * *at++;
  for (double& d : w.thermal_deformation) d = film_.model().clearance * *at++;
}

bool CycleSearch::put_walls() {
  const bool open = film_.set_walls(*walls_, length_, steps_.longest / kSkinSteps, now_);
  if (!open) {
    r_.verdict = {Status::iteration_limit,
                  ending::NoClearance{mean_deformation(*walls_), film_.model().clearance}};
  }
  return open;
}

bool CycleSearch::pass_between(const WallMeans& walls) {
  if (!brought_back_) {
    walls_ = walls;
    if (!put_walls()) return false;
  }
  if (!pass()) return false;
  const std::vector<double> mean = heat_.mean_skin();
  for (std::size_t k = 0; k < mean.size(); ++k) now_.heat.skin[k] -= mean[k];
  return true;
}

bool CycleSearch::answer_walls(const std::vector<double>& x, std::vector<double>& g) {
  WallMeans walls = *walls_;
  unpack(x, walls);
  if (!pass_between(walls)) return false;
  wall_change_ = change_of_walls();
  walls_->flux = answered_->flux;
  g = packed(*answered_);
  return true;
}

BodiesAnswer CycleSearch::bodies_answer() const {
  const int nodes = film_.heat()->skin().nodes();
  return answer_of_bodies(film_.model(), *walls_, heat_, *response_, nodes);
}

bool CycleSearch::settle_walls(bool rough, int turns) {
  const double T = mean_supply_temperature(c_);
  const double by_T = -rheology::viscosity_slopes(film_.model().oil, T, 0.0, 0.0).dln_dT;
  const bool coarsely = rough || !(by_T > 0.0);
  const double enough = coarsely ? kWallsOff : std::min(kWallsOff, steps_.error / by_T);
  if (!brought_back_) {
    walls_begun_ = packed(*walls_);
    answers_.clear();
    given_ = 0;
  }
  std::vector<double> x = walls_begun_;
  const auto map = [this](const std::vector<double>& at, std::vector<double>& g) {
    if (auto known = remembered()) {
      g = *std::move(known);
      return true;
    }
    if (!answer_walls(at, g)) return false;
    remember(g);
    return true;
  };
  return fixed_point(map, {FixedPointOptions{}.depth, 1, turns, enough / kHeatUnit}, x) ==
         FixedPointEnd::converged;
}

void CycleSearch::settle_walls_and_oil(bool rough) {
  while (true) {
    const bool to_walls = !brought_back_ || phase_ != Phase::closing;
    if (to_walls) {
      phase_ = Phase::walls;
      settled_ = settle_walls(rough, kTurns);
      if (!r_.verdict.good() || (settled_ && rough)) return;
    }
    phase_ = Phase::closing;
    until_closed(settled_ ? kClosed : steps_.error);
    if (!r_.verdict.good()) return;
    wall_change_ = change_of_walls();
    if (settled_ && wall_change_ <= kWallsOff) return;
    stalled_ = wall_change_ < round_change_ ? 0 : stalled_ + 1;
    round_change_ = wall_change_;
    if (r_.cycles >= most_ || stalled_ == kStalled) {
      r_.verdict = walls_unsettled();
      return;
    }
  }
}

double CycleSearch::change_of_walls() {
  BodiesAnswer answer = bodies_answer();
  const HeatTaken taken = told_.heat_taken();
  r_.audit.to_shell = answer.solids.shell.heat_in - taken.shell;
  r_.audit.to_shaft = answer.solids.shaft.heat_in - taken.shaft;
  answered_ = std::move(answer.walls);
  return kHeatUnit * largest_difference(packed(*answered_), packed(*walls_));
}

Verdict CycleSearch::walls_unsettled() const {
  return {Status::iteration_limit,
          ending::Unsettled{ending::Iteration::walls_of_cycles, r_.cycles, wall_change_}};
}

const Verdict& CycleSearch::search(bool rough) {
  const bool heat = film_.model().physics.film_energy;
  if (!r_.verdict.good()) return r_.verdict;
  if (!brought_back_) {
    most_ = r_.cycles + kMostCycles;
    round_change_ = INFINITY;
    stalled_ = 0;
  }
  if (!heat || held_ || !c_.cycle->repeats()) {
    until_closed(kClosed);
    return r_.verdict;
  }
  if (!brought_back_) phase_ = looked_ == 0 ? Phase::orbit : Phase::walls;
  if (phase_ == Phase::orbit && !pass()) return r_.verdict;  // before heat is looked at
  settle_walls_and_oil(rough);
  return r_.verdict;
}

const Verdict& CycleSearch::follow() {
  const bool heat = film_.model().physics.film_energy;
  for (int k = 0; k < kWornShapeTurns && r_.verdict.good(); ++k) {
    if (heat) {
      settled_ = settle_walls(true, kWornShapeTurns);
      if (!settled_ && r_.verdict.good()) r_.verdict = walls_unsettled();
    } else {
      pass();
    }
    if (!r_.verdict.good()) return r_.verdict;
    closure_.last = told_.drift();
    if (closure_.last <= steps_.error) return r_.verdict;
    walls_ = heat ? answered_ : walls_;
  }
  if (r_.verdict.good()) {
    r_.verdict = {Status::iteration_limit,
                  ending::Unsettled{ending::Iteration::cycles, r_.cycles, closure_.last, false,
                                    told_.oil_gathered()}};
  }
  return r_.verdict;
}

CycleResult CycleSearch::result() const {
  CycleResult r = r_;
  told_.write(r);
  r.audit.walls = wall_change_;
  r.audit.to_shell = r_.audit.to_shell;
  r.audit.to_shaft = r_.audit.to_shaft;
  if (film_.heat() == nullptr) {
    const double T = now_.film.columns.T.front();
    for (Note& w : oil_range_warnings(c_.oil, T, T, 0.0)) r.warnings.push_back(std::move(w));
  }
  if (!c_.cycle->repeats()) {
    const bool still = course_.at(0.0).omega == 0.0;
    r.assumptions.push_back(from_rest_ ? note::Plain::event_in_the_middle
                            : still    ? note::Plain::event_at_rest
                                       : note::Plain::event_from_steady);
    if (begun_cold_) r.assumptions.push_back(note::Plain::event_without_heat);
  }
  r.tier = tier_;
  r.closure = closure_.last;
  r.cost.factorizations = cost_.factorizations;
  r.cost.newton_iterations = cost_.newton_iterations;
  return r;
}

}  // namespace shellback::bearing
