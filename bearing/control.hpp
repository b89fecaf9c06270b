#pragma once
/// What a running solve tells, and how it is told to stop.
#include <atomic>
#include <functional>
#include <limits>
#include <string>

namespace shellback::bearing {

/// Where a solve stands; sent after each outer iteration of heat and each step in time: a film of
/// one temperature and an estimate send nothing.
struct Progress {
  std::string stage;             ///< "isothermal", "thd", ...
  int step = 0;                  ///< outer iteration
  double residual = 0.0;         ///< relative change of the iterate [-]
  double friction_torque = 0.0;  ///< [N m]
  double h_min = 0.0;            ///< [m]
};

class KeptRun;

struct SolveControl {
  std::function<void(const Progress&)> progress;  ///< may be empty
  const std::atomic<bool>* stop = nullptr;        ///< set from outside: end soon, keep the state
  KeptRun* kept = nullptr;  ///< of all but steady states: kept on the way (kept_run.hpp)
  /// Work from which a search from cold is given up, if before its own bound (`most_work`) [cells].
  double most_work = std::numeric_limits<double>::infinity();
  /// Change per iteration with which heat may end, if less than its own bound
  /// (ThermalOptions::tolerance), where this solve is one value of a map with a tolerance [-].
  double heat_within = std::numeric_limits<double>::infinity();
};

[[nodiscard]] inline bool stopped(const SolveControl& control) {
  return control.stop != nullptr && control.stop->load();
}

}  // namespace shellback::bearing
