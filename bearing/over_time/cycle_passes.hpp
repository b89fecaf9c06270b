#pragma once
/// A bearing passed through its load cycle once and once more, between walls that stay as they are.
///
/// Each pass takes the film from where the last one left it, through the steps in time of
/// cycle_steps.hpp, and gathers what the cycle was: its record, the mean heat into the walls and,
/// for the first cycles, how the film would answer them.
#include <functional>
#include <memory>
#include <optional>

#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/cycle_record.hpp"
#include "bearing/over_time/cycle_start.hpp"
#include "bearing/over_time/cycle_steps.hpp"
#include "bearing/over_time/cycle_walls.hpp"
#include "bearing/pressed_layer.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {

/// Steps of a period at least, at a tolerance of 1 %: 8 degrees of two turns. That no pulse is
/// passed over from a steady place is what the corners of the course are for.
inline constexpr double kFewestSteps = 90.0;
/// Error of a step in time, over model.tolerance [-] (decision 024).
inline constexpr double kOfTolerance = 0.1;

class CyclePasses {
 public:
  /// What its owner keeps with it.
  using Rest = std::function<void(Tape&)>;

  /// On the grid of the case. `control` must outlive it; refers to itself, is not copied.
  /// `solids`: operators of former passes of the same geometry.
  CyclePasses(const Case& c, Tier tier, const Physics& physics, const SolveControl& control,
              std::shared_ptr<const Solids> solids = nullptr);
  CyclePasses(const CyclePasses&) = delete;
  CyclePasses& operator=(const CyclePasses&) = delete;

  // Where the first pass begins (cycle_begin.cpp).

  /// From rest in a film of one temperature [K]; an event from the steady state of its first row,
  /// if there is one.
  void begin(double T);
  /// From what other passes of the bearing have come to.
  void begin(const CycleStart& from);
  /// As begin(T), between these walls.
  void begin_between(const WallMeans& walls, double T);
  /// From what passes of the same bearing with a shell of another shape have come to, on the same
  /// grid, in the steps in time that they took, between these walls; none: of one temperature.
  /// False, with the verdict, if the gap is closed.
  bool begin_reshaped(const CyclePasses& other, const std::optional<WallMeans>& walls);
  /// From where it stands, in a film of another temperature [K]; an event begins anew.
  void set_temperature(double T);
  /// From what a tape has kept in the middle of a pass, with the rest behind it.
  void begin(Tape& tape, const Rest& rest);

  // For a tape, between two passes.

  /// All that further passes, and what is told of the last one, depend on.
  void members(Tape& tape);

  /// Passes the period once more; false, with the verdict, if it does not end. From time to time
  /// the state is kept, and the rest behind it.
  bool pass(const Rest& rest = {});
  /// The same between other walls. What the skin has warmed in the mean is then taken from it.
  bool pass_between(const WallMeans& walls, const Rest& rest = {});
  /// In the middle of a pass that a tape has brought back.
  [[nodiscard]] bool brought_back() const { return brought_back_; }

