#pragma once
/// The skin of a wall in time: what its surface does beyond the mean that the body behind it holds.
///
///   w rho c dT/dt = d/dy (w k dT/dy),   -k dT/dy (0) = q',   T(depth) = 0             (1)
///
/// per cell of the wall, y into it, w = 1 + y/R how it widens (R > 0 the bore of a shell, R < 0 a
/// shaft), layers of different materials in perfect contact; q' is the
/// heat that enters beyond its mean over the period. Heat swings reach sqrt(a period/pi) deep, far
/// less than a cell is wide, so that nothing flows sideways. `depth` is three such depths: what is
/// held there changes the answer to the period by exp(-6), and less what is quicker. Where the
/// layers end before, -k dT/dy = h T stands there, h the heat transfer at their back. Linear
/// elements with lumped heat on nodes graded from a fraction of the depth that the shortest step
/// reaches; every end of a layer is a node.
///
/// Over a step dt from the temperatures T_before (implicit Euler, or a stage of a diagonally
/// implicit Runge-Kutta method)
///   (C/dt + K) T = C/dt T_before + e_0 q',   surface: T_0 = r_0 + Z q'                (2)
/// Z the impedance, r what is left of before. How walls grow by their skins is told by their meshes
/// (bearing/skin_nodes.hpp). Sources: textbook; methods 3.5.
#include <limits>
#include <vector>

namespace shellback::thermal {

/// From the surface inwards.
struct SkinLayer {
  double thickness = 0.0;     ///< [m]
  double conductivity = 0.0;  ///< [W/(m K)]
  double capacity = 0.0;      ///< rho c [J/(m3 K)]
};

/// What depends on the length of a step alone.
struct SkinStep {
  double dt = 0.0;              ///< [s]
  std::vector<double> pivot;    ///< of the tridiagonal matrix of (2), eliminated from the depth
  std::vector<double> by_flux;  ///< of every node per heat that enters [K m2/W]
  [[nodiscard]] double impedance() const { return by_flux.front(); }
};

class WallSkin {
 public:
  /// For changes of this period and steps down to `shortest` of it [s]. Needs a layer; thicknesses,
  /// conductivities and capacities positive. `back`: h of the last layer's end [W/(m2 K)],
  /// infinite where its temperature is held. `curvature`: 1/R of (1), 0 a flat wall; layers end at
  /// a shaft's axis at most [1/m].
  WallSkin(const std::vector<SkinLayer>& layers, double period, double shortest,
           double back = std::numeric_limits<double>::infinity(), double curvature = 0.0);

  [[nodiscard]] int nodes() const { return static_cast<int>(capacity_.size()); }
  /// Depths of the nodes, the first at the surface, and, if it is held, of where T = 0 [m].
  [[nodiscard]] const std::vector<double>& depths() const { return y_; }
  [[nodiscard]] SkinStep over(double dt) const;
  /// r of (2) for one cell: `T` holds its nodes before the step, and then r [K].
  void relax(const SkinStep& step, double* T) const;
  /// Heat held per area [J/m2].
  [[nodiscard]] double heat(const double* T) const;

 private:
  std::vector<double> y_;            ///< [m]
  std::vector<double> conductance_;  ///< between a node and the next one, or the back [W/(m2 K)]
  std::vector<double> capacity_;     ///< of a node [J/(m2 K)]
};

}  // namespace shellback::thermal
