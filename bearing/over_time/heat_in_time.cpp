#include "bearing/over_time/heat_in_time.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bearing/heat_state.hpp"
#include "bearing/temperature_limits.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {
namespace {

std::vector<thermal::SkinLayer> skin_layers(const Case& c) {
  const Solids::Layers layers = wall_layers(c);
  std::vector<thermal::SkinLayer> out;
  for (std::size_t k = 0; k < layers.thickness.size(); ++k) {
    const solid::Material& m = layers.material[k];
    const double held = (1.0 + m.poisson_ratio) / (1.0 - m.poisson_ratio);
    out.push_back(
        {layers.thickness[k], m.conductivity, m.density * m.heat_capacity, held * m.expansion});
  }
  return out;
}

/// Sweeps until nothing changes any more but by round-off of the balance; false if it still does.
bool settle(thermal::FilmEnergy& energy, std::vector<double>& T) {
  for (int k = 0; k < kMostIterations; ++k) {
    if (energy.sweep(T) <= kKnownTemperature) return true;
  }
  return false;
}

bool possible(const std::vector<double>& T) {
  return std::all_of(T.begin(), T.end(),
                     [](double t) { return t > kColdestOil && t < kHottestOil; });
}

/// (7) of thermal/film_energy.hpp for the oil that `s` expects in the supplies.
void let_supplies_thin(const BearingModel& model, const FilmEquilibrium& s,
                       thermal::FilmEnergyProblem& problem) {
  const int n = model.gl.n;
  for (int c = 0; c < model.domain.grid.cells(); ++c) {
    if (problem.patch[c] < 0) continue;
    thermal::SupplyVessel& v = problem.vessels[problem.patch[c]];
    v.T_sheared = s.columns.T[static_cast<std::size_t>(c) * n + n / 2];
    const double dln_dT =
        rheology::viscosity_slopes(model.oil, v.T_sheared, s.film.p[c], 0.0).dln_dT;
    v.thinning = std::max(-dln_dT, 0.0);
  }
}

}  // namespace

WallMeans uniform_walls(const BearingModel& model, double T) {
  const FilmGrid& g = model.domain.grid;
  return {Field(g.cells(), T), std::vector<double>(g.nz, T), Field(g.cells(), 0.0),
          model.solids->at(model.solids->uniform_state(T)).thermal_deformation};
}

