#pragma once
/// One step in time of film, journal and elastic surfaces.
///
/// Oil M per cell, journal position q and velocity v follow
///   dM/dt = -outflow/A,   dq/dt = v,   m dv/dt = F + W                               (1)
/// by a diagonally implicit Runge-Kutta method. Each of its stages is the residual of
/// bearing/film/equilibrium.hpp over a_ii dt, begun from
///   M* = M_n + dt sum_j<i a_ij k_j,   likewise q* and v*                             (2)
/// with k the slopes of the stages before. k of M is the outflow itself, and M is carried as what
/// flowed in and out, M_n+1 = M_n + dt sum b_i k_i: oil is conserved to round-off, however loosely
/// a stage is solved. Without mass the journal's position follows from the balance of forces in
/// every stage.
/// TR-BDF2 (three stages, the first explicit) where the load is smooth, SDIRK2 where no slope at
/// the step's beginning is known: at the start and behind a jump of load or speed. Both are of
/// second order and stiffly accurate. The last stage of SDIRK2 has a pressure that swings from step
/// to step where film forms again, by a tenth and more; told is the mean over its step,
///   p = sum_i b_i p_i,                                                               (3)
/// and with TR-BDF2, which swings by a few per cent, the last stage's. Where film temperatures are
/// solved, heat takes its stage behind the film's (heat_in_time.hpp). Source: textbook (Hosea and
/// Shampine's form of TR-BDF2; Alexander's SDIRK2); methods 4.
#include "bearing/film/equilibrium.hpp"
#include "bearing/film/vessels.hpp"
#include "bearing/load_cycle.hpp"
#include "bearing/over_time/drillings.hpp"
#include "bearing/over_time/film_stage.hpp"
#include "bearing/over_time/film_trend.hpp"
#include "bearing/over_time/heat_in_time.hpp"
#include "bearing/over_time/orbit_growth.hpp"
#include "core/tape.hpp"

namespace shellback::bearing {

/// Where the bearing stands in time: the unknowns and what carries over from step to step.
struct FilmInTime {
  double t = 0.0;  ///< [s]
  FilmEquilibrium film;
  Field oil;                             ///< M as carried [kg/m2]
  std::array<double, 2> velocity{};      ///< of the journal [m/s]
  std::array<double, 2> acceleration{};  ///< [m/s2]
  Field oil_slope;                       ///< dM/dt at t; empty: not known, the step begins anew
  fluid::OilFlows flows;                 ///< at t [kg/s]
  std::vector<char> full_before;         ///< cells full when the step that led here began
  HeatInTime heat;                       ///< tiers with film temperatures
  FilmTrend trend;                       ///< over the last stage
  double thermal_deformation = 0.0;      ///< mean thermal widening of its gap [m]
  std::vector<double> vessels;           ///< E of each vessel as carried (vessels.hpp) [kg]
  LayerInTime layer;                     ///< of an elasto-plastic layer
};

/// Of the step that begins there.
[[nodiscard]] inline Tableau method_at(const FilmInTime& now) {
  return now.oil_slope.empty() ? sdirk2() : tr_bdf2();
}

/// What a step found.
struct FilmStep {
  Verdict verdict;
  FilmInTime after;     ///< good: the state at its end
  Field p;              ///< film pressure told of its end (3) [Pa]
  double error = 0.0;   ///< estimated, of the loaded film over its height (film_motion.hpp) [-]
  double supply = 0.0;  ///< oil fed in over the step, into pockets and film [kg]
  std::vector<double> patch;  ///< out of every supply into the film alone [kg]
  double side = 0.0;          ///< and lost at the sides, net [kg]
  double side_inflow = 0.0;   ///< come in there [kg]
  double layer_loss = 0.0;    ///< turned into heat in an elasto-plastic layer, solved part [J]
  double line = 0.0;          ///< come from the supplies' lines: the same and into vessels [kg]
  std::array<double, 2> impulse{};  ///< of the film on the journal [N s]
  double off_balance = 0.0;         ///< largest residual of the force balance [N]
  double off_content = 0.0;         ///< oil held at its end beside that carried, solved part [kg]
  HeatFlows heat;                   ///< over the step [J]; tiers with film temperatures
};

/// The fill ratios of a steady film as a film in time carries them: theta of a cavitated cell is
/// its mean there, not that of its downstream face (fluid/fill_front.hpp).
[[nodiscard]] fluid::FilmState filled_as_carried(const BearingModel& model,
                                                 const OperatingPoint& point,
                                                 const fluid::FilmState& steady);

/// Part of the error that a step may have to which flows and forces of its film are solved: in time
/// a film need not be known better [-].
inline constexpr double kFilmPart = 1e-2;

/// And to which its gap and its viscosity are, of which that error is one: docs/decisions/063 [-].
inline constexpr double kShapePart = 0.1;

/// Residual over the largest flow of the film from which a stage takes its fronts of oil, and how
/// many times less well its load, shape and viscosity need be known than the stage's [-]: one
/// iteration from a film carried on (docs/decisions/093).
inline constexpr double kFilmOfFronts = 1.0;
inline constexpr double kLooser = 100.0;

/// The bearing in time, on one grid, under a course of load and speed.
class FilmSteps {
 public:
  /// `mass` of the journal [kg], 0: none. `options`: of a stage's film. The film from
  /// which it takes its fronts of oil is solved to kFilmOfFronts and kLooser times the rest.
  FilmSteps(const BearingModel& model, const LoadCourse& course, double mass,
            const EquilibriumOptions& options);

