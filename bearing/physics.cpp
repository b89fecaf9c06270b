#include "bearing/physics.hpp"

namespace shellback::bearing {
namespace {

bool chosen(const std::optional<bool>& given, bool usual) { return given.value_or(usual); }

}  // namespace

Physics physics_of(const Case& c, Tier tier) {
  const Switches& s = c.model.switches;
  const bool rough = c.surfaces.shell.roughness > 0.0 || c.surfaces.shaft.roughness > 0.0;
  Physics p;
  p.film_energy = tier == Tier::thd || tier == Tier::tehd;
  p.elastic = chosen(s.elastic_deformation, tier == Tier::tehd);
  p.thermal_deformation = p.film_energy && chosen(s.thermal_deformation, tier == Tier::tehd);
  p.contact = chosen(s.asperity_contact, c.surfaces.contact.has_value());
  p.flow_factors = chosen(s.flow_factors, rough);
  p.pressure_dependence = chosen(s.pressure_dependence, true);
  p.shear_thinning = chosen(s.shear_thinning, true);
  return p;
}

}  // namespace shellback::bearing
