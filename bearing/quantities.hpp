#pragma once
/// The scalars of a result, each with its name, unit and meaning in one table.
///
/// Not-a-number: the tier does not know it. A new quantity is a member, a row of the table and the
/// line of bearing/steady/summary.cpp that computes it; its name is that of the result contract
/// (JSON).
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace shellback::bearing {

/// A reported scalar with its bars.
struct Quantity {
  std::string name;
  double value = 0.0;
  std::string unit;
  double error_grid = std::numeric_limits<double>::quiet_NaN();   ///< bar of the discretisation
  double error_model = std::numeric_limits<double>::quiet_NaN();  ///< bar of the physics left out
  double order =
      std::numeric_limits<double>::quiet_NaN();  ///< observed, with which error_grid falls
  /// Part of error_grid that more cells do not take off: that of the nodes across the film.
  double error_nodes = 0.0;
  double error_time =
      std::numeric_limits<double>::quiet_NaN();  ///< bar of a load cycle's steps in time
  double magnitude = 0.0;  ///< mean of |value| over a cycle in which it changes its sign
  /// What the grids of the bar lead to as cells get infinitely fine; NaN: not known.
  double limit = std::numeric_limits<double>::quiet_NaN();
  /// What finer grids and shorter steps may change: error_grid, and error_time where it is known.
  [[nodiscard]] double discretisation() const;
  /// Sum of the bars that are known; NaN: none is.
  [[nodiscard]] double error() const;
  /// What bars are measured by: |value|, or the magnitude of what changes its sign.
  [[nodiscard]] double size() const { return std::max(std::abs(value), magnitude); }
};

/// That of this name; null: there is none.
[[nodiscard]] const Quantity* quantity_in(const std::vector<Quantity>& list,
                                          const std::string& name);
/// Its value; not-a-number: there is none.
[[nodiscard]] double value_in(const std::vector<Quantity>& list, const std::string& name);

/// The values, typed. A friction torque has the sign of the speed, so that torque times speed is a
/// loss; powers are losses; forces are those of the film on the journal; flows are volumes at the
/// density of the supplied oil.
struct Quantities {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  double friction_torque = kUnknown;           ///< on the journal, of film and asperities [N m]
  double friction_torque_asperity = kUnknown;  ///< part of it from asperities [N m]
  // Parts of the asperity torque, and each over the torque of a coefficient of one: known where
  // the case has a friction law.
  double friction_torque_abrasive = kUnknown;            ///< [N m]
  double friction_torque_adhesive = kUnknown;            ///< [N m]
  double friction_torque_micro_hydrodynamic = kUnknown;  ///< [N m]
  double mu_abrasive = kUnknown;                         ///< mean coefficient [-]
  double mu_adhesive = kUnknown;                         ///< [-]
  double mu_micro_hydrodynamic = kUnknown;               ///< [-]
  /// On the shell, as its housing feels it: that of the journal less the moment of the film's force
  /// on a journal off the axis [N m].
  double friction_torque_shell = kUnknown;
  double breakaway_torque = kUnknown;     ///< at which a journal at rest begins to turn [N m]
  double lift_off_speed = kUnknown;       ///< at which asperities hardly rub any more [rad/s]
  double power_loss = kUnknown;           ///< friction torque times speed [W]
  double pump_power = kUnknown;           ///< of the supplied pressure [W]
  double eccentricity_ratio = kUnknown;   ///< |e| over the cold radial clearance [-]
  double attitude_angle = kUnknown;       ///< load line to line of centres, with the speed [deg]
  double tilt_x = kUnknown;               ///< of the journal about X, if it is tilted [rad]
  double tilt_y = kUnknown;               ///< about Y [rad]
  double h_min = kUnknown;                ///< smallest film, edges included [m]
  double h_min_mid = kUnknown;            ///< smallest film at mid-width [m]
  double p_max = kUnknown;                ///< largest film pressure, gauge [Pa]
  double p_asperity_max = kUnknown;       ///< largest contact pressure [Pa]
  double asperity_load_share = kUnknown;  ///< their force over that on the journal, sizes [-]
  double load_x = kUnknown;               ///< of film and asperities on the journal [N]
  double load_y = kUnknown;               ///< [N]
  double moment_x = kUnknown;      ///< of the film on the journal about X, if it is tilted [N m]
  double moment_y = kUnknown;      ///< about Y [N m]
  double side_flow = kUnknown;     ///< out of both sides [m3/s]
  double supply_flow = kUnknown;   ///< in at the supplies [m3/s]
  double p_vessel_min = kUnknown;  ///< smallest pressure of a supply's vessel, gauge [Pa]
  double elastic_opening_max = kUnknown;    ///< largest elastic widening of the gap [m]
  double layer_depth = kUnknown;            ///< largest lasting one of an elasto-plastic layer [m]
  double layer_loss = kUnknown;             ///< heat made in it, mean over a cycle [W]
  double T_film_max = kUnknown;             ///< [K]
  double T_film_mean = kUnknown;            ///< weighted by the oil that is there [K]
  double T_shell_max = kUnknown;            ///< on its surface [K]
  double T_shell_back = kUnknown;           ///< mean over the back [K]
  double T_shell_back_max = kUnknown;       ///< [K]
  double T_shaft = kUnknown;                ///< mean over the width [K]
  double T_supply_mixed = kUnknown;         ///< oil behind the supplies, mean by what they feed [K]
  double heat_by_oil = kUnknown;            ///< carried off [W]
  double heat_to_shell = kUnknown;          ///< [W]
  double heat_to_shaft = kUnknown;          ///< [W]
  double thermal_opening_mean = kUnknown;   ///< mean thermal widening of the gap [m]
  double T_equivalent = kUnknown;           ///< film temperature of tier isothermal [K]
  double K_xx = kUnknown, K_xy = kUnknown;  ///< stiffness, model.coefficients [N/m]
  double K_yx = kUnknown, K_yy = kUnknown;
  double C_xx = kUnknown, C_xy = kUnknown;  ///< damping [N s/m]
  double C_yx = kUnknown, C_yy = kUnknown;
  double whirl_critical_mass = kUnknown;  ///< of a rigid rotor, per bearing [kg]
  double whirl_speed_ratio = kUnknown;    ///< at it: omega sqrt(c m/W) [-]
  double whirl_ratio = kUnknown;          ///< whirl frequency at it, over the speed [-]
};

/// One row of the table.
struct QuantityEntry {
  double Quantities::*member;
  std::string_view name;   ///< in JSON
  std::string_view unit;   ///< in JSON; "1" for a plain number
  std::string_view label;  ///< for people
};

/// In the order of the result contract.
inline constexpr QuantityEntry kQuantities[] = {
    {&Quantities::friction_torque, "friction_torque", "N m", "friction torque"},
    {&Quantities::friction_torque_asperity, "friction_torque_asperity", "N m",
     "  of it from asperities"},
    {&Quantities::friction_torque_abrasive, "friction_torque_abrasive", "N m",
     "    of that abrasive"},
    {&Quantities::friction_torque_adhesive, "friction_torque_adhesive", "N m",
     "    of that adhesive"},
    {&Quantities::friction_torque_micro_hydrodynamic, "friction_torque_micro_hydrodynamic", "N m",
     "    of that micro-hydrodynamic"},
    {&Quantities::mu_abrasive, "mu_abrasive", "1", "boundary friction, abrasive"},
    {&Quantities::mu_adhesive, "mu_adhesive", "1", "boundary friction, adhesive"},
    {&Quantities::mu_micro_hydrodynamic, "mu_micro_hydrodynamic", "1",
     "boundary friction, micro-hydrodynamic"},
    {&Quantities::friction_torque_shell, "friction_torque_shell", "N m",
     "friction torque on the shell"},
    {&Quantities::breakaway_torque, "breakaway_torque", "N m", "breakaway torque"},
    {&Quantities::lift_off_speed, "lift_off_speed", "rad/s", "speed of lift-off"},
    {&Quantities::power_loss, "power_loss", "W", "power loss"},
    {&Quantities::pump_power, "pump_power", "W", "power of the supplied pressure"},
    {&Quantities::eccentricity_ratio, "eccentricity_ratio", "1", "eccentricity ratio"},
    {&Quantities::attitude_angle, "attitude_angle", "deg", "attitude angle"},
    {&Quantities::tilt_x, "tilt_x", "rad", "tilt of the journal about X"},
    {&Quantities::tilt_y, "tilt_y", "rad", "tilt of the journal about Y"},
    {&Quantities::h_min, "h_min", "m", "smallest film, h_min"},
    {&Quantities::h_min_mid, "h_min_mid", "m", "smallest film at mid-width"},
    {&Quantities::p_max, "p_max", "Pa", "largest film pressure, p_max"},
    {&Quantities::p_asperity_max, "p_asperity_max", "Pa", "largest contact pressure"},
    {&Quantities::asperity_load_share, "asperity_load_share", "1", "load share of asperities"},
    {&Quantities::load_x, "load_x", "N", "force on journal, X"},
    {&Quantities::load_y, "load_y", "N", "force on journal, Y"},
    {&Quantities::moment_x, "moment_x", "N m", "film moment on journal about X"},
    {&Quantities::moment_y, "moment_y", "N m", "film moment on journal about Y"},
    {&Quantities::side_flow, "side_flow", "m3/s", "side flow"},
    {&Quantities::supply_flow, "supply_flow", "m3/s", "supply flow"},
    {&Quantities::p_vessel_min, "p_vessel_min", "Pa", "smallest pressure of a vessel"},
    {&Quantities::layer_depth, "layer_depth", "m", "lasting depth of the surface layer"},
    {&Quantities::layer_loss, "layer_loss", "W", "power lost in the surface layer"},
    {&Quantities::elastic_opening_max, "elastic_opening_max", "m",
     "largest elastic opening of the gap"},
    {&Quantities::T_film_max, "T_film_max", "K", "film temperature, largest"},
    {&Quantities::T_film_mean, "T_film_mean", "K", "film temperature, mean"},
    {&Quantities::T_shell_max, "T_shell_max", "K", "shell surface temperature, largest"},
    {&Quantities::T_shell_back, "T_shell_back", "K", "shell-back temperature"},
    {&Quantities::T_shell_back_max, "T_shell_back_max", "K", "shell-back temperature, largest"},
    {&Quantities::T_shaft, "T_shaft", "K", "shaft temperature"},
    {&Quantities::T_supply_mixed, "T_supply_mixed", "K", "temperature of the mixed supply"},
    {&Quantities::heat_by_oil, "heat_by_oil", "W", "heat carried off by the oil"},
    {&Quantities::heat_to_shell, "heat_to_shell", "W", "heat into the shell"},
    {&Quantities::heat_to_shaft, "heat_to_shaft", "W", "heat into the shaft"},
    {&Quantities::thermal_opening_mean, "thermal_opening_mean", "m",
     "mean thermal opening of the gap"},
    {&Quantities::T_equivalent, "T_equivalent", "K", "equivalent temperature"},
    {&Quantities::K_xx, "K_xx", "N/m", "stiffness K_xx"},
    {&Quantities::K_xy, "K_xy", "N/m", "stiffness K_xy"},
    {&Quantities::K_yx, "K_yx", "N/m", "stiffness K_yx"},
    {&Quantities::K_yy, "K_yy", "N/m", "stiffness K_yy"},
    {&Quantities::C_xx, "C_xx", "N s/m", "damping C_xx"},
    {&Quantities::C_xy, "C_xy", "N s/m", "damping C_xy"},
    {&Quantities::C_yx, "C_yx", "N s/m", "damping C_yx"},
    {&Quantities::C_yy, "C_yy", "N s/m", "damping C_yy"},
    {&Quantities::whirl_critical_mass, "whirl_critical_mass", "kg",
     "critical mass of a rigid rotor, per bearing"},
    {&Quantities::whirl_speed_ratio, "whirl_speed_ratio", "1",
     "speed ratio at it, omega sqrt(c m/W)"},
    {&Quantities::whirl_ratio, "whirl_ratio", "1", "whirl frequency at it, over speed"},
};
// Every member has a row; the tests see that none has two.
static_assert(sizeof(Quantities) == std::size(kQuantities) * sizeof(double));

/// The row of that name; null: there is none.
[[nodiscard]] const QuantityEntry* find_quantity(std::string_view name);

/// The known ones, in the order of the table, without bars.
[[nodiscard]] std::vector<Quantity> listed(const Quantities& values);

/// The values of such a list; a name that is not in the table is left out.
[[nodiscard]] Quantities typed(const std::vector<Quantity>& list);

}  // namespace shellback::bearing
