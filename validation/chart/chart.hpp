#pragma once
/// Speed against accuracy: what each way to solve a scene costs and how far off it is.
///
/// Errors are measured against the richest tier on the finest grid with nine nodes across the film
/// (validation/chart/chart_reference.hpp); those of friction torque and smallest film are relative,
/// that of the highest film temperature is in kelvin. The highest temperature of a tier with one
/// film temperature is that one; of an isothermal scene there is none. Tier `auto` is charted where
/// the scene's own tier is the richest that its data allow: it chooses among all of them. Wall
/// times are those of cold solves, solid operators and coarser grids included, on one thread, the
/// best of a few repeats. Of a load cycle the mean torque, the smallest film and the highest
/// temperature over it are charted; its reference is stepped to 0.1 %, and what 0.3 % moves it by
/// counts as uncertainty.
#include <array>
#include <atomic>
#include <functional>
#include <vector>

#include "bearing/result.hpp"
#include "validation/chart/chart_reference.hpp"
#include "validation/chart/chart_settings.hpp"

namespace shellback::validation {

enum class ChartQuantity { friction_torque, h_min, T_max };
inline constexpr int kChartQuantities = 3;
/// Friction torque [N m], smallest film [m], highest film temperature [K]; NaN: not there.
using ChartValues = std::array<double, kChartQuantities>;

struct ChartPoint {
  ChartSetting setting;
  Verdict verdict;
  ChartValues value{};
  ChartValues error{};  ///< [-], [-], [K]; NaN where the solve failed
  double wall_s = 0.0;
  long factorizations = 0;  ///< of film matrices
  long sweeps = 0;          ///< of the relaxation
  std::array<bool, kChartQuantities> on_front{};
};

struct ChartScene {
  std::string name;
  std::string title;
  Verdict verdict;  ///< of the reference; without it there are no errors
  std::array<ReferenceValue, kChartQuantities> reference{};
  ChartValues floor{};  ///< uncertainty of the reference in the units of the errors
  std::vector<ChartPoint> points;
};

struct ChartOptions {
  ChartGrids grids;
  ChartGrids of_cycles = cycle_grids();
  int threads = 1;        ///< for the references, which are not timed
  int repeats = 5;        ///< at most, of each timed solve
  double enough_s = 0.5;  ///< time spent on one point after which it is not repeated [s]
  std::vector<double> tolerances{0.1, 0.03, 0.01, 0.003};  ///< of the points of tier `auto` [-]
  const std::atomic<bool>* stop = nullptr;
  /// Told before each solve: what, and how many of how many are done. May be empty.
  std::function<void(const std::string& what, int done, int of)> tell;
};

/// Charts one scene. Stopped from outside it keeps the points that are finished.
[[nodiscard]] ChartScene chart_scene(const std::string& name, const bearing::Case& c,
                                     const ChartOptions& options);

[[nodiscard]] const char* to_string(ChartQuantity quantity);

}  // namespace shellback::validation
