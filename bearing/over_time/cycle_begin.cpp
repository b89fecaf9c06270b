/// Where the passes of a cycle begin: in a steady film, between walls of one
/// temperature, on a coarser grid, at a shape that has worn, in what was kept.
#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/over_time/cycle_passes.hpp"
#include "bearing/steady/nested.hpp"
#include "bearing/steady/solve.hpp"
#include "core/constants.hpp"

namespace shellback::bearing {
namespace {

/// Those of a steady bearing, with the heat that its film gives them.
WallMeans steady_walls(const Solution& s) {
  const FilmGrid& g = s.model.domain.grid;
  thermal::FilmEnergy energy(
      film_energy_problem(s.model, s.point, s.film, friction_of(s.model, s.point, s.film)));
  std::vector<double> T = s.film.columns.T;
  for (int k = 0; k < kMostIterations && energy.sweep(T) > kKnownTemperature; ++k) {
  }  // until what is mixed in the supplies has settled, too
  thermal::WallHeat q = energy.wall_heat(T);
  const ContactHeat rubbed = contact_heat(s.model, s.point, s.film);
  for (int c = 0; c < g.cells(); ++c) {
    q.shell[c] = q.shell[c] / g.area(c) + rubbed.shell[c];
    q.shaft[c] += g.area(c) * rubbed.shaft[c];
  }
  return {s.heat.T_shell, s.heat.T_shaft, q.shell, s.heat.thermal_deformation,
          mean_of_rings(s.model, q.shaft)};
}

/// Walls on other cells.
WallMeans carry_over(const BearingModel& from, const WallMeans& walls, const BearingModel& to) {
  HeatState state;
  state.T_shell = walls.shell;
  state.T_shaft = walls.shaft;
  state.thermal_deformation = walls.thermal_deformation;
  state = carry_over(from, state, to);
  WallMeans out{state.T_shell, state.T_shaft,
                interpolate(from.domain.grid, walls.flux, to.domain.grid),
                state.thermal_deformation};
  for (int c = 0; c < to.domain.grid.cells(); ++c) {
    if (!meets_walls(to, c)) out.flux[c] = 0.0;  // it is answered by itself: no swing
  }
  return out;
}

}  // namespace

void CyclePasses::begin_film(double T, const WallMeans* walls) {
  std::optional<FilmInTime> begun;
  r_.verdict = {};
  const bool event = !c_.cycle->repeats();
  if (event) {
    begun = film_.steady(T, walls ? walls->thermal_deformation : Field{}, cost_, control_.stop);
    if (begun && walls) begun->thermal_deformation = mean_deformation(*walls);
  }
  if (event && !begun && stopped(control_)) r_.verdict = {Status::interrupted};
  from_rest_ = !begun.has_value();
  now_ = begun ? *std::move(begun) : film_.at_rest(T);
  if (walls && !put(*walls)) return;
  if (!from_rest_) carry_oil_round();
}

void CyclePasses::carry_oil_round() {
  constexpr int kTurnsBefore = 4;   // two laps: oil goes round at half the journal's speed
  constexpr int kStepsOfTurn = 16;  // the film that stays is the same in any steps
  const double omega = std::abs(course_.begins().omega);
  if (!(omega > 0.0) || film_.drillings().any() || film_.vessels().any()) return;
  const double dt = 2.0 * kPi / omega / kStepsOfTurn;
  FilmInTime now = now_;
  for (int k = kTurnsBefore * kStepsOfTurn; k > 0; --k) {
    now.t = -k * dt;  // an event stands there in its first row
    FilmStep step = film_.take(dt, now, cost_, control_.stop);
    if (step.verdict.status == Status::interrupted) r_.verdict = step.verdict;
    if (!step.verdict.good()) return;  // it begins with the oil of the steady film
    now = std::move(step.after);
    FilmSteps::hold_walls(now);  // oil is carried beside walls that stand
  }
  now.t = 0.0;
  now_ = std::move(now);
}

void CyclePasses::begin(double T) {
  const bool heat = film_.model().physics.film_energy;
  r_.verdict = {};
  const bool event = heat && !c_.cycle->repeats();
  if (event && begin_warm()) return;  // else, unless stopped, from cold
  begun_cold_ = event;
  const double begun = event ? mean_supply_temperature(c_) : T;
  if (!heat) return begin_film(begun);
  const WallMeans walls = uniform_walls(film_.model(), begun);
  if (!c_.cycle->repeats()) return begin_film(begun, &walls);
  begin_film(begun);
  walls_ = walls;  // they are put on with the first cycle
}

void CyclePasses::begin_between(const WallMeans& walls, double T) { begin_film(T, &walls); }

void CyclePasses::set_temperature(double T) {
  if (!c_.cycle->repeats()) return begin(T);
  std::fill(now_.film.columns.T.begin(), now_.film.columns.T.end(), T);
  if (!now_.layer.now.empty()) {  // marks of another temperature are none of this one
    now_.layer = {Columns(now_.layer.now.size()), {}, 0.0};
    now_.oil_slope.clear();
  }
  r_.verdict = {};
}

bool CyclePasses::begin_warm() {
  const LoadNow first = course_.begins();
  Case steady = c_;
  steady.cycle.reset();
  steady.model.axial_spacing = axial_spacing(c_);  // the cells of the event
  steady.operation.omega = first.omega;
  steady.operation.position = LoadGiven{std::hypot(first.x, first.y), std::atan2(first.y, first.x)};
  if (first.omega == 0.0 || !(std::hypot(first.x, first.y) > 0.0)) return false;
  if (film_.drillings().any()) return false;  // a steady bearing knows none
  const Solution s = solve_tier(steady, tier_, control_, film_.model().solids);
  cost_.newton_iterations += s.cost.newton_iterations;
  cost_.factorizations += s.cost.factorizations;
  if (!s.verdict.good()) return false;
  now_ = film_.at_rest(s.film.columns.T.front());
  now_.film = s.film;
  now_.film.film = filled_as_carried(s.model, s.point, s.film.film);
  now_.film.contact_widening.reset();
  now_.layer.now.clear();
  for (const solid::PressedColumn& c : s.film.layer) now_.layer.now.push_back(c.now);
  const WallMeans walls = steady_walls(s);
  now_.thermal_deformation = mean_deformation(walls);
  from_rest_ = false;
  if (!put(walls)) return true;
  carry_oil_round();
  film_.rest_walls(now_);
  walls_ = film_.heat()->walls;
  return true;
}

void CyclePasses::begin(const CycleStart& from) {
  const BearingModel& to = film_.model();
  now_ = film_.at_rest(from.now.film.columns.T.front());
  now_.film = carry_over(from.model, from.now.film, to);
  now_.velocity = from.now.velocity;
  now_.thermal_deformation = from.now.thermal_deformation;
  now_.vessels = from.now.vessels;
  walls_ = carry_over(from.model, from.walls, to);
  response_ = from.response;
  measured_ = from.measured;
  carried_over_ = true;
}

bool CyclePasses::begin_reshaped(const CyclePasses& other, const std::optional<WallMeans>& walls) {
  now_ = other.now_;
  film_.put_back(other.film_.supplies());
  periods_.repeat(other.periods_);
  response_ = other.response_;
  measured_ = other.measured_;
  from_rest_ = false;
  if (walls) return put(*walls);
  if (!film_.reshape(now_)) {
    r_.verdict = {Status::iteration_limit, ending::NoClearance{0.0, film_.model().clearance}};
  }
  return r_.verdict.good();
}

}  // namespace shellback::bearing
