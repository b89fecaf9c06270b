#include "bearing/heat_march.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/heat_endings.hpp"
#include "bearing/step_control.hpp"
#include "bearing/told_ranges.hpp"
#include "bearing/wall_balance.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

using Walls = MarchStand::Walls;

/// Half the distance of the walls from where the last step's rate would have led them: the local
/// error of backward Euler, as dt^2 T''/2 [K].
double local_error(const Walls& now, const Walls& before, const Walls& rate, double dt) {
  double most = 0.0;
  const auto look = [&](const auto& a, const auto& b, const auto& r) {
    for (std::size_t k = 0; k < a.size(); ++k) {
      most = larger(most, std::abs(a[k] - b[k] - (r.empty() ? 0.0 : dt * r[k])));
    }
  };
  look(now.shell, before.shell, rate.shell);
  look(now.shaft, before.shaft, rate.shaft);
  return 0.5 * most;
}

double largest_move(const Walls& now, const Walls& before) {
  return larger(largest_difference(now.shell, before.shell),
                largest_difference(now.shaft, before.shaft));
}

Walls rate_of(const Walls& now, const Walls& before, double dt) {
  Walls rate = now;
  for (std::size_t k = 0; k < rate.shell.size(); ++k) {
    rate.shell[k] = (rate.shell[k] - before.shell[k]) / dt;
  }
  for (std::size_t k = 0; k < rate.shaft.size(); ++k) {
    rate.shaft[k] = (rate.shaft[k] - before.shaft[k]) / dt;
  }
  return rate;
}

/// `s`: the last instant that was found; `v`: why there is none after it.
bool no_film_left(const Solution& s, const Verdict& v) {
  const auto& contact = s.model.contact;
  const bool pressed = contact && s.film.least.h < contact->least_gap();
  return v.status == Status::no_steady_state || pressed || thinner_than_a_molecule(s.model, s.film);
}

/// True if the heat that enters the walls now would hold them for ever where they are. That they do
/// not move says little: heat from the back may not have reached them yet.
bool is_at_rest(const Solution& s) {
  constexpr double kRest = 0.03;  // ten times what an iteration may leave [K]
  Solution now = s;
  WallBalance walls(now, kSweepsOfResponse, nullptr);
  return walls.change_for_ever(friction_of(s.model, s.point, s.film)) < kRest;
}

}  // namespace

void tell_bodies(const FilmGrid& g, const SolidTemperature& solids,
                 const thermal::EnergyBalance& film, double films, const Field& deformation,
                 Instant& i) {
  i.T_shell_back = area_mean(g, solids.shell.back);
  for (int j = 0; j < g.nz; ++j) i.T_shaft += solids.shaft.temperature[j] * g.dz[j];
  i.T_shaft /= g.z_face.back() - g.z_face.front();
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
  i.torque = f.viscous + f.asperity;
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

MarchEnd march_heat(Solution& s, MarchStand& stand, const MarchOptions& o,
                    const SolveControl& control, const std::function<void(const Instant&)>& tell) {
  const double still = kHeatUnit * ThermalOptions{}.tolerance;  // what one iteration may leave [K]
  const bool accurate = std::isfinite(o.error);
  auto& [bodies, end, dt, rate, calm] = stand;
  if (dt == 0.0) dt = o.first;
  SolidStep last;
  while (!end.at_rest && end.t < o.end && dt <= o.longest) {
    const double length = std::min(dt, o.end - end.t);
    HeatStep step{s.model.solids->step(length, bodies, &last), length,
                  film_enthalpy(s.model, s.film.columns.T)};
    const FilmEquilibrium film = s.film;
    const HeatState heat = s.heat;
    end.verdict = solve_heat(s, o.heat, control, &step);
    const Walls before{heat.T_shell, heat.T_shaft};
    const Walls now{s.heat.T_shell, s.heat.T_shaft};
    const double error = accurate ? local_error(now, before, rate, length) : 0.0;
    const bool shortest = dt <= o.shortest;
    if (!end.verdict.good() || (error > o.error && !shortest)) {
      const bool hot =
          largest(s.film.columns.T) > mean_supply_temperature(s.model.input) + kHottestRise;
      s.film = film;
      s.heat = heat;
      const bool given_up = end.verdict.status == Status::interrupted || s.cost.spent();
      if (given_up || shortest) {
        end.left_bounds = !given_up && (hot || no_film_left(s, end.verdict));
        return end;
      }
      dt *= end.verdict.good() ? 1.0 / kStepLonger : kStepShorter;
      calm = 0;
      continue;
    }
    if (error > o.error) ++end.jumps;
    rate = rate_of(now, before, length);
    bodies = s.model.solids->state(s.heat.solids, &step.solids);
    end.t += length;
    last = std::move(step.solids);
    end.at_rest = accurate && largest_move(now, before) < still && is_at_rest(s);
    ++calm;
    if (!accurate && calm > MarchStand::kCalm) dt /= kStepShorter;
    // A step so much longer errs by the square of that.
    const bool easily = std::pow(kStepLonger, kStepOrderAnew) * error <= o.error;
    if (accurate && easily && calm > 1) dt *= kStepLonger;
    if (tell) tell(instant_of(s, end.t, length));
  }
  end.verdict = {};
  end.at_rest = end.at_rest || dt > o.longest;
  return end;
}

}  // namespace shellback::bearing
