#pragma once
/// Temperature of the film, resolved across it: conservative Gauss-Lobatto-Legendre form.
///
/// Per cell, with s = y/h, T_k at the GLL nodes, m_k the mass flow per unit s through a face at
/// node k, V_k the mass flow through the surface s = s_k (V = 0 at both walls):
///   sum over faces (m_k cp T_k)_upwind + (D (V cp T))_k
///       + (1/w_k) K (D^T W D T)_k = (1/w_k) heat_k + wall flux        [W]        (1)
/// K = k A theta / h [W/K]; walls at given temperature; their heat fluxes are the residuals of (1)
/// at the wall nodes. T is counted from a reference. The node flows are projected onto degree
/// n - 2 in s, so that V, their integral, lies in the polynomial space: then D V equals minus the
/// outflow at every node, a uniform temperature stays uniform, and sum w_k (D f)_k = f(1) - f(0)
/// makes the energy balance of the film exact to round-off of the sweeps.
///
/// Over a time step dt a cell whose oil mass changes from M_before to M, spread evenly in s, stores
///   w_k (M cp_k T_k - (M_before cp T)_k,before) / dt                          [W]        (4)
/// at each node; V then holds -s (M - M_before)/dt as well, so that a uniform temperature stays
/// uniform (implicit Euler; s moves with the gap). Supply patches store nothing. Without storage
/// (4) is absent: the steady state.
///
/// D (V cp T) by collocation is not monotone where V is large against K/cp: in refilling cells
/// beside a supply a column may answer what flows in, and its walls, with weights far below zero.
/// There it is blended with upwind fluxes between the nodes,
///   w_k (D (V cp T))_k -> F_k - F_{k-1},  F_k = M_k (cp T)_upwind,  M_k = sum_{l<=k} w_l (D V)_l
///   (3)
/// which telescope, so that nothing is lost, and keep a uniform temperature; with them alone the
/// column's matrix has no positive entry off its diagonal but those of conduction. Share b of (3):
/// nu is the largest sum, over the nodes of the column, of the negative weights; b = 0 up to
/// nu = 1/4, 1 from nu = 1/2, linear between (docs/decisions/020).
///
/// Supply patches are mixing vessels:
///   T_mix O = lambda sum(I T) + (O - lambda I) T_supply + heat/cp                   (2)
/// O, I gross mass flows out of and into the patch, lambda the part of the film oil that is mixed
/// in again; (1 - lambda) I drains at its own temperature and is replaced by fresh oil. If
/// O < lambda I the surplus leaves through the supply at T_mix. A vessel may exchange heat with
/// both walls over its cells; (2) then has on its right
///   - sum over cells of h A [(T_mix - T_shell) + (T_mix - T_shaft)] / cp                 (6)
/// which the walls receive. Over a step in time what is sheared inside a vessel is as thin as it
/// turns out to be: of the heat the part `sheared`, known at T_sheared, follows
///   sheared exp(-thinning (T_mix - T_sheared))                                        (7)
/// A vessel stores nothing; heat of oil as it was would have no hold on its temperature where
/// little flows, and thick oil would heat itself in one step to what no oil can be. The wall nodes
/// of its cells hold the walls' temperatures. Oil that is drawn off evenly along a groove cools on
/// its way as m cp dT = -h dA (T - T_wall), m falling to zero at its end: it leaves at a mean of
/// T_wall + (T_in - T_wall)/(1 + h A/(O cp)), which is (6). O and I are of the faces of a patch
/// towards film and side edges. Patches that touch are one: no film parts them. Sources:
/// methods 3.1, 3.2; the projection is ours (docs/theory.md).
#include <cmath>
#include <optional>
#include <vector>

#include "core/gauss_lobatto.hpp"
#include "core/grid.hpp"

