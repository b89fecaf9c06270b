#pragma once
/// A sweep on the screen.
#include <iosfwd>

#include "app/study/sweep.hpp"

namespace shellback::app {

/// The main quantities of every point in engineering units, curve after curve; then failures with
/// their reasons, the largest imbalances, warnings and cost. `subject` gives title and bearing.
void write_sweep_table(std::ostream& out, const bearing::Case& subject, const study::Sweep& sweep);

}  // namespace shellback::app
