#pragma once
/// Friction of a solved film: viscous shear of both surfaces, and that of their summits.
///
/// Viscous: tau = U/g0 (phi_f + phi_fs)/h and what pressure drives (fluid/resultants.hpp, theory
/// 6). In a groove the oil is sheared over gap and depth, and thins by that rate of shear.
/// Asperities: the boundary law on the contact pressure (solid/boundary_friction.hpp).
#include "bearing/film/equilibrium.hpp"

namespace shellback::bearing {

/// Friction of a solved film.
struct Friction {
  fluid::ShearStress stress;   ///< viscous [Pa]
  double viscous = 0.0;        ///< torque on the journal [N m]
  double viscous_shell = 0.0;  ///< torque on the shell [N m]
  double asperity = 0.0;       ///< torque [N m]
  [[nodiscard]] double torque() const { return viscous + asperity; }  ///< on the journal [N m]
};
[[nodiscard]] Friction friction_of(const BearingModel& model, const OperatingPoint& point,
                                   const FilmEquilibrium& s);

/// Cell `c` as the law of boundary friction sees it; there is contact in the model.
[[nodiscard]] solid::RubbingPlace rubbing_place(const BearingModel& model,
                                                const OperatingPoint& point,
                                                const FilmEquilibrium& s, std::size_t c);

/// Shear stress of the asperities per cell, in its parts [Pa], opposing the motion; empty without
/// contact. Pressure, gap and, harmonic across the film as for viscous shear, viscosity are those
/// of the cell (at its temperature, pressure and shear rate).
struct AsperityStress {
  Field abrasive, adhesive, micro_hydrodynamic;
  [[nodiscard]] Field sum() const;
};
[[nodiscard]] AsperityStress asperity_stress(const BearingModel& model, const OperatingPoint& point,
                                             const FilmEquilibrium& s);

/// Torque at which a journal at rest would begin to turn: that of the boundary coefficient at rest
/// on the contact pressure [N m].
[[nodiscard]] double breakaway_torque(const BearingModel& model, const OperatingPoint& point,
                                      const FilmEquilibrium& s);

}  // namespace shellback::bearing
