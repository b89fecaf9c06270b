#pragma once
/// Effects that a tier may leave out, and limiters that may act. Their words are made in app/words.

namespace shellback::bearing {

enum class EffectKind {
  heating,
  temperature_across_film,
  elastic_deformation,
  thermal_deformation,
  viscosity_with_pressure,
  shear_thinning,
  roughness_and_contact,
  turbulence,          ///< and Taylor vortices
  film_inertia,        ///< of the film as it turns
  inertia_of_fed_oil,  ///< pressed out of a supply
};

enum class Limiter {
  rejected_steps,      ///< of Newton's method
  backflow_nodes,      ///< of the film, with flow against the rotation
  upwind_columns,      ///< of the film, with upwind fluxes across it
  held_at_hardness,    ///< cells whose contact pressure ends there
  beyond_contact_law,  ///< cells pressed deeper than the law of contact goes
  bent_edges,          ///< places whose gap is held open, on side edges and beside supplies
                       ///< (fluid::edge_gap)
  steps_too_long,      ///< in time, that err by more than they may
};

}  // namespace shellback::bearing
