#include "bearing/running_in.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bearing/film_heat.hpp"
#include "bearing/fixed_point.hpp"
#include "bearing/solids.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

constexpr double kFirstDepth = 0.1;    ///< of the first step, in summit roughnesses [-]
constexpr double kDepthError = 0.005;  ///< of a step before it is extrapolated, over the depth or
                                       ///< the summit roughness [-]
constexpr double kShortest = 1e-6;     ///< step over the first one: below, nothing moves [-]
constexpr double kLongest = 4.0;       ///< growth of the step [-]
constexpr double kComplementarity = 1e-6;  ///< of (3), in summit roughnesses [-]

// Towards (3): shapes tried for the KS bearing worn in at 5 MPa under 40, 60, 80 kN are 34, 139,
// 325 with 15 vectors, 34, 170, 553 with 8; at 80 kN 278 with 30, and 403 at 1 MPa. A delay of 1
// takes 338, of 0 or 10 meets a shape without a film. Out of any reach so do 100 kN, and 20 and 80
// kN at 3000 rpm on 60 x 13 cells (2 MPa); within 3 the latter two take 17 and 235, within 10 not.
constexpr int kEndDepth = 15;         ///< shapes kept by the acceleration [-]
constexpr int kEndDelay = 2;          ///< plain shapes before it [-]
constexpr int kEndIterations = 1000;  ///< three times what 80 kN needs
constexpr double kEndReach = 3.0;     ///< of the next shape, in summit roughnesses [-]

/// (e^x - 1)/x.
double phi_1(double x) { return std::abs(x) < 1e-8 ? 1.0 + 0.5 * x : std::expm1(x) / x; }

/// A case whose shell has worn, and its solution.
class WornBearing {
 public:
  WornBearing(const Case& c, Tier tier, const SolveControl& control)
      : case_(c), tier_(tier), control_(control), given_(*c.running_in) {
    now_ = solve_tier(c, tier, control);
    if (!now_.verdict.good()) return;
    sigma_ = now_.model.contact->sigma();
    rate_ = given_.wear_coefficient / hardness_of_shell(c);
  }

  [[nodiscard]] const Solution& solution() const { return now_; }
  [[nodiscard]] double sigma() const { return sigma_; }
  [[nodiscard]] FilmGrid grid() const { return now_.model.scene.grid; }
  [[nodiscard]] double speed() const { return std::abs(now_.model.scene.speed); }

  /// Solves with this wear [m]. False: no solution; the last good one stays.
  bool wear_to(const Field& wear, Verdict& why) {
    Case worn = case_;
    worn.bearing.wear = wear_table(full_grid(grid()), mirror_to_full(grid(), wear));
    roughen(worn, largest(wear));
    Solution next = solve_tier_from(worn, tier_, now_, control_, Otherwise::failure);
    if (!next.verdict.good()) {
      why = next.verdict;
      return false;
    }
    now_ = std::move(next);
    return true;
  }

  void back_to(const Solution& s) { now_ = s; }

  /// (1) [m/s].
  [[nodiscard]] Field rate() const {
    Field r = now_.film.p_contact;
    for (double& p : r) p = rate_ * speed() * std::max(0.0, p - given_.limit_pressure);
    return r;
  }
  /// (2) [1/s].
  [[nodiscard]] Field stiffness() const {
    const double tau = now_.model.physics.elastic ? now_.model.solids->winkler() : 0.0;
    Field J = now_.film.dp_contact;
    for (std::size_t k = 0; k < J.size(); ++k) {
      const bool wears = now_.film.p_contact[k] > given_.limit_pressure;
      J[k] = wears ? rate_ * speed() * -J[k] / (1.0 - tau * J[k]) : 0.0;
    }
    return J;
  }

 private:
  /// The shell's surface on its way from new to worn.
  void roughen(Case& c, double depth) const {
    if (!given_.worn) return;
    const double part = std::min(1.0, depth / given_.worn_after);
    const auto mix = [part](double& a, double b) { a += part * (b - a); };
    mix(c.surfaces.shell.roughness, given_.worn->roughness);
    mix(c.surfaces.shell.orientation, given_.worn->orientation);
    mix(c.surfaces.shell.summit_roughness, given_.worn->summit_roughness);
    mix(c.surfaces.shell.summit_height, given_.worn->summit_height);
  }