double mean_deformation(const WallMeans& walls) {
  const Field& x = walls.thermal_deformation;
  if (x.empty()) return 0.0;
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

void HeatFlows::add(double f, const HeatFlows& other) {
  if (to_shell.empty()) {
    to_shell.assign(other.to_shell.size(), 0.0);
    to_shaft.assign(other.to_shaft.size(), 0.0);
  }
  for (std::size_t c = 0; c < to_shell.size(); ++c) {
    to_shell[c] += f * other.to_shell[c];
    to_shaft[c] += f * other.to_shaft[c];
  }
  balance.heat += f * other.balance.heat;
  balance.to_shell += f * other.balance.to_shell;
  balance.to_shaft += f * other.balance.to_shaft;
  balance.carried_out += f * other.balance.carried_out;
  balance.carried_in += f * other.balance.carried_in;
  balance.stored += f * other.balance.stored;
  rubbed += f * other.rubbed;
  work += f * other.work;
}

HeatSteps::HeatSteps(const BearingModel& model, double period, double shortest)
    : skin_(skin_layers(model.input), period, shortest) {}

HeatInTime HeatSteps::begin(const BearingModel& model, std::vector<double> T,
                            const Field& mass) const {
  HeatInTime heat;
  heat.held = thermal::heat_content(mass, film_enthalpy(model, T));
  heat.T = std::move(T);
  heat.skin.assign(mass.size() * skin_.nodes(), 0.0);
  return heat;
}

thermal::YieldingShell HeatSteps::free_shell(const FilmGrid& g, const thermal::SkinStep& step,
                                             Field rubbed, std::vector<double>& skin) const {
  thermal::YieldingShell shell{step.impedance(), Field(g.cells()), std::move(rubbed)};
  for (int c = 0; c < g.cells(); ++c) {
    double* T = &skin[static_cast<std::size_t>(c) * skin_.nodes()];
    skin_.relax(step, T);
    shell.free[c] = walls.shell[c] + T[0] - step.impedance() * walls.flux[c];
  }
  return shell;
}

void HeatSteps::heat_skin(const thermal::SkinStep& step, const std::vector<double>& before,
                          HeatStage& out) const {
  const auto nodes = static_cast<std::size_t>(skin_.nodes());
  for (std::size_t c = 0; c < walls.flux.size(); ++c) {
    const double beyond = out.flows.to_shell[c] - walls.flux[c];
    for (std::size_t k = 0; k < nodes; ++k) out.skin[c * nodes + k] += step.by_flux[k] * beyond;
  }
  out.skin_slope.resize(before.size());
  for (std::size_t k = 0; k < before.size(); ++k) {
    out.skin_slope[k] = (out.skin[k] - before[k]) / step.dt;
  }
}

HeatStage HeatSteps::stage(const BearingModel& model, const OperatingPoint& point,
                           const FilmEquilibrium& s, double own, const Field& before,
                           const Field& after, const std::vector<double>& held,
                           const std::vector<double>& skin) const {
  const FilmGrid& g = model.domain.grid;
  const int n = model.gl.n;
  const auto film = [&](int c) { return model.supply.cell[c] < 0; };
  const ContactHeat rubbed = contact_heat(model, point, s);
  HeatStage out;
  out.skin = skin;
  const thermal::SkinStep step = skin_.over(own);
  const Friction friction = friction_of(model, point, s);
  thermal::FilmEnergyProblem problem = film_energy_problem(
      model, point, s, friction, thermal::FilmStorage{own, after, before, held});
  problem.shell = free_shell(g, step, rubbed.shell, out.skin);
  out.T = s.columns.T;
  for (int c = 0; c < g.cells(); ++c) {
    if (!meets_walls(model, c)) continue;
    out.T[static_cast<std::size_t>(c) * n + n - 1] = walls.shaft[c % g.nz];
  }
  let_supplies_thin(model, s, problem);
  const std::vector<double> cp = problem.cp;
  const double T_ref = problem.T_reference;
  thermal::FilmEnergy energy(std::move(problem));
  out.settled = settle(energy, out.T);
  out.possible = possible(out.T);
  out.flows.balance = energy.balance(out.T);
  out.flows.work = friction.torque() * point.scene.speed / g.radius + pump_power(model, point, s) +
                   energy.heat_of_thinning() * g.multiplicity();
  const thermal::WallHeat into = energy.wall_heat(out.T);
  out.flows.to_shell = walls.flux;  // of supplies that exchange no heat: no swing
  out.flows.to_shaft.assign(g.cells(), 0.0);
  out.held_slope.assign(out.T.size(), 0.0);
  for (int c = 0; c < g.cells(); ++c) {
    if (!meets_walls(model, c)) continue;
    const double area = g.area(c);
    out.flows.to_shell[c] = into.shell[c] / area + rubbed.shell[c];
    out.flows.to_shaft[c] = into.shaft[c] / area + rubbed.shaft[c];
    out.flows.rubbed += area * (rubbed.shell[c] + rubbed.shaft[c]);
    for (int k = 0; k < n && film(c); ++k) {
      const std::size_t at = static_cast<std::size_t>(c) * n + k;
      out.held_slope[at] = (after[c] * cp[at] * (out.T[at] - T_ref) - held[at]) / own;
    }
  }
  heat_skin(step, skin, out);
  return out;
}

Field HeatSteps::swelling(const std::vector<double>& skin) const {
  Field narrower(skin.empty() ? 0 : walls.thermal_deformation.size());
  const auto nodes = static_cast<std::size_t>(skin_.nodes());
  for (std::size_t c = 0; c < narrower.size(); ++c) narrower[c] = skin_.swelling(&skin[c * nodes]);
  return narrower;
}

double HeatSteps::surprise(const BearingModel& model, const FilmEquilibrium& s,
                           const std::vector<double>& T) const {
  const FilmGrid& g = model.domain.grid;
  const int n = model.gl.n;
  double sum = 0.0;
  double load = 0.0;
  for (int c = 0; c < g.cells(); ++c) {
    if (model.supply.cell[c] >= 0 || !s.film.full[c]) continue;
    double off = 0.0;
    for (int k = 0; k < n; ++k) {
      const std::size_t at = static_cast<std::size_t>(c) * n + k;
      off += model.gl.w[k] * (T[at] - s.columns.T[at]);
    }
    const double weight = std::max(s.film.p[c], 0.0) * g.area(c);
    const double by_T =
        rheology::viscosity_slopes(model.oil, s.columns.T_mean[c], s.film.p[c], 0.0).dln_dT;
    sum += weight * std::abs(off * by_T);
    load += weight;
  }
  return load > 0.0 ? sum / load : 0.0;
}

thermal::FilmEnergyProblem lasting_film(const BearingModel& model, const OperatingPoint& point,
                                        const FilmEquilibrium& s) {
  const FilmGrid& g = model.domain.grid;
  const double dt = 1.0;  // [s]; only the rate of M counts
  Field gained = fluid::net_outflow(point.scene, s.flow);
  Field lost = gained;
  for (std::size_t c = 0; c < gained.size(); ++c) {
    gained[c] = std::max(-dt * gained[c], 0.0);
    lost[c] = std::max(dt * lost[c], 0.0);
  }
  const std::vector<double> none(static_cast<std::size_t>(g.cells()) * model.gl.n, 0.0);
  return film_energy_problem(model, point, s, friction_of(model, point, s),
                             thermal::FilmStorage{dt, gained, lost, none});
}

}  // namespace shellback::bearing
