#pragma once
/// What a cycle was: instants, means, extremes, maxima over the bearing, audit.
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/cycle_walls.hpp"
#include "bearing/over_time/film_step.hpp"
#include "bearing/over_time/wear_load.hpp"
#include "core/tape.hpp"

namespace shellback::bearing {

/// Means over a cycle.
struct CycleMeans {
  double torque = 0.0;           ///< [N m]
  double torque_asperity = 0.0;  ///< part of it [N m]
  double T_film = 0.0;           ///< of the oil, by its mass; resolved tiers [K]
  double power = 0.0;            ///< of shaft, load and supply [W]
  double side_mass_flow = 0.0;   ///< [kg/s]
  std::vector<double> fed;       ///< out of every supply into the film, net [kg/s]
};

class CycleRecord {
 public:
  /// `film` and `course` must outlive the record.
  CycleRecord(const FilmSteps& film, const LoadCourse& course, double length);

  /// The state with which the cycle begins.
  void begin(const FilmInTime& now);
  /// One accepted step of dt.
  void add(const FilmStep& step, double dt, const SolveControl& control);
  /// Time that has been told [s].
  [[nodiscard]] double told() const { return instants_.back().t; }
  /// Largest relative difference in smallest film, mean and largest torque, and what the cycle ends
  /// with otherwise than it began: relative change of the oil in the gap, and the journal's change
  /// of momentum over the impulse of the load's magnitude (the mean film force is the mean load).
  [[nodiscard]] double difference(const CycleRecord& other) const;
  /// Smallest film [m], largest and mean torque [N m]; at the end oil in film and vessels [kg] and
  /// the journal's velocity [m/s].
  [[nodiscard]] std::vector<double> mark() const;
  /// Largest relative difference from what another cycle has been marked with.
  [[nodiscard]] double difference(const std::vector<double>& mark) const;
  [[nodiscard]] CycleMeans means() const;
  /// Of a film with heat.
  [[nodiscard]] HeatTaken heat_taken() const;
  /// By how much the film ends otherwise than it began: relative change of smallest film, of torque
  /// (over its largest) and of the oil in the gap [-].
  [[nodiscard]] double drift() const;
  /// Oil that the film has gained over the cycle, over what it held as it began [-].
  [[nodiscard]] double oil_gathered() const { return oil_ended_ / oil_begun_ - 1.0; }
  [[nodiscard]] bool edges_took_oil_in() const { return side_inflow_ > 0.0; }
  /// Mean over the cycle, on the solved grid; of a case with [running_in].
  [[nodiscard]] WearLoad wear_load() const { return wear_.mean(); }
  /// Largest contact pressure [Pa] and smallest gap [m] of each place, on the solved grid.
  [[nodiscard]] const Field& largest_contact() const { return p_asperity_max_; }
  [[nodiscard]] const Field& smallest_gap() const { return h_min_; }
  /// All but verdict, tier (to be set before) and cost; of a cycle without a step only what it is.
  void write(CycleResult& r) const;
  /// For a tape: all but film and course.
  void members(Tape& tape);

