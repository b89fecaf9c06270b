#include "bearing/over_time/running_in.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "bearing/over_time/kept_run.hpp"
#include "bearing/over_time/solution_members.hpp"
#include "bearing/over_time/worn_bearing.hpp"
#include "bearing/pressed_layer.hpp"
#include "core/contract.hpp"
#include "core/fixed_point.hpp"
#include "core/largest.hpp"
#include "core/step_control.hpp"

namespace shellback::bearing {
namespace {

constexpr double kFirstDepth = 0.1;    ///< of the first step, in summit roughnesses [-]
constexpr double kDepthError = 0.001;  ///< of a step, over the depth or the summit roughness [-]
constexpr double kOtherRate = 0.1;     ///< part of the wear rate by which another state differs [-]
constexpr double kComplementarity =
    1e-6;  ///< of (3), or next to nothing worn, in summit roughnesses [-]

// Towards (3), before a lost acceleration doubled the delay (since then some 130 and 370 shapes at
// 60 and 80 kN, and rigid bearings half in contact are found): shapes tried for the KS bearing worn
// in at 5 MPa under 40, 60, 80 kN are 34, 139, 325 with 15 vectors, 34, 170, 553 with 8; at 80 kN
// 278 with 30, and 403 at 1 MPa. A delay of 1 takes 338, of 0 or 10 meets a shape without a film.
// Out of any reach so do 100 kN, and 20 and 80 kN at 3000 rpm on 60 x 13 cells (2 MPa); within 3
// the latter two take 17 and 235, within 10 not.
constexpr int kEndDepth = 15;         ///< shapes kept by the acceleration [-]
constexpr int kEndDelay = 2;          ///< plain shapes before it [-]
constexpr int kEndIterations = 1000;  ///< three times what 80 kN needs

/// (e^x - 1)/x and (phi_1(x) - 1)/x, by their series where those lose their digits.
double phi_1(double x) { return std::abs(x) < 1e-8 ? 1.0 + 0.5 * x : std::expm1(x) / x; }
double phi_2(double x) { return std::abs(x) < 1e-5 ? 0.5 + x / 6.0 : (phi_1(x) - 1.0) / x; }

double volume_of(const FilmGrid& g, const Field& wear) {
  double sum = 0.0;
  for (int k = 0; k < g.cells(); ++k) sum += wear[k] * g.area(k);
  return sum * g.multiplicity();
}

/// What a step errs, and what it makes of the errors before: of dV/dt = f(V) they change as f does.
struct StepError {
  double depth = 0.0;    ///< [m]
  double volume = 0.0;   ///< [m3]
  double carried = 1.0;  ///< rate of the volume at its end over that at its beginning [-]
};

void note_state(const WornBearing& b, double t, double step, const StepError& error,
                const Field& wear, RunningInRun& run) {
  const FilmGrid& g = b.model().domain.grid;
  RunningInState state;
  state.t = t;
  state.step = step;
  if (!run.states.empty()) {
    state.depth_error = error.carried * run.states.back().depth_error + error.depth;
    state.volume_error = error.carried * run.states.back().volume_error + error.volume;
  }
  state.depth = largest(wear);
  state.volume = volume_of(g, wear);
  b.tell(state, run);
  run.states.push_back(state);
  run.grid = full_grid(g);
  run.wear = mirror_to_full(g, wear);
}

Verdict interrupted(double t) { return {Status::interrupted, ending::RunningInEnded{t}}; }

/// What has been found, for a tape: all but the last solution, which its bearing tells anew.
void members(Tape& tape, WornBearing& b, RunningInRun& run) {
  tape(run.states, run.rejected_steps);
  if (!tape.reads() || run.states.empty()) return;
  RunningInState told;
  b.tell(told, run);
  run.grid = full_grid(b.model().domain.grid);
  run.wear = mirror_to_full(b.model().domain.grid, b.wear());
}

/// Keeps bearing, states and what `more` writes, if it is time or in any case.
template <class More>
void keep(KeptRun* kept, bool in_any_case, WornBearing& b, RunningInRun& run, More& more) {
  if (kept == nullptr || !(in_any_case || kept->due())) return;
  kept->keep([&](Tape& tape) {
    b.keep(tape);
    members(tape, b, run);
    tape(more);
  });
}

/// What `more` was when it was kept, after bearing and states; nothing was: as it is.
template <class More>
void take_up(KeptRun* kept, More& more) {
  if (kept == nullptr || kept->under_way() == nullptr) return;
  (*kept->under_way())(more);
  kept->taken_up();
}

/// Wear, what wears it and how much less it will with more of it, at one time.
struct WearPoint {
  Field w;  ///< [m]
  Field r;  ///< (1) [m/s]
  Field J;  ///< (2) [1/s]
};

WearPoint point_of(const WornBearing& b, double per_load, Field w) {
  WearLoad load = b.load();
  for (double& x : load.load) x *= per_load;
  for (double& x : load.stiffness) x *= per_load;
  return {std::move(w), std::move(load.load), std::move(load.stiffness)};
}

/// A step of (2) from `now`; what it rests on.
struct WearStep {
  double dt = 0.0;
  Field slope;  ///< of N over time, carried on [m/s2]
};

/// N of another point less that of `now`, cell k.
double change_of_rest(const WearPoint& now, const WearPoint& other, std::size_t k) {
  return other.r[k] - now.r[k] + now.J[k] * (other.w[k] - now.w[k]);
}

/// N in a straight line through the point before, `past` [s] ago; without one it stays.
WearStep step_of(const WearPoint& now, const WearPoint* before, double past, double dt) {
  WearStep step{dt, Field(now.w.size(), 0.0)};
  for (std::size_t k = 0; before != nullptr && k < now.w.size(); ++k) {
    step.slope[k] = -change_of_rest(now, *before, k) / past;
  }
  return step;
}

Field after(const WearPoint& now, const WearStep& step) {
  const double dt = step.dt;
  Field w = now.w;
  for (std::size_t k = 0; k < w.size(); ++k) {
    const double x = -dt * now.J[k];
    w[k] += std::max(0.0, dt * (phi_1(x) * now.r[k] + phi_2(x) * dt * step.slope[k]));
  }
  return w;
}

/// By how much the rate at the end moves the wear of the step.
StepError error_of(const FilmGrid& g, const WearPoint& now, const WearStep& step,
                   const WearPoint& end) {
  StepError error;
  double before = 0.0, behind = 0.0;  // rates of the volume
  for (int k = 0; k < g.cells(); ++k) {
    if (now.r[k] == 0.0 && end.r[k] == 0.0) continue;  // it rests, whatever the line says
    before += now.r[k] * g.area(k);
    behind += end.r[k] * g.area(k);
    const double off = change_of_rest(now, end, k) - step.dt * step.slope[k];
    const double moved = step.dt * phi_2(-step.dt * now.J[k]) * off;
    error.depth = larger(error.depth, std::abs(moved));
    error.volume += moved * g.area(k);
  }
  error.volume = std::abs(g.multiplicity() * error.volume);
  if (before > 0.0) error.carried = behind / before;
  return error;
}

/// (1) up to a time; steps as long as their error allows.
class March {
 public:
  March(WornBearing& b, const Case& c, const SolveControl& control,
        const std::function<void(const RunningInRun&)>& seen, RunningInRun& run)
      : b_(b),
        control_(control),
        seen_(seen),
        run_(run),
        per_load_(c.running_in->wear_coefficient / hardness_of_shell(c)),
        unit_(b.model().contact->sigma()),
        now_(point_of(b, per_load_, b.wear())) {
    take_up(control.kept, *this);
  }

