#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bearing/cycle.hpp"
#include "bearing/cycle_record.hpp"
#include "bearing/cycle_steps.hpp"
#include "bearing/cycle_walls.hpp"
#include "bearing/film_heat.hpp"
#include "bearing/fixed_point.hpp"
#include "bearing/solve.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

constexpr double kClosure = 1e-4;            ///< two cycles agree: smallest film and torque [-]
constexpr int kMostCycles = 40;              ///< starved films gather their oil over ten and more
constexpr double kOfTolerance = 0.1;         ///< error of a step, of model.tolerance [-]
constexpr double kFewestSteps = 90.0;        ///< of a period: 8 degrees of two turns
constexpr double kAfterJump = 1.0 / 7200.0;  ///< of a period: 0.1 degrees of two turns (methods 4)
constexpr double kShortest = 1e-7;           ///< of a period
constexpr double kUnit = 10.0;               ///< one unit of the walls' temperatures [K]
constexpr double kSkinSteps = 8.0;           ///< longest step over the one that skins resolve

/// All lengths go with the error allowed, as steps do that it chooses.
StepOptions step_options(const Case& c, const LoadCourse& course, double length) {
  constexpr double kUsual = 0.01;          // model.tolerance for which lengths are meant
  constexpr double kDegrees = kPi / 1800;  // 0.1 degrees of the journal's turn
  const double longer = std::cbrt(c.model.tolerance / kUsual);
  StepOptions o;
  o.error = kOfTolerance * c.model.tolerance;
  o.longest = longer * length / kFewestSteps;
  o.shortest = kShortest * length;
  o.after_jump = longer * kAfterJump * length;
  if (course.largest_speed() > 0.0) {
    o.after_jump = std::min(o.after_jump, longer * kDegrees / course.largest_speed());
  }
  o.fixed = c.cycle->step.value_or(0.0);
  return o;
}

/// In time a film need not be known better than the steps err; oil is conserved in any case.
EquilibriumOptions film_options(double error) {
  constexpr double kPart = 1e-2;  // of the error of a step
  EquilibriumOptions o;
  o.film_tolerance = o.load_tolerance = kPart * error;
  o.elastic_tolerance = o.viscosity_tolerance = kPart * error;
  return o;
}

Verdict not_closed(int cycles, double closure) {
  return {Status::iteration_limit,
          fmt::format("after {} cycles two of them still differ by {:.1e} in smallest film or "
                      "torque (1e-4 is asked for)",
                      cycles, closure),
          "",
          "repeat the load several times in a longer period (oil of a starved film gathers over "
          "more than 40 short ones), or look at the orbit: it may repeat itself over several "
          "periods, as journals that whirl do"};
}

Verdict walls_not_found(int cycles, double change) {
  return {Status::iteration_limit,
          fmt::format("after {} cycles the walls still change by {:.2g} K from one to the next",
                      cycles, kUnit * change),
          "", "a finer grid, a lower load, or tier isothermal"};
}

/// With the instant at which the step was not found.
Verdict at_instant(Verdict v, double t, double crank_speed) {
  const std::string when = crank_speed > 0.0
                               ? fmt::format("{:.4g} deg", t * crank_speed * 180.0 / kPi)
                               : fmt::format("{:.4g} s", t);
  const bool defect = v.status == Status::invalid_number;  // to be reported, nothing physical
  if (v.status == Status::interrupted || defect) return v;
  v.status = Status::iteration_limit;
  v.reason = fmt::format("no step in time is found at {} of the cycle: {}", when, v.reason);
  v.cure =
      "give load_cycle.journal_mass (a journal without mass may have to leap), elastic "
      "deformation, a lower load, or a finer grid";
  return v;
}

constexpr const char* kFromSteady = "the event begins in the steady state of its first row";
constexpr const char* kFromRest =
    "the event begins with the journal at rest in the middle of a full film: no steady state of "
    "its "
    "first row was found";
