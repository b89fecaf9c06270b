#pragma once
/// Results as plain text: aligned columns, engineering units, ASCII.
///
/// A state that did not converge is announced above and below its numbers.
#include <iosfwd>

#include "bearing/result.hpp"

namespace shellback::app {

/// One result: quantities (with measured values and differences if the case has any), audit,
/// effects, limiters that acted, warnings, assumptions, cost.
void write_table(std::ostream& out, const bearing::Case& c, const bearing::Result& result);
void write_table(std::ostream& out, const bearing::Result& result);

/// Tiers side by side with the measured values, then the friction split in its order of
/// substitution, the calibrated equivalent temperature, audits, effects, warnings.
void write_comparison_table(std::ostream& out, const bearing::Case& c,
                            const bearing::Comparison& comparison);

}  // namespace shellback::app
