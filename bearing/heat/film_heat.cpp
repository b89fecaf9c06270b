#include "bearing/heat/film_heat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bearing/heat_state.hpp"
#include "rheology/density.hpp"
#include "rheology/heat.hpp"

namespace shellback::bearing {

double reference_density(const BearingModel& model) {
  return rheology::density(model.oil, mean_supply_temperature(model.input), 0.0).rho;
}

std::vector<double> fed_temperatures(const Case& c, const std::vector<int>& touching) {
  struct Pocket {
    double pressure = -std::numeric_limits<double>::infinity();
    double sum = 0.0;
    int count = 0;
  };
  std::vector<Pocket> pockets(touching.size());
  for (std::size_t k = 0; k < touching.size(); ++k) {
    Pocket& pocket = pockets[touching[k]];
    const Supply& supply = c.supplies[k];
    if (supply.pressure > pocket.pressure) pocket = {supply.pressure, 0.0, 0};
    if (supply.pressure < pocket.pressure) continue;
    pocket.sum += supply.temperature;
    ++pocket.count;
  }
  std::vector<double> T;
  for (const int k : touching) T.push_back(pockets[k].sum / pockets[k].count);
  return T;
}

OilFed oil_fed(const Case& c, const std::vector<int>& touching, const std::vector<double>& out_of) {
  const std::vector<double> T = fed_temperatures(c, touching);
  const std::vector<double> net = fluid::sum_over_touching(touching, out_of);
  OilFed fed;
  double sum = 0.0;
  for (std::size_t k = 0; k < net.size(); ++k) {
    const double m = std::max(net[k], 0.0);
    fed.mass += m;
    sum += m * T[k];
  }
  fed.T = fed.mass > 0.0 ? sum / fed.mass : mean_supply_temperature(c);
  return fed;
}

std::pair<double, double> supply_temperatures(const Case& c) {
  const auto [low, high] = std::minmax_element(
      c.supplies.begin(), c.supplies.end(),
      [](const Supply& a, const Supply& b) { return a.temperature < b.temperature; });
  return {low->temperature, high->temperature};
}

double pump_power(const BearingModel& model, const OperatingPoint& point,
                  const FilmEquilibrium& s) {
  const auto flows = fluid::oil_flows(point.scene, s.flow);
  double power = -flows.side * model.domain.p_edge;
  for (std::size_t k = 0; k < flows.patch.size(); ++k) {
    power += flows.patch[k] * point.scene.supply.patches[k].pressure;
  }
  return power / reference_density(model);
}

namespace {

using NodeArray = std::vector<double>;

/// Work of the pressure on the flow through every face [W].
struct FlowWork {
  Field film;                   ///< given to the film cells beside it
  std::vector<double> vessels;  ///< to the patch into which oil flows over a side edge
  double throttled = 0.0;       ///< to oil that leaves a patch over a side edge
};

FlowWork flow_work(const BearingModel& model, const OperatingPoint& point,
                   const FilmEquilibrium& s) {
  const fluid::FilmScene& scene = point.scene;
  const FilmGrid& g = scene.grid;
  const double per_mass = 1.0 / reference_density(model);
  FlowWork out{Field(g.cells(), 0.0), std::vector<double>(scene.supply.patches.size(), 0.0)};
  Field& work = out.film;
  const auto film = [&](int k) { return scene.supply.cell[k] < 0; };
  const auto share = [&](int a, int b, double m) {
    const double power = m * (s.film.p[a] - s.film.p[b]) * per_mass;
    if (film(a) && film(b)) {
      work[a] += 0.5 * power;
      work[b] += 0.5 * power;
    } else if (film(a) || film(b)) {
      work[film(a) ? a : b] += power;
    }
  };
  const auto over_edge = [&](int k, double leaves) {
    const double power = leaves * (s.film.p[k] - scene.p_edge) * per_mass;
    if (film(k)) {
      work[k] += power;
    } else {
      (leaves > 0.0 ? out.throttled : out.vessels[scene.supply.cell[k]]) += power;
    }
  };
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      const int l = g.index(g.previous(i), j);
      const int line = scene.supply.line[k];
      if (line < 0) {
        share(l, k, s.flow.phi[k].m);
      } else {
        const double p = scene.supply.patches[line].pressure;
        if (film(k)) work[k] += s.flow.phi[k].m * (p - s.film.p[k]) * per_mass;
      }
      const int f = i * (g.nz + 1) + j;
      if (j > 0) share(k - 1, k, s.flow.z[f].m);
    }
    const int f = i * (g.nz + 1);
    over_edge(g.index(i, 0), -s.flow.z[f].m);
    over_edge(g.index(i, g.nz - 1), s.flow.z[f + g.nz].m);
  }
  for (const fluid::LineFace& l : s.flow.lines) {
    const int k = g.index(g.previous(l.face / g.nz), l.face % g.nz);
    const double p = scene.supply.patches[l.patch].pressure;
    if (film(k)) work[k] += l.west.m * (s.film.p[k] - p) * per_mass;
  }
  for (std::size_t k = 0; k < s.flow.fed.size(); ++k) {
    const fluid::Mouth& m = scene.supply.mouths[k];
    const double p = scene.supply.patches[m.patch].pressure;
    work[m.cell] += s.flow.fed[k] * (p - s.film.p[m.cell]) * per_mass;
  }
  return out;
}

