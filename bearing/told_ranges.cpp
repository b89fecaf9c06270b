#include "bearing/told_ranges.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/bore_shape.hpp"
#include "bearing/case_limits.hpp"
#include "bearing/pressed_layer.hpp"
#include "core/constants.hpp"
#include "core/round_off.hpp"
#include "fluid/patir_cheng.hpp"
#include "rheology/density.hpp"
#include "rheology/viscosity.hpp"
#include "solid/joined_rings.hpp"

namespace shellback::bearing {
namespace {

/// Cells in which the contact law is asked for more than it was made for.
long cells_beyond_law(const BearingModel& m, const Field& h) {
  if (!m.contact) return 0;
  return std::count_if(h.begin(), h.end(),
                       [least = m.contact->least_gap()](double x) { return x < least; });
}

long cells_that_flow(const Field& flow) {
  return std::count_if(flow.begin(), flow.end(), [](double x) { return x > 0.0; });
}

/// Columns beside each other shear by the time that half of them has flowed away, and none can lose
/// more than it has.
void add_flown_layer(const BearingModel& m, double depth, std::vector<Note>& out) {
  if (!(depth > 0.0)) return;
  const double thickness = m.input.shell->layers.front().thickness;
  if (depth > kMostFlown * thickness) out.emplace_back(note::LayerFlown{depth, thickness});
}

void add_hot_lining(const BearingModel& m, double T, std::vector<Note>& out) {
  if (!m.input.shell || m.input.shell->layers.empty()) return;
  const solid::Material& lining = m.input.shell->layers.front().material;
  if (lining.limit_temperature > 0.0 && T > lining.limit_temperature) {
    out.emplace_back(note::LiningTooHot{lining.name, T, lining.limit_temperature});
  }
}

}  // namespace

Field summit_flow(const BearingModel& m, const Field& h) {
  if (!m.contact || !std::isfinite(m.contact->flow_gap())) return {};
  Field flow = h;
  for (std::size_t k = 0; k < flow.size(); ++k) {
    const bool supplied = m.supply.cell[k] >= 0;
    flow[k] = supplied ? 0.0 : std::max(0.0, m.contact->flow_gap() - h[k]);
  }
  return flow;
}

namespace {

/// Cells whose gap is smaller than what flow factors are known for: the first of a measured table,
/// the lower end of the fits otherwise.
void add_factors(const BearingModel& m, const Field& h, std::vector<Note>& out) {
  const fluid::RoughPair& rough = m.domain.rough;
  if (!m.physics.flow_factors || !(rough.sigma > 0.0)) return;
  const auto& measured = rough.measured;
  const double H =
      measured ? measured->H_low : std::max({rough.x.H_low, rough.z.H_low, fluid::kShearLow});
  const double first = H * (measured ? measured->sigma : rough.sigma);
  const long cells = std::count_if(h.begin(), h.end(), [first](double x) { return x < first; });
  if (cells == 0) return;
  out.push_back(note::FactorsContinued{cells, first, H, measured.has_value()});
}

void add_contact(const BearingModel& m, const FilmReach& reach, std::vector<Note>& out) {
  const Field& h = reach.h;
  add_contact_left_out(m.input, reach.h_min, out);
  const fluid::SmallestGap& least = reach.least;
  if (const long cells = cells_beyond_law(m, h); cells > 0) {
    out.push_back(note::BeyondContactLaw{cells, least.h, m.contact->sigma(), m.contact->least_gap(),
                                         least.place()});
  }
  const Field flow = summit_flow(m, h);
  if (const long cells = cells_that_flow(flow); cells > 0) {
    const auto deepest = std::max_element(flow.begin(), flow.end());
    out.push_back(note::HeldAtHardness{
        m.contact->hardness(), cells, *deepest,
        fluid::place_of(m.domain.grid, static_cast<int>(deepest - flow.begin()))});
  }
}

/// A last cell that is open says nothing of the edge if the line through its neighbour closes
/// there, or takes more than half of its gap.
void add_edge(const BearingModel& m, const FilmReach& reach, std::vector<Note>& out) {
  const double cell = *std::min_element(reach.h.begin(), reach.h.end());
  const bool held_open = m.physics.elastic && m.domain.rough.sigma <= 0.0;  // fluid::edge_gap
  const double resolved = held_open ? fluid::kMostOfEdge * cell : 0.0;
  if (reach.h_min < resolved && cell > 0.0) {
    out.push_back(note::EdgeNotResolved{reach.h_min, cell});
  }
}

/// What the cells do not show of the bore, where it is more than a part of the film.
void add_bore(const BearingModel& m, const FilmReach& reach, std::vector<Note>& out) {
  constexpr double kOfFilm = 0.1;    // of the smallest film: as much as bars are usually wide
  constexpr double kOfVolume = 0.2;  // of the profile: a groove of five cells, off by one
  const Bearing& b = m.input.bearing;
  const MissedShape missed = missed_shape(b, m.domain.grid);
  const double film = std::max(reach.h_min, m.domain.rough.sigma);
  if (missed.depth > kOfFilm * film) {
    out.push_back(note::ShapeBetweenCells{missed.depth, film, {missed.phi, missed.z}});
  }
  const double part = missed_profile(b, m.domain.grid);
  if (part > kOfVolume) out.push_back(note::ProfileBetweenCells{part});
}

/// Holes that cells of the film show too wide: a circle within one square cell is 4/pi of its area.
void add_holes(const BearingModel& m, std::vector<Note>& out) {
  constexpr double kOfArea = 1.5;  // a half more than the circle: one square cell is not told
  const FilmGrid& g = m.domain.grid;
  const auto& supplies = m.input.supplies;
  for (int k = 0; k < static_cast<int>(supplies.size()); ++k) {
    if (supplies[k].kind != SupplyKind::hole) continue;
    double area = 0.0;
    for (int c = 0; c < g.cells(); ++c) {
      if (m.supply.cell[c] == k) area += g.multiplicity() * g.area(c);
    }
    const double taken = std::sqrt(4.0 * area / kPi);
    const double diameter = supplies[k].diameter;
    if (taken <= std::sqrt(kOfArea) * diameter) continue;
    out.push_back(note::MouthWidened{k, diameter, taken});
  }
}

/// Supplies that reach a side edge on this grid alone.
void add_lands(const BearingModel& m, std::vector<Note>& out) {
  const FilmGrid& g = m.domain.grid;
  const std::vector<Supply>& supplies = m.input.supplies;
  for (int k = 0; k < static_cast<int>(supplies.size()); ++k) {
    const fluid::SupplyPatch& patch = m.supply.patches[k];
    const double land = 0.5 * (m.input.bearing.width - patch.length) - std::abs(patch.z);
    bool open = false;
    for (int i = 0; i < g.nt && !open; ++i) {
      open = m.supply.cell[g.index(i, g.nz - 1)] == k ||
             (!g.half && m.supply.cell[g.index(i, 0)] == k);
    }
    if (open && land > kRoundOff * m.input.bearing.width) out.push_back(note::LandUnseen{k, land});
  }
}

/// Of those that are not alike.
void add_joined_supplies(const BearingModel& m, std::vector<Note>& out) {
  const std::vector<Supply>& s = m.input.supplies;
  for (int a = 0; a < static_cast<int>(s.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(s.size()); ++b) {
      const bool alike = s[a].pressure == s[b].pressure && s[a].temperature == s[b].temperature;
      if (m.supply.touching[a] == m.supply.touching[b] && !alike) {
        out.push_back(note::SuppliesJoined{a, b});
      }
    }
  }
}

/// Of a bonded layer, mean over its thickness: what pressure drives out of its middle must pass its
/// faces, tau = nu/(1 - nu) t dp/dx at the bond (balance of forces, textbook); thick ones shear by
/// the pressure itself.
double shear_strain(const ShellLayer& layer, double p_max, double p_slope) {
  const solid::Material& m = layer.material;
  const double G = m.shear_modulus();
  const double push = m.poisson_ratio / (1.0 - m.poisson_ratio);
  return push * std::min(layer.thickness * p_slope, p_max) / (2.0 * G);
}

/// A layer behind the first is pressed over a wider area, by less: told is what it has at most.
void add_strain(const BearingModel& m, double p_max, double p_slope, std::vector<Note>& out) {
  if (!m.physics.elastic || !m.input.shell) return;
  const auto& layers = m.input.shell->layers;
  for (int k = 0; k < static_cast<int>(layers.size()); ++k) {
    if (layers[k].elasto_plastic) continue;  // it has a law of its own
    const double pressed = p_max * solid::confined_compliance(layers[k].material);
    const double sheared = shear_strain(layers[k], p_max, p_slope);
    const double strain = std::max(pressed, sheared);
    if (strain > kBearingLimits.strain_usual) {
      out.push_back(note::LayerPressed{k, strain, sheared > pressed});
    }
  }
}

void add_soft_layer(const BearingModel& m, double p_max, std::vector<Note>& out) {
  if (!m.physics.elastic || !m.input.shell || m.input.shell->layers.empty()) return;
  const ShellLayer& first = m.input.shell->layers.front();
  const double hardness = first.material.hardness;
  if (first.elasto_plastic || !(hardness > 0.0) || !(p_max > hardness)) return;
  out.push_back(note::LayerBeyondHardness{first.material.name, p_max, hardness});
}

}  // namespace

note::NotLaminar reynolds_number(const Case& c, double U, double T) {
  const double gap = c.bearing.radial_clearance;
  const double nu = rheology::viscosity(c.oil, T, 0.0) / rheology::density(c.oil, T, 0.0).rho;
  return {std::abs(U) * gap / nu, kTaylor * std::sqrt(c.bearing.radius / gap)};
}

double reduced_reynolds(const Case& c, const note::NotLaminar& film) {
  return film.reynolds * c.bearing.radial_clearance / c.bearing.radius;
}

void add_contact_left_out(const Case& c, double h_min, std::vector<Note>& notes) {
  constexpr double kTouching = 3.0;  // film over roughness: mixed lubrication below it (textbook)
  const double sigma = combined_roughness(c.surfaces);
  if (c.surfaces.contact || !(h_min < kTouching * sigma)) return;
  notes.push_back(note::ContactLeftOut{h_min / sigma});
}

void add_turbulence(const Case& c, double U, double T, std::vector<Note>& notes) {
  const note::NotLaminar film = reynolds_number(c, U, T);
  if (film.reynolds > film.limit) notes.push_back(film);
  const double reduced = reduced_reynolds(c, film);
  if (reduced > kInertiaMatters) notes.push_back(note::FilmInertia{reduced});
}

void add_squeeze_inertia(const Case& c, double velocity, double T, std::vector<Note>& notes) {
  const double reduced = reynolds_number(c, velocity, T).reynolds;
  if (reduced > kInertiaMatters) notes.push_back(note::FilmInertia{reduced, true});
}

std::vector<Note> oil_range_warnings(const rheology::Oil& oil, double T_low, double T_high,
                                     double p_max) {
  const auto& range = oil.range;
  std::vector<Note> out;
  constexpr double kBelowTold = 0.5;  // what a range told to whole degrees does not show [K]
  if (T_low < range.T_min - kBelowTold || T_high > range.T_max + kBelowTold) {
    out.push_back(note::BeyondOilRange{T_low, T_high, range.T_min, range.T_max});
  }
  if (p_max > range.p_max) out.push_back(note::Plain::pressure_beyond_law);
  return out;
}

std::vector<Note> input_warnings(const Case& c, const Physics& physics) {
  std::vector<Note> out;
  const auto texture = [](const solid::RoughSurface& s) {
    return fluid::SurfaceTexture{s.roughness, s.orientation};
  };
  const bool tabulated = physics.flow_factors && !c.surfaces.flow_factors;
  if (tabulated &&
      fluid::rough_pair(texture(c.surfaces.shell), texture(c.surfaces.shaft)).beyond_table) {
    out.emplace_back(note::Plain::orientation_beyond_table);
  }
  if (!physics.elastic && pressed_layer(c, 0)) out.emplace_back(note::Plain::rigid_layer);
  return out;
}

void add_layer_of_constant_thickness(const BearingModel& m, std::vector<Note>& assumptions) {
  if (!m.physics.thermal_deformation || !pressed_layer(m.input, 0)) return;
  assumptions.emplace_back(note::Plain::layer_keeps_thickness);
}

void add_joint_that_pulls(const BearingModel& m, double bore, double back,
                          std::vector<Note>& assumptions) {
  const Case& c = m.input;
  const bool grows = m.physics.thermal_deformation && c.shell && c.shell->housing &&
                     c.shell->housing->support != HousingSupport::clamped;
  if (!grows || !std::isfinite(bore) || !std::isfinite(back)) return;
  const double fitted = c.bearing.reference_temperature;
  std::vector<solid::Ring> rings;
  double outer = c.bearing.radius;
  for (const ShellLayer& layer : c.shell->layers) {
    outer += layer.thickness;
    rings.push_back({layer.material, outer, 0.5 * (bore + back) - fitted});
  }
  const double loose = solid::joined_rings(c.bearing.radius, rings).opening;
  rings.push_back({c.shell->housing->material, c.shell->housing->outer_radius, back - fitted});
  const solid::JoinedRings joined = solid::joined_rings(c.bearing.radius, rings);
  const double pull = -joined.pressures.back();
  const double moved = std::abs(joined.opening - loose);
  if (!(pull > 0.0) || moved < c.model.tolerance * c.bearing.radial_clearance) return;
  assumptions.emplace_back(note::JointPulls{pull, joined.opening, loose});
}

void add_temperature_of_edge_oil(const BearingModel& m, Tier tier, std::vector<Note>& assumptions) {
  if (m.physics.film_energy) {
    assumptions.emplace_back(note::Plain::edge_oil_as_supply);
  } else if (tier == Tier::lumped) {
    assumptions.emplace_back(note::Plain::edge_oil_as_film);
  }
}

std::vector<Note> range_warnings(const BearingModel& m, const FilmReach& reach) {
  std::vector<Note> out = oil_range_warnings(m.oil, reach.T_low, reach.T_high, reach.p_max);
  for (const Note& note : input_warnings(m.input, m.physics)) out.push_back(note);
  add_factors(m, reach.h, out);
  add_contact(m, reach, out);
  add_edge(m, reach, out);
  add_bore(m, reach, out);
  add_holes(m, out);
  add_lands(m, out);
  add_joined_supplies(m, out);
  add_strain(m, reach.p_max, reach.p_slope, out);
  add_soft_layer(m, reach.p_max, out);
  if (reach.shear_rate > m.oil.range.rate_max) {
    out.push_back(note::ShearBeyondLaw{reach.shear_rate, m.oil.range.rate_max});
  }
  add_flown_layer(m, reach.layer_depth, out);
  add_hot_lining(m, reach.T_shell, out);
  if (reach.h_min < 0.0) out.emplace_back(note::Plain::planes_overlap);
  return out;
}

double largest_shear_rate(const fluid::FilmState& film, const Field& h, double U) {
  double most = 0.0;
  for (std::size_t c = 0; c < h.size(); ++c) {
    if (film.full[c] && h[c] > 0.0) most = std::max(most, std::abs(U) / h[c]);
  }
  return most;
}

double largest_slope(const FilmGrid& g, const Field& p) {
  double most = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const double here = p[g.index(i, j)];
      const double around = p[g.index((i + 1) % g.nt, j)] - here;
      const int next = (i + 1) % g.nt;
      most = std::max(most, std::abs(around) / (0.5 * (g.dphi[i] + g.dphi[next]) * g.radius));
      if (j + 1 == g.nz) continue;
      const double along = p[g.index(i, j + 1)] - here;
      most = std::max(most, std::abs(along) / (g.z[j + 1] - g.z[j]));
    }
  }
  return most;
}

note::OilSheared sheared_oil(const FilmGrid& grid, const Field& p, const Field& stress) {
  note::OilSheared most;
  for (int c = 0; c < grid.cells(); ++c) {
    const double part =
        std::abs(stress[c]) / (kShearAtRest + kShearByPressure * std::max(p[c], 0.0));
    if (part > most.part) most = {std::abs(stress[c]), p[c], part, fluid::place_of(grid, c)};
  }
  return most;
}

note::OilSheared worse(const note::OilSheared& a, const note::OilSheared& b) {
  return b.part > a.part ? b : a;
}

void add_sheared_oil(const note::OilSheared& sheared, std::vector<Note>& notes) {
  if (sheared.part > 1.0) notes.push_back(sheared);
}

std::vector<LimiterCount> contact_limiters(const BearingModel& m, const Field& h) {
  std::vector<LimiterCount> out;
  const auto add = [&](Limiter what, long count) {
    if (count > 0) out.push_back({what, count});
  };
  add(Limiter::held_at_hardness, cells_that_flow(summit_flow(m, h)));
  add(Limiter::beyond_contact_law, cells_beyond_law(m, h));
  return out;
}

}  // namespace shellback::bearing
