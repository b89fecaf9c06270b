#pragma once
/// Words of effects and limiters.
#include <string>

#include "bearing/result.hpp"

namespace shellback::app {

[[nodiscard]] const char* name_of(bearing::EffectKind effect);
/// What its indicator number is, and from which value on it matters.
[[nodiscard]] const char* meaning_of(const bearing::Effect& effect);
[[nodiscard]] const char* words_of(bearing::Limiter limiter);

}  // namespace shellback::app
