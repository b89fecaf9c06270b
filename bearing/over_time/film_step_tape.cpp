/// What FilmSteps keeps between steps, on a tape (core/tape.hpp).
#include "bearing/over_time/film_step.hpp"
#include "bearing/over_time/tape_members.hpp"

namespace shellback::bearing {

void FilmSteps::members(Tape& tape, double period, double shortest) {
  bool warm = heat_.has_value();
  tape(point_.scene.speed, point_.scene.storage, vessels_, warm);
  for (fluid::SupplyPatch& patch : point_.scene.supply.patches)
    tape(patch.phi, patch.pressure, patch.fill);
  tape(point_.scene.supply.mouths);
  if (!warm) return;
  if (!heat_) heat_.emplace(model_, period, shortest);
  tape(heat_->walls, growth_.from, growth_.begun, growth_.length, widening_);
}

}  // namespace shellback::bearing