constexpr const char* kOverLong = "steps in time that err by more than they may";

/// How cycles draw near to the periodic state: where the change falls by the ratio rho from cycle
/// to cycle, rho/(1 - rho) of the last one is still to come.
struct Closure {
  double last = NAN;    ///< difference of the last two cycles [-]
  double before = NAN;  ///< of the two before [-]
  void add(double difference) {
    before = last;
    last = difference;
  }
  [[nodiscard]] bool closed() const {
    constexpr double kSlowest = 0.99;  // slower is not seen from noise
    const double rho = std::isfinite(before) ? std::min(last / before, kSlowest) : 0.0;
    return last * std::max(1.0, rho / (1.0 - rho)) <= kClosure;
  }
};

/// Cycles of one bearing, one after the other, until two agree.
class CycleSearch {
 public:
  CycleSearch(const Case& c, Tier tier, const SolveControl& control);

  [[nodiscard]] CycleResult run();

 private:
  /// Passes the period once more; false where the search has ended.
  bool pass();
  /// Isothermal: cycles until two agree.
  void until_closed();
  /// Cycles with walls that follow them (cycle_walls.hpp), until walls and cycles agree.
  void with_walls();
  /// Walls, by their temperature in units and their growth in clearances, and back.
  [[nodiscard]] std::vector<double> packed(const WallMeans& w) const;
  void unpack(const std::vector<double>& x, WallMeans& w) const;
  bool one_of_walls(const std::vector<double>& x, std::vector<double>& g);
  void begin();

  const Case& c_;
  Tier tier_;
  const SolveControl& control_;
  double length_;
  LoadCourse course_;
  StepOptions steps_;
  FilmSteps film_;
  CycleSteps periods_;
  EquilibriumCost cost_;
  FilmInTime now_;
  CycleRecord told_;
  Closure closure_;
  CycleHeat heat_;
  std::optional<thermal::WallResponse> response_;
  WallMeans walls_;
  double wall_change_ = NAN;
  int looked_ = 0;
  bool from_rest_ = true;
  CycleResult r_;
};

CycleSearch::CycleSearch(const Case& c, Tier tier, const SolveControl& control)
    : c_(c),
      tier_(tier),
      control_(control),
      length_(c.cycle->length()),
      course_(*c.cycle, c.operation.omega),
      steps_(step_options(c, course_, length_)),
      film_(make_bearing(c, physics_of(c, tier), c.model.grid), course_, c.cycle->journal_mass,
            film_options(steps_.error)),
      periods_(film_, course_, length_, steps_),
      told_(film_, course_, length_) {}

void CycleSearch::begin() {
  const double T = equivalent_temperature(c_);
  std::optional<FilmInTime> begun;
  if (!c_.cycle->repeats()) begun = film_.steady(T, cost_, control_.stop);
  from_rest_ = !begun.has_value();
  now_ = begun ? *std::move(begun) : film_.at_rest(T);
}

bool CycleSearch::pass() {
  constexpr int kLooks = 24;       // of a cycle, at the film's response to its walls
  constexpr int kCyclesLooked = 2; // after which it hardly changes any more
  CycleRecord record(film_, course_, length_);
  record.begin(now_);
  const bool heat = film_.heat() != nullptr;
  heat_ = {};
  if (heat) heat_.begin(now_);
  const bool look = heat && looked_ < kCyclesLooked;
  double next_look = 0.0;
  const PeriodEnd end = periods_.pass(now_, cost_, control_, [&](const FilmStep& step, double dt) {
    record.add(step, dt, control_);
    if (!heat) return;
    heat_.add(step, dt);
    if (!look || heat_.time() < next_look) return;
    heat_.look_at(film_.model(), step.after.film);
    next_look += length_ / kLooks;
  });
  r_.verdict = end.verdict;
  if (end.verdict.status == Status::interrupted && r_.cycles > 0) return false;
  if (end.verdict.good() && r_.cycles > 0) closure_.add(record.difference(told_));
  if (look && heat_.looked()) {
    response_ = heat_.response();
    ++looked_;
  }
  ++r_.cycles;
  r_.steps = end.accepted;
  r_.rejected_steps = end.rejected;
  r_.limiters.clear();
  if (end.over > 0) r_.limiters.push_back({kOverLong, end.over});
  told_ = std::move(record);
  if (!r_.verdict.good()) r_.verdict = at_instant(r_.verdict, told_.told(), c_.cycle->crank_speed);
  return r_.verdict.good();
}