  /// At rest in the middle of the clearance, in a full film of one temperature [K].
  [[nodiscard]] FilmInTime at_rest(double T);
  /// Solves film temperatures from here on, with these walls; the heat of `now` begins anew, at
  /// the temperatures of its film. The first walls stand as they are, oil keeps its fill ratios
  /// where the gap has grown. From the walls of one cycle to those of the next the gap grows over
  /// the first tenth of the period and displaces its oil: a gap that jumped would ask pressure and
  /// elastic surfaces for a jump that no short step makes smaller (docs/decisions/039). False if
  /// the walls would grow together.
  [[nodiscard]] bool set_walls(WallMeans walls, double period, double shortest, FilmInTime& now);
  /// The walls are as warm as their mean, whatever has entered their skins.
  static void hold_walls(FilmInTime& now);
  /// The heat that flows now is what belongs to the walls' temperatures: they are at rest.
  void rest_walls(FilmInTime& now);
  /// `now` of the same bearing with a shell of another shape: oil keeps its fill ratios where the
  /// gap has grown. False if the gap is closed.
  [[nodiscard]] bool reshape(FilmInTime& now);
  /// The oil of every cell and vessel [kg].
  [[nodiscard]] std::vector<double> oil_of(const FilmInTime& now) const;
  /// What may come to rest only over many periods: that oil, and, where it has a mass, place and
  /// velocity of the journal, as the oil that the film would gain or lose by them [kg].
  [[nodiscard]] std::vector<double> lasting_of(const FilmInTime& now) const;
  /// Puts it back: the journal where it is told, oil as put_oil() does. False if the gap is closed
  /// there.
  [[nodiscard]] bool put_lasting(const std::vector<double>& lasting, FilmInTime& now);
  /// Place and velocity of the journal as they stand there [kg]. Put back, oil keeps its fill
  /// ratios where the gap has changed; false if it is closed.
  [[nodiscard]] JournalState journal_of(const FilmInTime& now) const;
  [[nodiscard]] bool put_journal(const JournalState& journal, FilmInTime& now);
  /// Oil by which the film changes if its journal moves by a metre [kg/m], as the root of the sum
  /// over cells, each of which sees it; velocities count as places after a radian of the period.
  [[nodiscard]] double unit_of_place() const;
  [[nodiscard]] double unit_of_velocity() const;
  /// Puts the oil that it tells first into cavitated cells, as much as they hold, and into vessels;
  /// full cells keep theirs, and the slope dM/dt stays that of before, less by the share of what is
  /// taken out: the next step errs by its share of what was put in, which ends as that does.
  void put_oil(const std::vector<double>& oil, FilmInTime& now) const;
  /// The steady state under load and speed at t = 0, in oil of one temperature, between surfaces
  /// that heat has `deformed` [m]; none if it is not found.
  [[nodiscard]] std::optional<FilmInTime> steady(double T, const Field& deformed,
                                                 EquilibriumCost& cost,
                                                 const std::atomic<bool>* stop);
  /// One step of dt from `now`.
  [[nodiscard]] FilmStep take(double dt, const FilmInTime& now, EquilibriumCost& cost,
                              const std::atomic<bool>* stop);
  [[nodiscard]] const BearingModel& model() const { return model_; }
  /// As it was in the last stage: its speed, load, supplies and step.
  [[nodiscard]] const OperatingPoint& point() const { return point_; }
  /// Of the journal [kg].
  [[nodiscard]] double mass() const { return mass_; }
  [[nodiscard]] const Vessels& vessels() const { return vessels_; }
  [[nodiscard]] const Drillings& drillings() const { return drillings_; }
  /// Vessels and supplies, which a step moves: to put them back if it is not to count.
  struct Supplies {
    Vessels vessels;
    std::vector<fluid::SupplyPatch> patches;
    std::vector<fluid::Mouth> mouths;
  };
  [[nodiscard]] Supplies supplies() const;
  void put_back(const Supplies& before);
  /// None: one temperature for the whole film.
  [[nodiscard]] const HeatSteps* heat() const { return heat_ ? &*heat_ : nullptr; }
  /// For a tape: speed and storage of the last stage, and the walls of film temperatures with the
  /// skin of set_walls.
  void members(Tape& tape, double period, double shortest);

