#include "bearing/heat/wall_balance.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/fixed_point.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {

WallBalance::WallBalance(Solution& s, const HeatStep* step) : s_(s), step_(step) {}

thermal::FilmEnergyProblem WallBalance::problem(const Friction& friction) const {
  std::optional<thermal::FilmStorage> storage;
  if (step_) {
    const Field mass =
        per_cell(s_.model.domain.grid,
                 fluid::oil_content(s_.point.scene, s_.film.gap, s_.film.oil, s_.film.film));
    storage = thermal::FilmStorage{step_->dt, mass, mass,
                                   thermal::heat_content(mass, step_->enthalpy_before)};
  }
  return film_energy_problem(s_.model, s_.point, s_.film, friction, std::move(storage));
}

void WallBalance::read_from_film() {
  const FilmGrid& g = s_.model.domain.grid;
  const auto& T = s_.film.columns.T;
  const int n = s_.model.gl.n;
  for (int c = 0; c < g.cells(); ++c) {
    if (meets_walls(s_.model, c)) s_.heat.T_shell[c] = T[c * n];
  }
  for (int j = 0; j < g.nz; ++j) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < g.nt; ++i) {
      const int c = g.index(i, j);
      if (!meets_walls(s_.model, c)) continue;
      sum += T[c * n + n - 1];
      ++count;
    }
    if (count > 0) s_.heat.T_shaft[j] = sum / count;
  }
}

void WallBalance::begin(const Friction& friction, int iteration) {
  constexpr int kAgain = 4;  // iteration that measures it again; till then that of a coarser grid
  energy_.emplace(problem(friction));
  for (int k = 0; k < kSweepsOfResponse; ++k) energy_->sweep(s_.film.columns.T);
  if (!(s_.heat.response.shell_local > 0.0) || iteration == kAgain) {
    s_.heat.response = energy_->wall_response(kSweepsOfResponse);
  }
}

void WallBalance::balance_roughly(double tolerance) {
  constexpr double kWallPart = 0.03;  // of the first round's change: what is left for later
  const double change = round();
  const double enough = kWallPart * std::max(change, tolerance);
  if (change > enough) balance(enough, kMostIterations);
  for (int k = 0; k < kSweepsOfResponse; ++k) energy_->sweep(s_.film.columns.T);
}

void WallBalance::deform() {
  warm_the_walls({true, false});
  take_wall_temperatures();
  if (!s_.heat.thermal_deformation.empty())
    s_.heat.thermal_deformation = s_.heat.solids.thermal_deformation;
}

void WallBalance::impose_walls() {
  const FilmGrid& g = s_.model.domain.grid;
  const int n = s_.model.gl.n;
  for (int c = 0; c < g.cells(); ++c) {
    if (!meets_walls(s_.model, c)) continue;
    s_.film.columns.T[c * n] = s_.heat.T_shell[c];
    s_.film.columns.T[c * n + n - 1] = s_.heat.T_shaft[c % g.nz];
  }
}

void WallBalance::warm_the_walls(Solids::Wanted wanted) {
  const FilmGrid& g = s_.model.domain.grid;
  const thermal::WallHeat walls = energy_->wall_heat(s_.film.columns.T);
  const ContactHeat rubbed = contact_heat(s_.model, s_.point, s_.film);
  WallFlux q{walls.shell, std::vector<double>(g.nz, 0.0), s_.heat.response};
  s_.heat.contact_heat = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      q.shell[c] = q.shell[c] / g.area(i, j) + rubbed.shell[c];
      q.shaft[j] += (walls.shaft[c] / g.area(i, j) + rubbed.shaft[c]) * g.dphi[i] / (2.0 * kPi);
      s_.heat.contact_heat += g.multiplicity() * g.area(i, j) * (rubbed.shell[c] + rubbed.shaft[c]);
    }
  }
  s_.heat.solids =
      s_.model.solids->answer(q, s_.heat.T_shell, s_.heat.T_shaft, wanted, solid_step());
}

double WallBalance::take_wall_temperatures() {
  HeatState& h = s_.heat;
  const double change = larger(largest_difference(h.solids.shell.surface, h.T_shell),
                               largest_difference(h.solids.shaft.temperature, h.T_shaft));
  h.T_shell = h.solids.shell.surface;
  h.T_shaft = h.solids.shaft.temperature;
  impose_walls();
  return change;
}

double WallBalance::round() {
  for (int k = 0; k < kSweepsOfResponse; ++k) energy_->sweep(s_.film.columns.T);
  warm_the_walls({false, false});
  return take_wall_temperatures();
}

double WallBalance::balance(double enough, int rounds) {
  constexpr int kDepth = 12;
  const auto cells = static_cast<std::ptrdiff_t>(s_.heat.T_shell.size());
  double least = INFINITY;  // of the best round: the walls are left as they were there
  std::vector<double> best_T = s_.film.columns.T;
  HeatState best = s_.heat;
  const auto map = [&](const std::vector<double>& x, std::vector<double>& g) {
    std::copy_n(x.begin(), cells, s_.heat.T_shell.begin());
    std::copy(x.begin() + cells, x.end(), s_.heat.T_shaft.begin());
    impose_walls();
    const double change = round();
    if (change < least) {
      least = change;
      best_T = s_.film.columns.T;
      best = s_.heat;
    }
    g = s_.heat.T_shell;
    g.insert(g.end(), s_.heat.T_shaft.begin(), s_.heat.T_shaft.end());
    return true;
  };
  std::vector<double> x = s_.heat.T_shell;
  x.insert(x.end(), s_.heat.T_shaft.begin(), s_.heat.T_shaft.end());
  if (fixed_point(map, {kDepth, 1, rounds, enough}, x) != FixedPointEnd::converged) {
    s_.film.columns.T = best_T;
    s_.heat = best;
  }
  return least;
}

void WallBalance::settle_film(double enough) {
  constexpr int kMostSweeps = 400;  // oil that returns by nine tenths needs 150
  for (int k = 0; k < kMostSweeps; ++k) {
    if (energy_->sweep(s_.film.columns.T) < enough) break;
  }
}

double WallBalance::change_for_ever(const Friction& friction) {
  energy_.emplace(problem(friction));
  settle_film(kKnownTemperature);
  warm_the_walls({false, false});
  return larger(largest_difference(s_.heat.solids.shell.surface, s_.heat.T_shell),
                largest_difference(s_.heat.solids.shaft.temperature, s_.heat.T_shaft));
}

double WallBalance::finish(const Friction& friction, bool close) {
  constexpr double kSettled = 1e-9;         // change per round of walls, per sweep of the film [K]
  constexpr double kRoughlySettled = 1e-3;  // the same where the balance need not close [K]
  energy_.emplace(problem(friction));
  const double change = close ? balance(kSettled, kMostIterations) : 0.0;
  settle_film(close ? kSettled : kRoughlySettled);
  warm_the_walls({true, true});
  s_.heat.balance = energy_->balance(s_.film.columns.T);
  s_.heat.T_mix = energy_->mix_temperatures();
  for (std::size_t k = 0; k < s_.heat.T_mix.size(); ++k) {
    s_.heat.T_mix[k] = told_temperature(s_.model, s_.heat.T_mix[k], energy_->cp_of_vessel(k));
  }
  const std::vector<int>& vessel = s_.point.scene.supply.touching;
  for (std::size_t k = 0; k < vessel.size(); ++k) s_.heat.T_mix[k] = s_.heat.T_mix[vessel[k]];
  s_.heat.backflow_nodes = energy_->backflow_nodes();
  s_.heat.blended_columns = energy_->blended_columns();
  return change;
}

}  // namespace shellback::bearing
