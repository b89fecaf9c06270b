#include "bearing/heat/heat_march.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/heat/heat_endings.hpp"
#include "bearing/heat/wall_balance.hpp"
#include "bearing/told_ranges.hpp"
#include "core/largest.hpp"
#include "core/step_control.hpp"
#include "core/tableau.hpp"

namespace shellback::bearing {
namespace {

/// Temperatures of the walls [K].
struct Walls {
  Field shell;
  std::vector<double> shaft;
};

Walls walls_of(const Solution& s) { return {s.heat.T_shell, s.heat.T_shaft}; }

/// a + f (b - a)
template <class T>
T carried_on(const T& a, const T& b, double f) {
  T out = b;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = a[k] + f * (b[k] - a[k]);
  return out;
}

double largest_distance(const Walls& a, const Walls& b) {
  return larger(largest_difference(a.shell, b.shell), largest_difference(a.shaft, b.shaft));
}

/// `s`: the last instant that was found; `v`: why there is none after it.
bool no_film_left(const Solution& s, const Verdict& v) {
  const auto& contact = s.model.contact;
  const bool pressed = contact && s.film.least.h < contact->least_gap();
  return v.status == Status::no_steady_state || pressed || thinner_than_a_molecule(s.model, s.film);
}

/// Smooth surfaces that meet within some of the shortest steps, as the last one brought them
/// together: when that is, is known as well as a march knows it.
bool surfaces_meet(const Solution& s, const MarchStand& stand, double shortest) {
  constexpr double kSteps = 10.0;
  return s.model.domain.rough.sigma == 0.0 &&
         s.film.least.h < -stand.rate.h_min * kSteps * shortest;
}

/// True if the heat that enters the walls now would hold them for ever where they are. That they do
/// not move says little: heat from the back may not have reached them yet.
bool is_at_rest(const Solution& s) {
  constexpr double kRest = 0.03;  // ten times what an iteration may leave [K]
  Solution now = s;
  WallBalance walls(now, nullptr);
  return walls.change_for_ever(friction_of(s.model, s.point, s.film)) < kRest;
}

}  // namespace

void tell_bodies(const FilmGrid& g, const SolidTemperature& solids,
                 const thermal::EnergyBalance& film, double films, const Field& deformation,
                 Instant& i) {
  i.T_shell_back = area_mean(g, solids.shell.back);
  i.T_shaft = axial_mean(g, solids.shaft.temperature);
  i.heat_out = films * (film.carried_out - film.carried_in) + solids.shell.heat_back +
               solids.shell.heat_ends + solids.shaft.heat_out;
  i.stored = solids.shell.stored + solids.shaft.stored + films * film.stored;
  if (!deformation.empty()) i.deformation = area_mean(g, deformation);
}

Instant instant_of(const Solution& s, double t, double dt) {
  const FilmGrid& g = s.model.domain.grid;
  const Friction f = friction_of(s.model, s.point, s.film);
  const SolidTemperature& solids = s.heat.solids;
  Instant i;
  i.t = t;
  i.dt = dt;
  i.torque = f.torque();
  i.h_min = s.film.least.h;
  i.T_film_max = largest(s.film.columns.T);
  i.T_film_min = *std::min_element(s.film.columns.T.begin(), s.film.columns.T.end());
  i.T_shell_max = largest(solids.shell.surface);
  i.heat_in = i.torque * s.point.omega() + pump_power(s.model, s.point, s.film);
  tell_bodies(g, solids, s.heat.balance, g.multiplicity(), s.heat.thermal_deformation, i);
  return i;
}

std::vector<Note> march_warnings(const rheology::Oil& oil, const std::vector<Instant>& instants) {
  double low = NAN, high = NAN;  // as long as none is known
  for (const Instant& i : instants) {
    low = std::fmin(low, i.T_film_min);
    high = std::fmax(high, i.T_film_max);
  }
  return oil_range_warnings(oil, low, high, 0.0);
}

namespace {

/// What a step leads to.
struct Stepped {
  Verdict verdict;
  SolidState bodies;
  SolidStep last;      ///< of its last stage
  Instant at;          ///< its end
  double error = 0.0;  ///< of the walls [K]
};

/// A stage of `own` [s] from bodies and oil of `enthalpy`; `at` is told of its end.
Verdict take_stage(Solution& s, double own, const SolidState& from,
                   const std::vector<double>& enthalpy, const MarchOptions& o,
                   const SolveControl& control, Stepped& to) {
  HeatStep stage{s.model.solids->step(own, from, &to.last), own, enthalpy};
  const Verdict v = solve_heat(s, o.heat, control, &stage);
  to.last = std::move(stage.solids);
  if (!v.good()) return v;
  to.bodies = s.model.solids->state(s.heat.solids, &to.last);
  to.at = instant_of(s, 0.0, 0.0);
  return v;
}

/// Half the distance of the walls from where the last step's rate would have led them: the local
/// error of backward Euler, as dt^2 T''/2 [K].
double error_of_shortest(const Walls& now, const Walls& before, const MarchStand::Rate& rate,
                         double dt) {
  Walls expected = before;
  for (std::size_t k = 0; k < rate.shell.size(); ++k) expected.shell[k] += dt * rate.shell[k];
  for (std::size_t k = 0; k < rate.shaft.size(); ++k) expected.shaft[k] += dt * rate.shaft[k];
  return 0.5 * largest_distance(now, expected);
}

/// `s`: now; `before`, `h_min`: a step of `dt` [s] ago.
MarchStand::Rate rate_of(const Solution& s, const Walls& before, double h_min, double dt) {
  const Walls now = walls_of(s);
  MarchStand::Rate rate{now.shell, now.shaft, (s.film.least.h - h_min) / dt};
  for (std::size_t k = 0; k < rate.shell.size(); ++k) {
    rate.shell[k] = (rate.shell[k] - before.shell[k]) / dt;
  }
  for (std::size_t k = 0; k < rate.shaft.size(); ++k) {
    rate.shaft[k] = (rate.shaft[k] - before.shaft[k]) / dt;
  }
  return rate;
}

/// One step of `length` [s] from `s` and its bodies: SDIRK2 where its error counts. The shortest
/// is one of backward Euler, which does not overshoot where hot oil first meets a cold wall.
Stepped take_step(Solution& s, double length, const MarchStand& stand, const SolidStep& last,
                  const MarchOptions& o, const SolveControl& control) {
  const SolidState& bodies = stand.bodies;
  const Tableau by = sdirk2();
  const double g = by.a[0][0];
  const bool accurate = std::isfinite(o.error) && length > o.shortest;
  const std::vector<double> enthalpy = film_enthalpy(s.model, s.film.columns.T);
  const Walls before = walls_of(s);
  Stepped to{{}, {}, last, {}};
  to.verdict = take_stage(s, accurate ? g * length : length, bodies, enthalpy, o, control, to);
  if (!to.verdict.good()) return to;
  if (!accurate) {
    if (std::isfinite(o.error)) {
      to.error = error_of_shortest(walls_of(s), before, stand.rate, length);
    }
    return to;
  }
  const Instant first = to.at;
  const Walls expected{carried_on(before.shell, s.heat.T_shell, 1.0 / g),
                       carried_on(before.shaft, s.heat.T_shaft, 1.0 / g)};
  const double ahead = (1.0 - g) / g;  // (1)
  const SolidState star{bodies.shell + ahead * (to.bodies.shell - bodies.shell),
                        bodies.shaft + ahead * (to.bodies.shaft - bodies.shaft)};
  const auto held = carried_on(enthalpy, film_enthalpy(s.model, s.film.columns.T), ahead);
  to.verdict = take_stage(s, g * length, star, held, o, control, to);
  to.error = to.verdict.good() ? largest_distance(walls_of(s), expected) : 0.0;
  for (double Instant::*heat : {&Instant::heat_in, &Instant::heat_out, &Instant::stored}) {
    to.at.*heat = (1.0 - g) * (first.*heat) + g * (to.at.*heat);
  }
  return to;
}

/// In the steps that are given, whatever they err.
MarchEnd march_by_steps(Solution& s, MarchStand& stand, const MarchOptions& o,
                        const SolveControl& control,
                        const std::function<void(const Instant&)>& tell) {
  SolidStep last;
  for (const double length : o.steps) {
    const Walls before = walls_of(s);
    const double h_min = s.film.least.h;
    Stepped step = take_step(s, length, stand, last, o, control);
    stand.end.verdict = step.verdict;
    if (!step.verdict.good()) return stand.end;
    stand.bodies = std::move(step.bodies);
    stand.rate = rate_of(s, before, h_min, length);
    last = std::move(step.last);
    stand.end.t += length;
    step.at.t = stand.end.t;
    step.at.dt = length;
    if (tell) tell(step.at);
  }
  return stand.end;
}

}  // namespace

MarchEnd march_heat(Solution& s, MarchStand& stand, const MarchOptions& o,
                    const SolveControl& control, const std::function<void(const Instant&)>& tell) {
  if (!o.steps.empty()) return march_by_steps(s, stand, o, control, tell);
  const double still = kHeatUnit * ThermalOptions{}.tolerance;  // what one iteration may leave [K]
  const bool accurate = std::isfinite(o.error);
  auto& [bodies, end, dt, calm, rate] = stand;
  if (dt == 0.0) dt = o.first;
  SolidStep last;
  while (!end.at_rest && end.t < o.end && dt <= kEndless) {
    const double length = std::min(dt, o.end - end.t);
    const FilmEquilibrium film = s.film;
    const HeatState heat = s.heat;
    const Walls before = walls_of(s);
    Stepped step = take_step(s, length, stand, last, o, control);
    end.verdict = step.verdict;
    const bool shortest = dt <= o.shortest;
    if (!end.verdict.good() || (step.error > o.error && !shortest)) {
      const bool hot =
          largest(s.film.columns.T) > mean_supply_temperature(s.model.input) + kHottestRise;
      s.film = film;
      s.heat = heat;
      const bool given_up = end.verdict.status == Status::interrupted || s.cost.spent();
      if (given_up || shortest) {
        const bool left = hot || no_film_left(s, end.verdict) ||
                          (accurate && surfaces_meet(s, stand, o.shortest));
        end.left_bounds = !given_up && left;
        return end;
      }
      dt *= end.verdict.good() ? 1.0 / kStepLonger : kStepShorter;
      calm = 0;
      continue;
    }
    if (step.error > o.error) ++end.jumps;
    bodies = std::move(step.bodies);
    rate = rate_of(s, before, film.least.h, length);
    end.t += length;
    last = std::move(step.last);
    end.at_rest = accurate && largest_distance(walls_of(s), before) < still && is_at_rest(s);
    ++calm;
    if (!accurate && calm > MarchStand::kCalm) dt /= kStepShorter;
    // A step so much longer errs by the square of that.
    const bool easily = std::pow(kStepLonger, kStepOrderAnew) * step.error <= o.error;
    if (accurate && easily && calm > 1) dt *= kStepLonger;
    step.at.t = end.t;
    step.at.dt = length;
    if (tell) tell(step.at);
  }
  end.verdict = {};
  end.at_rest = end.at_rest || dt > kEndless;
  return end;
}

}  // namespace shellback::bearing
