#pragma once
/// The periodic state of a bearing under a load cycle, on one grid.
///
///   one temperature   cycle after cycle until two agree; what the film gathers or loses over many
///                     of them is led on to where it leads (led_oil.hpp)
///   film energy       the fixed point of the walls: one cycle with walls that stay as they are ->
///                     its mean heat and what its films answer -> the walls of the next
///                     (cycle_walls.hpp), Anderson acceleration (KINSOL); then cycles between the
///                     last walls until two agree, the oil led on. Walls that oil has moved
///                     meanwhile, or that did not settle while it moved, settle again: until both
///                     hold
/// A single event is passed once.
#include <memory>
#include <optional>

#include "bearing/over_time/cycle_endings.hpp"
#include "bearing/over_time/cycle_passes.hpp"
#include "bearing/over_time/led_oil.hpp"
#include "core/replay.hpp"

namespace shellback::bearing {

class CycleSearch {
 public:
  /// On the grid of the case. `control` must outlive the search, which is not copied.
  CycleSearch(const Case& c, Tier tier, const SolveControl& control);
  /// The same with other physics than the tier's.
  /// `solids`: operators of a former search of the same geometry.
  CycleSearch(const Case& c, Tier tier, const Physics& physics, const SolveControl& control,
              std::shared_ptr<const Solids> solids = nullptr);

  /// From rest in a film of one temperature [K]; an event from the steady state of its first row,
  /// if there is one.
  void begin(double T) { passes_.begin(T); }
  /// From what another search of the bearing has found.
  void begin(const CycleStart& from);
  /// As begin(T), between walls that are held from here on, whatever heat enters them.
  void begin_between(const WallMeans& walls, double T);
  /// From what a search of the same bearing with a shell of another shape has found, on the same
  /// grid, in the steps in time that it took. False, with the verdict, if the gap is closed.
  bool begin_reshaped(const CycleSearch& other);
  /// From what a tape has kept in the middle of a cycle; search() goes on from there.
  void begin(Tape& tape);
  /// For a tape: all of a search that has ended, or one that has just been made in its place.
  void ended(Tape& tape);
  /// From where it stands, in a film of another temperature [K]; an event begins anew.
  void set_temperature(double T);

  /// Of a search that is part of an iteration: what the iteration's function came to, in a run that
  /// is gone on with.
  [[nodiscard]] Replay<std::vector<double>>& answers() { return answers_; }
  /// In the middle of a cycle that a tape has brought back.
  [[nodiscard]] bool brought_back() const { return passes_.brought_back(); }

  /// Searches; `rough`: only so far as a finer grid needs to begin.
  const Verdict& search(bool rough);
  /// Of a periodic state that was found: cycles that were led on may lead to an orbit that no
  /// journal keeps to, so what a displaced one does in some cycles more (orbit_growth.hpp). It
  /// looks at no other grid: an unstable orbit ends as iteration_limit.
  const Verdict& judge_orbit();
  /// The periodic state of a shape that has hardly changed since begin_reshaped(): cycles until the
  /// film ends one as it began it, within the error of a step in time, and the walls agree with its
  /// heat within a tenth of a kelvin.
  const Verdict& follow();
  [[nodiscard]] const Verdict& verdict() const;
  /// The cycle that was passed last.
  [[nodiscard]] const CycleRecord& told() const { return passes_.told(); }
  [[nodiscard]] const EquilibriumCost& cost() const { return passes_.cost(); }
  [[nodiscard]] const FilmSteps& film() const { return passes_.film(); }
  [[nodiscard]] int cycles() const { return passes_.passed(); }
  [[nodiscard]] CycleResult result() const;
  /// What it has found, for another search of the bearing; with film temperatures.
  [[nodiscard]] CycleStart start() const;

 private:
  enum class Phase { orbit, walls, closing };

  /// A journal displaced from its orbit.
  struct Displaced {
    Tape::Content from;              ///< passes on the orbit
    std::vector<JournalState> ends;  ///< of cycles since
  };

