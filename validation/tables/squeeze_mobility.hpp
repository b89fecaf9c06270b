#pragma once
/// How fast a load moves a journal through the film of a finite bearing: one point of the table of
/// mobilities.
///
/// Unknowns are the pressure p >= 0 of a rigid, smooth, isoviscous film and the journal's velocity
/// v as the oil sees it, which turns with half the journal's speed (textbook, Booker's mobility):
///
///   -div(h^3/(12 eta) grad p) >= v . n,  equal where p > 0;   h = c (1 - eps cos phi)       (1)
///   int p n dA = W                                                                         (2)
///
/// n points from the axis to the shell at the angle phi, counted from the line of centres; p = 0
/// at the ends of the bearing. (1) is the condition of Swift and Stieber for any direction of v. It
/// is what a film that conserves oil does as long as it is full where it closes (a full film in
/// which oil can only be lost), and (1) and (2) are the conditions of a minimum: p and v exist and
/// are unique, and v is the slope of a convex function of W; with alpha the angle from the load to
/// the line of centres (counter-clockwise, as "across"),
///
///   v = c |W| psi^2/(eta B D) M(alpha),   M_across = -1/2 d M_along/d alpha.               (3)
///
/// Cells of second order on the half width, crowded where the film is thin and towards the edge;
/// the cells with pressure are found by Newton's method for (1)-(2) (an active set).
#include <optional>
#include <vector>

#include "core/eigen.hpp"
// after the alignment
#include <Eigen/SparseCholesky>

namespace shellback::validation {

/// Numbers of one place and one direction of the load.
struct MobilityPoint {
  double along = 0.0;     ///< M along the load [-]
  double across = 0.0;    ///< M across it, counter-clockwise [-]
  double pressure = 0.0;  ///< largest p over W/(B D) [-]
  double side = 0.0;      ///< oil pressed out of the edges over 2 R B |v| [-]
};

/// The angle phi from the line of centres at which the sweep is s, -pi ... pi [rad]: half the angle
/// plus half that of Sommerfeld's substitution, in which the thin film is as wide as any. Equal
/// steps of s spread the thin film and leave the rest its cells. `eps` below 1.
[[nodiscard]] double angle_of_sweep(double s, double eps);

class SqueezeMobility {
 public:
  /// `b` = B/D; cells around and along the half width.
  SqueezeMobility(double b, double eps, int around, int along);

  /// `load`: the angle from the line of centres to the load [rad]. None: the set of cells with
  /// pressure does not settle.
  [[nodiscard]] std::optional<MobilityPoint> at(double load);

 private:
  using Vector = Eigen::VectorXd;
  void assemble();
  /// v for a load of the direction (x, y), with pressure in the cells of `full_`.
  [[nodiscard]] Eigen::Vector2d solve(double x, double y);
  /// Cells that change sides.
  int exchange(const Eigen::Vector2d& v);

  double b_, eps_;
  int nt_, nz_;
  std::vector<double> face_;  ///< angles of the faces around
  std::vector<double> edge_;  ///< faces along the half width, 0 ... 1
  Eigen::SparseMatrix<double> a_;
  Eigen::SparseMatrix<double> reduced_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  Eigen::Matrix<double, Eigen::Dynamic, 2> n_;  ///< integral of n over each cell
  Vector edge_conductance_;                     ///< of each cell to the end of the bearing
  Vector p_;                                    ///< over eta R^2/c^3
  std::vector<char> full_;
};

}  // namespace shellback::validation
