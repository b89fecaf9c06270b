#pragma once
/// Heat conduction in the layered shell and its housing, by circumferential harmonics.
///
///   (1/r)(r k T_n,r),r + (k T_n,z),z - n^2 k T_n / r^2 = rho c dT_n/dt           (1)
///   bore:           heat flux q_n(z) [W/m2] enters, constant on each axial film cell
///   outer surface:  -k T_n,r = h_back T_n (convective), or T_n = 0 from the shell's back outwards
///                   (prescribed)
///   end faces:      flux h_end T_n leaves
///
/// T is the temperature above that of the surroundings (ambient or prescribed back), [K]; both
/// boundaries refer to the same temperature. Eight-node ring elements, full quadrature
/// (core/revolution_mesh.hpp), the bore being the innermost line; z = 0 of a half grid is a plane
/// of symmetry. Sources: textbook; methods 3.3.
///
/// Over a time step dt (implicit Euler, thermal/conduction_system.hpp), with A_n = K_n + M/dt and P
/// the integrals of the bore's shape functions over the film cells, the nodal temperatures are
///   T_n = A_n^-1 P R q_n + A_n^-1 M/dt T_n,before                                (2)
/// and cell means of the bore temperature Z_n q_n + history, Z_n = R diag(1/dz) P^T A_n^-1 P:
/// diag(dz) Z_n is symmetric and positive. What lies above the highest harmonic N, cell by cell, is
/// answered as that one is, with its history: T = sum_n Z_n q_n + Z_N (q - P q), P the projection
/// on harmonics 0 .. N (Harmonics::fit). Dropped instead, the temperature of an insulating bore
/// beside cold oil rings about its jump, up to 0.09 of it beyond both sides on any grid; so it
/// stays between them. A body that conducts along holds such waves back by n/N more: jumps are as
/// steep as the cells are. The steady state is dt = infinity: no history. The discrete heat balance
/// is exact: heat in = through the back + through the ends + stored, to round-off.
#include <vector>

#include "core/eigen.hpp"
#include "core/grid.hpp"
#include "core/harmonics.hpp"
#include "core/revolution_mesh.hpp"
#include "thermal/conduction_system.hpp"

namespace shellback::thermal {

/// Corner line at the outer radius of layer `layer` of the mesh.
[[nodiscard]] int outer_line(const RevolutionMesh& mesh, int layer);

/// Temperature of the shell for one heat flux. Temperatures are absolute.
struct ShellTemperature {
  Field surface;  ///< bore, mean over each film cell [K]
  Field back;     ///< back of the shell, mean over each film cell [K]
  /// Of the flux that entered: 2 N + 1 coefficients (core/harmonics.hpp) and what lies above them,
  /// a column for each cell around, nz x (2 N + 1 + nt) [W/m2].
  Eigen::MatrixXd flux;
  double heat_in = 0.0;    ///< into the bore of the whole bearing [W]
  double heat_back = 0.0;  ///< leaving through the back [W]
  double heat_ends = 0.0;  ///< leaving through the end faces [W]
  double stored = 0.0;     ///< in shell and housing, mean over the time step [W]
};

/// What the temperatures before a time step add to those after it: the second part of (2).
struct ShellHistory {
  Eigen::MatrixXd nodal;          ///< A_n^-1 M/dt T_n,before, nodes x (2 N + 1 + nt) [K]
  Eigen::MatrixXd surface, back;  ///< its cell means at bore and back, nz x (2 N + 1 + nt) [K]
  double mean = 0.0;              ///< area mean at the bore [K]
  double heat_back = 0.0, heat_ends = 0.0, stored = 0.0;  ///< [W], without any flux at the bore
};

/// How the heat from the film falls with the wall's temperature, -dq/dT [W/(m2 K)]. The oil follows
/// a wall that is warmer all round, and hardly one that is warmer here and cooler there.
struct FilmConductance {
  double mean = 0.0;   ///< against the circumferential mean (harmonic 0)
  double local = 0.0;  ///< against all other harmonics
};

/// Owns the operators of one geometry; solving is const and may be done from several threads.
class ShellConduction {
 public:
  /// `conductivity[mesh.layer[row]]` [W/(m K)]. Throws InputError if a conductivity is not
  /// positive, a coefficient is negative, or no heat can leave.
  ShellConduction(const RevolutionMesh& mesh, const FilmGrid& grid,
                  const std::vector<double>& conductivity, const ConductionBoundary& boundary,
                  Harmonics harmonics);
  /// The same with the operators between those of `sample` interpolated.
  ShellConduction(const RevolutionMesh& mesh, const FilmGrid& grid,
                  const std::vector<double>& conductivity, const ConductionBoundary& boundary,
                  Harmonics harmonics, HarmonicSample sample);
  /// The same shell over a time step dt [s]: every harmonic is computed. `rho_c[mesh.layer[row]]`
  /// [J/(m3 K)]. Throws InputError if the step or a capacity is not positive and finite.
  [[nodiscard]] ShellConduction over(double dt, const std::vector<double>& rho_c) const;
  [[nodiscard]] double dt() const { return system_.dt(); }  ///< infinity: steady [s]