  Case case_;
  Tier tier_;
  SolveControl control_;
  RunningIn given_;
  Solution now_;
  double sigma_ = 0.0;
  double rate_ = 0.0;
};

double volume_of(const FilmGrid& g, const Field& wear) {
  double sum = 0.0;
  for (int k = 0; k < g.cells(); ++k) sum += wear[k] * g.area(k / g.nz, k % g.nz);
  return sum * g.multiplicity();
}

void note_state(const WornBearing& b, double t, double step, const Field& wear, RunningInRun& run) {
  const Solution& s = b.solution();
  RunningInState state;
  state.t = t;
  state.step = step;
  state.depth = largest(wear);
  state.volume = volume_of(b.grid(), wear);
  state.p_asperity_max = largest(s.film.p_contact);
  const Friction f = friction_of(s.model, s.film);
  state.torque = f.viscous + f.asperity;
  state.h_min = s.film.least.h;
  run.states.push_back(state);
  run.grid = full_grid(b.grid());
  run.wear = mirror_to_full(b.grid(), wear);
  run.solution = s;
}

/// Wear after dt from `w`, the bearing standing in that state.
Field after(const WornBearing& b, Field w, double dt) {
  const Field rate = b.rate(), J = b.stiffness();
  for (std::size_t k = 0; k < w.size(); ++k) w[k] += dt * phi_1(-dt * J[k]) * rate[k];
  return w;
}

bool stopped(const SolveControl& control) { return control.stop != nullptr && *control.stop; }

Verdict interrupted(double t) { return {Status::interrupted, ending::RunningInEnded{t}}; }

/// A step of (1) that has been tried.
struct Attempt {
  Field w;            ///< wear after it [m]
  double over = 0.0;  ///< its error over the one that is allowed [-]
  bool found = false;
  Verdict why;  ///< it was not found

  [[nodiscard]] bool good() const { return found && over <= 1.0; }
};

/// From the wear `w`, in which the bearing stands: once whole, once in halves, and extrapolated to
/// steps of no length. What has gone does not come back. A good step leaves the bearing so worn.
Attempt attempt(WornBearing& b, const Field& w, double dt) {
  Attempt a;
  const Field whole = after(b, w, dt);
  a.w = after(b, w, 0.5 * dt);
  a.found = b.wear_to(a.w, a.why);
  if (!a.found) return a;
  a.w = after(b, a.w, 0.5 * dt);
  a.over = largest_difference(whole, a.w) / (kDepthError * std::max(b.sigma(), largest(a.w)));
  if (!a.good()) return a;
  for (std::size_t k = 0; k < w.size(); ++k) a.w[k] = std::max(w[k], 2.0 * a.w[k] - whole[k]);
  a.found = b.wear_to(a.w, a.why);
  return a;
}

/// No step is short enough.
Verdict too_short(const Attempt& last, double t) {
  if (last.found) return {Status::iteration_limit, ending::RunningInEnded{t, last.over}};
  return {last.why.status, ending::RunningInEnded{t}, last.why.place, {last.why}};
}

/// (1) up to the time `end`; steps as long as their error allows.
void march(WornBearing& b, const SolveControl& control, double end,
           const std::function<void(const RunningInRun&)>& seen, RunningInRun& run) {
  Field w(b.grid().cells(), 0.0);
  double t = 0.0;
  const double fastest = largest(b.rate());
  if (!(fastest > 0.0)) {  // nothing rubs, for however long
    note_state(b, end, end, w, run);
    return;
  }
  const double first = kFirstDepth * b.sigma() / fastest;
  double dt = std::min(first, end);
  while (t < end) {
    if (stopped(control)) {
      run.verdict = interrupted(t);
      return;
    }
    dt = std::min(dt, end - t);
    const Solution before = b.solution();
    const Attempt step = attempt(b, w, dt);
    if (!step.good()) {
      b.back_to(before);
      ++run.rejected_steps;
      dt *= step.found ? std::max(0.2, 0.9 / std::sqrt(step.over)) : 0.25;
      if (dt < kShortest * first) {
        run.verdict = too_short(step, t);
        return;
      }
      continue;
    }
    t += dt;
    w = step.w;
    note_state(b, t, dt, w, run);
    if (seen) seen(run);
    dt *= std::min(kLongest, 0.9 / std::sqrt(std::max(step.over, 1e-12)));
  }
}

