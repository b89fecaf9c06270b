#pragma once
/// What a fine grid would give, from full solutions on coarse grids and their films on finer ones.
///
/// Around the bearing the film alone needs fine cells: cavitation, the neighbourhood of the
/// smallest gap. Temperatures and deformation are smooth around, but steep towards the edges. So
/// each full solution V on a x b cells is followed by its film on r a x b cells, temperatures and
/// deformation held (frozen_film.hpp), which gives F. An error that falls as n^-p with the cells n
/// leads from two grids m < n on to N cells by
///   onward(m, n, N, p) = (n^-p - N^-p) / (m^-p - n^-p)                                  (1)
/// of the step between them, hence around and then, from one full solution to the next, along:
///   L = F + (F - V) onward(a, r a, 800, p_f),    value = L1 + (L1 - L0) onward(b0, b1, 100, p_s)
///   (2)
/// The value is that of the fine grid, 800 x 100 cells, which full solutions are compared with;
/// what that grid itself still lacks, the same steps led on to infinitely many cells, is told
/// apart. The second of these is left out between grids that lie close together along the axis. p_f
/// = 1.5, between the first order of cavitation's ends and the second of full films; p_s = 2. Bars:
/// the spread of (2) between p_f = 1 and 2, a part of |L1 - L0| and of the step before.
/// Richardson's extrapolation, textbook; orders and parts are ours, tuned on random cases
/// (docs/auto-tier.md).
#include <array>

namespace shellback::fidelity {

/// Cells around and along the full width of the grid that values are meant for.
inline constexpr std::array<int, 2> kFineGrid{800, 100};

struct GridLimit {
  double value = 0.0;
  double bar = 0.0;     ///< half-width, in the unit of the value
  double beyond = 0.0;  ///< from the fine grid to infinitely many cells, in the unit of the value
};

/// Half-width around the value that is to hold the limit of fine grids too.
[[nodiscard]] double full_bar(const GridLimit& l);

/// Part of a step from m to n cells that is still to come up to `end` cells (infinity: all), for an
/// error of order p; zero if n is there already.
[[nodiscard]] double onward(double m, double n, double end, double p);

/// L of (2): `whole` V on `cells` around, `film` F on `film_cells` (NaN: not solved, then V).
[[nodiscard]] GridLimit film_limit(double whole, double film, int cells, int film_cells);

/// The value of (2): two L, on b0 and b1 cells along; `before`: L of `coarse` minus that of the
/// grid before it, NaN if there was none.
[[nodiscard]] GridLimit grid_limit(const GridLimit& coarse, const GridLimit& fine, int b0, int b1,
                                   double before);

/// The value of the fine grid itself, `whole`, solved after `coarse` on `cells` around.
[[nodiscard]] GridLimit fine_limit(double coarse, double whole, int cells);

}  // namespace shellback::fidelity
