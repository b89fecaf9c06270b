#pragma once
/// Film and elastic displacement in turn, as most programs do it.
///
///   film and position of the bearing that is widened by d  ->  pressures  ->  d* = C (p + p_a),
///   d <- d + omega (d* - d)                                                              (1)
/// omega is fixed (Methods::relaxation), or Aitken's: with r = d* - d of this and r' of the last
/// round, omega <- - omega' r'.(r - r')/|r - r'|^2, held to [0.01, 1]. It converges where the
/// displacement is small against the film, as in a stiff bearing; where it is many times the film,
/// each round answers with the wrong film and (1) diverges: that is named, with the ratio.
/// Source: textbook (Gauss-Seidel of two fields, Aitken's vector extrapolation).
#include "bearing/film/equilibrium.hpp"

namespace shellback::validation {

/// As solve_equilibrium, for an elastic bearing.
[[nodiscard]] Verdict elastic_fixed_point(const bearing::FilmTask& task,
                                          bearing::FilmEquilibrium& state,
                                          bearing::EquilibriumCost& cost);

}  // namespace shellback::validation
