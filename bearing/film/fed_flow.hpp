#pragma once
/// How fast oil is pressed out of supplies: what a film without inertia does not know.
///
/// On each side of a supply's patch, along the side edges in equal pieces of about 30 degrees, with
/// the pressure-driven part m_p of the mass flow out of it, of no face more than leaves there on
/// the whole, widths w and gaps h of the film's cells there,
///   u = sum m_p/sum(rho h w),   Re = rho u h/eta,   head = 1/2 rho u^2                         (1)
/// A mean over the side: at a patch's corners the flow of a film without inertia has no bound.
/// Oil that enters a gap takes its head from the pressure that drives it (textbook: Bernoulli).
/// Beyond a tenth of it the flow is less than the film's by several per cent; beyond Re of 1000
/// laminar flow between plates becomes turbulent (textbook: 1000 to 1400 by mean velocity and gap).
#include "bearing/film/equilibrium.hpp"
#include "bearing/note.hpp"

namespace shellback::bearing {

/// The fastest oil on its way out of a supply, by the part of its pressure that its head is; its
/// Reynolds number is the largest of all. Zero where none is pressed out. Of the film as it stands,
/// over a cycle, too; a drilling's mouth is a source of cells and not looked at.
[[nodiscard]] note::FedFlow fed_flow(const fluid::FilmScene& scene, const Evaluation& film);

/// What is worse in either of two films.
[[nodiscard]] note::FedFlow worse(note::FedFlow a, const note::FedFlow& b);

inline constexpr double kHeadThatCounts = 0.1;    ///< of what drives the oil, see (1) [-]
inline constexpr double kTurbulentFlow = 1000.0;  ///< Re, the same [-]

/// One note where it leaves what a film without inertia bears.
void add_fed_flow(const note::FedFlow& flow, std::vector<Note>& notes);

}  // namespace shellback::bearing
