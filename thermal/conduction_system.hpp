#pragma once
/// The discrete heat equation of a body of revolution, harmonic by harmonic: the layered shell with
/// its housing, or the shaft.
///
///   (K_n + M/dt) T_n = f_n + M/dt T_n,before                                              (1)
///
/// T: nodal temperatures above the surroundings [K]; K: conduction and losses, M: heat capacity
/// (thermal/heat_element.hpp), per radian; implicit Euler [textbook], dt = infinity is the steady
/// state. With a prescribed back its line and all outside it are held at zero. The rows of (1) add
/// up to the heat balance: in = through the back + through the ends + stored.
#include <limits>
#include <vector>

#include "core/block_cholesky.hpp"
#include "core/eigen.hpp"
#include "thermal/heat_element.hpp"

namespace shellback::thermal {

/// Owns the element integrals of one body for one time step.
class ConductionSystem {
 public:
  /// Steady. `conductivity[mesh.layer[row]]` [W/(m K)]. Throws InputError if a conductivity is not
  /// positive or a coefficient is negative.
  ConductionSystem(const RevolutionMesh& mesh, const std::vector<double>& conductivity,
                   const ConductionBoundary& boundary);
  /// The same body over a time step dt [s]; `rho_c[mesh.layer[row]]` [J/(m3 K)]. Throws InputError
  /// if the step or a capacity is not positive.
  ConductionSystem(const ConductionSystem& steady, const std::vector<double>& rho_c, double dt);

  [[nodiscard]] const RevolutionMesh& mesh() const { return mesh_; }
  [[nodiscard]] double dt() const { return dt_; }
  /// Nodes in front of a prescribed back; all of them otherwise.
  [[nodiscard]] int free_nodes() const;

  /// Factor of K_n + M/dt, held nodes left out; `outer_line` is added to it on the outermost corner
  /// line, if it is given. Throws InputError if nothing holds the temperature.
  [[nodiscard]] BlockTridiagonal factor(int n, const Eigen::MatrixXd& outer_line = {}) const;
  /// Nodal temperatures under nodal heat `load`, nodes x any number of right-hand sides.
  [[nodiscard]] Eigen::MatrixXd solve(const BlockTridiagonal& factor,
                                      const Eigen::MatrixXd& load) const;
  /// M/dt T for nodal temperatures, nodes x any number of columns; finite dt only.
  [[nodiscard]] Eigen::MatrixXd stored(const Eigen::MatrixXd& T) const;

  // Heat per radian of harmonic 0 [W/K], by nodal temperature: a row for all nodes.
  [[nodiscard]] Eigen::RowVectorXd to_ends() const;
  /// Through the outer surface, or into the held nodes without what (2) takes from it.
  [[nodiscard]] Eigen::RowVectorXd to_back() const;
  /// By T_before: what held nodes have given back because their elements were warm before.     (2)
  [[nodiscard]] Eigen::RowVectorXd before_to_back() const;
  [[nodiscard]] Eigen::RowVectorXd to_store() const;

 private:
  [[nodiscard]] bool held() const { return boundary_.kind == BackKind::prescribed; }
  [[nodiscard]] Eigen::RowVectorXd row_sums(Matrix8 HeatElement::*loss) const;

  RevolutionMesh mesh_;
  ConductionBoundary boundary_;
  int rows_ = 0;                       ///< rows that conduct
  std::vector<HeatElement> elements_;  ///< row * cols + col
  std::vector<Matrix8> storage_;       ///< M/dt of each element; empty: steady
  double dt_ = std::numeric_limits<double>::infinity();
};

}  // namespace shellback::thermal
