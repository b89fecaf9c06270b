#pragma once
/// What a rival that has run away advises.

namespace shellback::validation {

/// Cure where a method that is shown as it is known elsewhere, without our help, has run away.
inline constexpr const char* kMethodDiverged =
    "this method has diverged: take model.methods.cavitation = \"active-set\"";

}  // namespace shellback::validation
