#pragma once
/// Which of the other methods go together, and with which physics.
#include <string>

#include "bearing/physics.hpp"

namespace shellback::bearing {

/// Why the methods of the case cannot solve this physics, with a cure; empty if they can:
/// Swift-Stieber films have no heat balance; only the active set has an elastic Newton step.
[[nodiscard]] std::string impossible_methods(const Case& c, const Physics& physics);

/// True if the case asks for the usual methods; others are shown as they are known elsewhere, and
/// know nothing of a path of loads.
[[nodiscard]] bool usual_methods(const Case& c);

/// Throws InputError with the words of impossible_methods, if there are any, and for methods in
/// whose place nothing stands in.
void expect_possible_methods(const Case& c, const Physics& physics);

[[nodiscard]] const char* to_string(CavitationMethod method);
[[nodiscard]] const char* to_string(AcrossFilm method);
[[nodiscard]] const char* to_string(ElasticMethod method);

}  // namespace shellback::bearing