/// Splits face flows over the nodes by the velocity profiles of the cells beside them.
class NodeFlows {
 public:
  NodeFlows(const BearingModel& model, const OperatingPoint& point, const FilmEquilibrium& s)
      : scene_(point.scene), s_(s), v_(velocity_profiles(model.gl, s.columns)), n_(model.gl.n) {}

  void through(const fluid::FaceFlow& f, int a, int b, double* out) const {
    const double poiseuille = f.m - f.carried;
    for (int k = 0; k < n_; ++k) {
      const std::size_t ka = static_cast<std::size_t>(a) * n_ + k;
      const std::size_t kb = static_cast<std::size_t>(b) * n_ + k;
      out[k] = 0.5 * (f.carried * (v_.couette[ka] + v_.couette[kb]) +
                      poiseuille * (v_.poiseuille[ka] + v_.poiseuille[kb]));
    }
  }

  void fill(thermal::FilmEnergyProblem& p) const {
    const fluid::FilmScene& scene = scene_;
    const FilmGrid& g = scene.grid;
    p.phi_flow.assign(static_cast<std::size_t>(g.cells()) * n_, 0.0);
    p.z_flow.assign(static_cast<std::size_t>(g.nt) * (g.nz + 1) * n_, 0.0);
    for (int i = 0; i < g.nt; ++i) {
      for (int j = 0; j < g.nz; ++j) {
        const int k = g.index(i, j);
        const int l = g.index(g.previous(i), j);
        const bool line = scene.supply.line[k] >= 0;
        through(s_.flow.phi[k], line ? k : l, k, &p.phi_flow[static_cast<std::size_t>(k) * n_]);
      }
      for (int j = 0; j <= g.nz; ++j) {
        const int f = i * (g.nz + 1) + j;
        const int a = g.index(i, std::max(j - 1, 0));
        const int b = g.index(i, std::min(j, g.nz - 1));
        through(s_.flow.z[f], a, b, &p.z_flow[static_cast<std::size_t>(f) * n_]);
      }
    }
    for (const fluid::LineFace& l : s_.flow.lines) {
      const int k = g.index(g.previous(l.face / g.nz), l.face % g.nz);
      thermal::LineFlow line{l.face, l.patch, NodeArray(n_)};
      through(l.west, k, k, line.flow.data());
      p.lines.push_back(std::move(line));
    }
  }

 private:
  const fluid::FilmScene& scene_;
  const FilmEquilibrium& s_;
  VelocityProfiles v_;
  int n_;
};

/// Brings the heat of a cell's nodes, which sums to `sum`, to `power` [W]. What is missed is spread
/// evenly; too much is taken from each node in proportion: beside a step of the gap the cell has
/// the slope of pressure of its neighbour, whose stresses, in its own gap, are many times its own
/// and all at the walls, and evenly the middle of the film would be cooled for them.
void spread_heat(const CrossFilmNodes& gl, double power, double sum, double* heat) {
  const double most = std::max(power, 0.0);
  const double kept = sum > most ? most / sum : 1.0;
  const double missed = power - kept * sum;
  for (int k = 0; k < gl.n; ++k) heat[k] = kept * heat[k] + gl.w[k] * missed;
}

