#pragma once
/// The oil in the gap over grooves and holes, in time.
///
/// A groove or hole of the shell is a pocket of constant volume under the journal. As the gap over
/// it opens, the pocket takes oil out of its supply, and gives it back as the gap closes:
///   M = sum rho h A over the cells of the patch,   outflow = flow into the film + dM/dt       (1)
/// In a stage of a step (film_step.hpp) of length `own` that begins from M*, dM/dt = (M - M*)/own.
/// The pocket stays full: what a vessel at the cavitation pressure cannot give is missing in its
/// balance (vessels.hpp) until the gap has closed again. Source: textbook (a piston's flow).
#include "bearing/film/equilibrium.hpp"

namespace shellback::bearing {

/// M of every patch, whole bearing [kg]; zero for lines and for drillings, whose cells are film.
[[nodiscard]] std::vector<double> oil_in_pockets(const BearingModel& model,
                                                 const FilmEquilibrium& film);

/// Adds dM/dt to the outflow of every patch, (1) [kg/s].
void count_pockets(const BearingModel& model, const FilmEquilibrium& film,
                   const std::vector<double>& star, double own, fluid::OilFlows& flows);

/// Work of the supplies on the oil that fills their pockets from one film to the other, whole
/// bearing [J]. What flows out of a pocket into the film is told without it.
[[nodiscard]] double work_on_pockets(const BearingModel& model, const FilmEquilibrium& before,
                                     const FilmEquilibrium& after);

}  // namespace shellback::bearing
