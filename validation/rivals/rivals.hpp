#pragma once
/// The rivals of the solver: what other programs do, built on its own film, oil and solids, to be
/// compared with. A case that names them (model.methods) is given what solves it by them.
#include "bearing/case.hpp"

namespace shellback::validation {

/// What stands in for Newton's method where these names ask for another; none if they do not.
[[nodiscard]] bearing::EquilibriumMethod rival_for(const bearing::Methods& methods);

/// The case with it put in.
[[nodiscard]] bearing::Case with_rivals(bearing::Case c);

}  // namespace shellback::validation
