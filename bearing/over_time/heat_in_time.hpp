#pragma once
/// Heat of film and shell surface in time: one stage of a step.
///
/// The heat H = M cp (T - T_ref) of every node of the film and the temperatures of the shell's skin
/// follow their balances (thermal/film_energy.hpp (4), thermal/wall_skin.hpp (1)). Like the oil M
/// (film_step.hpp) they are advanced by stages: each is a step of backward Euler over own = a_ii dt
/// from
///   H* = H_n + dt sum_j<i a_ij dH_j,   likewise the skin                               (1)
/// with the flows, the oil and the friction of that stage, so that heat is conserved to the round-
/// off of the sweeps. Shell and film are solved together, column by column.
/// The walls' bodies answer far more slowly than a cycle lasts: they hold their mean over it
/// (cycle_walls.hpp), and the skin swings about it and grows (bearing/skin_nodes.hpp). The
/// shaft turns: its surface is at its mean (thermal/shaft_conduction.hpp). Over a single event
/// there is no mean to come to: the shaft has a skin, too, one for each ring of cells, which meets
/// the mean of the heat around,
///   T_j = free_j + Z q_j,   q_j = sum_i q_ij A_ij / (2 pi R dz_j)                     (2)
/// found with the film's temperatures, sweep by sweep. It reaches
/// to the axis and narrows on the way as a cylinder does (thermal/wall_skin.hpp). The film's
/// viscosity in a stage is that of temperatures carried on in a straight line from the stages
/// before, not of the last ones. Source: methods 3.5, 4; textbook.
#include <optional>

#include "bearing/heat/film_heat.hpp"
#include "thermal/wall_skin.hpp"

namespace shellback::bearing {

/// What the walls' bodies hold over a cycle.
struct WallMeans {
  Field shell;                ///< bore [K]
  std::vector<double> shaft;  ///< per axial cell [K]
  Field flux;                 ///< heat into the bore that belongs to it [W/m2]
  Field thermal_deformation;  ///< of the gap, opening positive [m]; empty: none
  /// Heat into each ring of the shaft that belongs to its temperature [W/m2]; empty: none.
  std::vector<double> shaft_flux{};
};

/// All bodies at one temperature [K], without heat.
[[nodiscard]] WallMeans uniform_walls(const BearingModel& model, double T);

/// How deep heat goes into shell or shaft, whichever is deeper, in a time t [s]: sqrt(a t), a
/// layer's own a in each [m].
[[nodiscard]] double reach_of_heat(const Case& c, double t);

/// Sum over the cells of each ring, of those that meet the walls, over the ring's area.
[[nodiscard]] std::vector<double> mean_of_rings(const BearingModel& model, const Field& per_cell);

/// Of all cells [m]; 0 without thermal deformation.
[[nodiscard]] double mean_deformation(const WallMeans& walls);

/// Heat that flows at an instant, or has flowed in a step.
struct HeatFlows {
  Field to_shell;                  ///< per cell, with that of asperities [W/m2] or [J/m2]
  Field to_shaft;                  ///< the same
  thermal::EnergyBalance balance;  ///< of the film, solved part [W] or [J]
  double rubbed = 0.0;             ///< by asperities, into both walls, solved part [W] or [J]
  /// Of shaft, load and supply on the oil, whole bearing [W]; over a step of moment, growth and
  /// pockets, too [J].
  double work = 0.0;
  /// this + f other.
  void add(double f, const HeatFlows& other);
};

/// Heat of film and skin at one instant.
struct HeatInTime {
  std::vector<double> T;     ///< film nodes, walls included [K]
  std::vector<double> held;  ///< H of every node as carried [J]
  /// Above the mean, cell by cell, WallSkin::nodes() each; over an event then those of the shaft,
  /// ring by ring [K].
  std::vector<double> skin;
  std::vector<double> held_slope;  ///< at this instant [W]; empty: not known
  std::vector<double> skin_slope;  ///< [K/s]
  std::vector<double> T_slope;     ///< over the last step [K/s]; empty: not known
  HeatFlows flows;                 ///< at this instant
};

/// What a stage found.
struct HeatStage {
  std::vector<double> T;           ///< [K]
  std::vector<double> skin;        ///< [K]
  std::vector<double> held_slope;  ///< [W]
  std::vector<double> skin_slope;  ///< [K/s]
  HeatFlows flows;
  bool settled = true;   ///< the film's heat is balanced
  bool possible = true;  ///< all temperatures are numbers within what an oil can be
};

class HeatSteps {
 public:
  /// Of a bearing whose loads change over `period`, in steps down to `shortest` [s].
  HeatSteps(const BearingModel& model, double period, double shortest);

  /// Film and skin of these walls at the film's temperatures; `mass` of the cells' oil [kg].
  [[nodiscard]] HeatInTime begin(const BearingModel& model, std::vector<double> T,
                                 const Field& mass) const;
  /// Solves a stage of length `own` [s] for the film that `s` holds, from the oil `before` of the
  /// cells to `after` [kg], the heat `held` and the skin `skin` of (1).
  [[nodiscard]] HeatStage stage(const BearingModel& model, const OperatingPoint& point,
                                const FilmEquilibrium& s, double own, const Field& before,
                                const Field& after, const std::vector<double>& held,
                                const std::vector<double>& skin) const;
  /// How far the film's viscosity was missed by temperatures `T` where those of `s` were expected:
  /// mean over the film, by its pressure [-].
  [[nodiscard]] double surprise(const BearingModel& model, const FilmEquilibrium& s,
                                const std::vector<double>& T) const;

  /// By which the skins of temperatures `skin` narrow the gap [m]; empty: no thermal deformation.
  [[nodiscard]] Field swelling(const BearingModel& model, const std::vector<double>& skin) const;

  WallMeans walls;  ///< of this cycle
  [[nodiscard]] const thermal::WallSkin& skin() const { return skin_; }

 private:
  /// (5) of thermal/film_energy.hpp for this step; `skin` holds what is left of it then.
  [[nodiscard]] thermal::YieldingShell free_shell(const FilmGrid& g, const thermal::SkinStep& step,
                                                  Field rubbed, std::vector<double>& skin) const;
  /// The skin by the heat that has entered, and its slopes from `before`.
  void heat_skin(const BearingModel& model, double own, const std::vector<double>& before,
                 HeatStage& out) const;
  /// free of (2), per ring; `skin` holds what is left of the shaft's then.
  [[nodiscard]] std::vector<double> free_shaft(const thermal::SkinStep& step,
                                               std::vector<double>& skin) const;
  [[nodiscard]] double flux_of_ring(std::size_t j) const {
    return walls.shaft_flux.empty() ? 0.0 : walls.shaft_flux[j];
  }

  thermal::WallSkin skin_;
  std::optional<thermal::WallSkin> shaft_;  ///< over an event
  HarmonicOperator opening_;                ///< of the gap by the skins; empty: none [m/K]
  Eigen::MatrixXd opening_by_shaft_;        ///< by those of the shaft [m/K]
};

/// -d ln eta/dT of the oil, not below zero [1/K].
[[nodiscard]] double thinning(const BearingModel& model, double T, double p);

/// The film's energy equation as it stands, as if its flow would stay: oil that cells gain or lose
/// counts, heat that they store does not.
[[nodiscard]] thermal::FilmEnergyProblem lasting_film(const BearingModel& model,
                                                      const OperatingPoint& point,
                                                      const FilmEquilibrium& s);

}  // namespace shellback::bearing
