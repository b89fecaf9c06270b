#include "bearing/over_time/heat_in_time.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bearing/heat_state.hpp"
#include "bearing/temperature_limits.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {
namespace {

bool is_event(const BearingModel& m) { return m.input.cycle && !m.input.cycle->repeats(); }

/// Period to whose depth a skin must reach: heat that flows on over an event goes twice as deep as
/// one that swings so long (of what swells by it a hundredth lies deeper).
double reach_of(const BearingModel& m, double length) {
  return is_event(m) ? 4.0 * length : length;
}

/// Layers that a skin of the shell may go through: a given temperature is that of the shell's back,
/// before a housing.
std::size_t layers_of_skin(const Case& c, const Solids::Layers& all) {
  const bool cooled = std::holds_alternative<ConvectiveBack>(c.shell->back);
  return cooled ? all.thickness.size() : all.last_of_shell + 1;
}

thermal::SkinLayer skin_layer(const solid::Material& m, double thickness) {
  return {thickness, m.conductivity, m.density * m.heat_capacity};
}

thermal::WallSkin shell_skin(const Case& c, double period, double shortest) {
  const Solids::Layers layers = wall_layers(c);
  const auto* cooled = std::get_if<ConvectiveBack>(&c.shell->back);
  std::vector<thermal::SkinLayer> out;
  for (std::size_t k = 0; k < layers_of_skin(c, layers); ++k) {
    out.push_back(skin_layer(layers.material[k], layers.thickness[k]));
  }
  return {out, period, shortest, cooled ? cooled->heat_transfer : INFINITY, 1.0 / c.bearing.radius};
}

/// The shaft's surface, ring by ring, while the film settles: (2) of the header. What it takes less
/// where it is warmer by one kelvin, the film at rest, is more than the settled film makes of it: a
/// change goes by what that leaves of it. In a short step nearly all of it is stored in the oil on
/// the surface: m cp/dt, beyond all conductances.
class TurningSurface {
 public:
  TurningSurface(const BearingModel& model, double impedance, std::vector<double> free,
                 std::vector<double> rubbed)
      : model_(model),
        impedance_(impedance),
        free_(std::move(free)),
        rubbed_(std::move(rubbed)),
        T_(free_) {}

  /// Puts it to the film's nodes and looks at what it takes less there by one kelvin.
  void meet(const thermal::FilmEnergy& energy, std::vector<double>& T) {
    const auto takes = [&] { return mean_of_rings(model_, energy.wall_heat(T).shaft); };
    put(T);
    slope_ = takes();
    for (double& t : T_) t += 1.0;
    put(T);
    const std::vector<double> warmer = takes();
    for (std::size_t j = 0; j < T_.size(); ++j) {
      T_[j] -= 1.0;
      slope_[j] -= warmer[j];
    }
    put(T);
  }

  /// Puts its temperatures to the film's nodes.
  void put(std::vector<double>& T) const {
    const std::size_t rings = T_.size();
    const int n = model_.gl.n;
    for (int c = 0; c < model_.domain.grid.cells(); ++c) {
      if (meets_walls(model_, c)) T[static_cast<std::size_t>(c) * n + n - 1] = T_[c % rings];
    }
  }

  /// Moves it towards (2); by how much it is off [K].
  double follow(const thermal::FilmEnergy& energy, std::vector<double>& T) {
    const std::vector<double> heat = mean_of_rings(model_, energy.wall_heat(T).shaft);
    double off = 0.0;
    for (std::size_t j = 0; j < T_.size(); ++j) {
      const double change = free_[j] + impedance_ * (heat[j] + rubbed_[j]) - T_[j];
      off = larger(off, std::abs(change));
      T_[j] += change / (1.0 + impedance_ * slope_[j]);
    }
    put(T);
    return off;
  }

 private:
  const BearingModel& model_;
  double impedance_;            ///< Z [K m2/W]
  std::vector<double> free_;    ///< [K]
  std::vector<double> rubbed_;  ///< heat of asperities [W/m2]
  std::vector<double> slope_;   ///< [W/(m2 K)]
  std::vector<double> T_;       ///< [K]
};

/// Sweeps until nothing changes any more but by round-off of the balance; false if it still does.
/// `walls` moves those that the film warms, and tells by how much.
template <class Walls>
bool settle(thermal::FilmEnergy& energy, std::vector<double>& T, const Walls& walls) {
  for (int k = 0; k < kMostIterations; ++k) {
    if (larger(energy.sweep(T), walls(T)) <= kKnownTemperature) return true;
  }
  return false;
}

/// (7) of thermal/film_energy.hpp for the oil that `s` expects in the supplies.
void let_supplies_thin(const BearingModel& model, const FilmEquilibrium& s,
                       thermal::FilmEnergyProblem& problem) {
  const int n = model.gl.n;
  for (int c = 0; c < model.domain.grid.cells(); ++c) {
    if (problem.patch[c] < 0) continue;
    thermal::SupplyVessel& v = problem.vessels[problem.patch[c]];
    v.T_sheared = s.columns.T[static_cast<std::size_t>(c) * n + n / 2];
    v.thinning = thinning(model, v.T_sheared, s.film.p[c]);
  }
}

}  // namespace

double reach_of_heat(const Case& c, double t) {
  const auto reach = [t](const solid::Material& m) {
    return std::sqrt(m.conductivity / (m.density * m.heat_capacity) * t);
  };
  const Solids::Layers shell = wall_layers(c);
  double deep = 0.0, left = 1.0;  // of the time's square root
  for (std::size_t k = 0; k < layers_of_skin(c, shell) && left > 0.0; ++k) {
    const double in_layer = std::min(left * reach(shell.material[k]), shell.thickness[k]);
    deep += in_layer;
    left -= in_layer / reach(shell.material[k]);
  }
  return std::max(deep, reach(c.shaft->material));
}

