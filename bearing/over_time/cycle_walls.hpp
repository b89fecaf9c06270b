#pragma once
/// The bodies behind the walls over a load cycle: their mean temperatures and thermal deformation.
///
/// Shell, housing and shaft take seconds to minutes to warm; over a cycle they are where the mean
/// heat of the cycle holds them. From the mean flux <q> into the walls that a cycle has found with
/// some walls, and what its films answer to their temperature, follow the walls of the next one;
/// the fixed point is the periodic state. Where the skin has warmed in the mean, that belongs to
/// the body and is taken from it. Source: methods 3.5.
#include "bearing/over_time/film_step.hpp"
#include "bearing/solids.hpp"
#include "core/tape.hpp"

namespace shellback::bearing {

/// Mean heat of one cycle, gathered step by step.
class CycleHeat {
 public:
  /// The film with which the cycle begins.
  void begin(const FilmInTime& now);
  /// One accepted step of dt.
  void add(const FilmStep& step, double dt);
  /// Measures how the film of this instant would answer its walls.
  void look_at(const BearingModel& model, const OperatingPoint& point, const FilmEquilibrium& s);
  /// Keeps the film of this instant, which answers all that walls may do (film_answer.hpp).
  void hold(const BearingModel& model, const OperatingPoint& point, const FilmEquilibrium& s);
  [[nodiscard]] const std::vector<thermal::FilmEnergyProblem>& held() const { return held_; }
  /// After a tape, which knows nothing of grids.
  void put_on(const BearingModel& model);

  [[nodiscard]] bool looked() const { return looks_ > 0; }
  [[nodiscard]] double time() const { return time_; }  ///< [s]
  /// Over the cycle [J], [J/m2].
  [[nodiscard]] const HeatFlows& flows() const { return flows_; }
  [[nodiscard]] thermal::WallResponse response() const;  ///< mean [W/(m2 K)]
  /// Mean of the skin over the cycle, as HeatInTime::skin [K].
  [[nodiscard]] std::vector<double> mean_skin() const;
  /// For a tape.
  void members(Tape& tape);

 private:
  HeatFlows flows_;
  std::vector<double> skin_;  ///< integral over time [K s]
  std::vector<double> last_;  ///< at the last instant [K]
  double time_ = 0.0;
  thermal::WallResponse response_;  ///< sum
  int looks_ = 0;
  std::vector<thermal::FilmEnergyProblem> held_;
};

/// Temperatures and thermal deformation of the walls, in units of an iteration: kHeatUnit and
/// clearances.
[[nodiscard]] std::vector<double> packed(const WallMeans& walls, double clearance);
/// Back into walls that have as many of them.
void unpack(const std::vector<double>& x, double clearance, WallMeans& walls);

/// Mean over shell or shaft, whichever is more, of the magnitude by which their temperatures differ
/// [K].
[[nodiscard]] double mean_difference(const FilmGrid& g, const WallMeans& a, const WallMeans& b);

/// What the bodies come to.
struct BodiesAnswer {
  WallMeans walls;
  SolidTemperature solids;
  double left = 0.0;  ///< by which the last round of film and bodies still moved a wall [K]
};

/// Mean heat into shell and shaft of the whole bearing [W].
struct HeatTaken {
  double shell = 0.0;
  double shaft = 0.0;
};

/// What oil does where its walls are warmer: makes less heat, or all that it has made.
enum class OilAnswers { by_thinning, not_at_all };

/// The walls between which the mean heat that a cycle has found with `walls` and what its film
/// answers to their change, (1) of film_answer.hpp, balance to a thousandth of a kelvin: in the
/// periodic state, or at the end of a step in time through which the bodies see that heat, and
/// `more` besides, spread evenly over what meets it [W]. The cycle must have held its films, as
/// those that repeat do.
/// `oil`: over a step in time walls move by little, and what thinning takes growth may give back:
/// where the heat stays, that of a warm-up closes to 0.4 % instead of 1.7 (decision 091).
[[nodiscard]] BodiesAnswer answer_of_bodies(const BearingModel& model, const WallMeans& walls,
                                            const CycleHeat& heat,
                                            const thermal::WallResponse& response, int skin_nodes,
                                            const SolidStep* step = nullptr,
                                            const HeatTaken& more = {},
                                            OilAnswers oil = OilAnswers::by_thinning);

}  // namespace shellback::bearing
