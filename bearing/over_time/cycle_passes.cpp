#include "bearing/over_time/cycle_passes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/over_time/cycle_endings.hpp"
#include "bearing/over_time/kept_run.hpp"
#include "bearing/over_time/tape_members.hpp"
#include "bearing/steady/solve.hpp"
#include "bearing/told_ranges.hpp"
#include "core/constants.hpp"
#include "core/step_control.hpp"

namespace shellback::bearing {
namespace {

constexpr double kAfterJump = 3600.0;  ///< steps of a turn, behind a jump: 0.1 degrees (methods 4)
constexpr double kSkinSteps = 8.0;     ///< longest step over the one that skins resolve
constexpr int kPassesOfAnswer = 2;     ///< in which the film's response to its walls changes much

/// All lengths go with the error allowed, as steps do that it chooses.
StepOptions step_options(const Case& c, const LoadCourse& course, double length) {
  const double longer = std::cbrt(c.model.tolerance / Model{}.tolerance);
  StepOptions o;
  o.error = kOfTolerance * c.model.tolerance;
  o.longest = longer * length / kFewestSteps;
  o.shortest = kStepShortest * length;
  for (const Supply& s : c.supplies) {
    const double speed = course.largest_speed() * c.bearing.radius;
    if (s.kind != SupplyKind::drilling || !(speed > 0.0)) continue;
    o.longest = std::min(o.longest, c.cycle->of_mouth * s.diameter / speed);
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
  o.elastic_tolerance = o.viscosity_tolerance = kShapePart * error;
  return o;
}

}  // namespace

CyclePasses::CyclePasses(const Case& c, Tier tier, const Physics& physics,
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

void CycleStart::members(Tape& tape) { tape(now, walls, response, measured, led); }

double CyclePasses::skin_time() const { return steps_.longest / kSkinSteps; }

void CyclePasses::members(Tape& tape) {
  film_.members(tape, length_, skin_time());
  tape(periods_, cost_, now_, walls_, from_rest_, begun_cold_);
  tape(told_, difference_, heat_, response_, measured_, r_, carried_over_);
  heat_.put_on(film_.model());
}

void CyclePasses::keep(bool in_any_case, const Rest& rest) {
  if (control_.kept == nullptr || !(in_any_case || control_.kept->due())) return;
  control_.kept->keep([this, &rest](Tape& tape) {
    members(tape);
    tape(*passing_);
    if (rest) rest(tape);
  });
}

void CyclePasses::begin(Tape& tape, const Rest& rest) {
  passing_ = Passing{CycleRecord(film_, course_, length_)};
  members(tape);
  tape(*passing_);
  if (rest) rest(tape);
  periods_.go_on();
  brought_back_ = true;
}

bool CyclePasses::put(const WallMeans& walls) {
  walls_ = walls;
  const bool open = film_.set_walls(*walls_, length_, skin_time(), now_);
  if (!open) {
    r_.verdict = {Status::iteration_limit,
                  ending::NoClearance{mean_deformation(*walls_), film_.model().clearance}};
  }
  return open;
}

bool CyclePasses::put_lasting(const std::vector<double>& carried) {
  carried_over_ = false;
  if (film_.put_lasting(carried, now_)) return true;
  r_.verdict = {Status::iteration_limit, ending::NoClearance{0.0, film_.model().clearance}};
  return false;
}

double CyclePasses::displacement() const {
  constexpr double kDisplaced = 1e-3;  // of the clearance
  return kDisplaced * film_.model().clearance * film_.unit_of_place();
}

int CyclePasses::cycles_of_turn() const {
  const double cycles = 2.0 * kPi / (course_.largest_speed() * length_);
  return static_cast<int>(std::ceil(std::clamp(cycles, 1.0, kMostCycles / 12.0)));
}

bool CyclePasses::displace() {
  JournalState journal = film_.journal_of(now_);
  journal[0] += displacement();
  carried_over_ = false;
  return film_.put_journal(journal, now_);
}

Tape::Content CyclePasses::stand() {
  Tape tape;
  members(tape);
  return tape.content();
}

void CyclePasses::put_back(const Tape::Content& stand) {
  EquilibriumCost cost = cost_;
  Tape tape(stand);
  members(tape);
  cost_ = std::move(cost);
}

void CyclePasses::begin_pass() {
  passing_ = Passing{CycleRecord(film_, course_, length_)};
  passing_->record.begin(now_);
  const bool heat = film_.heat() != nullptr;
  heat_ = {};
  if (heat) heat_.begin(now_);
  passing_->look = heat && c_.cycle->repeats() && measured_ < kPassesOfAnswer;
}

void CyclePasses::add(const FilmStep& step, double dt) {
  constexpr int kLooks = 24;  // of a cycle, at what the film answers to its walls
  passing_->record.add(step, dt, control_);
  if (film_.heat() == nullptr) return;
  heat_.add(step, dt);
  if (!c_.cycle->repeats() || heat_.time() < passing_->next_look) return;
  if (passing_->look) heat_.look_at(film_.model(), film_.point(), step.after.film);
  heat_.hold(film_.model(), film_.point(), step.after.film);
  passing_->next_look += length_ / kLooks;
}

PeriodEnd CyclePasses::go_through(const Rest& rest) {
  return periods_.pass(
      now_, cost_, control_, [this](const FilmStep& step, double dt) { add(step, dt); },
      [this, &rest] { keep(false, rest); });
}

bool CyclePasses::begin_again_from_rest(const Verdict& ended) {
  if (ended.status == Status::interrupted) return false;  // it goes on where it was
  if (!std::exchange(carried_over_, false) || ended.status != Status::iteration_limit) return false;
  const WallMeans walls = *walls_;
  begin_between(walls, area_mean(film_.model().domain.grid, walls.shell));
  if (r_.verdict.good()) begin_pass();
  return r_.verdict.good();
}

bool CyclePasses::pass(const Rest& rest) {
  if (r_.verdict.status == Status::interrupted) return false;  // before it had begun
  if (!std::exchange(brought_back_, false)) begin_pass();
  PeriodEnd end = go_through(rest);
  if (begin_again_from_rest(end.verdict)) end = go_through(rest);
  if (end.verdict.status == Status::interrupted) keep(true, rest);
  Passing passed = *std::move(passing_);
  passing_.reset();
  r_.verdict = end.verdict;
  if (end.verdict.status == Status::interrupted && r_.cycles > 0) return false;
  take(std::move(passed), end);
  return r_.verdict.good();
}

void CyclePasses::take(Passing passed, const PeriodEnd& end) {
  if (end.verdict.good() && r_.cycles > 0) difference_ = passed.record.difference(told_);
  if (passed.look && heat_.looked()) {
    response_ = heat_.response();
    ++measured_;
  }
  ++r_.cycles;
  r_.steps = end.accepted;
  r_.rejected_steps = end.rejected;
  r_.limiters.clear();
  if (end.over > 0) r_.limiters.push_back({Limiter::steps_too_long, end.over});
  told_ = std::move(passed.record);
  if (r_.verdict.good()) return;
  r_.verdict =
      at_instant(r_.verdict, {told_.told(), c_.cycle->crank_speed, false,
                              c_.cycle->journal_mass == 0.0, !film_.model().physics.elastic});
}

bool CyclePasses::pass_between(const WallMeans& walls, const Rest& rest) {
  if (!brought_back_ && !put(walls)) return false;
  if (!pass(rest)) return false;
  const std::vector<double> mean = heat_.mean_skin();
  for (std::size_t k = 0; k < mean.size(); ++k) now_.heat.skin[k] -= mean[k];
  return true;
}

CycleResult CyclePasses::result() const {
  CycleResult r = r_;
  r.tier = tier_;
  told_.write(r);
  if (!r.verdict.good()) {  // what a state that failed would swing by says nothing
    std::erase_if(r.assumptions,
                  [](const Note& n) { return std::holds_alternative<note::ShaftSwing>(n); });
  }
  if (film_.heat() == nullptr) {
    const double T = now_.film.columns.T.front();
    for (Note& w : oil_range_warnings(c_.oil, T, T, 0.0)) r.warnings.push_back(std::move(w));
  }
  if (!c_.cycle->repeats()) {
    const bool still = course_.begins().omega == 0.0;
    r.assumptions.push_back(from_rest_ ? note::Plain::event_in_the_middle
                            : still    ? note::Plain::event_at_rest
                                       : note::Plain::event_from_steady);
    if (begun_cold_) r.assumptions.push_back(note::Plain::event_without_heat);
    if (tier_ == Tier::lumped) r.assumptions.push_back(note::Plain::event_in_lumps);
  }
  if (told_.edges_took_oil_in()) add_temperature_of_edge_oil(film_.model(), tier_, r.assumptions);
  if (passes_over_supply(c_, tier_)) {
    r.assumptions.push_back(note::Plain::supply_temperature_unused);
  }
  r.cost.factorizations = cost_.factorizations;
  r.cost.newton_iterations = cost_.newton_iterations;
  return r;
}

}  // namespace shellback::bearing