std::vector<double> mean_of_rings(const BearingModel& model, const Field& per_cell) {
  const FilmGrid& g = model.domain.grid;
  std::vector<double> mean(g.nz, 0.0);
  for (int c = 0; c < g.cells(); ++c) {
    if (meets_walls(model, c)) mean[c % g.nz] += per_cell[c];
  }
  for (int j = 0; j < g.nz; ++j) mean[j] /= 2.0 * kPi * g.radius * g.dz[j];
  return mean;
}

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
    : skin_(shell_skin(model.input, reach_of(model, period), shortest)) {
  const bool grows = model.physics.thermal_deformation;
  if (grows) opening_ = model.solids->opening_by_skins({skin_.depths(), skin_.nodes()});
  if (!is_event(model)) return;
  const double R = model.input.bearing.radius;
  const thermal::SkinLayer shaft = skin_layer(model.input.shaft->material, R);
  shaft_.emplace(std::vector{shaft}, reach_of(model, period), shortest, 0.0, -1.0 / R);
  if (!grows) return;
  opening_by_shaft_ = model.solids->opening_by_shaft_skins({shaft_->depths(), shaft_->nodes()});
}

HeatInTime HeatSteps::begin(const BearingModel& model, std::vector<double> T,
                            const Field& mass) const {
  HeatInTime heat;
  heat.held = thermal::heat_content(mass, film_enthalpy(model, T));
  heat.T = std::move(T);
  const std::size_t of_shaft = shaft_ ? model.domain.grid.nz * shaft_->nodes() : 0;
  heat.skin.assign(mass.size() * skin_.nodes() + of_shaft, 0.0);
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

std::vector<double> HeatSteps::free_shaft(const thermal::SkinStep& step,
                                          std::vector<double>& skin) const {
  std::vector<double> free = walls.shaft;
  double* T = &skin[walls.flux.size() * skin_.nodes()];
  for (std::size_t j = 0; j < free.size(); ++j, T += shaft_->nodes()) {
    shaft_->relax(step, T);
    free[j] += T[0] - step.impedance() * flux_of_ring(j);
  }
  return free;
}

void HeatSteps::heat_skin(const BearingModel& model, double own, const std::vector<double>& before,
                          HeatStage& out) const {
  const FilmGrid& g = model.domain.grid;
  const auto warm = [](const thermal::SkinStep& step, double flux, double*& T) {
    for (const double by_flux : step.by_flux) *T++ += by_flux * flux;
  };
  double* T = out.skin.data();
  const thermal::SkinStep step = skin_.over(own);
  for (int c = 0; c < g.cells(); ++c) warm(step, out.flows.to_shell[c] - walls.flux[c], T);
  if (shaft_) {
    const std::vector<double> flux = mean_of_rings(model, per_cell(g, out.flows.to_shaft));
    const thermal::SkinStep turning = shaft_->over(own);
    for (int j = 0; j < g.nz; ++j) warm(turning, flux[j] - flux_of_ring(j), T);
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
  const Friction friction = friction_of(model, point, s);
  thermal::FilmEnergyProblem problem = film_energy_problem(
      model, point, s, friction, thermal::FilmStorage{own, after, before, held});
  problem.shell = free_shell(g, skin_.over(own), rubbed.shell, out.skin);
  out.T = s.columns.T;
  for (int c = 0; c < g.cells(); ++c) {
    if (!meets_walls(model, c)) continue;
    out.T[static_cast<std::size_t>(c) * n + n - 1] = walls.shaft[c % g.nz];
  }
  let_supplies_thin(model, s, problem);
  const std::vector<double> cp = problem.cp;
  const double T_ref = problem.T_reference;
  std::optional<TurningSurface> shaft;
  if (shaft_) {
    const thermal::SkinStep turning = shaft_->over(own);
    shaft.emplace(model, turning.impedance(), free_shaft(turning, out.skin),
                  mean_of_rings(model, per_cell(g, rubbed.shaft)));
  }
  thermal::FilmEnergy energy(std::move(problem));
  if (shaft) shaft->meet(energy, out.T);
  out.settled = settle(energy, out.T, [&](std::vector<double>& T) {
    return shaft ? shaft->follow(energy, T) : 0.0;
  });
  out.possible = oil_can_be(out.T);
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
  heat_skin(model, own, skin, out);
  return out;
}

Field HeatSteps::swelling(const BearingModel& model, const std::vector<double>& skin) const {
  if (skin.empty() || walls.thermal_deformation.empty()) return {};
  const std::size_t cells = walls.thermal_deformation.size();
  const auto of_shaft = skin.begin() + static_cast<std::ptrdiff_t>(cells * skin_.nodes());
  Field narrower = model.solids->widening(opening_, Field(skin.begin(), of_shaft));
  for (double& x : narrower) x = -x;
  if (!shaft_) return narrower;
  const Eigen::Map<const Eigen::VectorXd> T(&*of_shaft, opening_by_shaft_.cols());
  const Eigen::VectorXd opens = opening_by_shaft_ * T;
  for (std::size_t c = 0; c < cells; ++c) {
    narrower[c] -= opens[static_cast<Eigen::Index>(c) % opens.size()];
  }
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

double thinning(const BearingModel& model, double T, double p) {
  return std::max(-rheology::viscosity_slopes(model.oil, T, p, 0.0).dln_dT, 0.0);
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
