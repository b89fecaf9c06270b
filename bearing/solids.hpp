#pragma once
/// Shell, housing and shaft of one bearing on one film grid: how the gap answers pressure and heat.
///
/// Owns the harmonic operators of solid/revolution_elasticity and thermal/revolution_conduction,
/// built once per geometry. All fields are film cells. One answer serves the steady state and a
/// time step (implicit Euler): the steady state is the step without end. Over a step
///   heat in = heat out + stored                                                     [W]     (1)
/// holds to round-off for shell with housing, and for the shaft.
#include <memory>
#include <optional>

#include "bearing/case.hpp"
#include "bearing/skin_nodes.hpp"
#include "core/field_operator.hpp"
#include "core/revolution_mesh.hpp"
#include "thermal/film_energy.hpp"
#include "thermal/revolution_conduction.hpp"
#include "thermal/shaft_conduction.hpp"

namespace shellback::bearing {

/// Which operators are wanted.
struct SolidEffects {
  bool elastic = false;
  bool heat = false;
  bool thermal_deformation = false;
  /// No harmonic is interpolated, so that a march of time ends in the steady answer to round-off;
  /// otherwise to what HarmonicSample says of harmonics above the sixth.
  bool every_harmonic = false;
};

/// Heat from the film into the two walls and the film's response to their temperature.
struct WallFlux {
  Field shell;                     ///< [W/m2]
  std::vector<double> shaft;       ///< circumferential mean per axial cell [W/m2]
  thermal::WallResponse response;  ///< of the film to its walls
};

/// Temperatures of the solids and what they do to the gap.
struct SolidTemperature {
  thermal::ShellTemperature shell;
  thermal::ShaftTemperature shaft;
  Field thermal_deformation;  ///< thermal widening of the gap, shell and shaft; empty without
                              ///< thermal deformation [m]
};

/// All that shell, housing and shaft keep from one time step to the next.
struct SolidState {
  /// Nodal temperatures above the shell's surroundings, nodes x (2 N + 1 + nt): coefficients, and
  /// what cells have above them (thermal/revolution_conduction.hpp) [K].
  Eigen::MatrixXd shell;
  Eigen::VectorXd shaft;  ///< nodal temperatures above the shaft's ambient [K]
};

/// What depends on the length of a time step alone.
struct StepOperators {
  thermal::ShellConduction shell;
  thermal::ShaftConduction shaft;
  HarmonicOperator thermal_deformation;   ///< of the bore per nodal temperature [m/K]
  HarmonicOperator deformation_per_flux;  ///< [m3/W]
};

/// The time from one state of the solids to the next; made by Solids::step.
struct SolidStep {
  std::shared_ptr<const StepOperators> operators;  ///< none: a step without end
  thermal::ShellHistory history;
  Eigen::MatrixXd thermal_deformation;  ///< what that does to the bore, nz x (2 N + 1) [m]
  thermal::ShaftHistory shaft;
};

class Solids {
 public:
  /// Throws InputError if the case lacks shell or shaft data for what is wanted.
  Solids(const Case& c, const FilmGrid& grid, SolidEffects effects);

  /// Widening of the gap by a pressure on shell and shaft [m].
  [[nodiscard]] Field compliance(const Field& pressure) const;
  /// Thermal deformation of the gap by asperity heat, per contact pressure [m/Pa]: `rate` [m/s] is
  /// the part of p_a mu U that goes into the shell over p_a; of that heat the film takes some back,
  /// as its largest local response has it. Negative: the shell bulges towards the journal. An
  /// estimate: the thermal deformation found with the temperatures is the true one.
  [[nodiscard]] HarmonicOperator contact_widening(double rate, const thermal::WallResponse& film,
                                                  const SolidStep* step = nullptr) const;
  /// Widening by a field and such an operator [m].
  [[nodiscard]] Field widening(const HarmonicOperator& by, const Field& contact) const;
  /// How skins open the gap that are warmer than the temperatures of an answer or a state: those of
  /// shell and housing harmonic by harmonic, those of the shaft all round, nz x (nz count), column
  /// j count + s by 1 K of node s behind axial cell j. The meshes' own, (3) of
  /// solid/revolution_elasticity.hpp: layers, supports and ends are those of the bodies [m/K].
  [[nodiscard]] HarmonicOperator opening_by_skins(const SkinNodes& shell) const;
  [[nodiscard]] Eigen::MatrixXd opening_by_shaft_skins(const SkinNodes& shaft) const;
  /// Winkler foundation that stands for the compliance in a preconditioner [m/Pa].
  [[nodiscard]] double winkler() const { return winkler_; }

