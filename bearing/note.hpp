#pragma once
/// What a result says of itself beside its numbers: warnings and assumptions. Their words are made
/// in app/words; texts are told as they are.
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "bearing/case.hpp"
#include "core/outcome.hpp"

namespace shellback::bearing {

namespace note {

enum class Plain {
  orientation_beyond_table,  ///< of the roughness, for the tabulated flow factors
  pressure_beyond_law,       ///< of the oil
};

/// The film is colder at one place than everything around it.
struct ColdSpot {
  double T = 0.0;  ///< [K]
};

/// Stiffness and damping were asked for and are not given.
struct NoCoefficients {
  Verdict why;
};

/// Damping by oil that comes and goes in the cavitated film, which only slow motions feel so.
struct CavitatedDamping {
  double share = 0.0;  ///< of all [-]
};

/// The heat balance of the whole bearing is met elsewhere, too.
struct OtherRoots {
  struct Root {
    double T = 0.0;  ///< [K]
    bool stable = false;
    bool taken = false;
  };
  std::vector<Root> roots;
};

/// Gaps below the smallest of the measured flow factors.
struct FactorsContinued {
  long cells = 0;
  double h = 0.0;  ///< the smallest measured [m]
  double H = 0.0;  ///< the same over sigma [-]
};

/// Film temperatures outside the range in which the oil's viscosity is known.
struct BeyondOilRange {
  double T_low = 0.0, T_high = 0.0;  ///< of the film; T_low not-a-number: not known [K]
  double T_min = 0.0, T_max = 0.0;   ///< of the oil [K]
};

/// Surfaces pressed deeper into each other than the contact law describes.
struct BeyondContactLaw {
  long cells = 0;
  double h = 0.0;      ///< smallest, negative [m]
  double sigma = 0.0;  ///< roughness of the summits [m]
  double least = 0.0;  ///< gap at which the law ends, negative [m]
  FilmPlace place{};   ///< of the smallest gap
};

/// The gap at a side edge, continued from the last cells, is closed while no cell's is.
struct EdgeNotResolved {
  double edge = 0.0;  ///< negative [m]
  double cell = 0.0;  ///< smallest of all cells [m]
};

/// Oil that is driven faster than a laminar film bears.
struct NotLaminar {
  double reynolds = 0.0;  ///< Re of the clearance [-]
  double limit = 0.0;     ///< beyond which vortices or turbulence begin [-]
};

/// Contact pressure held at the hardness: summits flow.
struct HeldAtHardness {
  double hardness = 0.0;  ///< [Pa]
  long cells = 0;
  double flow = 0.0;  ///< deepest [m]
  FilmPlace place{};  ///< there
};

/// A vessel of a supply at the cavitation pressure.
struct VesselEmpty {
  double part = 0.0;  ///< of the time [-]
};

/// The mouth of a drilling that is finer than the grid.
struct MouthWidened {
  int supply = 0;
  double diameter = 0.0;  ///< [m]
  double taken = 0.0;     ///< [m]
};

/// Tier `auto`: what richer physics would change is not known, its tier being not found.
struct NothingRicher {
  Tier tier = Tier::tehd;
  std::array<int, 2> grid{0, 0};  ///< on which it was tried
  Verdict why;
};

/// What tier `auto` took for a load cycle.
struct TierTaken {
  Tier tier = Tier::isothermal;
  std::array<int, 2> grid{0, 0};
  double friction = 0.0;  ///< most that the physics left out is worth, of the mean torque [-]
  double h_min = 0.0;     ///< the same of the smallest film [-]
  std::vector<NothingRicher> unjudged;  ///< one, if that is not known; or none
  std::vector<std::string> solved;      ///< on the way
};

}  // namespace note

using Note = std::variant<std::string, note::Plain, note::ColdSpot, note::NoCoefficients,
                          note::CavitatedDamping, note::OtherRoots, note::FactorsContinued,
                          note::BeyondOilRange, note::BeyondContactLaw, note::HeldAtHardness,
                          note::EdgeNotResolved, note::NotLaminar, note::VesselEmpty,
                          note::MouthWidened, note::NothingRicher, note::TierTaken>;

}  // namespace shellback::bearing
