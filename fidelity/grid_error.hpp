#pragma once
/// Error of the discretisation from the values on nested grids: what a finer one would give, and
/// the bar of that.
///
/// An error that falls as n^-p with the cells n of one direction leads from two grids m < n on to N
/// cells by
///   onward(m, n, N, p) = (n^-p - N^-p) / (m^-p - n^-p)                                    (1)
/// of the step between them (Richardson, textbook).
///
/// Same refinement of both directions: n = N^(1/2) = 1/h, N = nt x nz over the full width. Three
/// grids give the observed order p. The bar of the finest value f1 is
///   bar = F(h1) d onward(n2, n1, infinity, p) + noise,                                    (2)
///   d = max(|f2 - f1|, |f3 - f2| onward(n3, n2, n1, q)),   q the highest order            (3)
///   F(h) = 1.5 sqrt(max(1, h/h_200x25))                                                   (4)
/// Values that move on in one direction slower than with order 1/2 on grids that are halved show no
/// limit; their bar is, if longer, 1.5 d onward(n2, n1, infinity, 1/2): F does not come on top,
/// which stands for the same. (3): two values that happen to agree are no proof of a limit; the
/// change before tells what is left at best. (4): coarse sequences are further from (1). Orders and
/// F were set on random bearings, docs/decisions/011. Source: methods 7.1, 5 (GCI with three
/// grids); (3), (4) our own.
///
/// What the grids lead to: from the two finest to infinitely many cells with the highest order,
///   limit = f1 + (f1 - f2) onward(n2, n1, infinity, 1.75),                                (5)
/// nearer to the truth than f1 on four bearings of five (docs/error-bars.md has the table, for
/// orders from 1 to 2 and the observed one).
///
/// One direction after the other (tier `auto`): around the bearing the film alone needs fine cells;
/// temperatures and deformation are smooth around, but steep towards the edges. So each full
/// solution V on a x b cells is followed by its film F on r a x b cells (held_film.hpp); then
///   L = F + (F - V) onward(a, r a, 800, p),  value = L1 + (L1 - L0) onward(b0, b1, 100, q)    (6)
/// is that of 800 x 100 cells. Around, the middle between the lowest and the highest order is taken
/// and their difference is the bar; along, the last step with what it is led on by. What 800 x 100
/// cells lack to the limit, the same steps with the lowest order, is told apart.
#include <array>
#include <utility>
#include <vector>

namespace shellback::fidelity {

/// Part of a step from m to n cells that is still to come up to `end` cells (infinity: all), for an
/// error of order p; zero if n is there already.
[[nodiscard]] double onward(double m, double n, double end, double p);

/// Value on one grid.
struct GridValue {
  double h = 0.0;      ///< cell size N^(-1/2), in any unit [-]
  double value = 0.0;  ///< any unit
  double noise = 0.0;  ///< what it is uncertain by for lack of iteration, same unit
};

struct GridBar {
  double bar = 0.0;    ///< same unit as the values; NaN: unknown
  double order = 0.0;  ///< observed order as used; NaN: two grids, or no limit in sight
  double limit = 0.0;  ///< (5), same unit; NaN: one grid alone, or three without an order
};

/// Orders that whole solutions show: films and their torque fall with the second, ends of the film
/// and edges of elastic bodies with the first. The highest is the one of 1.5, 1.75 and 2 that keeps
/// bars short while 94 % hold (table in docs/decisions/011).
inline constexpr double kLeastOrder = 1.0;
inline constexpr double kMostOrder = 1.75;
/// Values that move on in one direction slower than with this order have no limit in sight: they
/// get no order, and the bar of this one.
inline constexpr double kSlowOrder = 0.5;

/// F of (4) on 200 x 25 cells and finer [-].
inline constexpr double kSafety = 1.5;

/// Order p in [kLeastOrder, kMostOrder] of three values, coarsest first; NaN if they do not
/// approach a limit (oscillating, or moving away).
[[nodiscard]] double observed_order(const std::vector<GridValue>& coarse_to_fine);

/// Bar of the value on the grid of cell size `h`, one of two or more values, coarsest first; only
/// the last three are used. With one value: not-a-number.
[[nodiscard]] GridBar grid_bar(const std::vector<GridValue>& coarse_to_fine, double h);

/// A bar and the size of its quantity.
struct BarOfSize {
  double* bar = nullptr;
  double size = 0.0;
  bool part = false;  ///< of another quantity, or a slope of it: no witness of its own
};

/// No bar is left shorter, against the size of its quantity, than a fifth of the median one: all
/// share one film, and a small change of one is often chance. Bars that are not known have no part
/// in the median, nor have those of parts: four parts of a light contact's friction, each known to
/// twice itself, would be most of what a load cycle tells.
void share_bars(const std::vector<BarOfSize>& bars);

/// Cells around and along the full width of the grid that the values of tier `auto` are meant for.
inline constexpr std::array<int, 2> kFineGrid{800, 100};

struct GridLimit {
  double value = 0.0;   ///< on the fine grid
  double bar = 0.0;     ///< half-width, in the unit of the value
  double beyond = 0.0;  ///< and from the fine grid to infinitely many cells
};

/// L of (6): `whole` V on `cells` around, `film` F on `film_cells` (NaN: not solved, then V).
[[nodiscard]] GridLimit film_limit(double whole, double film, int cells, int film_cells);

/// The value of (6): two L, on b0 and b1 cells along.
[[nodiscard]] GridLimit grid_limit(const GridLimit& coarse, const GridLimit& fine, int b0, int b1);

}  // namespace shellback::fidelity
