#pragma once
/// A course of speeds as a table, as JSON and as a picture.
#include <ostream>
#include <string>
#include <vector>

#include "fidelity/march_bars.hpp"

namespace shellback::app {

/// One line a stretch: speed, time at its end, and what the bearing is then.
void write_course_table(std::ostream& out, const std::vector<bearing::Stretch>& stretches,
                        const bearing::CourseRun& run, const fidelity::MarchBars& bars);

/// status, [reason, place, cure], title, tier, grid, `start` (temperature of the bodies),
/// `stretches`: speed, duration, passed, and where it was, every quantity at its end; `time` and
/// every quantity over time as {unit, values, error_grid,
/// error_time}, `audit` {energy at the ends}, warnings,
/// assumptions, provenance, `changes` and `case` (of the first stretch).
[[nodiscard]] std::string course_json(const std::vector<bearing::Stretch>& stretches,
                                      const bearing::WarmUpOptions& options,
                                      const bearing::CourseRun& run,
                                      const fidelity::MarchBars& bars);

/// What is followed over time (write_curves.hpp), with the speed and the number of the stretch from
/// which an instant is told; the end of one is the last of its instants.
[[nodiscard]] std::string course_csv(const std::vector<bearing::Stretch>& stretches,
                                     const bearing::CourseRun& run,
                                     const fidelity::MarchBars& bars);

/// Torque, temperatures and smallest film over time, and torque over speed (1200 x 780).
[[nodiscard]] std::string course_svg(const std::vector<bearing::Stretch>& stretches,
                                     const bearing::CourseRun& run,
                                     const fidelity::MarchBars& bars);

}  // namespace shellback::app
