#pragma once
/// The second law for a film: it is no colder than all that is given around it.
#include "coupling/bearing.hpp"

namespace shellback::coupling {

/// Coldest temperature given: supplies, surroundings of the shell and, if it has an overhang, of
/// the shaft [K]. For models with resolved heat.
[[nodiscard]] double coldest_around(const BearingModel& model);

}  // namespace shellback::coupling
