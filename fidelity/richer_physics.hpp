#pragma once
/// The way from one tier to the fullest physics that the case has the data for, effect by effect.
#include <string>
#include <vector>

#include "coupling/case.hpp"

namespace shellback::fidelity {

/// One more effect than the step before.
struct PhysicsStep {
  std::string effect;    ///< its name, as in coupling/effects
  coupling::Case input;  ///< the case with the switches set for it
  coupling::Tier tier = coupling::Tier::isothermal;
};

/// True if the case has what the heat in shell and shaft needs: both, and a way out for the heat.
[[nodiscard]] bool knows_its_walls(const coupling::Case& c);

/// Effects that the tier (with the case's own switches) leaves out and the case has data for, each
/// step with all before it: heating, temperature across the film, thermal deformation, elastic
/// deformation, viscosity with pressure, shear thinning, roughness and contact. The last step is
/// the fullest physics; empty: the tier is that already.
[[nodiscard]] std::vector<PhysicsStep> richer_physics(const coupling::Case& c, coupling::Tier tier);

/// Effects that nothing can be said about, since the case lacks their data.
[[nodiscard]] std::vector<std::string> unknown_effects(const coupling::Case& c);

/// Each effect that the tier includes, taken out alone.
[[nodiscard]] std::vector<PhysicsStep> poorer_physics(const coupling::Case& c, coupling::Tier tier);

}  // namespace shellback::fidelity
