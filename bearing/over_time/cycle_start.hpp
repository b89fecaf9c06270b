#pragma once
/// What a search for a periodic state with film temperatures has found, for another of the same
/// bearing to begin from: on other cells, or in other steps in time.
#include "bearing/over_time/film_step.hpp"
#include "core/tape.hpp"
#include "thermal/film_energy.hpp"

namespace shellback::bearing {

struct CycleStart {
  BearingModel model;  ///< on whose cells it stands
  FilmInTime now;      ///< at the beginning of a cycle
  WallMeans walls;
  thermal::WallResponse response;  ///< of the film to them
  int measured = 0;                ///< passes that have measured it
  bool led = false;                ///< anything, on the way there

  /// All but the model, which is made anew from its case.
  void members(Tape& tape);
};

}  // namespace shellback::bearing
