#include "coupling/thermal_turn.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/largest.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::coupling {
namespace {

constexpr int kLaps = 3;  ///< sweeps for the film's response to its walls
constexpr int kResponseTurn =
    4;  ///< in which that is measured again; a coarser grid's does till then

}  // namespace

std::vector<double> ThermalTurn::pack() const {
  std::vector<double> x;
  const double T0 = model_.input.supplies.front().temperature;
  for (const double T : film_.columns.T) x.push_back((T - T0) / kTemperatureUnit);
  for (const double d : heat_.growth) x.push_back(d / model_.clearance);
  return x;
}

void ThermalTurn::take_contact_growth() {
  const Physics& has = model_.physics;
  if (film_.contact_growth || !model_.contact || !has.elastic || !has.growth) return;
  if (!(heat_.response.shell_local > 0.0) || film_.p_contact.empty()) return;
  film_.contact_growth = std::make_shared<HarmonicOperator>(
      model_.solids->contact_growth(contact_heat_rate(model_).shell, heat_.response));
  const Field own = model_.solids->widening(*film_.contact_growth, film_.p_contact);
  for (std::size_t k = 0; k < own.size(); ++k) {
    heat_.growth[k] -= own[k];
    film_.elastic[k] += own[k];
  }
}

void ThermalTurn::give_contact_growth() {
  if (!film_.contact_growth) return;
  const Field own = model_.solids->widening(*film_.contact_growth, film_.p_contact);
  for (std::size_t k = 0; k < own.size(); ++k) {
    heat_.growth[k] += own[k];
    film_.elastic[k] -= own[k];
  }
  film_.contact_growth.reset();
}

/// No tighter than the temperatures are known: the map's noise stays well below its change.
EquilibriumOptions ThermalTurn::film_options() const {
  constexpr double kNoise = 1e-2;  // of the last change
  EquilibriumOptions o = options_.film;
  const double noise = turns_ <= 1 ? kNoise : kNoise * std::min(heat_.residual, 1.0);
  o.film_tolerance = std::max(o.film_tolerance, noise);
  o.load_tolerance = std::max(o.load_tolerance, noise);
  o.elastic_tolerance = std::max(o.elastic_tolerance, noise);
  o.viscosity_tolerance = std::max(o.viscosity_tolerance, noise);
  return o;
}

Verdict ThermalTurn::solve_film(const Place& from) {
  constexpr double kShortestStep = 1.0 / 32.0;
  const EquilibriumOptions options = film_options();
  const fluid::FilmState film = film_.film;
  const fluid::JournalPosition position = film_.position;
  const Field elastic = film_.elastic;
  const auto solve = [&](const Field& growth) {
    return solve_equilibrium(model_, target_, growth, options, film_, cost_, control_.stop);
  };
  Verdict verdict = solve(heat_.growth);
  const bool at_once = from.T.empty() || !options_.patient;
  if (verdict.good() || verdict.status == Status::interrupted || at_once) return verdict;
  const Place to{film_.columns.T, heat_.growth};
  film_.film = film;
  film_.position = position;
  film_.elastic = elastic;
  FilmEquilibrium reached = film_;
  double done = 0.0;
  for (double step = 0.25; done < 1.0;) {
    const double here = std::min(1.0, done + step);
    Field growth = to.growth;
    for (std::size_t k = 0; k < to.T.size(); ++k) {
      film_.columns.T[k] = from.T[k] + here * (to.T[k] - from.T[k]);
    }
    for (std::size_t k = 0; k < growth.size(); ++k) {
      growth[k] = from.growth[k] + here * (to.growth[k] - from.growth[k]);
    }
    verdict = solve(growth);
    if (verdict.good()) {
      reached = film_;
      done = here;
      step *= 2.0;
      continue;
    }
    if (verdict.status == Status::interrupted || step < kShortestStep) break;
    film_ = reached;
    step *= 0.25;
  }
  film_.columns.T = to.T;
  return verdict;
}

/// Warmer oil is thinner and makes less heat: the map answers a rise by -beta (T - T_supply) of it.
/// Taking this part of the change cancels that answer for the mean of the film.
double ThermalTurn::relaxation(const std::vector<double>& g) const {
  double mean = 0.0;
  const std::size_t nodes = film_.columns.T.size();
  for (std::size_t k = 0; k < nodes; ++k) mean += g[k];
  const double rise = kTemperatureUnit * mean / static_cast<double>(nodes);
  const double T = model_.input.supplies.front().temperature + rise;
  const double beta = -rheology::viscosity_slopes(model_.oil, T, 0.0, 0.0).dln_dT;
  return 1.0 / (1.0 + std::max(beta * rise, 0.0));
}

