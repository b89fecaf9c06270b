#pragma once
/// One turn of the fixed point between film, heat and growth (thermal_loop.hpp): the map, what the
/// walls answer within it, and how its failures are judged.
#include <string>
#include <vector>

#include "coupling/fixed_point.hpp"
#include "coupling/thermal_loop.hpp"

namespace shellback::coupling {

/// One unit of the fixed point's temperatures [K].
inline constexpr double kTemperatureUnit = 10.0;

/// The map of the fixed point, on the states it works on.
class ThermalTurn {
 public:
  ThermalTurn(const BearingModel& model, const LoadTarget& target, const ThermalOptions& options,
              const SolveControl& control, FilmEquilibrium& film, HeatState& heat,
              EquilibriumCost& cost, std::vector<HistoryEntry>& history)
      : model_(model),
        target_(target),
        options_(options),
        control_(control),
        film_(film),
        heat_(heat),
        cost_(cost),
        history_(history),
        newton_before_(cost.newton_iterations) {}

  bool operator()(const std::vector<double>& x, std::vector<double>& g);
  [[nodiscard]] std::vector<double> pack() const;
  /// From here on the growth by asperity heat goes with the film (film_equilibrium.hpp, (3a)).
  void take_contact_growth();
  /// Counts it as thermal growth again.
  void give_contact_growth();
  [[nodiscard]] const Verdict& verdict() const { return verdict_; }
  [[nodiscard]] int turns() const { return turns_; }
  /// True if there is a state to go on from and nobody has asked to stop.
  [[nodiscard]] bool may_go_on() const {
    return std::isfinite(best_.residual) && verdict_.status != Status::interrupted;
  }
  /// True if the last turn points farther than it was let go: however small the change that was
  /// made, near closed gaps, that is no state at rest.
  [[nodiscard]] bool limited() const { return limited_; }
  /// Small steps from the best state on, then accelerated again once they have come near.
  FixedPointEnd creep(const FixedPointOptions& fixed);
  /// Goes on to the value of the last turn, which is nearer to the fixed point.
  void take_last_value();
  /// Solves film, heat and walls of the last turn to the end, so that their balances close.
  void finish(bool converged);

 private:
  [[nodiscard]] EquilibriumOptions film_options() const;
  /// Temperatures and growth for which a film is solved.
  struct Place {
    std::vector<double> T;
    Field growth;
  };
  /// The film at the temperatures and growth that are set; where it is not found at once, by steps
  /// from the place where it was found last.
  Verdict solve_film(const Place& from);
  void limit_change(const std::vector<double>& x, std::vector<double>& g);
  [[nodiscard]] double relaxation(const std::vector<double>& g) const;
  void unpack(const std::vector<double>& x);
  void impose_walls(std::vector<double>& T) const;
  /// The energy equation of the film as it stands.
  thermal::FilmEnergy film_energy();
  /// The solids' answer to the heat of the present film temperatures.
  void warm_the_walls(const thermal::FilmEnergy& energy, Solids::Wanted wanted);
  /// One round of film and walls, the flow staying as it is; the largest change of a wall [K].
  double wall_round(thermal::FilmEnergy& energy);
  /// Rounds, accelerated, until one changes the walls by `enough` [K] or less, at most `rounds`;
  /// the change of the best one, in whose state all is left.
  double balance_walls(thermal::FilmEnergy& energy, double enough, int rounds);
  /// Gives the film the solids' new temperatures; the largest change [K].
  double take_wall_temperatures();
  /// False, with the verdict set, if a temperature or the growth is not a number.
  [[nodiscard]] bool finite();
  /// The same, and if the temperatures run away.
  [[nodiscard]] bool sound();
  /// The temperature of a node is one at which no law of the oil holds.
  [[nodiscard]] Verdict beyond_laws(int node) const;
  [[nodiscard]] Verdict runaway(const std::string& what) const;
  /// What growth has taken of the clearance, in words; empty while it is not most of it.
  [[nodiscard]] std::string seizure() const;
  [[nodiscard]] Verdict friction_runaway(double from, double to) const;
  /// Refuses a film that is colder than everything around it.
  [[nodiscard]] Verdict second_law() const;
  /// A film that fails because heat has thinned its oil is a thermal runaway.
  void name_the_failure();
  void report(const std::vector<double>& x, const std::vector<double>& g);
  [[nodiscard]] bool heated() const { return viscosity_change(model_, film_) > kHeatMatters; }
  /// Of the last turn's film, whichever way the shaft turns [N m].
  [[nodiscard]] double torque() const { return std::abs(friction_.viscous + friction_.asperity); }

  const BearingModel& model_;
  const LoadTarget& target_;
  const ThermalOptions& options_;
  const SolveControl& control_;
  FilmEquilibrium& film_;
  HeatState& heat_;
  EquilibriumCost& cost_;
  std::vector<HistoryEntry>& history_;
  std::vector<double> last_;    ///< value of the last turn
  std::vector<double> turn_T_;  ///< temperatures and growth for which the film was solved last
  Field turn_growth_;
  Friction friction_;
  struct Best {  ///< state after the turn with the least change
    double residual = INFINITY;
    double torque = 0.0;
    FilmEquilibrium film;
    HeatState heat;
    std::vector<double> T;  ///< for which its film was solved
    Field growth;
  } best_;
  Verdict verdict_;
  bool limited_ = false;
  int turns_ = 0;
  int newton_before_ = 0;  ///< iterations that were spent before this solve
};

}  // namespace shellback::coupling
