#pragma once
/// The oil of a film, and the journal that it carries, over their cycles, led on from time to time
/// to where the last of them lead (extrapolation.hpp): what a film gathers or loses in a hundred
/// cycles, and a whirl that dies out in as many, it then does in a few.
#include <optional>
#include <vector>

#include "core/extrapolation.hpp"
#include "core/tape.hpp"

namespace shellback::bearing {

/// `oil`: as FilmSteps::lasting_of tells it [kg].
class LedOil {
 public:
  /// No cycle counts yet; the next one begins with this oil.
  void begin(std::vector<double> oil);
  /// A cycle has been passed.
  void passed() { ++plain_; }
  /// No cycle has been passed since oil was led on.
  [[nodiscard]] bool just_led() const { return plain_ == 0; }
  /// The last cycle has ended with this oil; `cycles` in all. Where the last ones lead, if enough
  /// of them count: the next cycle is to begin with it, or with what led_to() is told.
  [[nodiscard]] std::optional<std::vector<double>> after(std::vector<double> oil, int cycles);
  /// The film has taken what after() had it led to, and holds this.
  void led_to(std::vector<double> oil);
  void members(Tape& tape) { tape(counted_, begun_, plain_); }

 private:
  std::vector<Iterate> counted_;  ///< cycles that lead on
  std::vector<double> begun_;     ///< with which the present cycle has begun
  int plain_ = 0;                 ///< cycles since the oil was led on
};

}  // namespace shellback::bearing
