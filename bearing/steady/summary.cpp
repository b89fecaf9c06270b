/// Summing a solution up: quantities, audit, effects, fields.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/solids.hpp"
#include "bearing/steady/audit.hpp"
#include "bearing/steady/effects.hpp"
#include "bearing/steady/solve.hpp"
#include "bearing/steady/told_limits.hpp"
#include "bearing/told_ranges.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// Film temperature, weighted by the oil that is there (theta h) [K].
double oil_mean_temperature(const BearingModel& m, const FilmEquilibrium& f) {
  const FilmGrid& g = m.domain.grid;
  double sum = 0.0;
  double oil = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      if (m.supply.cell[c] >= 0) continue;
      const double w = g.area(i, j) * f.film.theta[c] * f.shear_gap[c];
      sum += w * m.gl.mean(&f.columns.T[c * m.gl.n]);
      oil += w;
    }
  }
  return sum / oil;
}

/// The smallest film on the edge of the supply that row `j` lies in, towards the end of the bearing
/// that `step` leads to: on the straight line through the first two rows that are film [m].
double film_beside_supply(const BearingModel& m, const FilmEquilibrium& f, int j, int step) {
  const FilmGrid& g = m.domain.grid;
  const auto is_film = [&](int i, int row) {
    return row >= 0 && row < g.nz && m.supply.cell[g.index(i, row)] < 0;
  };
  double h = INFINITY;
  for (; j >= 0 && j < g.nz && !std::isfinite(h); j += step) {
    const double edge = g.z_face[step > 0 ? j : j + 1];
    for (int i = 0; i < g.nt; ++i) {
      if (!is_film(i, j)) continue;
      const double here = f.gap.cell[g.index(i, j)];
      const double slope = is_film(i, j + step) ? (f.gap.cell[g.index(i, j + step)] - here) /
                                                      (g.z[j + step] - g.z[j])
                                                : 0.0;
      h = std::min(h, here + slope * (edge - g.z[j]));
    }
  }
  return h;
}

/// At z = 0, in cells and on faces around, as the smallest film is; between the middles of two
/// cells on the straight line, beside the plane of symmetry on the parabola that stands on it.
/// Supplies are no film: where a groove runs all round, at its edge.
double gap_at_mid_width(const BearingModel& m, const FilmEquilibrium& f) {
  const FilmGrid& g = m.domain.grid;
  const auto above = std::lower_bound(g.z.begin(), g.z.end(), 0.0) - g.z.begin();
  const int b = std::min(static_cast<int>(above), g.nz - 1);
  const bool at_middle = g.z[b] <= 0.0;
  const int a = at_middle ? b : b > 0 ? b - 1 : std::min(1, g.nz - 1);
  const auto height = [&](int j) { return g.half ? g.z[j] * g.z[j] : g.z[j]; };
  const double part = a == b ? 0.0 : height(b) / (height(b) - height(a));  // of the way to a
  const auto between = [&](const Field& gap, int i) {
    return gap[g.index(i, b)] + part * (gap[g.index(i, a)] - gap[g.index(i, b)]);
  };
  const auto film = [&](int i) {
    return m.supply.cell[g.index(i, a)] < 0 && m.supply.cell[g.index(i, b)] < 0;
  };
  const auto step = [&](int i) { return m.profile.empty() ? 0.0 : between(m.profile, i); };
  double h = INFINITY;
  for (int i = 0; i < g.nt; ++i) {
    if (!film(i)) continue;
    h = std::min(h, between(f.gap.cell, i));
    const int west = g.previous(i);
    if (film(west)) h = std::min(h, between(f.gap.phi_face, i) + std::min(step(i), step(west)));
  }
  if (std::isfinite(h)) return h;
  const double above_it = film_beside_supply(m, f, b, 1);
  return g.half ? above_it : std::min(above_it, film_beside_supply(m, f, b, -1));
}

/// From the load line to the line of centres, positive in the direction of rotation [deg].
double attitude(const Solution& s) {
  const double load_line = std::atan2(-s.film.force[1], -s.film.force[0]);
  const double centres = std::atan2(s.film.position.ey(), s.film.position.ex());
  const double turn = s.point.scene.speed >= 0.0 ? 1.0 : -1.0;
  return turn * std::remainder(centres - load_line, 2.0 * kPi) * 180.0 / kPi;
}