namespace shellback::thermal {

/// A face on which oil enters or leaves a supply line, west side of the line.
struct LineFlow {
  int face = 0;  ///< west face of the cell east of the line
  int patch = 0;
  std::vector<double> flow;  ///< n: mass flow into the line per unit s [kg/s]
};

/// Oil that enters a cell through its surface, spread evenly in s, at its vessel's temperature of
/// supply; what leaves that way is as warm as the film and does not come back.
struct FedOil {
  int cell = 0;
  int vessel = 0;
  double flow = 0.0;  ///< positive into the film [kg/s]
};

struct SupplyVessel {
  double T_supply = 0.0;    ///< [K]
  double cp_supply = 0.0;   ///< mean heat capacity between the reference and T_supply [J/(kg K)]
  double cp_mix = 0.0;      ///< the same for the mixed oil [J/(kg K)]
  double carry_over = 1.0;  ///< lambda [-]
  double heat = 0.0;        ///< dissipated inside the patch [W] (of the solved part)
  double sheared = 0.0;     ///< of it, by the journal's motion [W]
  double T_sheared = 0.0;   ///< of the oil that is sheared so [K]
  double thinning = 0.0;    ///< of (7), -d ln eta/dT [1/K]; 0: the heat is given
  /// (7), and all other heat [W], at a temperature of the mixed oil [K].
  [[nodiscard]] double heat_at(double T_mix) const {
    return heat + sheared * std::expm1(-thinning * (T_mix - T_sheared));
  }
  /// h of (6), its oil against each wall [W/(m2 K)]; 0: none
  double heat_transfer = 0.0;
};

/// The oil of the cells over a time step, (4). Supply patches are not looked at.
struct FilmStorage {
  double dt = 0.0;                  ///< [s]
  std::vector<double> mass;         ///< per cell, at the end of the step [kg]
  std::vector<double> mass_before;  ///< per cell, at its beginning [kg]
  std::vector<double> heat_before;  ///< per node: (M cp (T - T_reference))_before [J]
};

/// What nodes of the enthalpy cp (T - T_reference) [J/kg] hold in cells of a mass [kg] each [J].
[[nodiscard]] std::vector<double> heat_content(const Field& mass,
                                               const std::vector<double>& enthalpy);

/// A shell whose surface follows the heat that enters it within the step:
///   T_shell = free + impedance (q + rubbed),   q of the film into the wall [W/m2]     (5)
/// as a skin of a wall does over a step in time (thermal/wall_skin.hpp). Eliminated column by
/// column with the nodes between: no iteration between film and wall.
struct YieldingShell {
  double impedance = 0.0;  ///< [K m2/W], positive
  Field free;              ///< temperature without any heat entering, per cell [K]
  Field rubbed;            ///< heat of asperities into the shell, per cell [W/m2]
};

/// All that is fixed while the film temperature is solved. Node arrays have index cell * n + k.
struct FilmEnergyProblem {
  const FilmGrid* grid = nullptr;
  const CrossFilmNodes* gl = nullptr;
  std::vector<double> phi_flow;  ///< west faces [kg/s per unit s], + in +phi
  std::vector<double> z_flow;    ///< axial faces, index (i (nz+1) + j) n + k, + in +z
  std::vector<LineFlow> lines;
  std::vector<int> patch;           ///< per cell: supply patch or -1
  std::vector<int> line;            ///< per west face: supply patch of the line on it or -1
  std::vector<double> conductance;  ///< K per cell [W/K]
  std::vector<double> heat;         ///< per node, weights included [W]
  /// By which it falls for each kelvin above T_reference, per node, none below zero: the oil thins
  /// [W/K]; empty: it is given.
  std::vector<double> thinning;
  std::vector<double> cp;  ///< mean heat capacity from T_reference on, per node [J/(kg K)]
  std::vector<SupplyVessel> vessels;
  std::vector<FedOil> fed;
  double T_reference = 0.0;  ///< enthalpies count from here [K]
  double T_edge = 0.0;       ///< of oil that enters at a side edge [K]
  double cp_edge = 0.0;      ///< its mean heat capacity from the reference on [J/(kg K)]
  bool forward = true;       ///< the journal moves in +phi
  /// Made by oil that leaves vessels straight over a side edge, and gone with it [W].
  double throttled = 0.0;
  std::optional<FilmStorage> storage;  ///< none: steady
  std::optional<YieldingShell> shell;  ///< none: its temperature is given
};

/// Enthalpy and heat flows of a film temperature field, whole solved part [W].
struct EnergyBalance {
  double heat = 0.0;         ///< dissipated, patches included
  double to_shell = 0.0;     ///< through the wall s = 0
  double to_shaft = 0.0;     ///< through the wall s = 1
  double carried_out = 0.0;  ///< enthalpy leaving: edges, drains, surplus
  double carried_in = 0.0;   ///< enthalpy entering: edges, fresh oil
  double stored = 0.0;       ///< in the film, mean over the time step
  [[nodiscard]] double imbalance() const {
    return heat - to_shell - to_shaft - carried_out + carried_in - stored;
  }
};

/// Heat through the two walls [W] per cell, out of the film.
struct WallHeat {
  Field shell;
  Field shaft;
};

/// How the heat into the walls answers to their temperatures, area means [W/(m2 K)]:
/// d q_shell = -shell d T_shell + across d T_shaft, d q_shaft = back d T_shell - shaft d T_shaft,
/// each wall warmer as a whole and the oil following.
struct WallResponse {
  double shell = 0.0;
  double shaft = 0.0;
  double across = 0.0;
  double back = 0.0;
  double shell_local = 0.0;  ///< one column warmed alone, -d q_shell/d T_shell: the largest
  double shell_ring = 0.0;   ///< the same, mean over a ring of columns at one z: the largest
  double shaft_ring = 0.0;   ///< the same for the shaft
};

/// Column matrices for one problem; sweeps, wall heat and balance for temperature fields.
class FilmEnergy {
 public:
  explicit FilmEnergy(FilmEnergyProblem problem);

