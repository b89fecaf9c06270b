#pragma once
/// What of a load cycle is followed over its time, and how it is called and shown.
///
/// Of a cycle with a crank all instants are told as crank angles [deg], else as times [s].
#include <string>
#include <vector>

#include "app/labels/quantity_label.hpp"
#include "bearing/over_time/cycle.hpp"

namespace shellback::app {

/// One quantity at all instants.
struct CycleSeries {
  std::string name;
  std::string unit;  ///< "1" for a plain number
  std::string long_name;
  std::vector<double> values;
};

/// Crank angles or times.
[[nodiscard]] bool has_crank(const bearing::CycleResult& cycle);

/// `t` as told: crank angle [deg] or time [s].
[[nodiscard]] double shown_instant(const bearing::CycleResult& cycle, double t);

/// "deg" or "s".
[[nodiscard]] std::string told_unit(const bearing::CycleResult& cycle);

/// Whether anything that the cycle tells was measured.
[[nodiscard]] bool is_measured(const bearing::Measured& measured,
                               const bearing::CycleResult& cycle);

/// All instants as told, under the name "angle" or "time".
[[nodiscard]] CycleSeries instants_told(const bearing::CycleResult& cycle);

/// Everything that is followed, SI, angles in radians. What the tier does not know is left out.
[[nodiscard]] std::vector<CycleSeries> followed(const bearing::Case& c,
                                                const bearing::CycleResult& cycle);

/// The other way round, from a file: instants at times t [s] with what was followed there, as long
/// as t; positions as they stand there, over the clearance.
[[nodiscard]] std::vector<bearing::CycleInstant> instants_of(const std::vector<double>& t,
                                                             const std::vector<CycleSeries>& all);

/// "friction torque, mean", "smallest film, h_min": extremes by their own names.
[[nodiscard]] std::string cycle_label(const bearing::CycleQuantity& q);

/// For people; kilowatts and the like after the value itself.
[[nodiscard]] DisplayUnit cycle_unit(const bearing::CycleQuantity& q);

/// A figure of the audit, relative unless it has a unit.
struct AuditFigure {
  std::string name;
  double value = 0.0;
  std::string unit = "1";
};

/// All that the tier knows; not-a-number where nothing was found.
[[nodiscard]] std::vector<AuditFigure> audit_of(const bearing::CycleResult& cycle);

/// "mass 2.1e-15  impulse 3.0e-06 ...".
[[nodiscard]] std::string audit_words(const bearing::CycleResult& cycle);

/// What the numbers of a cycle that did not converge are.
[[nodiscard]] std::string meaning_of_the_rest(const bearing::CycleResult& cycle);

/// What tier auto chose, and whether it is within the tolerance.
[[nodiscard]] std::string choice_words(const bearing::AutoChoice& choice);

/// How the cycle was run: "3 cycles, the last is periodic within 2.1e-05; 512 steps, 12 rejected;
/// period 40 ms"; "an event of 30 ms; 119 steps, 27 rejected".
[[nodiscard]] std::string how_it_ran(const bearing::Case& c, const bearing::CycleResult& cycle);

}  // namespace shellback::app
