#pragma once
/// What a bearing is asked to do at one instant: speed, supplies, load or position, and the step in
/// time that ends there.
#include <array>
#include <optional>

#include "bearing/bearing.hpp"
#include "bearing/pressed_layer.hpp"

namespace shellback::bearing {

struct State;

/// One more row of the border: position and load stand so far along a path,
///   sum_k along_k (q_k - from_k)/unit_k + along_load (ln_load - from_load) = length.       (4)
struct PathRow {
  std::array<double, 4> along{};  ///< [-]
  std::array<double, 4> unit{};   ///< [m], [rad]
  double along_load = 1.0;        ///< [-]
  fluid::JournalPosition from;
  double from_load = 0.0;  ///< [-]
  double length = 0.0;     ///< [-]
  bool moves = false;      ///< `from` moves with the surfaces as they grow (follow.hpp)
  /// `length` less what the state stands along [-].
  [[nodiscard]] double missing(const State& s) const;
};

/// What the journal must balance.
struct LoadTarget {
  int unknowns = 2;                 ///< 0: position given; 2: e; 4: e and tilt
  fluid::Wrench force{};            ///< wanted film force and moment on the journal: minus the load
  double inertial_stiffness = 0.0;  ///< m/dt^2 of the journal over a finite step [N/m]
  std::optional<PathRow> path;      ///< the load's factor is an unknown, too
  double unit = 0.0;                ///< by which residuals are measured [N]; 0: |force|
  [[nodiscard]] double scale() const;  ///< `unit`, or |force| [N]
  /// The force wanted of this state: with its factor and the journal's inertia by its flight.
  [[nodiscard]] fluid::Wrench wanted(const State& s) const;
  /// Work of the moment on a journal whose tilt follows it and changes by these [rad]; none where
  /// the tilt is held [J].
  [[nodiscard]] double work_of_moment(double psi_x, double psi_y) const;
};
[[nodiscard]] LoadTarget load_target(const Case& c);

/// The bearing never changes while it is solved; this does, along a branch and from step to step.
struct OperatingPoint {
  /// The film's domain with the journal's speed, its supplies and the step in time; a step without
  /// end is the steady bearing.
  fluid::FilmScene scene;
  LoadTarget load;
  std::optional<PressedLayer> layer;  ///< none: no elasto-plastic layer, or rigid surfaces
  /// Of the journal, positive counter-clockwise [rad/s].
  [[nodiscard]] double omega() const { return scene.speed / scene.grid.radius; }
};

/// As the case has it, steady.
[[nodiscard]] OperatingPoint operating_point(const BearingModel& model);

}  // namespace shellback::bearing