void CycleSearch::until_closed() {
  while (pass() && c_.cycle->repeats() && !closure_.closed()) {
    if (r_.cycles == kMostCycles) {
      r_.verdict = not_closed(r_.cycles, closure_.last);
      return;
    }
  }
}

std::vector<double> CycleSearch::packed(const WallMeans& w) const {
  std::vector<double> x;
  x.reserve(w.shell.size() + w.shaft.size() + w.growth.size());
  for (const double T : w.shell) x.push_back(T / kUnit);
  for (const double T : w.shaft) x.push_back(T / kUnit);
  for (const double d : w.growth) x.push_back(d / film_.model().clearance);
  return x;
}

void CycleSearch::unpack(const std::vector<double>& x, WallMeans& w) const {
  auto at = x.begin();
  for (double& T : w.shell) T = kUnit * *at++;
  for (double& T : w.shaft) T = kUnit * *at++;
  for (double& d : w.growth) d = film_.model().clearance * *at++;
}

bool CycleSearch::one_of_walls(const std::vector<double>& x, std::vector<double>& g) {
  unpack(x, walls_);
  film_.set_walls(walls_, length_, steps_.longest / kSkinSteps, now_);
  if (!pass()) return false;
  const int nodes = film_.heat()->skin().nodes();
  const BodiesAnswer next =
      answer_of_bodies(film_.model(), walls_, heat_, *response_, nodes);
  walls_.flux = next.walls.flux;
  const std::vector<double> mean = heat_.mean_skin();
  for (std::size_t k = 0; k < mean.size(); ++k) now_.heat.skin[k] -= mean[k];
  g = packed(next.walls);
  wall_change_ = largest_difference(g, x);
  return true;
}

void CycleSearch::with_walls() {
  constexpr int kDepth = 5;              // methods 3.5
  constexpr double kWallsAgree = 3e-4;   // of kUnit: 3 mK, a few 1e-5 of viscosity
  walls_ = uniform_walls(film_.model(), equivalent_temperature(c_));
  if (!pass()) return;  // the orbit, before heat is looked at
  std::vector<double> x = packed(walls_);
  const auto map = [this](const std::vector<double>& at, std::vector<double>& g) {
    return one_of_walls(at, g);
  };
  const FixedPointEnd end = fixed_point(map, {kDepth, 1, kMostCycles, kWallsAgree}, x);
  if (end == FixedPointEnd::map_failed) return;
  if (end == FixedPointEnd::iteration_limit) r_.verdict = walls_not_found(r_.cycles, wall_change_);
}

CycleResult CycleSearch::run() {
  const auto begin_time = std::chrono::steady_clock::now();
  begin();
  if (film_.model().physics.film_energy) {
    with_walls();
  } else {
    until_closed();
  }
  told_.write(r_);
  if (!c_.cycle->repeats()) r_.assumptions.push_back(from_rest_ ? kFromRest : kFromSteady);
  r_.tier = tier_;
  r_.closure = closure_.last;
  r_.cost.factorizations = cost_.factorizations;
  r_.cost.newton_iterations = cost_.newton_iterations;
  r_.cost.wall_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_time).count();
  return r_;
}

}  // namespace

CycleResult solve_cycle(const Case& c, Tier tier, const SolveControl& control) {
  EXPECTS(c.cycle.has_value());
  return CycleSearch(c, tier, control).run();
}

}  // namespace shellback::bearing
