#pragma once
/// From a solved film to its energy equation: node flows, dissipation, conductances.
///
/// The heat of a cell is the power that its film takes up, exactly as the film equation has it:
///   W = U tau_j A + sum over faces of the cell's share of m (p_- - p_+)/rho_ref     [W]   (1)
/// so that summed over the film it is friction power plus pump power, whatever the grid: the
/// second part telescopes to supply pressure times supply flow, and where cells gain oil to
/// -sum p dM/dt / rho_ref as well, the power of the walls that squeeze it. Across the film it is
/// spread as tau^2/eta (2 of columns.hpp); what that quadrature misses of (1) is spread evenly, and
/// where it finds more of a power that is positive, all nodes have less in proportion.
/// Asperity friction tau_a U heats the two walls, split by thermal effusivity.
#include <optional>
#include <vector>

#include "bearing/film/equilibrium.hpp"
#include "bearing/film/friction.hpp"
#include "bearing/solids.hpp"
#include "thermal/film_energy.hpp"

namespace shellback::bearing {

/// Power that the supply spends on pressing the oil through the film [W], whole bearing.
[[nodiscard]] double pump_power(const BearingModel& model, const OperatingPoint& point,
                                const FilmEquilibrium& s);

/// Density with which flow work and enthalpies are reckoned [kg/m3].
[[nodiscard]] double reference_density(const BearingModel& model);

/// Heat transfer coefficient between the oil of supply `patch` and each wall [W/(m2 K)], its
/// conductivity being that at the temperature of supply; 0 of drillings and none (patch < 0).
[[nodiscard]] double supply_heat_transfer(const BearingModel& model, int patch);
/// True of film cells, and of those of supplies that exchange heat with the walls.
[[nodiscard]] inline bool meets_walls(const BearingModel& model, int cell) {
  const int patch = model.supply.cell[cell];
  return patch < 0 || supply_heat_transfer(model, patch) > 0.0;
}

/// Of the oil that feeds each supply of the case [K]: its own; of supplies that touch
/// (SupplyMap::touching), which are one vessel, the mean of those under the highest pressure.
[[nodiscard]] std::vector<double> fed_temperatures(const Case& c, const std::vector<int>& touching);

/// Oil that comes out of the supplies which feed, and its mean temperature. What another supply
/// takes back leaves as warm as the film, unless the two touch: then it has passed no film.
struct OilFed {
  double mass = 0.0;  ///< [kg/s]
  double T = 0.0;     ///< [K]
};
/// `out_of`: net out of every supply of the case [kg/s]; `touching`: SupplyMap::touching; T where
/// none feeds: their plain mean.
[[nodiscard]] OilFed oil_fed(const Case& c, const std::vector<int>& touching,
                             const std::vector<double>& out_of);

/// Coldest and hottest oil of the supplies [K].
[[nodiscard]] std::pair<double, double> supply_temperatures(const Case& c);

/// Temperature of oil that as warm as T [K] and of the mean heat capacity `cp` [J/(kg K)] from the
/// reference on would have its enthalpy: that by the oil's law.
[[nodiscard]] double told_temperature(const BearingModel& model, double T, double cp);

/// The energy problem of the film as it stands, with the temperatures of its columns for the oil's
/// conductivity and heat capacity; over a time step with the oil that it has stored. Refers to
/// `model` and `model.gl`.
[[nodiscard]] thermal::FilmEnergyProblem film_energy_problem(
    const BearingModel& model, const OperatingPoint& point, const FilmEquilibrium& s,
    const Friction& friction, std::optional<thermal::FilmStorage> storage = {});

/// cp (T - T_reference) of every node at the temperatures `T` [K]: what a time step begins with
/// (thermal::heat_content) [J/kg].
[[nodiscard]] std::vector<double> film_enthalpy(const BearingModel& model,
                                                const std::vector<double>& T);

/// Asperity heat into shell and shaft per cell [W/m2].
struct ContactHeat {
  Field shell;
  Field shaft;
};
/// Heat into the shell per contact pressure, [W/m2] over [Pa] = [m/s]; where nothing touches,
/// that of its abrasive part.
[[nodiscard]] Field contact_heat_rate(const BearingModel& model, const OperatingPoint& point,
                                      const FilmEquilibrium& s);
[[nodiscard]] ContactHeat contact_heat(const BearingModel& model, const OperatingPoint& point,
                                       const FilmEquilibrium& s);

}  // namespace shellback::bearing
