#pragma once
/// How fast a load moves the journal of a finite bearing, from a table that this project's own
/// solver of the half film has computed (Booker's mobility method).
///
/// Rigid cylinder, smooth, aligned, isoviscous, p = 0 at the ends and where the film opens (the
/// condition of Swift and Stieber in any direction of the motion, validation/tables/
/// squeeze_mobility.hpp). The velocity v = de/dt - omega/2 x e of the journal as the oil sees it
/// follows the load that the film carries, at once and in proportion:
///
///   v = c |W| psi^2/(eta B D) M(eps, alpha; B/D)   [m/s],   psi = c/R                     (1)
///
/// alpha is the angle from the load to the line of centres, counter-clockwise. M has a component
/// along the load and one across it (counter-clockwise); alpha -> -alpha turns the sign of the
/// latter. Textbook; the table is data/tables/bearing_mobility.csv.
///
/// The table holds B/D = 0.05 ... 8, eps = 0.02 ... 0.999 and all alpha. Interpolated (cubics in ln
/// B/D, -ln(1 - eps) and a sweep of alpha that spreads the thin film) are ratios to the sum of the
/// narrow bearing's and the wide bearing's mobility (closed forms below), so that beyond the
/// table's ends these rule; B/D above 8 is taken as 8.
#include <array>
#include <vector>

namespace shellback::fidelity {

/// Relative error of interpolated mobilities, table and interpolation together: 98 of 100 numbers
/// between the rows of the table lie within it (tests/fidelity/mobility_table_test.cpp,
/// docs/auto-tier.md). Of |M| [-].
inline constexpr double kMobilityError = 0.01;

/// Text of the table, built into the program.
[[nodiscard]] const char* bearing_mobility_table();

/// Numbers of one place of the journal under one direction of the load.
struct Mobility {
  double along = 0.0;     ///< M along the load, positive [-]
  double across = 0.0;    ///< M across it, counter-clockwise [-]
  double pressure = 0.0;  ///< largest pressure over W/(B D) [-]
  double side = 0.0;      ///< oil that leaves the edges over 2 R B |v| [-]
};

/// M along the load of the narrow bearing [-]: (1 - eps cos alpha)^(5/2)/(pi b^2), b = B/D, a fit
/// within 6 % (Booker 1965, through ibell/pdsim).
[[nodiscard]] double narrow_mobility(double eps, double alpha, double b);

/// M along the load of the infinitely wide bearing without ends, whose film is full [-] (ours, from
/// Sommerfeld's film with its smallest pressure at zero): the mobility along the line of centres is
/// (1 - eps^2)^(3/2)/(6 pi), across it (2 + eps^2) sqrt(1 - eps^2)/(12 pi).
[[nodiscard]] double wide_mobility(double eps, double alpha);

/// Half the angle alpha plus half that of Sommerfeld's substitution; pi at pi [rad].
[[nodiscard]] double sweep_of(double alpha, double eps);

/// The table at one width over diameter.
class MobilityMap {
 public:
  /// `b` = B/D, positive.
  explicit MobilityMap(double b);

  /// 0 <= eps < 1, any alpha [rad].
  [[nodiscard]] Mobility at(double eps, double alpha) const;

 private:
  using Numbers = std::array<double, 4>;
  /// Value, slopes and mixed slope at a node.
  struct Node {
    Numbers f, u, s, us;
  };
  double b_;
  std::vector<Node> nodes_;  ///< index: of eps * sweeps + of the sweep
};

}  // namespace shellback::fidelity
