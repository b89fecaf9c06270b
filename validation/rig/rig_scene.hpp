#pragma once
/// The cases of the study: which file, with which changes.
#include <array>
#include <string>
#include <vector>

#include "bearing/case.hpp"

namespace shellback::validation {

enum class RigBearing { test, support };
inline constexpr RigBearing kRigBearings[] = {RigBearing::test, RigBearing::support};
[[nodiscard]] const char* to_string(RigBearing bearing);

/// How far the oil's viscosity is followed: Figures 5, 6 and 7 of the paper.
enum class OilModel { temperature, pressure, full };
inline constexpr OilModel kOilModels[] = {OilModel::temperature, OilModel::pressure,
                                          OilModel::full};
[[nodiscard]] const char* to_string(OilModel model);

/// An input that is not published: its range, and how each end changes the cases.
struct RigUnknown {
  std::string name;
  std::string range;
  std::array<std::vector<std::string>, 2> test;     ///< KEY=VALUE at the low, at the high end
  std::array<std::vector<std::string>, 2> support;  ///< the same
  std::array<double, 2> warmer{0.0, 0.0};           ///< film of the isothermal tier [K]
  std::array<double, 2> stretched{1.0, 1.0};        ///< period of the load, times [-]
};

/// Of the isothermal cycles, and of bodies in time.
[[nodiscard]] const std::vector<RigUnknown>& film_unknowns();
[[nodiscard]] const std::vector<RigUnknown>& body_unknowns();
/// Of the run-up and run-down: rod, brackets and base are not in the rings of the cases.
[[nodiscard]] const RigUnknown& heavier_bodies();

/// Where the rig runs.
struct RigSetting {
  double peak = 80e3;  ///< of the load on the test bearing [N]
  double rpm = 3000.0;
  std::array<int, 2> grid{60, 9};
  const RigUnknown* unknown = nullptr;  ///< null: as taken
  int end = 0;                          ///< of it: 0 low, 1 high
};

/// The case of temperature solved. Throws InputError.
[[nodiscard]] bearing::Case rig_case(RigBearing bearing, const RigSetting& setting);

/// The isothermal elastic case at the film temperature T [K] with the oil followed so far.
[[nodiscard]] bearing::Case rig_isothermal_case(RigBearing bearing, const RigSetting& setting,
                                                OilModel oil, double T);

/// The start and stop of section 4.4 in a film of temperature T [K], with the new or the worn
/// surface of its Table 3.
[[nodiscard]] bearing::Case rig_start_stop_case(RigBearing bearing, bool worn, double T,
                                                std::array<int, 2> grid);

/// Largest load of the shipped trace on the test bearing [N], and the test bearing's projected
/// area [m2].
inline constexpr double kTracePeak = 80e3;
[[nodiscard]] double rig_projected_area();

}  // namespace shellback::validation
