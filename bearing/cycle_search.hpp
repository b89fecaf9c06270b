#pragma once
/// The periodic state of a bearing under a load cycle, on one grid.
///
///   one temperature   cycle after cycle until two agree; what the film gathers or loses over many
///                     of them is led on to where it leads (extrapolation.hpp)
///   film energy       the fixed point of the walls: one cycle with walls that stay as they are ->
///                     its mean heat -> the walls of the next (cycle_walls.hpp), Anderson
///                     acceleration (KINSOL); then cycles between the last walls until two agree,
///                     the oil led on. Walls that oil has moved meanwhile, or that did not settle
///                     while it moved, settle again: until both hold
/// A single event is passed once.
#include <memory>
#include <optional>

#include "bearing/cycle.hpp"
#include "bearing/cycle_endings.hpp"
#include "bearing/cycle_record.hpp"
#include "bearing/cycle_steps.hpp"
#include "bearing/cycle_walls.hpp"
#include "bearing/extrapolation.hpp"

namespace shellback::bearing {

/// Steps of a period at least: 8 degrees of two turns. From a steady place no pulse is passed over.
inline constexpr double kFewestSteps = 90.0;
/// Error of a step in time, over model.tolerance [-] (decision 024).
inline constexpr double kOfTolerance = 0.1;
/// Cycles within which the film answers its walls: then its response hardly changes any more.
inline constexpr int kCyclesOfAnswer = 2;

class CycleSearch {
 public:
  /// On the grid of the case. `control` must outlive the search; refers to itself, is not copied.
  CycleSearch(const Case& c, Tier tier, const SolveControl& control);
  /// The same with other physics than the tier's.
  /// `solids`: operators of a former search of the same geometry.
  CycleSearch(const Case& c, Tier tier, const Physics& physics, const SolveControl& control,
              std::shared_ptr<const Solids> solids = nullptr);
  CycleSearch(const CycleSearch&) = delete;
  CycleSearch& operator=(const CycleSearch&) = delete;

  /// From rest in a film of one temperature [K]; an event from the steady state of its first row,
  /// if there is one.
  void begin(double T);
  /// From what a search on a coarser grid has found.
  void begin(const CycleSearch& coarser);
  /// As begin(T), between walls that are held from here on, whatever heat enters them.
  void begin_between(const WallMeans& walls, double T);
  /// From what a search of the same bearing with a shell of another shape has found, on the same
  /// grid, in the steps in time that it took. False, with the verdict, if the gap is closed.
  bool begin_reshaped(const CycleSearch& other);
  /// From what a tape has kept in the middle of a cycle; search() goes on from there.
  void begin(Tape& tape);
  /// For a tape: what a search on a finer grid takes from one that has ended.
  void found(Tape& tape);
  /// For a tape: all of a search that has ended, or one that has just been made in its place.
  void ended(Tape& tape);
  /// From where it stands, in a film of another temperature [K]; an event begins anew.
  void set_temperature(double T);

  /// A search that is part of an iteration: what the iteration's function came to the next time in
  /// a run that is gone on with; none: it has to be worked out, and told to `remember`.
  [[nodiscard]] std::optional<std::vector<double>> remembered();
  void remember(std::vector<double> answer);
  /// In the middle of a cycle that a tape has brought back.
  [[nodiscard]] bool brought_back() const { return brought_back_; }

  /// Searches; `rough`: only so far as a finer grid needs to begin.
  const Verdict& search(bool rough);
  /// The periodic state of a shape that has hardly changed since begin_reshaped(): cycles until the
  /// film ends one as it began it, within the error of a step in time, and the walls agree with its
  /// heat within a tenth of a kelvin.
  const Verdict& follow();
  [[nodiscard]] const Verdict& verdict() const { return r_.verdict; }
  /// The cycle that was passed last.
  [[nodiscard]] const CycleRecord& told() const { return told_; }
  [[nodiscard]] const EquilibriumCost& cost() const { return cost_; }
  /// One cycle with walls that stay as they are; false, with the verdict, if it does not end. What
  /// the skin has warmed in the mean is then taken from it.
  bool pass_between(const WallMeans& walls);
  /// Mean heat of the last cycle, and the film's response to its walls.
  [[nodiscard]] const CycleHeat& heat() const { return heat_; }
  [[nodiscard]] const thermal::WallResponse& response() const { return *response_; }
  [[nodiscard]] const FilmSteps& film() const { return film_; }
  [[nodiscard]] int cycles() const { return r_.cycles; }
  [[nodiscard]] CycleResult result() const;