/// Parts of the asperity torque, each also over that of a coefficient of one.
void add_friction_parts(const Solution& s, Quantities& q) {
  const BearingModel& m = s.model;
  if (!m.contact || !m.input.surfaces.contact->friction_law) return;
  const AsperityStress tau = asperity_stress(m, s.point, s.film);
  const double pressed = fluid::torque(s.point.scene, s.film.p_contact);
  const auto mean = [&](double part) { return pressed > 0.0 ? std::abs(part) / pressed : 0.0; };
  q.friction_torque_abrasive = fluid::torque(s.point.scene, tau.abrasive);
  q.friction_torque_adhesive = fluid::torque(s.point.scene, tau.adhesive);
  q.friction_torque_micro_hydrodynamic = fluid::torque(s.point.scene, tau.micro_hydrodynamic);
  q.mu_abrasive = mean(q.friction_torque_abrasive);
  q.mu_adhesive = mean(q.friction_torque_adhesive);
  q.mu_micro_hydrodynamic = mean(q.friction_torque_micro_hydrodynamic);
}

/// Of the film's force and moment on a journal that stands off the shell's axis, about that [N m].
double moment_of_eccentricity(const FilmEquilibrium& s) {
  const auto& [ex, ey, psi_x, psi_y] = s.position.q;
  const auto& [fx, fy, mx, my] = s.force;
  return ex * fy - ey * fx + psi_x * my - psi_y * mx;
}

void add_mechanics(const Solution& s, const Friction& f, Quantities& q) {
  const BearingModel& m = s.model;
  const double omega = s.point.omega();
  q.friction_torque = f.torque();
  q.friction_torque_asperity = f.asperity;
  q.friction_torque_shell = f.torque() - moment_of_eccentricity(s.film);
  q.power_loss = f.torque() * omega;
  q.pump_power = pump_power(m, s.point, s.film);
  q.eccentricity_ratio = std::hypot(s.film.position.ex(), s.film.position.ey()) / m.clearance;
  q.attitude_angle = attitude(s);
  if (s.point.load.unknowns == 4 || s.film.position.psi_x() != 0.0 ||
      s.film.position.psi_y() != 0.0) {
    q.tilt_x = s.film.position.psi_x();
    q.tilt_y = s.film.position.psi_y();
    q.moment_x = s.film.force[2];
    q.moment_y = s.film.force[3];
  }
  q.h_min = s.film.least.h;
  q.h_min_mid = larger(gap_at_mid_width(m, s.film), q.h_min);  // led on to, between cells
  q.p_max = largest(s.film.film.p);
  if (m.contact) {
    q.p_asperity_max = largest(s.film.p_contact);
    const fluid::Wrench contact = fluid::wrench(s.point.scene, s.film.p_contact);
    add_friction_parts(s, q);
    q.asperity_load_share =
        std::hypot(contact[0], contact[1]) / std::hypot(s.film.force[0], s.film.force[1]);
  }
  q.load_x = s.film.force[0];
  q.load_y = s.film.force[1];
  const auto flows = fluid::oil_flows(s.point.scene, s.film.flow);
  const double rho = reference_density(m);
  q.side_flow = flows.side / rho;
  q.supply_flow = flows.supply / rho;
  if (m.physics.elastic) q.elastic_opening_max = largest(s.film.elastic);
  if (!s.film.layer.empty()) q.layer_depth = largest(lasting_depth(s.film.layer));
}

/// Of the oil behind the supplies, mean by what each feeds, or plain where oil is pressed back into
/// all of them [K].
double mixed_supply(const Solution& s) {
  const std::vector<double>& T = s.heat.T_mix;
  const auto flows = fluid::oil_flows(s.point.scene, s.film.flow);
  double fed = 0.0;
  double by_flow = 0.0;
  double sum = 0.0;
  const auto net = fluid::sum_over_touching(s.point.scene.supply.touching, flows.patch);
  for (std::size_t k = 0; k < T.size(); ++k) {
    const double out = std::max(net[k], 0.0);
    fed += out;
    by_flow += out * T[k];
    sum += T[k];
  }
  return fed > 0.0 ? by_flow / fed : sum / static_cast<double>(T.size());
}