  /// One more pass, between other walls if there are any; false where the search has ended.
  bool pass(const WallMeans* between = nullptr);
  /// Cycles until one is closed, between walls that stay as they are.
  void until_closed(double within);
  /// Within `within` of the periodic state, as the last differences tell, the last one as small or
  /// the film at the end of the last cycle as near to that of its beginning: changes that hardly
  /// fall from cycle to cycle show in either, however fast others do.
  [[nodiscard]] bool closed(double within);
  void come_back();
  /// From time to time, the oil to which the last cycles lead.
  void lead_oil_on();
  /// Cycles have not come farther from a mark, `at` so many of them, than half of what their last
  /// difference would have added up to: they differ by chance, and do not drift.
  [[nodiscard]] bool stayed_near(const std::vector<double>& mark, int at) const;
  /// That of the mark.
  [[nodiscard]] bool by_chance() const;
  /// Cycles that go on differing by chance, by more than kClosed, have twice been found where they
  /// were so many cycles before that they leave no more than the error of a step: fronts of oil
  /// need not repeat. One of them is what there is to be told, and how far they go apart.
  [[nodiscard]] bool wander();
  void forget_marks();
  /// Back to where oil was led on, if with what it was led to no cycle is found: they go on as they
  /// are.
  bool come_back_from_led_oil();
  /// The walls' fixed point, a cycle a turn; false if they still change, or with the verdict.
  bool settle_walls(const WallMeans& from, bool rough, int turns);
  /// Walls and oil by turns, until both hold; `rough`: walls.
  void settle_walls_and_oil(bool rough);
  /// One turn of it: walls and their thermal deformation in units -> what they come to.
  bool answer_walls(const std::vector<double>& x, std::vector<double>& g);
  /// By how much the last cycle would change a wall, or its thermal deformation in units [K].
  [[nodiscard]] double change_of_walls();
  void walls_unsettled();
  void cycles_unsettled(double within);
  /// For a tape, besides the passes.
  void members(Tape& tape);
  [[nodiscard]] bool repeats() const { return film().model().input.cycle->repeats(); }
  /// Whether the orbit may be one that the journal does not keep to: cycles alone lead to none.
  [[nodiscard]] bool may_depart() const {
    return led_ && film().model().input.cycle->journal_mass > 0.0;
  }
  [[nodiscard]] bool heat() const { return film().model().physics.film_energy; }

  CyclePasses passes_;
  Closure closure_;
  std::vector<double> mark_;   ///< of the first cycle that hardly differed from the one before
  int marked_ = 0;             ///< after so many cycles
  double by_mark_ = INFINITY;  ///< what the cycle before told to be left since then [-]
  std::vector<double> near_;   ///< the same of one that differed by less than the error of a step
  int near_at_ = 0;            ///< after so many cycles
  int spans_ = 0;              ///< in which cycles have stayed near
  double left_ = NAN;          ///< CycleResult::closure
  bool led_ = false;           ///< anything, here or on the way to where it began
  double growth_ = NAN;        ///< CycleResult::growth
  bool unseen_ = false;        ///< growth was looked at, and is not known
  std::optional<Displaced> displaced_;
  LedOil oil_;
  std::optional<Tape::Content> before_led_;  ///< the passes, until one has begun with led oil
  std::optional<WallMeans> answered_;        ///< what the last cycle's heat makes of the walls
  HeatTaken off_{NAN, NAN};   ///< heat of the bodies then, less that of the cycle [W]
  double mean_change_ = NAN;  ///< of the walls then [K]
  double wall_change_ = NAN;  ///< of the last turn [K]
  bool held_ = false;         ///< the walls
  Phase phase_ = Phase::orbit;
  int most_ = 0;                         ///< cycles, of search()
  bool settled_ = false;                 ///< the walls, when they were looked at last
  double round_change_ = INFINITY;       ///< of the walls, as a round of walls and oil left it [K]
  int stalled_ = 0;                      ///< rounds since it has fallen
  Field layer_begun_;                    ///< depths to which a layer has flowed before a pass [m]
  double layer_grows_ = 0.0;             ///< by which it flowed most in the last pass [m]
  std::vector<double> walls_begun_;      ///< of the walls' fixed point, packed
  Replay<std::vector<double>> answers_;  ///< of the iteration around the cycles
  Verdict unsettled_;                    ///< the passes were good, but led nowhere
};

/// The search that solve_cycle makes, ended with its verdict; not for tier lumped. `control` must
/// outlive it. `cost`: that of all grids. `near`: where it begins; null: from rest, with heat on
/// coarse grids first.
[[nodiscard]] std::unique_ptr<CycleSearch> search_cycle(const Case& c, Tier tier,
                                                        const SolveControl& control, Cost& cost,
                                                        const CycleStart* near = nullptr);

/// A cycle that was solved, and what the search of another grid or of other steps may begin from;
/// none: it is not good, an event, or of one temperature, which repeats itself as soon from rest.
struct SolvedCycle {
  CycleResult result;
  std::optional<CycleStart> start;
};

/// As solve_cycle (cycle.hpp), begun near what was found there; null: from rest.
[[nodiscard]] SolvedCycle solve_cycle_from(const CycleStart* near, const Case& c, Tier tier,
                                           const SolveControl& control);

}  // namespace shellback::bearing
