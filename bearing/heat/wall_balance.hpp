#pragma once
/// Film energy and walls at a given flow: what the walls answer within one iteration of heat.
#include <optional>

#include "bearing/film/solution.hpp"
#include "bearing/heat/film_heat.hpp"

namespace shellback::bearing {

/// Works on the temperatures of a solution; its flow stays as it is.
class WallBalance {
 public:
  WallBalance(Solution& s, const HeatStep* step);

  /// The walls' temperatures travel as the film's wall nodes: takes them from there.
  void read_from_film();
  /// The energy equation of the film as it stands, swept; measures the film's response early on.
  void begin(const Friction& friction, int iteration);
  /// Walls in balance but for a part of their first change: they answer the film slowly, and each
  /// of their rounds costs far less than a film. `tolerance` [K].
  void balance_roughly(double tolerance);
  /// Thermal deformation of the walls' temperatures.
  void deform();
  /// The balance of the film with these walls, to round-off if `close`; the last change [K].
  double finish(const Friction& friction, bool close);
  /// Without a step: largest change of a wall if the heat that the film as it stands gives it went
  /// on for ever [K]. The walls stay as they are.
  [[nodiscard]] double change_for_ever(const Friction& friction);
  [[nodiscard]] const SolidStep* solid_step() const { return step_ ? &step_->solids : nullptr; }

 private:
  /// The film's energy equation as it stands, over the step if there is one.
  [[nodiscard]] thermal::FilmEnergyProblem problem(const Friction& friction) const;
  void impose_walls();
  /// Sweeps of the film's energy between its walls until one changes it by less than `enough` [K].
  void settle_film(double enough);
  /// The solids' answer to the heat of the present film temperatures.
  void warm_the_walls(Solids::Wanted wanted);
  /// Gives the film the solids' new temperatures; the largest change [K].
  double take_wall_temperatures();
  /// One round of film and walls; the largest change of a wall [K].
  double round();
  /// Rounds, accelerated, until one changes the walls by `enough` [K] or less, at most `rounds`;
  /// the change of the best one, in whose state all is left.
  double balance(double enough, int rounds);

  Solution& s_;
  const HeatStep* step_;
  std::optional<thermal::FilmEnergy> energy_;
};

}  // namespace shellback::bearing
