#pragma once
/// Where a film leaves the ranges of its laws: a steady state, or the extremes of a cycle.
#include <limits>
#include <string>
#include <vector>

#include "bearing/bearing.hpp"
#include "bearing/result.hpp"
#include "fluid/gap.hpp"

namespace shellback::bearing {

/// What a film has come to.
struct FilmReach {
  double T_low = 0.0;          ///< NaN: not known [K]
  double T_high = 0.0;         ///< NaN: not known [K]
  double p_max = 0.0;          ///< [Pa]
  const Field& h;              ///< smallest gap of each cell [m]
  fluid::SmallestGap least{};  ///< of all
  double h_min = least.h;      ///< the same, with side edges [m]
  double shear_rate = 0.0;     ///< largest of full columns (largest_shear_rate) [1/s]
  double p_slope = 0.0;        ///< largest slope of the film pressure [Pa/m]
  double layer_depth = 0.0;    ///< by which an elasto-plastic layer has flowed, at most [m]
  /// Largest of the shell's surface; NaN: not known [K].
  double T_shell = std::numeric_limits<double>::quiet_NaN();
};

/// How far summits have flowed at the contact's hardness where the gap is `h` [m], in the middle of
/// each cell [m]; empty: no hardness is known.
[[nodiscard]] Field summit_flow(const BearingModel& m, const Field& h);

/// One note for each range of the oil's laws that a film from T_low to T_high [K] (NaN: not known)
/// with pressures up to p_max [Pa] leaves.
[[nodiscard]] std::vector<Note> oil_range_warnings(const rheology::Oil& oil, double T_low,
                                                   double T_high, double p_max);

/// Those that follow from the case alone, whatever its film comes to.
[[nodiscard]] std::vector<Note> input_warnings(const Case& c, const Physics& physics);

/// Its own growth in thickness is left out: an assumption of models that have both.
void add_layer_of_constant_thickness(const BearingModel& m, std::vector<Note>& assumptions);

/// That shell and housing stay joined where heat would part them, from mean temperatures of bore
/// and back of the shell [K], if that moves the bore by more than model.tolerance of the clearance.
/// Rings at one temperature each, the housing at that of the joint (solid/joined_rings.hpp).
void add_joint_that_pulls(const BearingModel& m, double bore, double back,
                          std::vector<Note>& assumptions);

/// How warm oil is taken to be that comes in at a side edge; nothing where the film's temperature
/// is given.
void add_temperature_of_edge_oil(const BearingModel& m, Tier tier, std::vector<Note>& assumptions);

/// One note for each range that was left: temperature and pressure of the oil's laws, flow
/// factors, contact (beyond its law, or held at the hardness): how much, where.
[[nodiscard]] std::vector<Note> range_warnings(const BearingModel& m, const FilmReach& reach);

/// Reynolds number of the clearance at the sliding speed U [m/s] and film temperature T [K], and
/// that at which Taylor vortices begin in a concentric gap,
///   Re = rho |U| c/eta,   Re_limit = 41.2 sqrt(R/c)      Source: Taylor 1923, textbook form
inline constexpr double kTaylor = 41.2;  ///< [-]
[[nodiscard]] note::NotLaminar reynolds_number(const Case& c, double U, double T);
/// Inertia of the film over its viscous forces, Re c/R = rho omega c^2/eta [-] (textbook).
[[nodiscard]] double reduced_reynolds(const Case& c, const note::NotLaminar& film);
inline constexpr double kInertiaMatters = 1.0;  ///< of it: as large as they are [-]
/// Rough surfaces nearer than three roughnesses at `h_min` [m] without data of contact.
void add_contact_left_out(const Case& c, double h_min, std::vector<Note>& notes);

/// One note if that limit is passed, one if the film's inertia matters; U [m/s], T [K].
void add_turbulence(const Case& c, double U, double T, std::vector<Note>& notes);

/// A note on the inertia of a film that a journal squeezes, where it moves by up to `velocity`
/// [m/s] in oil of temperature T [K]: rho v c/eta beyond 1 (methods 7.2 with v/c as its rate).
void add_squeeze_inertia(const Case& c, double velocity, double T, std::vector<Note>& notes);

/// Shear stress that oils bear, beyond which they slip or flow plastically however viscous, at
/// ambient pressure and more by the pressure: tau_L = kShearAtRest + kShearByPressure p. Source:
/// textbook (limiting shear stress in traction: 1 to 5 MPa, and 0.05 to 0.1 of the pressure); the
/// upper ends.
inline constexpr double kShearAtRest = 5e6;      ///< [Pa]
inline constexpr double kShearByPressure = 0.1;  ///< [-]
/// Where the viscous stress on the journal is most of what oil bears.
[[nodiscard]] note::OilSheared sheared_oil(const FilmGrid& grid, const Field& p,
                                           const Field& stress);
/// What is worse in either of two films.
[[nodiscard]] note::OilSheared worse(const note::OilSheared& a, const note::OilSheared& b);
/// One note if it is more than oil bears.
void add_sheared_oil(const note::OilSheared& sheared, std::vector<Note>& notes);

/// Largest |U|/h of the columns that are full, h the mean gap of rough surfaces [1/s]: the mean
/// shear rate across the film by the sliding alone.
[[nodiscard]] double largest_shear_rate(const fluid::FilmState& film, const Field& h, double U);

/// Largest difference of the pressure between neighbours over their distance [Pa/m].
[[nodiscard]] double largest_slope(const FilmGrid& grid, const Field& p);

/// Cells of the contact at its limits, `h` as in FilmReach.
[[nodiscard]] std::vector<LimiterCount> contact_limiters(const BearingModel& m, const Field& h);

}  // namespace shellback::bearing