/// Wear at which every cell's contact pressure would be `limit` if the film stayed as it is.
Field asked_for(const WornBearing& b, const Field& w, double limit) {
  const Solution& s = b.solution();
  const double open = s.model.contact->gap_of(limit);
  Field to = w;
  for (std::size_t k = 0; k < w.size(); ++k) {
    const double p = s.film.p_contact[k];
    if (s.model.scene.supply.cell[k] >= 0) continue;
    const double h = p > 0.0 ? s.model.contact->gap_of(p) : s.film.gap.cell[k];
    to[k] = std::max(0.0, w[k] + open - h);
  }
  return to;
}

/// Why there is no shape of (3): the map ended by `why`, or (3) is still `lack` away [m].
Verdict not_worn_in(FixedPointEnd end, const Verdict& why, double lack) {
  if (why.status == Status::interrupted) return why;
  const ending::Unsettled unsettled{ending::Iteration::wear, 0, lack};
  if (end != FixedPointEnd::map_failed) return {Status::iteration_limit, unsettled};
  return {Status::iteration_limit, unsettled, why.place, {why}};
}

/// (3) by its own fixed point: in every cell the depth changes by what the gap lacks to the one at
/// which the contact pressure is the limit.
void find_end(WornBearing& b, const SolveControl& control, double limit, RunningInRun& run) {
  const double unit = b.sigma();
  Verdict why;
  Field w;  // of the film that was found last
  const auto map = [&](const std::vector<double>& x, std::vector<double>& g) {
    Field next = x;
    for (double& v : next) v = std::max(0.0, v * unit);
    if (stopped(control)) {
      why = interrupted(0.0);
      return false;
    }
    if (!b.wear_to(next, why)) return false;
    w = std::move(next);
    g = asked_for(b, w, limit);
    for (double& v : g) v /= unit;
    return true;
  };
  std::vector<double> x(b.grid().cells(), 0.0);
  FixedPointOptions options;
  options.depth = kEndDepth;
  options.delay = kEndDelay;
  options.max_iterations = kEndIterations;
  options.tolerance = kComplementarity;
  options.reach = kEndReach;
  const FixedPointEnd end = fixed_point(map, options, x);
  double lack = NAN;
  if (end != FixedPointEnd::map_failed) {
    note_state(b, std::numeric_limits<double>::infinity(), 0.0, w, run);
    lack = largest_difference(asked_for(b, w, limit), w);
    run.complementarity = lack / unit;
  }
  if (end != FixedPointEnd::converged) run.verdict = not_worn_in(end, why, lack);
}

}  // namespace

RunningInRun run_in(const Case& c, Tier tier, const SolveControl& control,
                    const std::function<void(const RunningInRun&)>& seen) {
  EXPECTS(c.running_in);
  RunningInRun run;
  WornBearing b(c, tier, control);
  run.verdict = b.solution().verdict;
  if (!run.verdict.good()) return run;
  note_state(b, 0.0, 0.0, Field(b.grid().cells(), 0.0), run);
  if (seen) seen(run);
  if (c.running_in->duration) {
    march(b, control, *c.running_in->duration, seen, run);
  } else {
    find_end(b, control, c.running_in->limit_pressure, run);
  }
  return run;
}

double hardness_of_shell(const Case& c) {
  if (c.running_in && c.running_in->hardness > 0.0) return c.running_in->hardness;
  return c.shell && !c.shell->layers.empty() ? c.shell->layers.front().material.hardness : 0.0;
}

Profile wear_table(const FilmGrid& g, const Field& wear) {
  Profile table;
  table.phi = g.phi;
  table.z.push_back(g.z_face.front());
  table.z.insert(table.z.end(), g.z.begin(), g.z.end());
  table.z.push_back(g.z_face.back());
  const auto beyond = [&](int i, int last, int inner, double z) {
    const double a = wear[g.index(i, last)];
    if (last == inner) return a;
    const double slope = (a - wear[g.index(i, inner)]) / (g.z[last] - g.z[inner]);
    return std::max(0.0, a + slope * (z - g.z[last]));
  };
  const int end = g.nz - 1;
  for (int i = 0; i < g.nt; ++i) {
    table.height.push_back(beyond(i, 0, std::min(1, end), g.z_face.front()));
    for (int j = 0; j < g.nz; ++j) table.height.push_back(wear[g.index(i, j)]);
    table.height.push_back(beyond(i, end, std::max(end - 1, 0), g.z_face.back()));
  }
  return table;
}

}  // namespace shellback::bearing