void add_heat(const Solution& s, Quantities& q) {
  const BearingModel& m = s.model;
  if (!m.physics.film_energy) {
    q.T_film_mean = s.T_film;
    return;
  }
  if (!s.heat.known()) return;  // stopped before the first heat solution
  const double twice = m.domain.grid.multiplicity();
  q.T_film_max = largest(s.film.columns.T);
  q.T_film_mean = oil_mean_temperature(m, s.film);
  q.T_shell_max = largest(s.heat.solids.shell.surface);
  q.T_shell_back = area_mean(m.domain.grid, s.heat.solids.shell.back);
  q.T_shell_back_max = largest(s.heat.solids.shell.back);
  q.T_shaft = axial_mean(m.domain.grid, s.heat.solids.shaft.temperature);
  q.T_supply_mixed = mixed_supply(s);
  q.heat_by_oil = twice * (s.heat.balance.carried_out - s.heat.balance.carried_in);
  q.heat_to_shell = s.heat.solids.shell.heat_in;
  q.heat_to_shaft = s.heat.solids.shaft.heat_in;
  if (m.physics.thermal_deformation) {
    q.thermal_opening_mean = area_mean(m.domain.grid, s.heat.thermal_deformation);
  }
}

/// Of forces; with whole-width films also the moments' (4 x 4), which only Coefficients has.
void add_coefficients(const Coefficients& k, Quantities& q) {
  q.K_xx = k.K[0][0];
  q.K_xy = k.K[0][1];
  q.K_yx = k.K[1][0];
  q.K_yy = k.K[1][1];
  q.C_xx = k.C[0][0];
  q.C_xy = k.C[0][1];
  q.C_yx = k.C[1][0];
  q.C_yy = k.C[1][1];
  q.whirl_critical_mass = k.whirl.critical_mass;
  q.whirl_speed_ratio = k.speed_ratio;
  q.whirl_ratio = k.whirl_ratio;
}

Field on_full(const BearingModel& m, const Field& x) {
  return x.empty() ? x : mirror_to_full(m.domain.grid, x);
}

std::vector<double> nodes_on_full(const BearingModel& m, const std::vector<double>& T) {
  const FilmGrid& g = m.domain.grid;
  const int n = m.gl.n;
  std::vector<double> out(static_cast<std::size_t>(full_grid(g).cells()) * n);
  Field layer(g.cells());
  for (int k = 0; k < n; ++k) {
    for (int c = 0; c < g.cells(); ++c) layer[c] = T[static_cast<std::size_t>(c) * n + k];
    const Field full = mirror_to_full(g, layer);
    for (std::size_t c = 0; c < full.size(); ++c) out[c * n + k] = full[c];
  }
  return out;
}

Fields fields_of(const Solution& s, const Friction& f) {
  const BearingModel& m = s.model;
  Fields out;
  out.grid = full_grid(m.domain.grid);
  out.p = on_full(m, s.film.film.p);
  out.theta = on_full(m, s.film.film.theta);
  if (m.contact) out.p_asperity = on_full(m, s.film.p_contact);
  const Field flow = summit_flow(m, fluid::nominal_depth(s.film.gap, m.supply));
  if (largest_magnitude(flow) > 0.0) out.summit_flow = on_full(m, flow);
  if (!s.film.layer.empty()) out.layer_depth = on_full(m, lasting_depth(s.film.layer));
  out.h = on_full(m, fluid::nominal_depth(s.film.gap, m.supply));
  Field supplied;
  for (const int patch : m.supply.cell) supplied.push_back(patch < 0 ? 0.0 : 1.0);
  for (const double x : on_full(m, supplied)) out.supplied.push_back(x > 0.5);
  out.tau_journal = on_full(m, f.stress.journal);
  out.tau_shell = on_full(m, f.stress.shell);
  if (m.contact && m.input.surfaces.contact->friction_law) {
    const AsperityStress tau = asperity_stress(m, s.point, s.film);
    out.tau_abrasive = on_full(m, tau.abrasive);
    out.tau_adhesive = on_full(m, tau.adhesive);
    out.tau_micro_hydrodynamic = on_full(m, tau.micro_hydrodynamic);
  }
  out.elastic = on_full(m, s.film.elastic);
  out.thermal_deformation = on_full(m, s.heat.thermal_deformation);
  if (!m.physics.film_energy || !s.heat.known()) return out;
  out.s = m.gl.s;
  out.T = nodes_on_full(m, s.film.columns.T);
  Field mean(m.domain.grid.cells());
  for (std::size_t c = 0; c < mean.size(); ++c) {
    mean[c] = m.gl.mean(&s.film.columns.T[c * m.gl.n]);
  }
  out.T_mean = on_full(m, mean);
  out.T_shell_surface = on_full(m, s.heat.solids.shell.surface);
  out.T_shell_back = on_full(m, s.heat.solids.shell.back);
  Field shaft(m.domain.grid.cells());
  for (int c = 0; c < m.domain.grid.cells(); ++c) {
    shaft[c] = s.heat.solids.shaft.temperature[c % m.domain.grid.nz];
  }
  const Field full = on_full(m, shaft);
  out.T_shaft.assign(full.begin(), full.begin() + out.grid.nz);
  out.r = m.solids->section_radii();
  out.T_solid = m.solids->section(s.heat.solids.shell);
  return out;
}