/// Heat per node [W] by (1), and the heat of every supply patch.
void fill_heat(const BearingModel& model, const OperatingPoint& point, const FilmEquilibrium& s,
               const Friction& friction, thermal::FilmEnergyProblem& p) {
  const fluid::FilmScene& scene = point.scene;
  const FilmGrid& g = scene.grid;
  const CrossFilmNodes& gl = model.gl;
  const FlowWork work = flow_work(model, point, s);
  const Field fill = fluid::cell_fill(scene, s.film);
  p.throttled = work.throttled;
  for (std::size_t v = 0; v < work.vessels.size(); ++v) {
    p.vessels[scene.supply.touching[v]].heat += work.vessels[v];
  }
  p.heat = dissipation(gl, scene.speed, s.shear_gap, s.gradient_x, s.gradient_z, s.columns);
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      const double rubbed = scene.speed * friction.stress.journal[c] * g.area(i, j);
      double* heat = &p.heat[static_cast<std::size_t>(c) * gl.n];
      if (p.patch[c] >= 0) {
        p.vessels[p.patch[c]].heat += rubbed;
        p.vessels[p.patch[c]].sheared += rubbed;
        std::fill_n(heat, gl.n, 0.0);
        continue;
      }
      const double volume = g.area(i, j) * s.shear_gap[c] * fill[c];
      double sum = 0.0;
      for (int k = 0; k < gl.n; ++k) {
        heat[k] *= gl.w[k] * volume;
        sum += heat[k];
      }
      spread_heat(gl, rubbed + work.film[c], sum, heat);
    }
  }
}

/// Fill ratio below which a column is dry: it still conducts like one of this, a hundredth of what
/// air would (textbook: 0.03 of 0.14 W/(m K)), and so takes the temperatures of its walls instead
/// of none [-].
constexpr double kDry = 1e-3;

/// Heat capacity between two temperatures; the laws are linear in T, so the middle one is exact.
double mean_heat_capacity(const rheology::Oil& oil, double a, double b) {
  return rheology::heat_capacity(oil, 0.5 * (a + b)).cp;
}

}  // namespace

std::vector<double> film_enthalpy(const BearingModel& model, const std::vector<double>& T) {
  const double T0 = mean_supply_temperature(model.input);
  std::vector<double> e;
  e.reserve(T.size());
  for (const double t : T) e.push_back(mean_heat_capacity(model.oil, T0, t) * (t - T0));
  return e;
}

double supply_heat_transfer(const BearingModel& model, int patch) {
  if (patch < 0) return 0.0;
  const Supply& supply = model.input.supplies[patch];
  if (supply.kind == SupplyKind::drilling) return 0.0;
  if (const double* given = std::get_if<double>(&supply.heat_transfer)) return *given;
  const double k = rheology::conductivity(model.oil, supply.temperature, 0.0).k;
  return ChannelHeat::kNusselt * k / (2.0 * supply.depth);
}

namespace {

/// Carry-over and heat transfer of patches that touch: one vessel has one of each, the means over
/// its cells, whichever of them comes first.
void share_what_vessels_exchange(const fluid::FilmScene& scene, thermal::FilmEnergyProblem& p) {
  const FilmGrid& g = scene.grid;
  const std::vector<int>& vessel = scene.supply.touching;
  std::vector<double> area(vessel.size(), 0.0), carried(area), exchanged(area);
  std::vector<int> members(vessel.size(), 0);
  for (const int v : vessel) ++members[v];
  for (int c = 0; c < g.cells(); ++c) {
    const int own = scene.supply.cell[c];
    if (own < 0 || members[vessel[own]] == 1) continue;
    const double A = g.area(c);
    area[vessel[own]] += A;
    carried[vessel[own]] += A * p.vessels[own].carry_over;
    exchanged[vessel[own]] += A * p.vessels[own].heat_transfer;
  }
  for (std::size_t v = 0; v < vessel.size(); ++v) {
    if (!(area[v] > 0.0)) continue;
    p.vessels[v].carry_over = carried[v] / area[v];
    p.vessels[v].heat_transfer = exchanged[v] / area[v];
  }
}

}  // namespace

double told_temperature(const BearingModel& model, double T, double cp) {
  constexpr int kMostRounds = 50;  // each leaves at most some tenths, the slope of cp times the way
  const double T0 = mean_supply_temperature(model.input);
  const double enthalpy = cp * (T - T0);
  for (int k = 0; k < kMostRounds; ++k) {
    const double next = T0 + enthalpy / mean_heat_capacity(model.oil, T0, T);
    if (std::abs(next - std::exchange(T, next)) < kKnownTemperature) break;
  }
  return T;
}

