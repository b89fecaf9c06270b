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

constexpr double kFirstDepth = 0.1;   ///< of the first step, in summit roughnesses [-]
constexpr double kDepthError = 0.02;  ///< of a step, over the depth or the summit roughness [-]
constexpr double kShortest = 1e-6;    ///< step over the first one: below, nothing moves [-]
constexpr double kLongest = 4.0;      ///< growth of the step [-]
constexpr double kComplementarity = 1e-6;  ///< of (3), in summit roughnesses [-]

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
    const Field whole = after(b, w, dt);
    const Solution before = b.solution();
    Verdict why;
    Field halves = after(b, w, 0.5 * dt);
    bool found = b.wear_to(halves, why);
    if (found) halves = after(b, halves, 0.5 * dt);
    const double allowed = kDepthError * std::max(b.sigma(), largest(halves));
    const double error = largest_difference(whole, halves);
    if (found && error <= allowed) found = b.wear_to(halves, why);
    if (!found || !(error <= allowed)) {
      b.back_to(before);
      ++run.rejected_steps;
      dt *= found ? std::max(0.2, 0.9 * std::sqrt(allowed / error)) : 0.25;
      if (dt < kShortest * first) {
        run.verdict = {why.status, ending::RunningInEnded{t}, why.place, {why}};
        return;
      }
      continue;
    }
    t += dt;
    w = halves;
    note_state(b, t, dt, w, run);
    if (seen) seen(run);
    dt *= std::min(kLongest, 0.9 * std::sqrt(allowed / std::max(error, 1e-12 * allowed)));
  }
}

/// (3) by its own fixed point: in every cell the depth changes by what the gap lacks to the one at
/// which the contact pressure is the limit.
void find_end(WornBearing& b, const SolveControl& control, double limit, RunningInRun& run) {
  const double unit = b.sigma();
  Verdict why;
  const auto lacking = [&](const Field& w) {
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
  };
  const auto map = [&](const std::vector<double>& x, std::vector<double>& g) {
    Field w = x;
    for (double& v : w) v = std::max(0.0, v * unit);
    if (stopped(control)) {
      why = interrupted(0.0);
      return false;
    }
    if (!b.wear_to(w, why)) return false;
    g = lacking(w);
    for (double& v : g) v /= unit;
    return true;
  };
  std::vector<double> x(b.grid().cells(), 0.0);
  FixedPointOptions options;
  options.tolerance = kComplementarity;
  const FixedPointEnd end = fixed_point(map, options, x);
  Field w = x;
  for (double& v : w) v = std::max(0.0, v * unit);
  if (end == FixedPointEnd::map_failed) {
    run.verdict = why;
    return;
  }
  note_state(b, std::numeric_limits<double>::infinity(), 0.0, w, run);
  const Field g = lacking(w);
  run.complementarity = largest_difference(g, w) / unit;
  if (end == FixedPointEnd::iteration_limit) {
    run.verdict = {Status::iteration_limit,
                   ending::Unsettled{ending::Iteration::wear, 0, run.complementarity * unit}};
  }
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
