#pragma once
/// The numbers by which a case is judged: what a value can be, what bearings are like.
///
/// One table each; every line tells where its numbers come from.
#include <array>
#include <cmath>

#include "bearing/temperature_limits.hpp"
#include "core/constants.hpp"
#include "core/range.hpp"

namespace shellback::bearing {

/// What a single value can be. Outside, nothing can be computed.
struct ValueRanges {
  /// [K] No bearing runs colder, no oil film survives hotter.
  Range temperature{kZeroCelsius - 60.0, kHottestOil, false, "lie between -60 and 400 degC"};
  Range turn{-2.0 * kPi, 2.0 * kPi, false, "lie between -360 deg and 360 deg"};
  Range arc{0.0, 2.0 * kPi, false, "lie between 0 deg (a line) and 360 deg"};
  Range extent{0.0, 2.0 * kPi, true, "be positive and at most 360 deg"};
  /// Elastic surfaces make way for a journal that has moved by several clearances.
  Range eccentricity_ratio{0.0, 100.0, false, "lie between 0 and 100 (between rigid surfaces, 1)"};
  /// Without any compression pressure and displacement are no longer those of elements of one kind.
  Range poisson_ratio{0.0, 0.4999, false, "lie between 0 and 0.4999"};
  Range gauge_pressure{-101325.0, kInfinite, false,  // standard atmosphere, definition
                       "not lie below vacuum (-1.013 bar)"};
  /// [W/(m2 K)] Boiling and jets reach 1e5; beyond 1e6 oil and walls have one temperature.
  Range groove_heat{0.0, 1e6, false, "not be negative, nor more than 1e6 W/(m2 K)"};
  Range wall_heat = groove_heat;  ///< of shell and shaft to what surrounds them, the same
  /// [W/(m2 K)] Pressed metal joints reach 1e5 (textbook); as a layer of finite thickness a joint
  /// of 1e9 is perfect, one of 1e12 conducts along itself.
  Range joint{0.0, 1e9, true, "be positive and at most 1e9 W/(m2 K) (a perfect joint has none)"};
  Range tolerance{0.0, 0.5, true, "be positive and at most 50 %"};
  Range kappa{0.0, 5.0, false, "lie between 0 and 5"};
  Range relaxation{0.0, 1.0, true, "be positive and at most 1"};
  std::array<int, 2> cells{3, 4000};     // finer than any published study by a factor of five
  std::array<int, 2> film_nodes{3, 15};  // beyond, the collocation points crowd at the walls
  std::array<int, 2> layers{2, 60};      // three times what is usual
};
inline constexpr ValueRanges kValueRanges{};

/// Of the thickness of a layer that flows, what is pressed before it does or has flowed: columns
/// beside each other shear by then [-].
inline constexpr double kMostFlown = 0.5;

/// Possible and usual range of one derived number.
struct Limits {
  double least;        ///< below: absurd
  double usual_least;  ///< below: suspicious
  double usual_most;
  double most;
};

/// Journal bearings as built, with a wide margin.
struct BearingLimits {
  Limits radius{2.5e-4, 2e-3, 1.0, 3.0};         // [m] from a watch's pivot to a ship's stern tube
  Limits clearance{1e-5, 2e-4, 5e-3, 0.05};      // over the radius [-]; made with about 1e-3
  Limits aspect{0.02, 0.1, 2.0, 10.0};           // width over diameter: a seal; edges rule [-]
  Limits surface_speed{0.0, 0.0, 120.0, 400.0};  // [m/s] turbomachinery reaches about 120
  Limits specific_load{0.0, 1e3, 150e6, 2e9};    // [Pa] engines reach about 150 MPa peak
  Limits edge_tilt{0.0, 0.0, 0.5, 1.0};          // over the clearance [-]; 1: across the whole gap
  Limits roughness{0.0, 0.0, 0.05, 0.5};         // combined, over the clearance [-]
  /// [-] Engineering surfaces 0.03 to 0.05 (Greenwood and Tripp, textbook); from 0.3 on all is
  /// contact as soon as the mean planes meet: pi^2 0.3^2 F_2(0) = 0.44.
  Limits summit_product{0.0, 0.01, 0.15, 0.3};
  /// K of Greenwood and Tripp [-]: 16 sqrt(2) pi/15 of the square of that product times the root of
  /// summit roughness over summit radius, here 1e-4 (ground), 0.1 (blasted), at most 1 (textbook).
  Limits elastic_factor{0.0, 4.7e-6, 0.034, 0.43};
  /// Mean height of the summits over the roughness [-]: 0.8 to 1.5 on Gaussian surfaces, less where
  /// they are worn (textbook); beyond 4 a Gaussian surface has no height at all.
  Limits summit_height{-4.0, -1.0, 3.0, 4.0};
  /// Deviation of the summits' heights over the roughness [-]: at most 1 on Gaussian surfaces
  /// (Nayak, textbook), where all of the surface is summits.
  Limits summit_spread{0.0, 0.0, 1.5, 5.0};
  Limits viscosity{1e-6, 5e-4, 2.0, 1e3};    // [Pa s] air to pitch; oils lie between
  Limits bulk_modulus{1e8, 8e8, 6e9, 1e11};  // [Pa] liquids: 0.8 (petrol) to 5 GPa
  /// [1/K] Lubricating oils 6.4e-4 to 7.3e-4 (seed 002, after Eq. 28); at 5e-3 the density would
  /// be gone 200 K above its reference.
  Limits oil_expansion{0.0, 0.0, 1.5e-3, 5e-3};
  Limits oil_density{100.0, 600.0, 2000.0, 2e4};      // [kg/m3] petrol 700, perfluoroethers 1900
  Limits oil_heat_capacity{200.0, 1000.0, 5e3, 2e4};  // [J/(kg K)] oils 1700 to 2500, water 4200
  Limits oil_conductivity{5e-3, 0.05, 0.8, 100.0};    // [W/(m K)] oils 0.13, water 0.6
  /// beta of exp(-beta (T - at)) [1/K]: oils 0.02 to 0.06; at 1 a degree takes two thirds.
  Limits viscosity_slope{0.0, 0.0, 0.12, 1.0};
  /// d ln eta/dp [1/Pa]: oils 1e-8 to 4e-8 (textbook); usual is a tenth of the least to some times
  /// the most of that. At 1e-6 a bearing's 10 MPa multiply the viscosity by exp(10).
  Limits pressure_slope{0.0, 1e-9, 1e-7, 1e-6};
  /// K of Cross' law, one over the rate at which an oil thins [s]: engine oils 1e-8 to 1e-5,
  /// polymer melts 1 s.
  Limits thinning_time{0.0, 1e-11, 1e-3, 1.0};
  /// Pressure times (1 + nu)(1 - 2 nu)/(E (1 - nu)), the strain of a thin layer [-]: laws of small
  /// strain err by their square, and beyond a half columns beside each other shear.
  double strain_usual = 0.1;
  double strain_most = 0.5;
  /// Composite modulus over that of first layer and shaft [-]: published ones of one pair differ by
  /// a tenth (KS rig: 53.3 GPa, of its materials 58.6), those of AlSn by a third.
  double modulus_apart = 1.5;
  Limits composite_modulus{1e6, 1e8, 5e11, 5e12};  // [Pa] rubber 5e6, steel on steel 1.2e11
  /// Lever arm of a moment over the width [-]: beyond 1/2 the load's line lies outside the bearing.
  Limits lever{0.0, 0.0, 0.5, 50.0};
  Limits mouth{1e-5, 2e-4, INFINITY, INFINITY};  // [m] diameter of a hole; bored ones have 0.5 mm
  Limits channel{0.0, 0.0, 0.05, 0.5};           // [m] depth of a groove; a ship's has centimetres
  /// Thickness over the radius of a wall that no housing holds [-]; a foil's bending stiffness is
  /// lost in the round-off of its stretching one.
  Limits free_wall{1e-3, 1e-2, INFINITY, INFINITY};
  Limits layer{1e-9, 1e-7, INFINITY,
               INFINITY};  // [m] sputtered coatings from 0.1 um; atoms: 0.3 nm
  /// C of Archard's law [-]: from lubricated to unlubricated metals 1e-10 to 1e-2 (textbook).
  Limits wear_coefficient{0.0, 1e-12, 1e-2, 1.0};
  /// Depth at which a surface is worn, over the clearance [-]: summits are some hundredths of it.
  Limits worn_after{1e-5, 1e-3, 1.0, 10.0};
  Limits hardness{1e6, 1e7, 2e10, 1e12};  // [Pa] polymers from 50 MPa, nitrided steel 10 GPa
  double supply_cover_usual = 0.3;        ///< of the surface [-]
  double supply_cover_most = 0.9;         ///< above, hardly any film is left [-]
  /// [Pa] of a supply that has any, above or below ambient; a centimetre of oil has 85.
  double least_pressure = 100.0;
  Limits supply_pressure{-INFINITY, -INFINITY, 50e5, 2e9};  // [Pa] above, hydrostatic; fuel 3e8
  /// [W/(m2 K)] Of walls to what surrounds them: still air 5, oil 1e3, jets and boiling 1e5.
  Limits wall_heat{0.0, 0.0, 1e5, kValueRanges.wall_heat.high};
  /// [W/(m2 K)] A gap of a millimetre of air has 30, pressed metal joints 1e3 to 1e5 (textbook).
  Limits joint{0.0, 10.0, INFINITY, INFINITY};
  /// [Pa] Oil and vessel together. Possible from air alone, as stiff as its pressure is high, usual
  /// from a soft hose on; a liquid in a stiff wall has 1 to 3 GPa (textbook), misread 1 to 3 MPa.
  Limits vessel_modulus{1e5, 3e6, 6e9, 1e11};
  /// [m3] Usual from the drillings of a pin to a gallery; possible from a cubic micrometre, as
  /// large a drop as a film is thick, to a tank whose oil is still counted to the last of what a
  /// gap holds, 1e-6 m3, to a millionth of it.
  Limits vessel_volume{1e-18, 1e-8, 1e-2, 1e3};
  /// Above cavitation [Pa]. Possible from the weight of a tenth of a millimetre of oil on.
  Limits vessel_head{1.0, 1e3, INFINITY, INFINITY};
  double profile_most = 0.1;     ///< heights' spread over the radius: no gap beyond [-]
  double wall_most = 5.0;        ///< shell over radius: no bush's wall is thicker [-]
  double housing_usual = 10.0;   ///< outer over inner radius: eyes and blocks have 1.3 to 4 [-]
  double housing_most = 50.0;    ///< beyond, a full space does as well [-]
  double overhang_least = 1e-4;  ///< over the radius: below, none; elements degenerate [-]
  double overhang_most = 100.0;  ///< over the radius: a shaft is infinite by then [-]
  /// [-] Over the radius: the local field is gone after two; a free body of 40 bends by itself
  /// (friction of thd-plain-bearing: 2.3530, 2.3502, 2.3423 N m with 1, 40, 100).
  double elastic_overhang_most = 20.0;
  int fewest_cells_round = 16;  ///< below, not even a full film's maximum is resolved
  int most_cells = 2000000;     ///< memory: some kB per cell
};
inline constexpr BearingLimits kBearingLimits{};

}  // namespace shellback::bearing
