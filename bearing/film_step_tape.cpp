/// What FilmSteps keeps between steps, on a tape (core/tape.hpp).
#include "bearing/film_step.hpp"
#include "bearing/tape_members.hpp"

namespace shellback::bearing {

void FilmSteps::members(Tape& tape, double period, double shortest) {
  bool warm = heat_.has_value();
  tape(model_.scene.speed, model_.scene.storage, vessels_, warm);
  for (fluid::SupplyPatch& patch : model_.scene.supply.patches)
    tape(patch.phi, patch.pressure, patch.fill);
  tape(model_.scene.supply.mouths);
  if (!warm) return;
  if (!heat_) heat_.emplace(model_, period, shortest);
  tape(heat_->walls, growth_.from, growth_.begun, growth_.length, widening_);
}

}  // namespace shellback::bearing