/// Oil that is still cold makes far more heat in one turn than it will once warm, and the solids
/// answer that heat: what this leads to is no state, and no turn goes farther towards it than this.
void ThermalTurn::limit_change(const std::vector<double>& x, std::vector<double>& g) {
  constexpr double kMostChange = 100.0 / kTemperatureUnit;  // of a temperature
  constexpr double kMostClosing = 0.5;  // of the gap, over the smallest film and the roughness [-]
  const std::size_t nodes = film_.columns.T.size();
  const std::vector<double> wanted = g;
  for (std::size_t k = 0; k < nodes; ++k) {
    g[k] = x[k] + std::clamp(g[k] - x[k], -kMostChange, kMostChange);
  }
  const double room = std::max(film_.least.h, 0.0) + 3.0 * model_.scene.rough.sigma;
  for (std::size_t k = nodes; k < x.size(); ++k) {
    g[k] = std::max(g[k], x[k] - kMostClosing * room / model_.clearance);
  }
  limited_ = false;
  for (std::size_t k = 0; k < g.size(); ++k) {
    limited_ = limited_ || std::abs(wanted[k] - g[k]) > options_.tolerance;
  }
}

void ThermalTurn::unpack(const std::vector<double>& x) {
  const FilmGrid& g = model_.scene.grid;
  const double T0 = model_.input.supplies.front().temperature;
  const std::size_t nodes = film_.columns.T.size();
  for (std::size_t k = 0; k < nodes; ++k) film_.columns.T[k] = T0 + kTemperatureUnit * x[k];
  for (std::size_t k = 0; k < heat_.growth.size(); ++k) {
    heat_.growth[k] = model_.clearance * x[nodes + k];
  }
  const int n = model_.gl.n;  // the walls' temperatures travel as the film's wall nodes
  for (int c = 0; c < g.cells(); ++c) {
    if (model_.scene.supply.cell[c] < 0) heat_.T_shell[c] = film_.columns.T[c * n];
  }
  for (int j = 0; j < g.nz; ++j) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < g.nt; ++i) {
      const int c = g.index(i, j);
      if (model_.scene.supply.cell[c] >= 0) continue;
      sum += film_.columns.T[c * n + n - 1];
      ++count;
    }
    if (count > 0) heat_.T_shaft[j] = sum / count;
  }
}

thermal::FilmEnergy ThermalTurn::film_energy() {
  friction_ = friction_of(model_, film_);
  return thermal::FilmEnergy(film_energy_problem(model_, film_, friction_));
}

void ThermalTurn::report(const std::vector<double>& x, const std::vector<double>& g) {
  heat_.residual = largest_difference(g, x);
  const double signed_torque = friction_.viscous + friction_.asperity;
  history_.push_back({"thermal", heat_.residual, signed_torque, film_.least.h});
  if (control_.progress) {
    control_.progress(
        {to_string(model_.input.model.tier), turns_, heat_.residual, signed_torque, film_.least.h});
  }
}

bool ThermalTurn::operator()(const std::vector<double>& x, std::vector<double>& g) {
  // Within a turn the walls come to balance but for this part of their first change: they answer
  // the film slowly, and each of their rounds costs far less than a film.
  constexpr double kWallPart = 0.1;
  constexpr int kWallRounds = 6;
  ++turns_;
  unpack(x);
  if (!sound()) return false;
  const Place before{std::move(turn_T_), std::move(turn_growth_)};
  turn_T_ = film_.columns.T;
  turn_growth_ = heat_.growth;
  verdict_ = solve_film(before);
  if (!verdict_.good()) {
    name_the_failure();
    return false;
  }
  thermal::FilmEnergy energy = film_energy();
  for (int k = 0; k < options_.sweeps; ++k) energy.sweep(film_.columns.T);
  if (!finite()) return false;
  if (!(heat_.response.shell_local > 0.0) || turns_ == kResponseTurn) {
    heat_.response = energy.wall_response(kLaps);
  }
  const double change = wall_round(energy);
  const double enough =
      std::max(kWallPart * change, kWallPart * kTemperatureUnit * options_.tolerance);
  if (change > enough) balance_walls(energy, enough, kWallRounds);
  for (int k = 0; k < options_.sweeps; ++k) energy.sweep(film_.columns.T);
  if (!finite()) return false;
  warm_the_walls(energy, {true, false});
  take_wall_temperatures();
  if (!heat_.growth.empty()) {
    heat_.growth = heat_.solids.growth;
    if (film_.contact_growth) {
      const Field own = model_.solids->widening(*film_.contact_growth, film_.p_contact);
      for (std::size_t k = 0; k < own.size(); ++k) heat_.growth[k] -= own[k];
    } else {
      take_contact_growth();  // the film's response is known from the first turn on
    }
  }
  if (!finite()) return false;
  g = pack();
  limit_change(x, g);
  const double part = relaxation(g);
  for (std::size_t k = 0; k < g.size(); ++k) g[k] = x[k] + part * (g[k] - x[k]);
  report(x, g);
  last_ = g;
  if (heat_.residual < best_.residual) {
    best_ = {heat_.residual, torque(), film_, heat_, turn_T_, turn_growth_};
  }
  return true;
}

void ThermalTurn::take_last_value() {
  unpack(last_);
  turn_T_ = film_.columns.T;
  turn_growth_ = heat_.growth;
}

}  // namespace shellback::coupling
