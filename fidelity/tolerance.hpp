#pragma once
/// Whether a result is as good as its case asks for, and what would make it so.
///
/// `model.tolerance` is wished for on friction torque and smallest film. The bar of the grid falls
/// as h^p with the cell size h = N^(-1/2) and the observed order p (grid_error.hpp); so
///   N_wanted = N (bar / allowed)^(2/p),   allowed = tolerance - bar of the physics left out   (1)
/// cells are expected to bring it within. Cells do not take off what the nodes across the film
/// leave: where that is more than kWorthAGrid of what is allowed, kMoreNodes more are expected to,
/// with which it was measured; otherwise it counts as allowed less. Where the physics left out
/// takes all or most of the tolerance, no grid does. Textbook (Richardson).
#include <algorithm>
#include <array>
#include <cmath>

#include "bearing/result.hpp"

namespace shellback::fidelity {

/// Bars, over their values, of the two quantities that the tolerance is for [-].
struct Bars {
  double friction = INFINITY;  ///< of the friction torque, over a cycle its mean
  double h_min = INFINITY;
  [[nodiscard]] double larger() const { return std::max(friction, h_min); }
  [[nodiscard]] bool within(double tolerance) const {
    return friction <= tolerance && h_min <= tolerance;
  }
};

/// Bars over the value of one quantity [-]; NaN: not known.
struct RelativeBars {
  double grid = 0.0;
  double model = 0.0;
  double order = 0.0;  ///< with which `grid` falls
  double nodes = 0.0;  ///< part of `grid` that only more nodes across the film take off
  /// The known ones together.
  [[nodiscard]] double total() const;
};
/// False if the warnings tell of vortices or turbulence, which no tier knows.
[[nodiscard]] bool is_laminar(const std::vector<bearing::Note>& warnings);

[[nodiscard]] RelativeBars relative_bars(const bearing::Result& r, const std::string& quantity);

/// What stands between a result and its tolerance.
struct Shortfall {
  double tolerance = 0.0;  ///< [-]
  RelativeBars friction;
  RelativeBars h_min;
  bool met = true;                ///< both bars are within; also where none is known
  bool laminar = true;            ///< false: of a film that it is not, bars tell nothing
  bool physics = false;           ///< what is left out exceeds what a grid could make up for
  std::array<int, 2> grid{0, 0};  ///< by (1), no finer than the finest that values are meant for
  double expected = 0.0;          ///< larger of both bars there [-]
  bool more_nodes = false;        ///< and with kMoreNodes more across the film
};
/// Part of the tolerance that a grid must be left for it to be worth while: its cells grow as the
/// inverse square [-].
inline constexpr double kWorthAGrid = 0.25;
/// `nodes_stay`: there cannot be more nodes across the film.
[[nodiscard]] Shortfall shortfall(const bearing::Result& r, double tolerance,
                                  bool nodes_stay = false);

/// True if the values differ by more than the bars of their grids together (the sum: a bar holds
/// the true value, it is no standard deviation); also if a bar is not known. Bars of the physics
/// left out do not count: results of one physics share it, and between two kinds of physics it is
/// the difference.
[[nodiscard]] bool told_apart(const bearing::Quantity& a, const bearing::Quantity& b);

}  // namespace shellback::fidelity
