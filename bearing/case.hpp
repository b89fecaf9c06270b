#pragma once
/// One case: all that a user can say about a bearing, in SI units, kelvin, radians.
///
/// The frame is that of docs/theory.md: X right, Y up, phi counter-clockwise from +X, positive
/// speed counter-clockwise, z = 0 at mid-width. app/reading/read_case fills it from a file, a C++
/// program by hand; bearing/judge/judge_case.hpp judges it: in the hands of a solver it is complete
/// and possible.
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bearing/load_cycle.hpp"
#include "bearing/methods.hpp"
#include "fluid/measured_factors.hpp"
#include "rheology/oil.hpp"
#include "solid/material.hpp"
#include "solid/surface.hpp"

namespace shellback::bearing {

/// Measured or designed deviation of the shell from the cylinder, added to the gap.
struct Profile {
  std::vector<double> phi{};     ///< n sorted positions in [0, 2 pi) [rad]
  std::vector<double> z{};       ///< m sorted positions [m]
  std::vector<double> height{};  ///< n x m, index i * m + k: gap added there [m]
  [[nodiscard]] bool operator==(const Profile&) const = default;
};

/// The bore opens over `length` from each side edge inwards, by `depth` at the edge itself.
struct EdgeOpening {
  double depth = 0.0;   ///< [m]
  double length = 0.0;  ///< [m]
  [[nodiscard]] bool operator==(const EdgeOpening&) const = default;
};

struct Bearing {
  double radius = 0.0;                       ///< R [m]
  double width = 0.0;                        ///< B [m]
  double radial_clearance = 0.0;             ///< cold radial clearance c [m]
  double reference_temperature = 293.15;     ///< at which `radial_clearance` was measured [K]
  std::optional<Profile> profile{};          ///< with jumps: constant on each cell
  std::optional<Profile> shape{};            ///< smooth: relief, crowning, wear
  std::optional<EdgeOpening> edge_relief{};  ///< a parabola, tangent to the cylinder
  std::optional<EdgeOpening> chamfer{};      ///< a cone
  std::optional<Profile> wear{};             ///< what running-in has taken away so far
  [[nodiscard]] bool operator==(const Bearing&) const = default;
};

/// A drilling is a hole of the journal and turns with it; it belongs to load cycles.
enum class SupplyKind { hole, axial_groove, circumferential_groove, drilling };

/// Laminar flow between parallel plates of one temperature, a groove's depth d apart: h = Nu k/(2
/// d) with Nu = 7.54 [textbook: Shah and London, Laminar Flow Forced Convection in Ducts].
struct ChannelHeat {
  static constexpr double kNusselt = 7.54;  ///< on the hydraulic diameter 2 d [-]
};

/// Oil behind a supply whose line is shut at times: it then lives on what the vessel holds.
struct Vessel {
  double volume = 0.0;          ///< between valve and film [m3]
  double bulk_modulus = 1.5e9;  ///< of the oil and of what yields around it [Pa]
  /// When the line is open: from and to, in the course's time [s], not overlapping, rising; none:
  /// never.
  std::vector<std::array<double, 2>> open;
};

/// One supply feature: the part of the surface on which the pressure is given.
struct Supply {
  SupplyKind kind = SupplyKind::hole;
  double angle = 0.0;        ///< of its middle, of a drilling as the cycle begins [rad]
  double z = 0.0;            ///< axial position of its middle [m]
  double arc = 0.0;          ///< circumferential extent [rad]; 0: a line; 2 pi: all round
  double length = 0.0;       ///< axial extent [m]
  double diameter = 0.0;     ///< hole and drilling [m]; arc and length then enclose the circle
  double depth = 1.0e-3;     ///< added to the gap inside [m]
  double pressure = 0.0;     ///< gauge [Pa]
  double temperature = 0.0;  ///< [K]
  double carry_over = 1.0;   ///< part of the film oil entering it that is mixed in again [-]
  /// Heat between its oil and each of the walls that it lies between [W/(m2 K)]; 0: none.
  std::variant<double, ChannelHeat> heat_transfer = 0.0;
  std::optional<Vessel> vessel{};  ///< none: its pressure stands, whatever flows
};

struct LoadGiven {
  double force = 0.0;  ///< magnitude of the load on the journal [N]
  double angle = 0.0;  ///< its direction [rad]
};
struct EccentricityGiven {
  double ratio = 0.0;       ///< |e| / c [-]
  double attitude = 0.0;    ///< from the load line to the line of centres, with the speed [rad]
  double load_angle = 0.0;  ///< the load line [rad]
  /// Of the displacement [rad]; a journal at rest counts as turning counter-clockwise.
  [[nodiscard]] double direction(double omega) const {
    return load_angle + (omega < 0.0 ? -attitude : attitude);
  }
};
/// Angle of the journal axis against the bearing axis.
struct TiltGiven {
  double about_x = 0.0;  ///< [rad]
  double about_y = 0.0;  ///< [rad]
};
/// Moment on the journal that the film must balance; the tilt is then solved for.
struct MomentGiven {
  double about_x = 0.0;  ///< [N m]
  double about_y = 0.0;  ///< [N m]
};

struct Operation {
  double omega = 0.0;  ///< journal speed, positive counter-clockwise [rad/s]
  std::variant<LoadGiven, EccentricityGiven> position = LoadGiven{};
  std::variant<TiltGiven, MomentGiven> alignment = TiltGiven{};
};

struct ShellLayer {
  solid::Material material{};
  double thickness = 0.0;       ///< radial [m]
  bool elasto_plastic = false;  ///< yields by solid/surface_layer.hpp; the first layer only
  [[nodiscard]] bool operator==(const ShellLayer&) const = default;
};
/// How the outer surface of the housing is held.
enum class HousingSupport {
  held,     ///< no displacement under load; free to grow with temperature
  free,     ///< no traction; rigid-body motion removed, net force balanced by body force
  clamped,  ///< no displacement under load or temperature
};
struct Housing {
  solid::Material material{};
  double outer_radius = 0.0;  ///< [m]
  HousingSupport support = HousingSupport::held;
  double joint_conductance =
      0.0;  ///< of the joint with the shell [W/(m2 K)]; 0: without resistance
  [[nodiscard]] bool operator==(const Housing&) const = default;
};
/// Heat leaves the outer surface of the housing (of the shell if there is no housing).
struct ConvectiveBack {
  double heat_transfer = 0.0;  ///< [W/(m2 K)]
  double ambient = 0.0;        ///< [K]
  [[nodiscard]] bool operator==(const ConvectiveBack&) const = default;
};
/// The back of the shell (interface to the housing) has this temperature.
struct PrescribedBack {
  double temperature = 0.0;  ///< [K]
  [[nodiscard]] bool operator==(const PrescribedBack&) const = default;
};
struct Shell {
  std::vector<ShellLayer> layers{};  ///< from the bore outwards
  std::optional<Housing> housing{};
  std::variant<ConvectiveBack, PrescribedBack> back = ConvectiveBack{};
  double end_heat_transfer = 50.0;  ///< from the end faces to the back's temperature [W/(m2 K)]
  [[nodiscard]] bool operator==(const Shell&) const = default;
};

struct Shaft {
  solid::Material material{};
  double overhang = 0.0;       ///< length beyond the bearing that gives off heat, each side [m]
  double heat_transfer = 0.0;  ///< from the overhang's surface [W/(m2 K)]
  double ambient = 0.0;        ///< of the overhang [K]
  /// Length beyond the bearing that is elastic, each side; unset: the larger of overhang and
  /// radius, beyond which the surface's own deformation has died out (Saint-Venant) [m].
  std::optional<double> elastic_overhang{};
  /// Between the middles of the supports, which lie as far to either side; unset: no bending [m].
  std::optional<double> span{};
  [[nodiscard]] bool operator==(const Shaft&) const = default;
};

struct Surfaces {
  solid::RoughSurface shell{};
  solid::RoughSurface shaft{};
  std::optional<solid::ContactParameters> contact{};
  std::optional<fluid::FactorTable> flow_factors{};  ///< measured, instead of Patir and Cheng's
};

/// The model ladder of design 4. `estimate` and `automatic` are the business of fidelity/; the
/// solvers of bearing/ know the four between them.
enum class Tier { estimate, isothermal, lumped, thd, tehd, automatic };
enum class AxialSpacing { graded, even };
enum class CavitatedShear { filled, full };
enum class Edges { flooded, dry };

/// Effects that can be switched; unset means the tier's own choice.
struct Switches {
  std::optional<bool> pressure_dependence{};
  std::optional<bool> shear_thinning{};
  std::optional<bool> flow_factors{};
  std::optional<bool> asperity_contact{};
  std::optional<bool> elastic_deformation{};
  std::optional<bool> thermal_deformation{};
};

struct Model {
  Tier tier = Tier::tehd;
  double tolerance = 0.01;           ///< wished for on friction torque and smallest film [-]
  std::array<int, 2> grid{200, 25};  ///< circumferential x axial cells over the full width
  std::optional<AxialSpacing> axial_spacing{};  ///< unset: graded if surfaces can touch
  bool grid_given = false;                      ///< false: tier `auto` chooses the grid
  int film_nodes = 5;                           ///< Gauss-Lobatto-Legendre nodes across the film
  bool film_nodes_given = false;                ///< false: tier `auto` chooses them
  Switches switches{};
  Methods methods{};
  CavitatedShear cavitated_shear = CavitatedShear::filled;
  Edges edges = Edges::flooded;
  double cavitation_pressure = 0.0;  ///< gauge [Pa]
  double kappa = 1.0;                ///< equivalent temperature factor [-]
  bool coefficients = false;         ///< stiffness, damping and whirl threshold are wanted
};

/// Wear of the shell (bearing/over_time/running_in.hpp).
struct RunningIn {
  double wear_coefficient = 0.0;     ///< C of Archard's C/H [-]
  double hardness = 0.0;             ///< H of the shell's surface; 0: that of its material [Pa]
  std::optional<double> duration{};  ///< unset: until it is worn in [s]
  double limit_pressure = 0.0;       ///< contact pressure at which wear ceases [Pa]
  std::optional<solid::RoughSurface> worn{};  ///< the shell's surface when worn
  double worn_after = 0.0;                    ///< greatest depth from which on it is [m]
};

struct Measured {
  std::optional<double> shell_back_temperature{};  ///< [K]
  std::optional<double> friction_torque{};         ///< [N m]
  std::optional<double> h_min{};                   ///< [m]
  std::optional<double> p_max{};                   ///< [Pa]
  std::optional<double> side_flow{};               ///< [m3/s]
  std::optional<double> eccentricity_ratio{};      ///< [-]
  std::optional<double> T_shell_max{};             ///< [K]
};

/// A key of the file that the command line changed.
struct Change {
  std::string key;     ///< "operation.speed"
  std::string value;   ///< as given: "1500 rpm"
  std::string option;  ///< that gave it, "--set", "--tier", ...
};

struct Case {
  std::string title;
  std::string path;      ///< file it came from
  std::string verbatim;  ///< the file's text
  /// Texts of the other files that it takes in: oils and materials, tables.
  std::vector<std::string> taken_in{};
  std::vector<Change> changes;  ///< in the order in which they were applied
  Bearing bearing;
  std::vector<Supply> supplies;
  Operation operation;
  std::optional<LoadCycle> cycle{};  ///< instead of operation.position's load
  rheology::Oil oil;
  std::optional<double> oil_temperature;  ///< isothermal film temperature, if given [K]
  std::optional<Shell> shell;
  std::optional<Shaft> shaft;
  Surfaces surfaces;
  Model model;
  Measured measured;
  std::optional<RunningIn> running_in;
  std::vector<std::string> assumptions;  ///< defaults and assumed data the reader relied on
  std::vector<std::string> warnings;     ///< possible but suspicious input
};

[[nodiscard]] const char* to_string(Tier tier);

/// Mean of what the supplies are given [K], whatever their order: where flows by volume are counted
/// and searches begin. The case has a supply.
[[nodiscard]] double mean_supply_temperature(const Case& c);

/// A groove whose arc closes.
[[nodiscard]] bool goes_all_round(const Supply& supply);

/// A mouth with a diameter: a hole or a drilling.
[[nodiscard]] inline bool is_round(const Supply& s) {
  return s.kind == SupplyKind::hole || s.kind == SupplyKind::drilling;
}
/// The supply with arc and length of the rectangle that encloses it, in a bearing of `radius` [m].
[[nodiscard]] Supply enclosed(Supply s, double radius);

/// Combined roughness of both surfaces, sigma = (sigma_shell^2 + sigma_shaft^2)^(1/2) [m].
[[nodiscard]] double combined_roughness(const Surfaces& s);

/// Whether heat goes through the shell's back.
[[nodiscard]] bool heat_leaves(const Shell& shell);

/// Whether its surfaces are known to give way: shell and shaft both.
[[nodiscard]] inline bool can_be_elastic(const Case& c) { return c.shell && c.shaft; }

/// Hardness of the shell's surface, of Archard's law: as [running_in] has it, else of the shell's
/// first layer; 0: not known [Pa].
[[nodiscard]] double hardness_of_shell(const Case& c);

/// At which contact pressure ends: that of the softer surface, as far as it is known; one that is
/// given with the contact counts instead [Pa]; 0: none. The case has contact.
[[nodiscard]] double hardness_of_contact(const Case& c);

}  // namespace shellback::bearing