  /// For a time step from nodal temperatures above the surroundings, nodes x (2 N + 1 + nt) [K].
  [[nodiscard]] ShellHistory history(const Eigen::MatrixXd& before) const;

  /// Robin coupling with the film: the flux into the shell is q at the wall temperature T_old and
  /// changes by -g per kelvin,
  ///   T = Z (q - g (T - T_old)) + history,
  /// solved for each harmonic, (1 + g Z_n)(t - t_old) = Z_n q_n + history_n - t_old. `q` [W/m2] and
  /// `t_old` [K] are cell fields, g >= 0 is uniform over the film, one for the mean and one for the
  /// rest; `surroundings` [K] is the ambient or the prescribed back temperature. At T = T_old the
  /// answer is that of the flux q whatever g is: g only steadies the iteration. `back` is left
  /// empty unless asked for. A time step needs its history, the steady state none.
  [[nodiscard]] ShellTemperature solve(const Field& q, FilmConductance g, const Field& t_old,
                                       double surroundings, bool with_back = true,
                                       const ShellHistory* history = nullptr) const;
  [[nodiscard]] ShellTemperature solve(const Field& q, double g, const Field& t_old,
                                       double surroundings) const {
    return solve(q, FilmConductance{g, g}, t_old, surroundings);
  }

  /// Part of a flux at the bore that enters the shell while the film takes back g per kelvin:
  /// (1 + g Z_n)^-1, nz x nz for each harmonic.
  [[nodiscard]] HarmonicOperator entering(FilmConductance g) const;
  /// Area mean of the bore temperature for the flux q, without Robin coupling [K].
  [[nodiscard]] double mean_surface(const Field& q, double surroundings,
                                    const ShellHistory* history = nullptr) const;
  /// Rise of that mean per uniform flux [K m2/W].
  [[nodiscard]] double resistance() const { return mean_.sum(); }
  /// Nodal temperatures above the surroundings (2) for a flux that entered
  /// (ShellTemperature::flux), nodes x (2 N + 1 + nt) [K]: what the next time step begins with.
  [[nodiscard]] Eigen::MatrixXd nodal_temperatures(const Eigen::MatrixXd& flux,
                                                   const ShellHistory* history = nullptr) const;
  /// The same for a body of one temperature: `rise` [K] above the surroundings, the nodes of a
  /// prescribed back at these.
  [[nodiscard]] Eigen::MatrixXd uniform_temperatures(double rise) const;
  /// Cell fields [K] of bore and back at given nodal temperatures; no flux, no heat.
  [[nodiscard]] ShellTemperature at(const Eigen::MatrixXd& nodal, double surroundings) const;

  [[nodiscard]] const Harmonics& harmonics() const { return harmonics_; }
  /// Bore temperature rise per flux, Z_n, nz x nz [K m2/W].
  [[nodiscard]] const HarmonicOperator& surface() const { return surface_; }
  /// Rise at the back of the shell per flux, B_n, nz x nz [K m2/W].
  [[nodiscard]] const HarmonicOperator& back() const { return back_; }
  /// Rise of every node of the mesh per flux, nodes x nz [K m2/W]: the input of thermal
  /// deformation. One for each computed harmonic of the sample.
  [[nodiscard]] const HarmonicOperator& nodal() const { return nodal_; }
  /// Rise at the nodes of the section z = 0 per flux, n_r x nz [K m2/W], bore first.
  [[nodiscard]] HarmonicOperator section() const;
  /// Rows of nodal temperatures at those nodes.
  [[nodiscard]] Eigen::MatrixXd section(const Eigen::MatrixXd& nodal) const;
  /// Radii of those nodes [m].
  [[nodiscard]] std::vector<double> section_radii() const;

 private:
  ShellConduction(const ShellConduction& steady, const std::vector<double>& rho_c, double dt);
  /// Operators at bore and back of the computed harmonics, and the heat of harmonic 0.
  void compute();
  /// Of solve(), above the highest harmonic: the flux that enters, nz x nt; adds to `surface`.
  [[nodiscard]] Eigen::MatrixXd answer_above(const Field& q, double g, const Field& t_old,
                                             const ShellHistory* history, Field& surface) const;
  /// Cell means of nodal temperatures on a corner line.
  [[nodiscard]] Eigen::MatrixXd cells_at(int line, const Eigen::MatrixXd& nodal) const;
  /// Heat per radian times this is that of the whole bearing [-].
  [[nodiscard]] double whole() const;

  ConductionSystem system_;
  FilmGrid grid_;
  int back_line_ = 0;
  Harmonics harmonics_;
  HarmonicSample sample_;
  Eigen::MatrixXd cells_;                 ///< P: line nodes x nz [m]
  std::vector<BlockTridiagonal> factor_;  ///< A_n of a time step; empty: steady
  HarmonicOperator surface_, back_, nodal_;
  std::vector<Eigen::MatrixXd> modes_;  ///< V_n: Z V = V diag(lambda), V^T diag(dz) V = 1
  std::vector<Eigen::VectorXd> lambda_;
  Eigen::RowVectorXd mean_;  ///< area mean of the bore's rise per flux of each axial cell [K m2/W]
  Eigen::RowVectorXd back_heat_, end_heat_, store_heat_;  ///< [W] per flux of each cell [W/m2]
};

}  // namespace shellback::thermal