 private:
  enum class Phase { orbit, walls, closing };
  /// The cycle that is being passed.
  struct Passing {
    CycleRecord record;
    bool look = false;       ///< at the film's response to its walls
    double next_look = 0.0;  ///< [s]
    void members(Tape& tape) { tape(record, look, next_look); }
  };

  void begin_pass();
  /// One accepted step of the cycle that is being passed.
  void add(const FilmStep& step, double dt);
  /// Keeps the state, if it is time, or in any case.
  void keep(bool in_any_case);
  void members(Tape& tape);
  /// The film alone, of one temperature [K].
  void begin_film(double T);
  /// The oil of a steady film is not quite that of one that carries its oil in time
  /// (fluid/fill_front.hpp): before an event its first load stands while the oil goes round twice.
  void carry_oil_round();
  /// Passes the period once more; false where the search has ended.
  bool pass();
  /// Cycles until two agree within `within`, between walls that stay as they are.
  void until_closed(double within);
  /// From time to time, the oil to which the last cycles lead.
  void lead_oil_on();
  /// The walls' fixed point, a cycle a turn; false if they still change, or with the verdict.
  bool settle_walls(bool rough, int turns);
  /// Walls and oil by turns, until both hold; `rough`: walls.
  void settle_walls_and_oil(bool rough);
  /// One turn of it: walls and their thermal deformation in units -> what they come to.
  bool answer_walls(const std::vector<double>& x, std::vector<double>& g);
  [[nodiscard]] Verdict walls_unsettled() const;
  /// By how much the last cycle would change a wall, or its growth in units [K].
  [[nodiscard]] double change_of_walls();
  /// What the bodies make of the heat of the last cycle.
  [[nodiscard]] BodiesAnswer bodies_answer() const;
  [[nodiscard]] std::vector<double> packed(const WallMeans& w) const;
  void unpack(const std::vector<double>& x, WallMeans& w) const;
  /// The film between `walls_`; false, with the verdict, if they leave it no room.
  bool put_walls();
  /// The steady state of an event's first row in a resolved tier; false if none is found.
  bool begin_warm();

  Case c_;
  Tier tier_;
  const SolveControl& control_;
  double length_;
  LoadCourse course_;
  StepOptions steps_;
  FilmSteps film_;
  CycleSteps periods_;
  EquilibriumCost cost_;
  FilmInTime now_;
  CycleRecord told_;
  Closure closure_;
  CycleHeat heat_;
  std::optional<thermal::WallResponse> response_;  ///< of the film to its walls
  int looked_ = 0;                                 ///< cycles that have measured it
  std::optional<WallMeans> walls_;
  std::optional<WallMeans> answered_;  ///< what the cycle's heat makes of them
  bool held_ = false;
  double wall_change_ = NAN;  ///< of the last turn [K]
  bool from_rest_ = true;
  bool begun_cold_ = false;  ///< an event, its walls at the supply's temperature
  Phase phase_ = Phase::orbit;
  int most_ = 0;                     ///< cycles, of search()
  std::vector<Iterate> oil_;         ///< of the cycles that lead on
  std::vector<double> oil_begun_;    ///< with which the present cycle has begun
  int plain_ = 0;                    ///< cycles since the oil was led on
  bool settled_ = false;             ///< the walls, when they were looked at last
  double round_change_ = INFINITY;   ///< of the walls, as a round of walls and oil has left it [K]
  int stalled_ = 0;                  ///< rounds since it has fallen
  std::vector<double> walls_begun_;  ///< of the walls' fixed point, packed
  std::vector<std::vector<double>> answers_;  ///< of the iteration around the cycles
  std::size_t given_ = 0;                     ///< of them, in this run
  bool brought_back_ = false;
  std::optional<Passing> passing_;
  CycleResult r_;  ///< verdict and counts, as they come
};

/// The search that solve_cycle makes, ended with its verdict; not for tier lumped. `control` must
/// outlive it. `cost`: that of all grids.
[[nodiscard]] std::unique_ptr<CycleSearch> search_cycle(const Case& c, Tier tier,
                                                        const SolveControl& control, Cost& cost);

}  // namespace shellback::bearing
