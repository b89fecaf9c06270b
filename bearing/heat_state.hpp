#pragma once
/// Everything thermal of a bearing: wall temperatures and thermal deformation, and what the last
/// iteration found with them.
#include <string>
#include <vector>

#include "bearing/solids.hpp"
#include "thermal/film_energy.hpp"

namespace shellback::bearing {

/// One unit of temperatures in iterations over heat [K], beside deformations in clearances: oil
/// changes its viscosity by some tens of per cent.
inline constexpr double kHeatUnit = 10.0;

/// The unknowns of heat beside the temperatures across the film (OilColumns).
struct HeatUnknowns {
  Field thermal_deformation;    ///< of the gap, opening positive [m]; empty: none
  Field T_shell;                ///< bore temperature seen by the film [K]
  std::vector<double> T_shaft;  ///< journal temperature seen by the film, per axial cell [K]
};

/// A temperature that changes no more than this is known: 1e-8 of a rise of 10 K and more [K].
inline constexpr double kKnownTemperature = 1e-7;

/// Sweeps of the film energy in one iteration, after which its response to the walls is known, too
/// (methods 3.4).
inline constexpr int kSweepsOfResponse = 3;

/// What the last iteration found with them.
struct HeatEvaluation {
  /// Part of the thermal deformation that summits make by their own heat, which the film's Newton
  /// iteration takes along (equilibrium.hpp (3a)); empty: none [m].
  Field contact_deformation;
  SolidTemperature solids;         ///< the solids' answer to the last heat
  thermal::EnergyBalance balance;  ///< of the film, solved part [W]
  double contact_heat = 0.0;       ///< asperity heat, whole bearing [W]
  std::vector<double> T_mix;       ///< of each supply patch [K]
  thermal::WallResponse response;  ///< of the film to its walls, refreshed in early iterations
  long backflow_nodes = 0;
  long blended_columns = 0;
  double residual = 0.0;  ///< last change per iteration [-]
};

struct HeatState : HeatUnknowns, HeatEvaluation {
  /// True once the film's heat has been balanced to the end.
  [[nodiscard]] bool known() const { return !T_mix.empty() && !solids.shell.back.empty(); }
};

/// The time over which film and walls store heat. The film's oil mass is steady within it.
struct HeatStep {
  SolidStep solids;
  double dt = 0.0;                      ///< [s]
  std::vector<double> enthalpy_before;  ///< of the film's nodes, film_enthalpy [J/kg]
};

}  // namespace shellback::bearing
