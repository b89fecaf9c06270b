#pragma once
/// Why film and heat found no common state, and where it shows.
#include <optional>

#include "bearing/film/solution.hpp"

namespace shellback::bearing {

/// Largest rise of the film over the supply that is looked at [K]: no oil film survives hotter, and
/// no law of an oil holds there.
inline constexpr double kHottestRise = 400.0;

/// The polynomials across the film ripple by this much [K]: less is not worth telling.
inline constexpr double kUndershoot = 2.0;
/// Change of the walls from one iteration to the next that is too large for a balance, and that a
/// finer grid makes in any case [K].
inline constexpr double kWallsOff = 0.1;

/// Good unless a temperature or the thermal deformation is not a number.
[[nodiscard]] Verdict fields_finite(const Solution& s);

/// The same, and unless the oil's laws do not hold at a temperature.
[[nodiscard]] Verdict temperatures_possible(const Solution& s);

/// Coldest temperature given: supplies, surroundings of the shell and, if it has an overhang, of
/// the shaft [K].
[[nodiscard]] double coldest_around(const Case& c, const Solids& solids);

/// Whether thermal deformation closes the bearing before it makes any heat: everything at the
/// coldest temperature given, or else at the warmest one; none: there is room at both. The
/// operators must hold thermal deformation.
[[nodiscard]] std::optional<ending::NoClearance> closed_at_rest(const Case& c, const Solids& solids,
                                                                const FilmGrid& grid);

/// Whether it does so at both: then nothing turns before it makes heat, which alone might open it.
[[nodiscard]] bool closed_at_any_rest(const Case& c, const Solids& solids, const FilmGrid& grid);

/// Good unless the film is colder than everything around it, which the second law forbids.
[[nodiscard]] Verdict colder_than_all_around(const Solution& s);

/// Good unless the last change of the walls [K] is too large for a balance.
[[nodiscard]] Verdict walls_unbalanced(double change);

}  // namespace shellback::bearing
