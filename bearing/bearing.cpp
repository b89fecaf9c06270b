#include "bearing/bearing.hpp"

#include <algorithm>

#include "bearing/bore_shape.hpp"
#include "bearing/possible_methods.hpp"
#include "bearing/solids.hpp"
#include "core/bulk_node.hpp"
#include "core/contract.hpp"
#include "core/even_layers.hpp"
#include "core/make_grid.hpp"
#include "core/ring_matrix.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {
namespace {

std::vector<fluid::SupplyPatch> patches_of(const Case& c) {
  std::vector<fluid::SupplyPatch> patches;
  for (const Supply& given : c.supplies) {
    const Supply s = enclosed(given, c.bearing.radius);
    fluid::SupplyPatch p;
    p.phi = s.angle;
    p.z = s.z;
    p.arc = s.arc;
    p.length = s.length;
    p.pressure = s.pressure;
    p.depth = s.depth;
    p.moving = s.kind == SupplyKind::drilling;
    p.round = is_round(s);
    patches.push_back(p);
  }
  return patches;
}

fluid::RoughPair rough_pair(const Surfaces& s) {
  return fluid::rough_pair({s.shell.roughness, s.shell.orientation},
                           {s.shaft.roughness, s.shaft.orientation},
                           s.flow_factors ? &*s.flow_factors : nullptr);
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

rheology::Oil oil_of(const Case& c, const Physics& physics) {
  rheology::Oil oil = c.oil;
  if (!physics.pressure_dependence) oil = rheology::without_pressure_effect(oil);
  if (!physics.shear_thinning) oil = rheology::without_shear_thinning(oil);
  return oil;
}

std::optional<solid::AsperityContact> contact_of(const Case& c) {
  if (!c.surfaces.contact) return {};
  solid::ContactParameters contact = *c.surfaces.contact;
  contact.hardness = hardness_of_contact(c);
  return solid::AsperityContact(c.surfaces.shell, c.surfaces.shaft, contact);
}

AxialSpacing axial_spacing(const Case& c) {
  const bool edges_rule = c.surfaces.contact && !c.cycle;
  return c.model.axial_spacing.value_or(edges_rule ? AxialSpacing::graded : AxialSpacing::even);
}

bool symmetric_about_mid_width(const Case& c) {
  if (const auto* tilt = std::get_if<TiltGiven>(&c.operation.alignment)) {
    if (tilt->about_x != 0.0 || tilt->about_y != 0.0) return false;
  } else {
    return false;
  }
  const bool centred =
      std::all_of(c.supplies.begin(), c.supplies.end(), [](const Supply& s) { return s.z == 0.0; });
  return centred && bore_is_symmetric(c.bearing);
}

int most_axial_cells(const Case& c) {
  return kLongestLine * (symmetric_about_mid_width(c) ? 2 : 1);
}

namespace {

/// Edges of supplies, and where relief and chamfer begin: however narrow, cells lie within them.
GridEdges axial_edges(const Case& c, const std::vector<fluid::SupplyPatch>& patches) {
  GridEdges edges = fluid::z_edges(patches);
  for (const auto& opening : {c.bearing.edge_relief, c.bearing.chamfer}) {
    if (!opening) continue;
    const double foot = 0.5 * c.bearing.width - opening->length;
    edges.emplace_back(-foot, -1, true);
    edges.emplace_back(foot, -1, true);
  }
  return edges;
}

}  // namespace

FilmGrid film_grid(const Case& c, std::array<int, 2> grid) {
  const auto patches = patches_of(c);
  return make_grid(c.bearing.radius, c.bearing.width, grid[0], grid[1],
                   symmetric_about_mid_width(c), fluid::phi_edges(patches), axial_edges(c, patches),
                   axial_spacing(c) == AxialSpacing::graded ? kEdgeGrading : 0.0);
}

fluid::SupplyMap supply_map(const Case& c, std::array<int, 2> grid) {
  return fluid::map_supplies(film_grid(c, grid), patches_of(c));
}

bool holds_supplies(const Case& c, std::array<int, 2> grid) {
  try {
    const std::vector<int> touching = supply_map(c, grid).touching;
    for (std::size_t k = 0; k < touching.size(); ++k) {
      const bool alone = std::count(touching.begin(), touching.end(), touching[k]) == 1;
      if (c.supplies[k].vessel && !alone) return false;
    }
    return true;
  } catch (const InputError&) {
    return false;
  }
}

BearingModel make_bearing(const Case& c, const Physics& physics, std::array<int, 2> grid,
                          std::shared_ptr<const Solids> solids) {
  BearingModel m;
  m.input = c;
  m.physics = physics;
  expect_possible_methods(c, physics);
  m.gl = nodes_across(c, physics);
  m.clearance = c.bearing.radial_clearance;
  m.oil = oil_of(c, physics);
  fluid::FilmDomain& s = m.domain;
  s.grid = film_grid(c, grid);
  s.angles = fluid::Angles(s.grid);
  m.supply = fluid::map_supplies(s.grid, patches_of(c));
  s.p_cavitation = c.model.cavitation_pressure;
  s.p_edge = std::max(0.0, s.p_cavitation);
  s.edges = c.model.edges == Edges::dry ? fluid::SideEdges::dry : fluid::SideEdges::flooded;
  if (physics.flow_factors) s.rough = rough_pair(c.surfaces);
  m.profile = profile_of_cells(c.bearing, s.grid);
  m.shape = shape_of(c.bearing, s.grid);
  s.shape_beside = shape_beside_faces(s.grid, m.shape);
  m.shear_rule = c.model.cavitated_shear == CavitatedShear::full ? fluid::CavitatedShear::full
                                                                 : fluid::CavitatedShear::filled;
  if (physics.contact) {
    if (!c.surfaces.contact) {
      throw InputError(
          "asperity contact is switched on but [surfaces] contact is missing; give "
          "elastic_factor, composite_modulus and friction, or switch it off");
    }
    m.contact = contact_of(c);
  }
  const SolidEffects wanted{physics.elastic, physics.film_energy, physics.thermal_deformation};
  if (wanted.elastic || wanted.heat) {
    m.solids = solids && solids->serve(c, s.grid, wanted)
                   ? std::move(solids)
                   : std::make_shared<const Solids>(c, s.grid, wanted);
  }
  return m;
}

fluid::Gap gap_at(const BearingModel& m, const fluid::JournalPosition& position,
                  const Field& displacement) {
  return fluid::film_gap(m.domain.grid, m.domain.angles, m.clearance, position, displacement,
                         m.profile, m.shape.cell.empty() ? nullptr : &m.shape,
                         kSummits * m.domain.rough.sigma, &m.supply);
}

Field shear_gap(const BearingModel& model, const Field& h) {
  if (model.domain.rough.sigma <= 0.0) return h;
  fluid::GapTransport gap;
  fluid::gap_transport(model.domain.rough, h, gap);
  return std::move(gap.average_gap);
}

}  // namespace shellback::bearing
