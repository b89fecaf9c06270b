#pragma once
/// Ends a solve that creeps.
#include <atomic>

#include "coupling/control.hpp"

namespace shellback::fidelity {

/// Control of a solve that is stopped, as if by the user, after so many turns of film and heat.
/// What the solve tells and what stops the outer one are handed on. Not copied: the solve points to
/// it.
class TurnLimit {
 public:
  TurnLimit(const coupling::SolveControl& outer, int most) {
    control_.stop = &stop_;
    control_.progress = [this, &outer, most](const coupling::Progress& p) {
      if (outer.progress) outer.progress(p);
      const bool asked = outer.stop != nullptr && outer.stop->load();
      if (asked || ++turns_ > most) stop_ = true;
    };
  }
  TurnLimit(const TurnLimit&) = delete;
  TurnLimit& operator=(const TurnLimit&) = delete;
  [[nodiscard]] const coupling::SolveControl& control() const { return control_; }

 private:
  std::atomic<bool> stop_{false};
  int turns_ = 0;
  coupling::SolveControl control_;
};

}  // namespace shellback::fidelity
