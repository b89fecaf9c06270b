#pragma once
/// Words for people about how a solve ended: what below is an enumerator with data is told here,
/// and nowhere else.
#include <string>

#include "core/outcome.hpp"

namespace shellback::app {

/// All empty where a solve converged.
struct EndingWords {
  std::string reason;  ///< what went wrong, with numbers
  std::string place;   ///< where in the film: "phi 212.4 deg, z 0.31 mm"
  std::string cure;    ///< what to try
};
[[nodiscard]] EndingWords words_of(const Verdict& verdict);

[[nodiscard]] std::string reason_of(const Verdict& verdict);

/// "phi 212.4 deg, z 0.31 mm", phi from 0 to 360; "z 0.31 mm" of a ring; empty: no place.
[[nodiscard]] std::string words_of(const FilmPlace& place);

}  // namespace shellback::app