  /// One marching sweep in the direction of motion. `T` [K], node layout; its wall nodes hold the
  /// wall temperatures and stay (but those of a yielding shell); interior nodes and patch cells are
  /// updated. Returns the largest change [K].
  double sweep(std::vector<double>& T);

  [[nodiscard]] WallHeat wall_heat(const std::vector<double>& T) const;
  /// Responses of the film to its walls, from `laps` sweeps each.
  [[nodiscard]] WallResponse wall_response(int laps) const;
  [[nodiscard]] EnergyBalance balance(const std::vector<double>& T) const;
  [[nodiscard]] const std::vector<double>& mix_temperatures() const { return T_mix_; }
  /// cp_mix with which the temperature of vessel v was found [J/(kg K)].
  [[nodiscard]] double cp_of_vessel(std::size_t v) const { return p_.vessels[v].cp_mix; }
  /// By which (7) exceeds what was sheared at T_sheared, all vessels [W].
  [[nodiscard]] double heat_of_thinning() const;
  [[nodiscard]] long backflow_nodes() const { return backflow_; }
  /// Columns in which (3) has a share.
  [[nodiscard]] long blended_columns() const { return blended_; }

 private:
  struct VesselFlow {
    double out = 0.0;        ///< O [kg/s]
    double in = 0.0;         ///< I [kg/s]
    double in_heat = 0.0;    ///< sum of I cp (T - T_ref) [W]
    double over_edge = 0.0;  ///< of O, over a side edge [kg/s]
    double edge_heat = 0.0;  ///< that enters over a side edge [W]
  };
  /// Flow into cell `cell` through one face, and whence.
  struct Inflow {
    const double* flow;  ///< n values
    double sign;         ///< flow * sign > 0 enters
    int source;          ///< cell, or -1 - patch, or kEdge
  };
  static constexpr int kEdge = -1000000;
  /// The (up to four) faces of a cell as inflows.
  int faces_of(int i, int j, Inflow* faces) const;
  [[nodiscard]] double source_enthalpy(const Inflow& f, int k, const std::vector<double>& T) const;
  /// What a node's heat falls by a kelvin [W/K].
  [[nodiscard]] double thins(int cell, int k) const {
    return p_.thinning.empty() ? 0.0 : p_.thinning[static_cast<std::size_t>(cell) * n_ + k];
  }
  /// Puts the enthalpy of oil that is fed into the cells to their heat.
  void take_fed_oil();
  /// h of (6) for the vessel that the cell lies in; 0 in the film [W/(m2 K)].
  [[nodiscard]] double vessel_transfer(int cell) const;
  /// (6) of one cell with an unyielding shell: h A of shell and shaft [W/K], and the temperatures
  /// against which they stand, from T_reference [K].
  struct VesselWalls {
    double shell = 0.0, shaft = 0.0;
    double T_shell = 0.0, T_shaft = 0.0;
  };
  [[nodiscard]] VesselWalls vessel_walls(int cell, const std::vector<double>& T) const;
  /// Puts T_mix to the cells of the vessels; a yielding shell warms by what it receives.
  void fill_vessels(std::vector<double>& T) const;
  /// What (4) brings from before the step, and how fast cells gain oil.
  void take_storage();
  void build_column(int i, int j);
  /// Inverse of the column's interior rows and what it makes of heat and walls.
  void invert_column(int cell);
  /// (5) of the inverted column.
  void let_shell_yield(int cell);
  /// The shell's temperature by (5), from T_reference, where the column's nodes without its share
  /// are `x` (n - 2), the shaft stands at `shaft` and `in` enters at the shell's node [W].
  [[nodiscard]] double yielded(int cell, const double* x, double shaft, double in) const;
  /// nu of the header, of the inverted column.
  [[nodiscard]] double negative_weights(int cell) const;
  /// M_k of (3) for k = 0 .. n - 2 [kg/s].
  void node_fluxes(int cell, double* M) const;
  /// Row `k` of the column's matrix, weights included, by T - T_reference [W/K].
  void matrix_row(int cell, int k, double* row) const;
  /// Row k of (1) at a wall node, weights included: heat into that wall [W]. enthalpies_of(T)
  /// first.
  [[nodiscard]] double wall_row(int cell, int k, const std::vector<double>& T,
                                const std::vector<double>& enthalpy) const;
  /// cp (T - T_reference) of all slots: cells, then patches, then the side edge [J/kg].
  void enthalpies_of(const std::vector<double>& T, std::vector<double>& enthalpy) const;
  /// One sweep with N nodes across the film (0: any number). Returns the largest change [K].
  template <int N>
  double march(std::vector<double>& T);
  [[nodiscard]] std::vector<VesselFlow> vessel_flows(const std::vector<double>& T) const;
  /// From and to a side edge without any film.
  void add_flows_over_edges(const std::vector<double>& T, std::vector<VesselFlow>& flows) const;
  void mix(std::vector<double>& T);
  /// (2) with (6) and (7): what is brought but for the vessel's own heat [W], what is taken [W/K].
  [[nodiscard]] double mixed(const SupplyVessel& s, double brought, double taken) const;

