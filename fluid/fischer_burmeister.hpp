#pragma once
/// Fischer-Burmeister form of the cavitation condition: the fallback when active sets cycle.
///
/// With P = (p - p_cav)/p_ref and c = 1 - theta, both >= 0 and one of them zero:
///   phi(P, c) = P + c - sqrt(P^2 + c^2) = 0.
/// In each cell the variable with the smaller |d phi| is eliminated, so that the matrix keeps the
/// film's five-point pattern; the step is shortened until |m|^2 + |phi|^2 falls. p_ref is the
/// local scale of the pressure, so that P and c are of one size. Source: methods 1.2.
#include "fluid/film_solution.hpp"

namespace shellback::fluid {

/// One damped step on solution.state; also refreshes its oil and flow. False if the matrix is
/// singular or no step length reduces the merit.
bool fischer_burmeister_step(const FilmScene& scene, const Gap& gap, const Field& profile,
                             const OilLaw& oil, FilmSolution& solution);

/// The highest pressure over that of cavitation, at least 1 Pa [Pa]: p_ref.
[[nodiscard]] double pressure_scale(const FilmScene& scene, const FilmState& state);

/// True if (2) of reynolds.hpp holds in every cell, to round-off.
[[nodiscard]] bool complementary(const FilmScene& scene, const FilmState& state);

/// Hash of the set of full cells.
[[nodiscard]] std::size_t active_set_hash(const FilmState& state);

}  // namespace shellback::fluid
