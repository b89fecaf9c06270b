#pragma once
/// Error bar of the discretisation from the values on nested grids.
///
/// The value on a grid of N = nt x nz cells over the full width is taken as
///   f(h) = f_0 + a h^p,   h = N^(-1/2)                                                    (1)
/// Three grids give the observed order p from (f3 - f2)/(f2 - f1) = (h3^p - h2^p)/(h2^p - h1^p)
/// (1 finest) for any ratios of refinement. The bar of the finest value is
///   bar = F(h1) d / ((h2/h1)^p - 1) + noise,                                              (2)
///   d = max(|f2 - f1|, |f3 - f2| (h2^q - h1^q)/(h3^q - h2^q)),   q the highest order      (3)
///   F(h) = 1.5 sqrt(max(1, h/h_200x25))                                                   (4)
/// (3): two values that happen to agree are no proof of a limit; the change before tells what is
/// left at best. (4): coarse sequences are further from (1). Orders, F and kShare were set on
/// random bearings, see docs/decisions/011. Source: methods 7.1, 5 (GCI with three grids); (1)
/// and (2) textbook; (3), (4) our own.
#include <string>
#include <vector>

#include "coupling/result.hpp"

namespace shellback::fidelity {

/// Value on one grid.
struct GridValue {
  double h = 0.0;      ///< cell size N^(-1/2), in any unit [-]
  double value = 0.0;  ///< any unit
  double noise = 0.0;  ///< what it is uncertain by for lack of iteration, same unit
};

struct GridBar {
  double bar = 0.0;    ///< same unit as the values; NaN: unknown
  double order = 0.0;  ///< observed order as used; NaN: two grids only
};

/// Orders that whole solutions show: films and their torque fall with the second, ends of the film
/// and edges of elastic bodies with the first. The highest is the one of 1.5, 1.75 and 2 that keeps
/// bars short while 94 % hold (table in docs/decisions/011).
inline constexpr double kLeastOrder = 1.0;
inline constexpr double kMostOrder = 1.75;

/// No bar is shorter, against the size of its quantity, than this part of the median bar of all
/// quantities of the result: they share one film, and a small change of one is often chance [-].
inline constexpr double kShare = 0.2;

/// Order p in [kLeastOrder, kMostOrder] of three values, coarsest first; NaN if they do not
/// approach a limit (oscillating, or moving away).
[[nodiscard]] double observed_order(const std::vector<GridValue>& coarse_to_fine);

/// Bar of the last of two or more values, coarsest first; only the last three are used. With one
/// value: not-a-number.
[[nodiscard]] GridBar grid_bar(const std::vector<GridValue>& coarse_to_fine);

/// Bar of `own` where only one finer grid gave a value: with the lowest order,
///   bar = F(h) |own - finer| / (1 - (h_finer/h)^p) + noise.
[[nodiscard]] GridBar grid_bar_below(const GridValue& own, const GridValue& finer);

/// True if the tier takes the quantity from the case: what is given has no error of the grid.
[[nodiscard]] bool given_by_case(const coupling::Case& c, coupling::Tier tier,
                                 const std::string& name);

/// The size against which a small change of the quantity is measured: for temperatures the rise
/// above the supply, for components of a vector its length, else the value [unit of quantity].
[[nodiscard]] double natural_size(const coupling::Quantity& q, double T_supply,
                                  const std::vector<coupling::Quantity>& all);

}  // namespace shellback::fidelity