  FilmEnergyProblem p_;
  int n_ = 0;
  std::vector<double> stiffness_;  ///< conduction of the nodal set, n x n
  std::vector<double> cross_;      ///< V per cell and node [kg/s]
  std::vector<double> outflow_;    ///< w_k * sum of outflows and M/dt, per cell and node [kg/s]
  Field blend_;                    ///< b per cell [-]
  Field accumulation_;             ///< (M - M_before)/dt per cell [kg/s]
  std::vector<double> brought_;    ///< w_k (M cp T)_before / dt per node [W]; empty: steady
  // Interior nodes of a column, solved: T = base - by_shell T_shell - by_shaft T_shaft
  // + inverse (inflow of enthalpy), temperatures from T_reference.
  std::vector<double> inverse_;              ///< (n-2)^2 per cell
  std::vector<double> base_;                 ///< n-2 per cell [K]
  std::vector<double> by_shell_, by_shaft_;  ///< n-2 per cell [-]
  // Yielding shell: its row of the matrix, per area and times the impedance, and what it holds.
  std::vector<double> shell_row_;                ///< n per cell [-]
  std::vector<double> shell_pivot_;              ///< per cell: the column following [-]
  std::vector<double> inflow_;                   ///< 4 faces x n per cell, weights included [kg/s]
  std::vector<int> source_;                      ///< 4 slots per cell from which that flow comes
  std::vector<double> enthalpy_;                 ///< n per slot [J/kg]
  std::vector<double> T_mix_;                    ///< per patch [K]
  std::vector<int> shore_;                       ///< film cells with a face to a patch
  std::vector<int> brink_;                       ///< patch cells with a face at a side edge
  std::vector<const LineFlow*> line_west_;       ///< per face: the flow into its line
  double shell_local_ = 0.0;                     ///< largest of all columns [W/(m2 K)]
  std::vector<double> shell_ring_, shaft_ring_;  ///< mean over the columns at each z [W/(m2 K)]
  Field fed_;                                    ///< per cell [kg/s]; empty: none
  double fed_heat_ = 0.0;                        ///< of what enters that way [W]
  long backflow_ = 0;
  long blended_ = 0;
};

}  // namespace shellback::thermal