  void to(double end);
  /// In these steps, whatever they err.
  void through(const std::vector<double>& steps);
  void members(Tape& tape) { tape(unit_, t_, dt_, first_, past_, before_, failing_); }

 private:
  enum class From { last, cold };
  /// Tries a step; false, and back where it began, if it is not found or errs too much for `most`
  /// times what is allowed, or if, from cold, another state is found and `most` is finite.
  bool take(double dt, double most = 1.0, From from = From::last);
  /// The same; where none is found for the first time, from cold, too: the last film may have been
  /// no start.
  bool advance(double dt);
  /// The same from cold; where it is not found, for the reason of before.
  bool take_from_cold(double dt, double most);
  /// Error of a step's wear [m].
  [[nodiscard]] double allowed(const Field& w) const {
    return kDepthError * std::max(unit_, largest(w));
  }
  /// A step that wears a tenth of a summit where it wears most [s].
  [[nodiscard]] double first_step() const;
  /// The first step's length; false if nothing rubs, for however long.
  bool begin(double end);
  /// Depths are allowed to err by more than a step wears that is not found: for its length it is
  /// not.
  [[nodiscard]] bool shorter_may_be_found() const;
  /// Where the states that were followed end: goes on, dt later, from the one found from cold.
  /// False: there is none, or the last one was found so, or it is not for want of states that no
  /// step is good.
  bool begin_anew(double dt);
  /// No step is short enough.
  void end_too_short();
  /// From outside; where it is, is kept.
  void stop();

