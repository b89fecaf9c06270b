#pragma once
/// The tests of Sander, Allmaier, Priebsch (InTech 2016), sections 4.1 and 4.4, on our rig.
///
///   1  run-up and run-down of speed, 20 minutes a step, from first principles: bodies in time,
///      cycles between (bearing/over_time/course.hpp), each bearing for itself
///   2  isothermal elastic cycles with three oils, each bearing at the temperature of its shell's
///      back in the run-up: the paper's own recipe (its measured temperatures are not published)
///   3  bands: unknown inputs, each changed alone to the ends of its range
///   4  start and stop with the new and the worn surface
///
/// Points that are not found carry their reason. Torques of the rig by rig_sum.hpp.
#include <vector>

#include "bearing/over_time/course.hpp"
#include "validation/rig/rig_scene.hpp"
#include "validation/rig/rig_sum.hpp"
#include "validation/study_crew.hpp"

namespace shellback::validation {

/// What the study walks through; rig_plan says it for the whole and the quick study.
struct RigPlan {
  std::vector<double> peaks;    ///< [N]
  std::vector<double> rpm;      ///< rising
  std::vector<double> few_rpm;  ///< of the bands
  double hold = 1200.0;         ///< paper: 20 minutes [s]
  double T_start = 353.15;      ///< of the bodies: as the supply [K]
  double warmer = 3.0;          ///< paper: run-down against run-up [K]
  std::array<int, 2> grid{60, 9};
  bool bands = true;
  std::vector<double> start_films{333.15};  ///< of start and stop; the first as taken [K]
};
[[nodiscard]] RigPlan rig_plan(bool quick);

/// Speeds of a run-up and run-down: up, and down again without the highest twice [rpm].
[[nodiscard]] std::vector<double> up_and_down(const std::vector<double>& rpm);

/// Run-up and run-down of both kinds of bearings.
struct RigCourse {
  double peak = 0.0;                    ///< [N]
  const RigUnknown* unknown = nullptr;  ///< null: as taken
  int end = 0;                          ///< of it
  std::vector<double> rpm;              ///< stretch by stretch
  std::array<bearing::CourseRun, 2> run;
  std::array<bool, 2> tried{};  ///< each bearing by a thread of its own
  /// The bearing at the end of stretch k; none if it was not reached.
  [[nodiscard]] const bearing::Instant* at(RigBearing bearing, std::size_t k) const;
  /// The stretch of the highest speed; before it the run-up, behind it the run-down, if any.
  [[nodiscard]] std::size_t highest() const;
  /// The stretch of the run-down at the speed of stretch k of the run-up; none: no run-down.
  [[nodiscard]] std::size_t down_from(std::size_t k) const { return 2 * highest() - k; }
  [[nodiscard]] bool has_run_down() const {
    return rpm.size() == 2 * highest() + 1 && highest() > 0;
  }
  /// Torque of the rig at the end of stretch k [N m]; not-a-number if not reached.
  [[nodiscard]] double torque(std::size_t k) const;
};

/// One bearing over an isothermal cycle.
struct RigCycle {
  Verdict verdict{Status::interrupted, ending::Plain::not_run};
  double T = 0.0;         ///< of the film [K]; not-a-number: no run-up has told it
  double torque = 0.0;    ///< mean [N m]
  double asperity = 0.0;  ///< part of it [N m]
  double p_max = 0.0;     ///< [Pa]
  double h_min = 0.0;     ///< [m]
  double shear =
      0.0;  ///< largest at mid-width, U over the smallest film there; none: surfaces touch [1/s]
};

/// An isothermal point of the whole rig.
struct RigPoint {
  double peak = 0.0;  ///< [N]
  double rpm = 0.0;
  OilModel oil = OilModel::full;
  double warmer = 0.0;                  ///< than the run-up [K]
  const RigUnknown* unknown = nullptr;  ///< null: as taken
  int end = 0;
  std::array<RigCycle, 2> cycle;  ///< test, support
  [[nodiscard]] bool good() const;
  [[nodiscard]] double torque() const;  ///< of the rig [N m]; not-a-number if not good
  [[nodiscard]] std::string reason() const;
};

/// Start and stop with one surface.
struct RigStart {
  bool worn = false;
  double T = 0.0;  ///< of the film [K]
  std::array<Verdict, 2> verdict{{{Status::interrupted, ending::Plain::not_run},
                                  {Status::interrupted, ending::Plain::not_run}}};
  std::array<bearing::CycleResult, 2> cycle;
  std::vector<RigInstant> series;  ///< of the rig; empty if a bearing was not solved
  double breakaway = 0.0;          ///< of the rig [N m]
  double boundary = 0.0;           ///< mu times the sum of load times radius [N m]
  double full_film = 0.0;          ///< when asperities rub no more [s]
};

struct RigStudy {
  RigPlan plan;
  std::vector<RigCourse> courses;
  std::vector<RigPoint> points;
  std::vector<RigStart> starts;
  double specific_area = 0.0;  ///< projected, of the test bearing [m2]
  int threads = 1;
  double wall_s = 0.0;
  bool interrupted = false;
  /// The point as taken; null if there is none of these.
  [[nodiscard]] const RigPoint* point(double peak, double rpm, OilModel oil,
                                      double warmer = 0.0) const;
  /// The course as taken, up and down; null likewise.
  [[nodiscard]] const RigCourse* course(double peak) const;
  /// Pieces of work that were tried and not solved.
  [[nodiscard]] int count_failed() const;
};

/// Pieces of work of the study, each of which keeps a state of its own.
[[nodiscard]] int count_pieces(const RigPlan& plan);

/// Runs the study. Throws InputError where a shipped case does not read.
[[nodiscard]] RigStudy run_rig_study(const StudyOptions& options);
/// The same by a plan of one's own.
[[nodiscard]] RigStudy run_rig_study(const RigPlan& plan, const StudyOptions& options);

}  // namespace shellback::validation