 private:
  void add_contact(const FilmEquilibrium& f, CycleInstant& i);
  /// `p`: the film pressure that is told [Pa].
  [[nodiscard]] CycleInstant instant_of(const FilmInTime& now, const Field& p, double dt);
  [[nodiscard]] std::vector<CycleQuantity> quantities() const;
  /// Those of tiers with film temperatures.
  void add_heat(std::vector<CycleQuantity>& out) const;
  [[nodiscard]] CycleAudit audit() const;
  [[nodiscard]] double oil_in_gap(const Field& oil) const;
  [[nodiscard]] Field shell_surface(const FilmInTime& now) const;
  /// Work of shaft, load and moment on the journal over the step that ends at t: load, torque,
  /// speed and velocity straight along it, from what holds behind a jump on. Under a load that
  /// rises in one step the velocity rises with it, and their product is a parabola [J].
  [[nodiscard]] double work_of(const CycleInstant& from, const CycleInstant& to, double t) const;
  /// Work of the moment on the journal between two instants [J].
  [[nodiscard]] double work_of_moment(const CycleInstant& from, const CycleInstant& to) const;
  /// Held by the elastic surfaces, half of pressure times widening; not by an elasto-plastic
  /// layer, whose spring is not straight [J].
  [[nodiscard]] double stored_by_surfaces(const FilmInTime& now) const;
  void gather_fields(const FilmInTime& now, const Field& p, double dt);
  /// Keeps the film, if it is time: at the instants that the case gives, or evenly.
  void keep_frame(const FilmInTime& now, const Field& p);
  void gather_heat(const FilmStep& step, double dt);
  void write_heat(CycleResult& r) const;
  /// Indicator numbers, of means and extremes.
  [[nodiscard]] std::vector<Effect> effects(const CycleResult& r) const;
  /// Ranges of the laws that were left, at the extremes of each place.
  void tell_ranges(CycleResult& r) const;
  /// Relative change of the oil in gap and vessels over the cycle [-].
  [[nodiscard]] double oil_drift() const;
  /// Change of the journal's momentum over the cycle, over the impulse of the load's magnitude [-].
  [[nodiscard]] double momentum_drift() const;
  /// Of the journal's velocity [m/s] its momentum, over the impulse of the load's magnitude [-].
  [[nodiscard]] double part_of_impulse(double change) const;
  /// Of oil [kg], over what all vessels hold [-].
  [[nodiscard]] double part_of_vessels(double oil) const;
  /// Of a smallest film over its yielding gap [-].
  [[nodiscard]] double change_of_film(double h, double other) const;
  /// By how much the shaft's surface would swing about its mean, as it turns and over the cycle:
  /// the half space under the first harmonic of either, q/(k sqrt(omega/a)) (textbook) [K].
  [[nodiscard]] note::ShaftSwing shaft_swing() const;
  /// A load between the ends of a given step that these do not show.
  void tell_missed_load(std::vector<Note>& warnings) const;

  const FilmSteps* film_;
  const LoadCourse* course_;
  double length_;
  std::vector<CycleInstant> instants_;
  std::vector<CycleFrame> frames_;
  double next_frame_ = 0.0;                               ///< [s]
  double oil_begun_ = 0.0;                                ///< [kg]
  double oil_ended_ = 0.0;                                ///< [kg]
  double supply_ = 0.0, side_ = 0.0, side_inflow_ = 0.0;  ///< over the cycle [kg]
  std::vector<double> fed_;                               ///< of `supply_`, out of every one [kg]
  double line_ = 0.0;                               ///< come from the lines of the supplies [kg]
  double vessels_begun_ = 0.0;                      ///< oil in them beyond that at p_cav [kg]
  double vessels_ended_ = 0.0;                      ///< [kg]
  double dry_ = 0.0;                                ///< time with an empty vessel [s]
  std::array<double, 2> impulse_{};                 ///< of the film [N s]
  std::array<double, 2> v_begun_{};                 ///< [m/s]
  std::array<double, 2> v_ended_{};                 ///< [m/s]
  double pump_now_ = 0.0, pump_ = 0.0;              ///< at the last instant [W], over the cycle [J]
  double off_balance_ = 0.0;                        ///< [N]
  double off_moment_ = 0.0;                         ///< [N m]
  double opening_ = 0.0;                            ///< elastic, over yielding_film [-]
  double off_content_ = 0.0;                        ///< over the oil in the gap [-]
  double stored_begun_ = 0.0, stored_ended_ = 0.0;  ///< by elastic surfaces [J]
  double work_ = 0.0;                               ///< of shaft, load and moment so far [J]
  double layer_loss_ = 0.0;  ///< of an elasto-plastic layer so far, solved part [J]
  Field layer_depth_;        ///< lasting, as it stands [m]; empty: none
  Field p_max_, p_asperity_max_, h_min_, friction_;  ///< on the solved grid
  Field power_now_;              ///< friction per area at the last instant [W/m2]
  HeatFlows heat_;               ///< over the cycle [J], [J/m2]; nothing without film temperatures
  double T_film_ = 0.0;          ///< integral over time [K s]
  Field T_shell_, T_shell_max_;  ///< integral over time [K s], largest [K]
  MeanWearLoad wear_;            ///< of a case with [running_in]
  int bent_edges_ = 0;           ///< most at an instant, on the solved grid
  note::FedFlow fed_fastest_;    ///< of all instants
  note::OilSheared sheared_;     ///< the same
  double shear_rate_ = 0.0;      ///< the same, largest_shear_rate [1/s]
  double p_slope_ = 0.0;         ///< the same, largest_slope [Pa/m]
};

}  // namespace shellback::bearing
