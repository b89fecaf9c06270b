#pragma once
/// The limit of fine grids, from full solutions on coarse grids and their films on finer ones.
///
/// Around the bearing the film alone needs fine cells: cavitation, the neighbourhood of the
/// smallest gap. Temperatures and deformation are smooth around, but steep towards the edges. So
/// each full solution V on nt x nz cells is followed by its film on r nt x nz cells, temperatures
/// and deformation held (frozen_film.hpp), which gives F, and
///   L = F + (F - V) g(r, p_f),   g(r, p) = 1/(r^p - 1)                                 (1)
/// is the value of that solution for fine cells around. From one full solution to the next, along
/// the axis s times finer, L moves by what temperatures, deformation and the edges still lacked:
///   limit = L1 + (L1 - L0) g(s, p_s).                                                    (2)
/// p_f = 1.3, between the first order of cavitation's ends and the second of full films; p_s = 2.
/// Bars: the spread of (1) between p_f = 1 and 2, and a part of |L1 - L0|, a smaller one where the
/// step before was larger and of the same sign. Richardson's extrapolation, textbook; orders and
/// parts are ours, tuned on random cases (docs/auto-tier.md).
namespace shellback::fidelity {

struct GridLimit {
  double value = 0.0;
  double bar = 0.0;  ///< half-width, in the unit of the value
};

/// (1): `whole` V, `film` F (NaN: not solved, then V), `ratio` r.
[[nodiscard]] GridLimit film_limit(double whole, double film, double ratio);

/// (2): two film limits, `ratio` s, at least 1; `before`: L of `coarse` minus that of the grid
/// before it, NaN if there was none.
[[nodiscard]] GridLimit grid_limit(const GridLimit& coarse, const GridLimit& fine, double ratio,
                                   double before);

}  // namespace shellback::fidelity