  /// Temperatures for the heat that the film gives at the wall temperatures `T_shell` (cells) and
  /// `T_shaft` (axial cells) [K], Robin-coupled by the film's response. The means of both walls
  /// are found together first: heat passes from one to the other through the film far more easily
  /// than out of the bearing, so that one after the other they would settle slowly.
  /// Thermal deformation and the back's temperature are found only if wanted.
  struct Wanted {
    bool thermal_deformation = true;
    bool back = true;
  };
  [[nodiscard]] SolidTemperature answer(const WallFlux& q, const Field& T_shell,
                                        const std::vector<double>& T_shaft, Wanted wanted,
                                        const SolidStep* step = nullptr) const;

  /// A time step of length dt [s] from the state `before`; dt = infinity is the steady state. The
  /// operators of `last` are used again if it was as long. Throws InputError if dt, or a density or
  /// heat capacity of shell, housing or shaft, is not positive.
  [[nodiscard]] SolidStep step(double dt, const SolidState& before,
                               const SolidStep* last = nullptr) const;
  /// The state that an answer has led to.
  [[nodiscard]] SolidState state(const SolidTemperature& answer,
                                 const SolidStep* step = nullptr) const;
  /// Everything at one temperature [K]; a prescribed back stays as it is prescribed.
  [[nodiscard]] SolidState uniform_state(double T) const;
  /// Temperatures and thermal deformation of a state; no flux, no heat.
  [[nodiscard]] SolidTemperature at(const SolidState& state) const;

  [[nodiscard]] double surroundings() const { return surroundings_; }  ///< of the shell [K]
  /// True if these operators are those of the case on the grid, and hold the effects wanted.
  [[nodiscard]] bool serve(const Case& c, const FilmGrid& grid, SolidEffects wanted) const;
  [[nodiscard]] double setup_seconds() const { return setup_s_; }

  /// Shell temperature in the section z = 0: radii [m] and values [K], index i * radii + k.
  [[nodiscard]] std::vector<double> section_radii() const;
  [[nodiscard]] std::vector<double> section(const thermal::ShellTemperature& T) const;
  [[nodiscard]] std::vector<double> section(const SolidState& state) const;

  /// Materials and thicknesses from the bore outwards, housing included.
  struct Layers {
    std::vector<solid::Material> material;
    std::vector<double> thickness;  ///< [m]
    int last_of_shell = 0;
  };

 private:
  void build_compliance(const Case& c, const HarmonicOperator& shell);
  /// A free shaft that overhangs by more than its radius is moved back by what its section bends
  /// as a whole beyond that of one radius: e stays the place of the journal within the bearing.
  void hold_shaft(const Case& c, double beyond, HarmonicOperator& compliance) const;
  /// Changes of the mean shell and shaft temperature that balance the heat [K].
  struct MeanChange {
    double shell = 0.0;
    double shaft = 0.0;
  };
  [[nodiscard]] MeanChange mean_change(const WallFlux& q, const Field& T_shell,
                                       const std::vector<double>& T_shaft,
                                       const SolidStep& step) const;
  /// The bore's thermal deformation of these coefficients with that of the surroundings and of the
  /// shaft, whose nodes are `shaft` above its ambient [m].
  [[nodiscard]] Field total_deformation(const Eigen::MatrixXd& bore,
                                        const Eigen::VectorXd& shaft) const;
  void build_heat(const Case& c, const Layers& layers, const RevolutionMesh& mesh);
  /// Conduction of the shaft and, if wanted, what its temperature does to the gap.
  void build_shaft(const Case& c);

  FilmGrid grid_;
  std::optional<Shell> shell_;  ///< what the operators were built for
  std::optional<Shaft> shaft_;
  SolidEffects effects_;
  Harmonics harmonics_;
  HarmonicSample sample_;
  RevolutionMesh shell_mesh_, shaft_mesh_;
  FieldOperator compliance_;
  double winkler_ = 0.0;
  std::optional<thermal::ShellConduction> conduction_;
  std::vector<double> capacity_;          ///< density times heat capacity of each layer [J/(m3 K)]
  HarmonicOperator thermal_deformation_;  ///< per nodal temperature, computed harmonics only [m/K]
  HarmonicOperator deformation_per_flux_;
  Eigen::VectorXd uniform_expansion_;  ///< of the bore per kelvin, per axial cell [m/K]
  std::optional<thermal::ShaftConduction> shaft_conduction_;
  double shaft_ambient_ = 0.0;                 ///< [K]
  Eigen::MatrixXd shaft_thermal_deformation_;  ///< of the gap per nodal temperature [m/K]
  double surroundings_ = 0.0;
  double reference_ = 0.0;
  double setup_s_ = 0.0;
};

/// Throws InputError if the case has no layers.
[[nodiscard]] Solids::Layers wall_layers(const Case& c);

}  // namespace shellback::bearing
