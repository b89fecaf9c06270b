#pragma once
/// Load and speed of a journal over time.
///
/// A cycle repeats itself with its period; a single event has none. Between the rows of the table
/// load and speed are straight lines or a periodic cubic spline. Two rows at one time are a jump:
/// the first holds before it, the second after it. The load acts on the journal, in the frame in
/// which the shell stands still; the speed is that of the journal against the shell.
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace shellback::bearing {

enum class LoadInterpolation { linear, periodic_spline };

/// A load cycle as given: rows of a table, in SI units.
struct LoadCycle {
  std::vector<double> t;      ///< of each row, not falling, from 0; below the period [s]
  std::vector<double> x;      ///< load on the journal [N]
  std::vector<double> y;      ///< [N]
  std::vector<double> omega;  ///< of the journal against the shell [rad/s]; empty: operation.speed
  double period = std::numeric_limits<double>::infinity();  ///< [s]; infinity: a single event
  LoadInterpolation interpolation = LoadInterpolation::linear;
  double journal_mass = 0.0;     ///< what the film carries [kg]; 0: a journal without inertia
  std::optional<double> step{};  ///< of time, given [s]; else chosen by model.tolerance
  double crank_speed = 0.0;      ///< crank angle per time [rad/s]; 0: told in time
  /// Of its width the mouth of a drilling moves in one step at most, below 1: no place that it
  /// passes over is left out [-].
  double of_mouth = 0.5;
  /// Instants whose films are kept, steps end on them [s]; empty: films evenly over the whole.
  std::vector<double> fields_at{};
  [[nodiscard]] bool repeats() const { return period < std::numeric_limits<double>::infinity(); }
  /// A period, or from the first row of an event to its last [s].
  [[nodiscard]] double length() const { return repeats() ? period : t.back() - t.front(); }
};

/// Straight lines in place of each stretch between rows of a spline: a cubic, which then is known
/// to a thousandth of what it bends.
inline constexpr std::size_t kLinesOfSpline = 16;

/// The same course as straight lines: every row of a spline followed by fifteen between it and the
/// next. Where a spline cannot be laid (rows that do not rise, fewer than three, none at 0, no
/// period) and without one: as it is.
[[nodiscard]] LoadCycle as_lines(const LoadCycle& cycle);

/// Load and speed at one instant.
struct LoadNow {
  double x = 0.0;      ///< [N]
  double y = 0.0;      ///< [N]
  double omega = 0.0;  ///< [rad/s]
};

/// Where the course of load or speed is not smooth; of a spline, what its rows bend it by.
struct LoadCorner {
  double t = 0.0;             ///< within the first period [s]
  bool jump = false;          ///< of load or speed; else only of their slopes
  double slope_change = 0.0;  ///< of load and speed, each over its largest [1/s]
};

/// A stretch of a course.
struct LoadStretch {
  double turned = 0.0;  ///< by the journal in it, whichever way [rad]
  LoadNow last{};       ///< load and speed in its last part
  bool always = false;  ///< it is the whole course, so without an end
};

/// The course of load and speed, at any time; an event begins at 0 with its first row.
class LoadCourse {
 public:
  /// `omega`: speed where the cycle has none [rad/s]. `slow`: magnitude of the speed at which, and
  /// at rest, straight courses of the speed have corners: there friction turns; and in parts of it,
  /// where the speed is low for long [rad/s]; 0: none.
  LoadCourse(const LoadCycle& cycle, double omega, double slow = 0.0);

  /// At time t [s]; before 0 an event stands in its first row. At a jump what holds after it, or
  /// before it.
  [[nodiscard]] LoadNow at(double t, bool before_jump = false) const;
  /// From which the journal comes: an event from its first row, which a second one at its time may
  /// follow.
  [[nodiscard]] LoadNow begins() const { return at(0.0, !repeats()); }
  /// By how much the journal has turned against the shell since the beginning, up to whole turns of
  /// the periods passed: the integral of the speed [rad].
  [[nodiscard]] double turned(double t) const;
  [[nodiscard]] bool repeats() const { return cycle_.repeats(); }
  /// Largest magnitude of the load [N] and of the speed [rad/s], of as_lines.
  [[nodiscard]] double largest_load() const { return largest_load_; }
  [[nodiscard]] double largest_speed() const { return largest_speed_; }
  /// Integral of the load over the first `length()`, by Simpson's rule between corners [N s].
  [[nodiscard]] std::array<double, 2> impulse() const;
  /// The stretch in which the journal turns furthest under more than half of the largest load while
  /// `holds` is true: asked for each of 720 parts (a degree of two turns) with load and speed at
  /// its beginning and its end and its duration [s]. It may go on over the end of a period.
  [[nodiscard]] LoadStretch heavy_stretch(
      const std::function<bool(const LoadNow&, const LoadNow&, double)>& holds) const;
  /// Sorted by time; the end of a period counts as the beginning of the next.
  [[nodiscard]] const std::vector<LoadCorner>& corners() const { return corners_; }

 private:
  struct Splines;
  [[nodiscard]] double within_period(double t) const;
  /// Integral of the speed from the first row to time t within the rows [rad].
  [[nodiscard]] double turned_within(double t) const;
  void find_corners();
  void find_rests(double slow);

  LoadCycle cycle_;
  std::shared_ptr<const Splines> splines_;  ///< none: straight lines
  double largest_load_ = 0.0;
  double largest_speed_ = 0.0;
  double length_ = 0.0;  ///< [s]
  std::vector<LoadCorner> corners_;
};

}  // namespace shellback::bearing