  [[nodiscard]] const Verdict& verdict() const { return r_.verdict; }
  [[nodiscard]] int passed() const { return r_.cycles; }
  /// The cycle that was passed last, and what separates it from the one before (CycleRecord).
  [[nodiscard]] const CycleRecord& told() const { return told_; }
  [[nodiscard]] double difference() const { return difference_; }
  /// Its mean heat, and the film's response to its walls; counted: passes that have measured it.
  [[nodiscard]] const CycleHeat& heat() const { return heat_; }
  [[nodiscard]] const thermal::WallResponse& response() const { return *response_; }
  [[nodiscard]] int measured() const { return measured_; }
  [[nodiscard]] const FilmSteps& film() const { return film_; }
  [[nodiscard]] const std::optional<WallMeans>& walls() const { return walls_; }
  /// The heat about which that into the walls swings from now on [W/m2].
  void swing_about(const Field& flux) { walls_->flux = flux; }
  /// What goes from cycle to cycle slowly, as FilmSteps::lasting_of tells it. Put back, it may
  /// close the gap: false, with the verdict.
  [[nodiscard]] std::vector<double> lasting() const { return film_.lasting_of(now_); }
  bool put_lasting(const std::vector<double>& carried);
  /// Displaces the journal by a thousandth of the clearance, as much in the unit of journal();
  /// false if that closes the gap.
  [[nodiscard]] bool displace();
  [[nodiscard]] double displacement() const;
  [[nodiscard]] JournalState journal() const { return film_.journal_of(now_); }
  /// Cycles in a turn of the journal at its fastest, at least one, and so few that a dozen turns
  /// end.
  [[nodiscard]] int cycles_of_turn() const;
  /// All of it between two passes, and the same put back, but for what was spent meanwhile.
  [[nodiscard]] Tape::Content stand();
  void put_back(const Tape::Content& stand);
  /// A layer keeps marks of what has flowed, which are not of the oil alone.
  [[nodiscard]] bool has_marks() const { return !now_.layer.now.empty(); }
  /// Lasting depths of it [m]; empty: no layer.
  [[nodiscard]] Field layer_depth() const {
    return has_marks() ? lasting_depth(now_.layer.now) : Field{};
  }
  [[nodiscard]] const EquilibriumCost& cost() const { return cost_; }
  /// Whether it has cost all that it may.
  [[nodiscard]] bool spent() const { return cost_.work > control_.most_work; }
  /// Error that is allowed in a step [-].
  [[nodiscard]] double error() const { return steps_.error; }
  /// Of the last cycle.
  [[nodiscard]] CycleResult result() const;
  /// What other passes of the bearing begin from; with film temperatures, after a pass.
  [[nodiscard]] CycleStart start() const {
    return {film_.model(), now_, *walls_, *response_, measured_};
  }

 private:
  /// The cycle that is being passed.
  struct Passing {
    CycleRecord record;
    bool look = false;       ///< at the film's response to its walls
    double next_look = 0.0;  ///< [s]
    void members(Tape& tape) { tape(record, look, next_look); }
  };

  void begin_pass();
  /// The pass that has begun, to its end.
  [[nodiscard]] PeriodEnd go_through(const Rest& rest);
  /// A film that was carried over from other cells need not hold together under the load: once more
  /// from rest, between the walls that were.
  [[nodiscard]] bool begin_again_from_rest(const Verdict& ended);
  /// One accepted step of the cycle that is being passed.
  void add(const FilmStep& step, double dt);
  /// The cycle that was being passed has ended so.
  void take(Passing passed, const PeriodEnd& end);
  /// Keeps the state, if it is time, or in any case.
  void keep(bool in_any_case, const Rest& rest);
  /// The film alone, of one temperature [K], between walls as warm, if there are any.
  void begin_film(double T, const WallMeans* walls = nullptr);
  /// The steady state of an event's first row in a resolved tier; false if none is found.
  bool begin_warm();
  /// The oil of a steady film is not quite that of one that carries its oil in time
  /// (fluid/fill_front.hpp): before an event its first load stands while the oil goes round twice.
  void carry_oil_round();
  /// The film between these walls; false, with the verdict, if they leave it no room.
  bool put(const WallMeans& walls);
  /// Shortest time that skins resolve [s].
  [[nodiscard]] double skin_time() const;

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
  std::optional<WallMeans> walls_;
  bool from_rest_ = true;
  bool carried_over_ = false;  ///< the film with which the first pass begins, from other cells
  bool begun_cold_ = false;    ///< an event, its walls at the supply's temperature
  std::optional<Passing> passing_;
  bool brought_back_ = false;
  CycleRecord told_;
  double difference_ = NAN;
  CycleHeat heat_;
  std::optional<thermal::WallResponse> response_;
  int measured_ = 0;
  CycleResult r_;  ///< verdict and counts, as they come
};

}  // namespace shellback::bearing