thermal::FilmEnergyProblem film_energy_problem(const BearingModel& model,
                                               const OperatingPoint& point,
                                               const FilmEquilibrium& s, const Friction& friction,
                                               std::optional<thermal::FilmStorage> storage) {
  const fluid::FilmScene& scene = point.scene;
  const FilmGrid& g = scene.grid;
  const int n = model.gl.n;
  thermal::FilmEnergyProblem p;
  p.grid = &model.domain.grid;
  p.gl = &model.gl;
  p.patch = scene.supply.cell;  // those that touch are one vessel: the first of them
  p.line = scene.supply.line;
  const std::vector<int>& vessel = scene.supply.touching;
  for (int& patch : p.patch) patch = patch < 0 ? patch : vessel[patch];
  const std::vector<double> T_fed = fed_temperatures(model.input, vessel);
  p.forward = scene.speed >= 0.0;
  p.T_reference = mean_supply_temperature(model.input);
  p.T_edge = oil_fed(model.input, scene.supply.touching, fluid::oil_flows(scene, s.flow).patch).T;
  p.cp_edge = mean_heat_capacity(model.oil, p.T_reference, p.T_edge);
  for (const Supply& supply : model.input.supplies) {
    thermal::SupplyVessel v;
    v.heat_transfer = supply_heat_transfer(model, static_cast<int>(p.vessels.size()));
    v.T_supply = T_fed[p.vessels.size()];
    v.carry_over = supply.carry_over;
    v.cp_supply = mean_heat_capacity(model.oil, p.T_reference, v.T_supply);
    v.cp_mix = v.cp_supply;
    p.vessels.push_back(v);
  }
  share_what_vessels_exchange(scene, p);
  p.cp.resize(s.columns.T.size());
  for (std::size_t k = 0; k < p.cp.size(); ++k) {
    p.cp[k] = mean_heat_capacity(model.oil, p.T_reference, s.columns.T[k]);
  }
  p.conductance.resize(g.cells());
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      const double k = rheology::conductivity(model.oil, s.columns.T_mean[c], s.film.p[c]).k;
      const double wet = std::max(s.film.theta[c], kDry);
      p.conductance[c] = k * g.area(i, j) * wet / s.shear_gap[c];
      const int patch = p.patch[c];
      if (patch >= 0) p.vessels[patch].cp_mix = p.cp[static_cast<std::size_t>(c) * n + n / 2];
    }
  }
  NodeFlows(model, point, s).fill(p);
  for (std::size_t k = 0; k < s.flow.fed.size(); ++k) {
    const fluid::Mouth& m = scene.supply.mouths[k];
    p.fed.push_back({m.cell, m.patch, s.flow.fed[k]});
  }
  fill_heat(model, point, s, friction, p);
  p.storage = std::move(storage);
  return p;
}

namespace {

/// Part of the contact's heat that enters the shell [-].
double share_of_shell(const BearingModel& model) {
  const auto effusivity = [](const solid::Material& m) {
    return std::sqrt(m.conductivity * m.density * m.heat_capacity);
  };
  const double shell = effusivity(model.input.shell->layers.front().material);
  const double shaft = effusivity(model.input.shaft->material);
  return shell / (shell + shaft);
}

}  // namespace

Field contact_heat_rate(const BearingModel& model, const OperatingPoint& point,
                        const FilmEquilibrium& s) {
  const double heat = share_of_shell(model) * point.scene.speed;
  Field rate(s.p_contact.size());
  for (std::size_t c = 0; c < rate.size(); ++c) {
    rate[c] = heat * model.contact->friction().per_pressure(rubbing_place(model, point, s, c));
  }
  return rate;
}

ContactHeat contact_heat(const BearingModel& model, const OperatingPoint& point,
                         const FilmEquilibrium& s) {
  ContactHeat q{Field(s.p_contact.size(), 0.0), Field(s.p_contact.size(), 0.0)};
  if (!model.contact) return q;
  const double to_shell = share_of_shell(model);
  const Field tau = asperity_stress(model, point, s).sum();
  for (std::size_t c = 0; c < tau.size(); ++c) {
    const double heat = tau[c] * point.scene.speed;
    q.shell[c] = to_shell * heat;
    q.shaft[c] = (1.0 - to_shell) * heat;
  }
  return q;
}

}  // namespace shellback::bearing