/// Of several vessels those whose net flow runs back.
void add_supplies_that_take_back(const Solution& s, std::vector<Note>& out) {
  constexpr double kTold = 0.01;  // of what is fed: less is the next digit of a balance [-]
  const auto flows = fluid::oil_flows(s.point.scene, s.film.flow);
  const auto net = fluid::sum_over_touching(s.point.scene.supply.touching, flows.patch);
  double fed = 0.0;
  for (const double q : net) fed += std::max(q, 0.0);
  const double rho = reference_density(s.model);
  for (std::size_t k = 0; k < net.size(); ++k) {
    if (-net[k] <= kTold * fed || !(fed > 0.0)) continue;
    out.push_back(note::SupplyTakesBack{static_cast<int>(k), -net[k] / rho, fed / rho});
  }
}

std::vector<SupplyState> supplies_of(const Solution& s) {
  const auto flows = fluid::oil_flows(s.point.scene, s.film.flow);
  const double rho = reference_density(s.model);
  const bool heat = s.model.physics.film_energy && s.heat.known();
  std::vector<SupplyState> all;
  for (std::size_t k = 0; k < flows.patch.size(); ++k) {
    all.push_back({flows.patch[k] / rho});
    if (heat && k < s.heat.T_mix.size()) all.back().T_mixed = s.heat.T_mix[k];
  }
  return all;
}

/// A gap that is closed has no flow: such a state has nothing to sum up.
bool evaluated(const FilmEquilibrium& film) { return !film.flow.phi.empty(); }

Quantities values_of(const Solution& s, Tier tier) {
  Quantities q;
  if (!evaluated(s.film)) return q;
  add_mechanics(s, friction_of(s.model, s.point, s.film), q);
  add_heat(s, q);
  if (tier == Tier::isothermal) q.T_equivalent = s.T_film;
  if (s.coefficients && s.coefficients->verdict.good()) add_coefficients(*s.coefficients, q);
  return q;
}

}  // namespace

std::vector<Quantity> quantities_of(const Solution& s, Tier tier) {
  return listed(values_of(s, tier));
}

Result summarize(const Solution& s, Tier tier) {
  const BearingModel& m = s.model;
  Result r;
  r.verdict = s.verdict;
  r.tier = tier;
  r.title = m.input.title;
  r.warnings.assign(m.input.warnings.begin(), m.input.warnings.end());
  r.assumptions.assign(m.input.assumptions.begin(), m.input.assumptions.end());
  r.grid = {m.domain.grid.nt, m.domain.grid.full_nz()};
  r.history = s.history;
  r.levels = s.levels;
  r.cost = {s.wall_s,
            m.solids ? m.solids->setup_seconds() : 0.0,
            s.cost.factorizations,
            s.cost.newton_iterations,
            static_cast<int>(s.history.size()),
            0.0};
  if (!evaluated(s.film)) return r;  // stopped before the first evaluation was through
  const Friction f = friction_of(m, s.point, s.film);
  r.quantities = quantities_of(s, tier);
  r.audit = audit_of(s, f);
  r.supplies = supplies_of(s);
  r.effects = effects_of(s, f, tier);
  if (fluid::oil_flows(s.point.scene, s.film.flow).side_inflow > 0.0) {
    add_temperature_of_edge_oil(m, tier, r.assumptions);
  }
  add_layer_of_constant_thickness(m, r.assumptions);
  if (s.heat.known()) {
    const auto& shell = s.heat.solids.shell;
    add_joint_that_pulls(m, area_mean(m.domain.grid, shell.surface),
                         area_mean(m.domain.grid, shell.back), r.assumptions);
  }
  add_supplies_that_take_back(s, r.assumptions);
  if (passes_over_supply(m.input, tier)) {
    r.assumptions.push_back(note::Plain::supply_temperature_unused);
  }
  r.limiters = limiters_of(s);
  r.coefficients = s.coefficients;
  for (Note& w : warnings_of(s)) r.warnings.push_back(std::move(w));
  r.heat_roots = s.heat_roots;
  r.fields = fields_of(s, f);
  return r;
}

}  // namespace shellback::bearing
