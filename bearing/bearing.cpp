#include "bearing/bearing.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/possible_methods.hpp"
#include "bearing/solids.hpp"
#include "core/bulk_node.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/even_layers.hpp"
#include "core/largest.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {
namespace {

std::vector<fluid::SupplyPatch> patches_of(const Case& c) {
  std::vector<fluid::SupplyPatch> patches;
  for (const Supply& s : c.supplies) {
    fluid::SupplyPatch p;
    p.phi = s.angle;
    p.z = s.z;
    p.arc = s.arc;
    p.length = s.length;
    p.pressure = s.pressure;
    p.depth = s.depth;
    if (s.kind == SupplyKind::hole) {
      p.round = true;
      p.arc = s.diameter / c.bearing.radius;
      p.length = s.diameter;
    }
    patches.push_back(p);
  }
  return patches;
}

/// Bilinear value of the profile table, periodic in phi, constant beyond its axial ends.
double profile_at(const Profile& p, double phi, double z) {
  const int n = static_cast<int>(p.phi.size());
  const int m = static_cast<int>(p.z.size());
  const double turn = 2.0 * kPi;
  phi -= turn * std::floor((phi - p.phi.front()) / turn);
  const int right =
      static_cast<int>(std::upper_bound(p.phi.begin(), p.phi.end(), phi) - p.phi.begin());
  const int a = right - 1;
  const int b = right < n ? right : 0;
  const double end = right < n ? p.phi[right] : p.phi.front() + turn;
  const double u = n > 1 ? (phi - p.phi[a]) / (end - p.phi[a]) : 0.0;
  const int up = static_cast<int>(std::upper_bound(p.z.begin(), p.z.end(), z) - p.z.begin());
  const int lo = std::clamp(up - 1, 0, m - 1);
  const int hi = std::clamp(up, 0, m - 1);
  const double v = hi > lo ? (z - p.z[lo]) / (p.z[hi] - p.z[lo]) : 0.0;
  const auto line = [&](int k) {
    return (1.0 - v) * p.height[k * m + lo] + v * p.height[k * m + hi];
  };
  return (1.0 - u) * line(a) + u * line(b);
}

Field profile_of_cells(const Case& c, const FilmGrid& g) {
  if (!c.bearing.profile) return {};
  Field profile(g.cells());
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      profile[g.index(i, j)] = profile_at(*c.bearing.profile, g.phi[i], g.z[j]);
    }
  }
  return profile;
}

bool profile_is_symmetric(const Profile& p) {
  constexpr double kSlack = 1e-9;  // of the largest height
  const double highest = largest_magnitude(p.height);
  for (const double phi : p.phi) {
    for (const double z : p.z) {
      if (std::abs(profile_at(p, phi, z) - profile_at(p, phi, -z)) > kSlack * highest) return false;
    }
  }
  return true;
}

fluid::RoughPair rough_pair(const Surfaces& s) {
  return fluid::rough_pair({s.shell.roughness, s.shell.orientation},
                           {s.shaft.roughness, s.shaft.orientation});
}

/// Only a film of resolved temperature asks for another set than the usual one.
CrossFilmNodes nodes_across(const Case& c, const Physics& physics) {
  if (!physics.film_energy) return gauss_lobatto(c.model.film_nodes);
  switch (c.model.methods.across) {
    case AcrossFilm::layers:
      return even_layers(c.model.methods.layers);
    case AcrossFilm::mean:
      return bulk_node();
    case AcrossFilm::lobatto:
      break;
  }
  return gauss_lobatto(c.model.film_nodes);
}

}  // namespace

bool symmetric_about_mid_width(const Case& c) {
  if (const auto* tilt = std::get_if<TiltGiven>(&c.operation.alignment)) {
    if (tilt->about_x != 0.0 || tilt->about_y != 0.0) return false;
  } else {
    return false;
  }
  const bool centred =
      std::all_of(c.supplies.begin(), c.supplies.end(), [](const Supply& s) { return s.z == 0.0; });
  return centred && (!c.bearing.profile || profile_is_symmetric(*c.bearing.profile));
}

BearingModel make_bearing(const Case& c, const Physics& physics, std::array<int, 2> grid,
                          std::shared_ptr<const Solids> solids) {
  BearingModel m;
  m.input = c;
  m.physics = physics;
  expect_possible_methods(c, physics);
  m.gl = nodes_across(c, physics);
  m.clearance = c.bearing.radial_clearance;
  m.oil = c.oil;
  if (!physics.pressure_dependence) m.oil = rheology::without_pressure_effect(m.oil);
  if (!physics.shear_thinning) m.oil = rheology::without_shear_thinning(m.oil);
  const auto patches = patches_of(c);
  fluid::FilmScene& s = m.scene;
  s.grid =
      make_grid(c.bearing.radius, c.bearing.width, grid[0], grid[1], symmetric_about_mid_width(c),
                fluid::phi_edges(patches), fluid::z_edges(patches));
  s.angles = fluid::Angles(s.grid);
  s.supply = fluid::map_supplies(s.grid, patches);
  s.speed = c.operation.omega * c.bearing.radius;
  s.p_cavitation = c.model.cavitation_pressure;
  s.p_edge = std::max(0.0, s.p_cavitation);
  s.edges = c.model.edges == Edges::dry ? fluid::SideEdges::dry : fluid::SideEdges::flooded;
  if (physics.flow_factors) s.rough = rough_pair(c.surfaces);
  m.profile = profile_of_cells(c, s.grid);
  m.shear_rule = c.model.cavitated_shear == CavitatedShear::full ? fluid::CavitatedShear::full
                                                                 : fluid::CavitatedShear::filled;
  if (physics.contact) {
    if (!c.surfaces.contact) {
      throw InputError(
          "asperity contact is switched on but [surfaces] contact is missing; give "
          "elastic_factor, composite_modulus and friction, or switch it off");
    }
    m.contact.emplace(c.surfaces.shell, c.surfaces.shaft, *c.surfaces.contact);
  }
  const SolidEffects wanted{physics.elastic, physics.film_energy, physics.thermal_deformation};
  if (wanted.elastic || wanted.heat) {
    m.solids = solids && solids->serve(c, s.grid, wanted)
                   ? std::move(solids)
                   : std::make_shared<const Solids>(c, s.grid, wanted);
  }
  return m;
}

Field shear_gap(const BearingModel& model, const Field& h) {
  if (model.scene.rough.sigma <= 0.0) return h;
  fluid::GapTransport gap;
  fluid::gap_transport(model.scene.rough, h, gap);
  return std::move(gap.average_gap);
}

}  // namespace shellback::bearing
