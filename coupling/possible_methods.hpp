#pragma once
/// Which of the other methods go together, and with which physics.
#include "coupling/bearing.hpp"

namespace shellback::coupling {

/// Throws InputError, with a cure, for methods of the case that cannot solve this physics:
/// Swift-Stieber films have no heat balance; only the active set has an elastic Newton step.
void expect_possible_methods(const Case& c, const Physics& physics);

[[nodiscard]] const char* to_string(CavitationMethod method);
[[nodiscard]] const char* to_string(AcrossFilm method);
[[nodiscard]] const char* to_string(ElasticMethod method);

}  // namespace shellback::coupling
