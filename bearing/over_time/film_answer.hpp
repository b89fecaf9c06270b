#pragma once
/// How the mean heat of a cycle into the walls answers to their temperatures, cell by cell.
///
/// At instants of the cycle the flow of the film is held. Its energy equation, linear then, is
/// solved between walls that are warmer by dT_shell(phi, z) and dT_shaft(z), of its own heat what
/// thinner oil makes less of it:
///   d q = mean over the instants of q(dT_shell, dT_shaft)                     [W/m2]   (1)
///   d heat = -heat |d ln eta/dT| dT        of a node that makes heat          [W]      (2)
/// of supplies (7) of thermal/film_energy.hpp. (2) is what bounds (1): where bodies let little
/// through, walls that wait for a heat that stays would warm until the oil carries all of it off,
/// by heat/(m cp), which may be hundreds of kelvin; with (2) by 1/|d ln eta/dT| at most. Heat falls
/// ever more slowly as oil warms, so that steps from the cold side stay there. How the gap
/// grows, and the journal moves in it, follows in the next cycle. Source: Newton's method with the
/// flow held, textbook.
#include <vector>

#include "bearing/film/equilibrium.hpp"
#include "bearing/solids.hpp"
#include "thermal/film_energy.hpp"

namespace shellback::bearing {

/// The film of an instant, its flow held and without heat of its own but for (2).
[[nodiscard]] thermal::FilmEnergyProblem held_film(const BearingModel& model,
                                                   const OperatingPoint& point,
                                                   const FilmEquilibrium& s);

class FilmAnswer {
 public:
  /// Of these instants, between walls as they were; `thins`: with (2). `model` must outlive it.
  FilmAnswer(const BearingModel& model, std::vector<thermal::FilmEnergyProblem> instants,
             bool thins = true);
  /// Adds (1) to the heat that the walls had, where shell (cells) and shaft (axial cells) are so
  /// much warmer [K]. Goes on from the film temperatures of the last call by a few sweeps: a round
  /// of an iteration between film and walls.
  void add_to(WallFlux& q, const Field& shell, const std::vector<double>& shaft);

 private:
  struct Instant {
    thermal::FilmEnergy film;
    double cold = 0.0;      ///< the temperature that stands for no change [K]
    std::vector<double> T;  ///< of the film's nodes [K]
  };
  const BearingModel& model_;
  std::vector<Instant> instants_;
};

}  // namespace shellback::bearing