  WornBearing& b_;
  const SolveControl& control_;
  const std::function<void(const RunningInRun&)>& seen_;
  RunningInRun& run_;
  double per_load_;  ///< C/H [1/Pa]
  double unit_;      ///< summit roughness of the new surfaces [m]
  double t_ = 0.0;
  double dt_ = 0.0;     ///< length of the next step [s]
  double first_ = 0.0;  ///< of the first one; 0: there was none [s]
  double past_ = 0.0;   ///< of the last one [s]
  WearPoint now_;
  std::optional<WearPoint> before_;
  double depth_ = 0.0;    ///< wear of the last step tried, at most [m]
  StepError error_;       ///< what it errs
  double over_ = 0.0;     ///< its error over the one that is allowed [-]
  bool found_ = true;     ///< it was found
  bool failing_ = false;  ///< from cold none was found near the last good one
  Verdict why_;           ///< not
};

bool March::take(double dt, double most, From from) {
  const WearStep step = step_of(now_, before_ ? &*before_ : nullptr, past_, dt);
  Field w = after(now_, step);
  depth_ = largest_difference(w, now_.w);
  found_ = from == From::cold ? b_.wear_from_cold(w, why_)
                              : b_.wear_to(w, std::numeric_limits<double>::infinity(), why_);
  if (!found_) return false;
  WearPoint end = point_of(b_, per_load_, std::move(w));
  error_ = error_of(b_.model().domain.grid, now_, step, end);
  over_ = error_.depth / allowed(end.w);
  const bool jumps = from == From::cold && !(std::abs(error_.carried - 1.0) <= kOtherRate);
  found_ = !jumps || std::isinf(most);
  if (!found_ || !(over_ <= most)) {
    b_.go_back();
    return false;
  }
  before_ = std::exchange(now_, std::move(end));
  past_ = dt;
  t_ += dt;
  failing_ = false;
  note_state(b_, t_, dt, error_, now_.w, run_);
  run_.states.back().anew = jumps;
  if (jumps) {
    before_.reset();
    past_ = 0.0;
  }
  if (seen_) seen_(run_);
  return true;
}

bool March::advance(double dt) {
  if (take(dt)) return true;
  if (found_ || failing_ || why_.status == Status::interrupted) return false;
  if (take_from_cold(dt, 1.0)) return true;
  failing_ = !found_ && !stopped(control_);  // else it errs too much: a shorter one may be found so
  return false;
}

bool March::take_from_cold(double dt, double most) {
  const Verdict why = why_;
  if (take(dt, most, From::cold)) return true;
  if (!stopped(control_)) why_ = why;
  return false;
}

bool March::shorter_may_be_found() const {
  return found_ ? dt_ >= kStepShortest * first_ : depth_ >= allowed(now_.w);
}

bool March::begin_anew(double dt) {
  if (found_ || run_.states.back().anew) return false;
  return take_from_cold(dt, std::numeric_limits<double>::infinity());
}

void March::end_too_short() {
  run_.verdict = found_ ? Verdict{Status::iteration_limit, ending::RunningInEnded{t_, over_}}
                        : Verdict{why_.status, ending::RunningInEnded{t_}, why_.place, {why_}};
}

void March::stop() {
  run_.verdict = interrupted(t_);
  keep(control_.kept, true, b_, run_, *this);
}

double March::first_step() const { return kFirstDepth * unit_ / largest(now_.r); }

bool March::begin(double end) {
  if (largest(now_.r) > 0.0) {
    first_ = dt_ = first_step();
    return true;
  }
  note_state(b_, end, end, {}, now_.w, run_);  // nothing rubs, for however long
  run_.states.back().cycles = 0;               // told with the first state
  if (seen_) seen_(run_);
  return false;
}

void March::to(double end) {
  if (first_ == 0.0 && !begin(end)) return;
  while (t_ < end) {
    if (stopped(control_)) return stop();
    dt_ = std::min(dt_, end - t_);
    const bool good = advance(dt_);
    const double longer = step_growth(1.0, over_, !(past_ > 0.0 && before_));
    if (!good && !found_ && why_.status == Status::interrupted) return stop();
    if (!good) {
      ++run_.rejected_steps;
      if (!shorter_may_be_found()) {
        if (!begin_anew(dt_)) return stopped(control_) ? stop() : end_too_short();
        if (run_.states.back().anew) dt_ = first_step();
        continue;
      }
    }
    dt_ *= !found_ ? kStepShorter : good ? longer : std::min(longer, kStepSafety);
    keep(control_.kept, false, b_, run_, *this);
  }
}

void March::through(const std::vector<double>& steps) {
  for (const double dt : steps) {
    if (stopped(control_)) return stop();
    if (!take(dt, std::numeric_limits<double>::infinity()) && !begin_anew(dt)) {
      return stopped(control_) ? stop() : end_too_short();
    }
  }
}

/// Wear at which every cell's contact pressure would be `limit` if the film stayed as it is.
Field asked_for(const WornBearing& b, const Field& w, double limit) {
  const BearingModel& m = b.model();
  const double open = m.contact->gap_of(limit);
  Field to = w;
  for (std::size_t k = 0; k < w.size(); ++k) {
    const double p = b.contact()[k];
    if (m.supply.cell[k] >= 0) continue;
    const double h = p > 0.0 ? m.contact->gap_of(p) : b.gap()[k];
    to[k] = std::max(0.0, w[k] + open - h);
  }
  return to;
}

/// Wears the shell to `next`: at once, or, where that shape has no film from the last one's, on the
/// straight way to it in steps half as long, down to a sixteenth. False: why not.
bool wear_on(WornBearing& b, const Field& next, double within, Verdict& why) {
  constexpr double kShortestPart = 1.0 / 16.0;
  const Field from = b.wear();
  double done = 0.0;
  for (double part = 1.0; done < 1.0;) {
    Field to = next;
    const double left = 1.0 - (done + part);
    for (std::size_t k = 0; k < to.size(); ++k) to[k] += left * (from[k] - next[k]);
    if (b.wear_to(to, within, why)) {
      done += part;
      part = std::min(2.0 * part, 1.0 - done);
    } else if (part *= 0.5; part < kShortestPart || why.status == Status::interrupted) {
      return false;
    }
  }
  return true;
}

/// Why there is no shape of (3): the map ended by `why`, or (3) is still `lack` away [m].
Verdict not_worn_in(FixedPointEnd end, const Verdict& why, double lack) {
  if (why.status == Status::interrupted) return why;
  const ending::Unsettled unsettled{ending::Iteration::wear, 0, lack};
  if (end != FixedPointEnd::map_failed) return {Status::iteration_limit, unsettled};
  return {Status::iteration_limit, unsettled, why.place, {why}};
}

/// What the iteration for (3) was told, to be led through it once more.
struct ShapesTried {
  double unit = 0.0;         ///< summit roughness of the new surfaces [m]
  std::vector<Field> asked;  ///< for every shape tried [m]
};

/// (3) by its own fixed point: in every cell the depth changes by what the gap lacks to the one at
/// which the contact pressure is the limit.
void find_end(WornBearing& b, const SolveControl& control, double limit, RunningInRun& run) {
  ShapesTried tried{b.model().contact->sigma(), {}};
  take_up(control.kept, tried);
  const double unit = tried.unit;
  Verdict why;
  std::size_t given = 0;
  double lack = std::numeric_limits<double>::infinity();  // of the last shape [m]
  const auto map = [&](const std::vector<double>& x, std::vector<double>& g) {
    Field next = x;
    for (double& v : next) v = std::max(0.0, v * unit);
    if (given == tried.asked.size()) {
      if (stopped(control)) {
        why = {Status::interrupted};
        return false;
      }
      // heat no rougher than what the last shape lacked: noise is not accelerated
      if (!wear_on(b, next, lack, why)) return false;
      tried.asked.push_back(asked_for(b, next, limit));
      const double off = largest_difference(tried.asked.back(), next) / unit;
      const int shapes = static_cast<int>(tried.asked.size());
      if (control.progress) control.progress({"shape", shapes, off, NAN, NAN});
      keep(control.kept, false, b, run, tried);
    }
    g = tried.asked[given++];
    lack = largest_difference(g, next);
    for (double& v : g) v /= unit;
    return true;
  };
  std::vector<double> x(b.model().domain.grid.cells(), 0.0);
  FixedPointOptions options;
  options.depth = kEndDepth;
  options.delay = kEndDelay;
  options.max_iterations = kEndIterations;
  options.tolerance = kComplementarity;
  options.reach = kSummits;
  const FixedPointEnd end = fixed_point(map, options, x);
  double away = NAN;  // of the last shape that was found [m]
  if (end != FixedPointEnd::map_failed) {
    note_state(b, std::numeric_limits<double>::infinity(), 0.0, {}, b.wear(), run);
    away = largest_difference(asked_for(b, b.wear(), limit), b.wear());
    run.complementarity = away / unit;
  }
  if (why.status == Status::interrupted) {
    keep(control.kept, true, b, run, tried);
    if (!tried.asked.empty()) {  // told, not kept: the shape tried last
      note_state(b, std::numeric_limits<double>::infinity(), 0.0, {}, b.wear(), run);
    }
  }
  if (end != FixedPointEnd::converged) run.verdict = not_worn_in(end, why, away);
}

}  // namespace

namespace {

/// Where the states that were followed ended first, and how often; never: nothing.
std::optional<note::StatesEnd> states_end(const std::vector<RunningInState>& states, bool flows) {
  std::optional<note::StatesEnd> ends;
  for (std::size_t k = 1; k < states.size(); ++k) {
    if (!states[k].anew) continue;
    if (!ends)
      ends = note::StatesEnd{states[k].t, states[k - 1].torque, states[k].torque, 0, flows};
    ++ends->times;
  }
  return ends;
}

}  // namespace

void expect_running_in(const Case& c, Tier tier) {
  if (!c.running_in) {
    throw InputError(c.path,
                     "there is no [running_in]; give wear_coefficient = \"1e-8\" and until = "
                     "\"200 s\" or \"worn_in\" with limit_pressure = \"5 MPa\"");
  }
  if (tier != Tier::isothermal && tier != Tier::thd && tier != Tier::tehd) {
    throw InputError("model.tier", "running-in needs a solved film; take isothermal, thd or tehd");
  }
}

RunningInRun run_in(const Case& c, Tier tier, const SolveControl& control,
                    const std::function<void(const RunningInRun&)>& seen,
                    const std::vector<double>& steps) {
  expect_running_in(c, tier);
  RunningInRun run;
  SolveControl within = control;  // of each shape; kept is what lies between them
  within.kept = nullptr;
  Tape* tape = control.kept != nullptr ? control.kept->under_way() : nullptr;
  const auto b =
      tape != nullptr ? kept_bearing(c, tier, within, *tape) : new_bearing(c, tier, within);
  run.verdict = b->verdict();
  if (!run.verdict.good()) return run;
  if (tape != nullptr) {
    members(*tape, *b, run);
  } else {
    note_state(*b, 0.0, 0.0, {}, b->wear(), run);
  }
  if (seen) seen(run);
  if (!steps.empty()) {
    March(*b, c, control, seen, run).through(steps);
  } else if (c.running_in->duration) {
    March(*b, c, control, seen, run).to(*c.running_in->duration);
  } else {
    find_end(*b, control, c.running_in->limit_pressure, run);
  }
  const bool flows = pressed_layer(c, 0).has_value() && b->model().physics.elastic;
  if (flows && !c.cycle) run.warnings.emplace_back(note::Plain::marks_begin_anew);
  const double depth = run.states.back().depth;
  if (run.verdict.good() && depth <= kComplementarity * b->model().contact->sigma()) {
    run.warnings.emplace_back(note::Plain::nothing_wears);
  }
  if (!c.running_in->worn) run.warnings.emplace_back(note::Plain::roughness_stays);
  if (const auto ends = states_end(run.states, flows)) run.warnings.emplace_back(*ends);
  if (c.shell && !c.shell->layers.empty() && depth > c.shell->layers.front().thickness) {
    run.warnings.emplace_back(note::WornThrough{depth, c.shell->layers.front().thickness});
  }
  if (depth > c.bearing.radial_clearance) {
    run.warnings.emplace_back(note::WornBeyondClearance{depth, c.bearing.radial_clearance});
  }
  if (const double edge = largest(wear_table(run.grid, run.wear).height); edge > depth) {
    run.warnings.emplace_back(note::WearLedOn{depth, edge});
  }
  return run;
}

}  // namespace shellback::bearing