 private:
  /// Heat held by the oil as it stands; the skin stays.
  void renew_heat(FilmInTime& now) const;
  /// Solves stage i; `stages` holds those before.
  [[nodiscard]] Verdict solve_stage(int i, double dt, const std::vector<FilmStage>& stages,
                                    const FilmInTime& now, FilmEquilibrium& film, FilmStage& found,
                                    EquilibriumCost& cost, const std::atomic<bool>* stop);
  /// Temperatures of the film and growth of the walls in stage i, carried on in a straight line
  /// from the stages and steps before.
  void expect_temperatures(int i, double dt, const std::vector<FilmStage>& stages,
                           const FilmInTime& now, FilmEquilibrium& film);
  /// Heat in stage i, whose film is solved.
  [[nodiscard]] Verdict solve_heat(int i, double dt, const std::vector<FilmStage>& stages,
                                   const FilmInTime& now, const FilmEquilibrium& film,
                                   FilmStage& found) const;
  /// Heat at the end of the step, whose film is `film`, and what flowed in it.
  void end_heat(double dt, const FilmInTime& now, const FilmEquilibrium& film,
                std::vector<FilmStage>& stages, FilmStep& step) const;
  /// What the supplies of a stage begin from.
  struct SuppliesStar {
    double own = 0.0;             ///< length of the stage [s]
    std::vector<double> vessels;  ///< E* of vessels.hpp [kg]
    std::vector<double> pockets;  ///< M* of pockets.hpp [kg]
  };
  [[nodiscard]] SuppliesStar supplies_star(int i, double dt, const std::vector<FilmStage>& stages,
                                           const FilmInTime& now) const;
  /// Part of the film's residual that may stay in a stage longer than its largest flow takes to
  /// fill the gap: what it leaves open of the oil grows with the stage [-].
  [[nodiscard]] double filled_in(double own, const FilmEquilibrium& film) const;
  /// The film of stage i and what its vessels hold.
  [[nodiscard]] Verdict solve_film(const SuppliesStar& star, const EquilibriumOptions& options,
                                   FilmEquilibrium& film, EquilibriumCost& cost,
                                   const std::atomic<bool>* stop);
  /// Fronts of oil as this film has them; empty with FillTransport::upwind.
  [[nodiscard]] Field fronts_of(const FilmEquilibrium& film) const;
  /// With FillTransport::van_leer the stage is solved loosely with the fronts of oil that it begins
  /// with, and then with its own (fluid/fill_front.hpp).
  [[nodiscard]] Verdict solve_film_and_fronts(const SuppliesStar& star, FilmEquilibrium& film,
                                              EquilibriumCost& cost, const std::atomic<bool>* stop);
  /// Mouths of drillings as they stand at time t [s], by this film.
  void open_mouths(double t, FilmEquilibrium& film);
  /// The film carried on along its trend for `ahead` [s]: cells that it fills are full, cells whose
  /// pressure it takes below that of cavitation are not.
  void carry_on(const FilmTrend& trend, double ahead, FilmEquilibrium& film) const;
  /// Adds what flowed in the stages to a step of dt.
  void sum_up(const Tableau& by, double dt, const std::vector<FilmStage>& stages,
              FilmStep& step) const;
  /// Estimated error of the step: of the loaded film, the vessels' oil and viscosity [-].
  [[nodiscard]] double error_of(const FilmInTime& now, const FilmEquilibrium& end,
                                const std::vector<FilmStage>& stages, double dt) const;
  [[nodiscard]] double error_of_film(const FilmInTime& now, const FilmEquilibrium& end,
                                     const std::vector<FilmStage>& stages, double dt) const;

  /// The thermal widening of the gap at time t [s] with these skins.
  [[nodiscard]] Field widening_at(double t, const std::vector<double>& skin) const;
  /// Work of walls that grow on oil and asperities from `now` to `film` at time t with the skins
  /// `skin`, whole bearing [J].
  [[nodiscard]] double work_of_growth(const FilmInTime& now, double t, const FilmEquilibrium& film,
                                      const std::vector<double>& skin) const;
  /// True if these walls leave the journal a place.
  [[nodiscard]] bool leave_room(const WallMeans& walls, const FilmInTime& now) const;

  const BearingModel model_;
  const LoadCourse& course_;
  double mass_;
  EquilibriumOptions options_;
  OperatingPoint point_;
  std::optional<HeatSteps> heat_;
  Drillings drillings_;
  Vessels vessels_;
  std::vector<double> vessels_begun_;  ///< E at the beginning of the step [kg]
  /// How the gap comes from the walls of one cycle to those of the next.
  struct Growth {
    Field from;           ///< thermal widening before; empty: none [m]
    double begun = 0.0;   ///< [s]
    double length = 0.0;  ///< [s]; 0: done
  };
  Growth growth_;
  Field widening_;       ///< thermal, of the gap, now; empty: none [m]
  KrylovMemory memory_;  ///< of the step's films
};

}  // namespace shellback::bearing
