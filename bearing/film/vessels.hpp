#pragma once
/// Supplies whose line is shut at times: the oil of a vessel of given volume feeds the film.
///
/// Beyond what it holds at the cavitation pressure a vessel of volume V holds the oil
///   E = kappa (p - p_cav),   kappa = rho V / K                                           (1)
///   dE/dt = inflow of the line - outflow into the film                                   (2)
/// While the line is open its pressure stands in the vessel and the line makes up for (2); where it
/// opens, the vessel is filled up at once. While it is shut there is no inflow, and p follows from
/// (1), never below p_cav: there
///   p - p_cav >= 0,   1 - fill >= 0,   (p - p_cav)(1 - fill) = 0                         (3)
/// the oil that the journal would drag out of the supply has a fill ratio below 1, so that no more
/// flows than the vessel has and than flows back into it. In a stage of a step (film_step.hpp) of
/// length `own`
///   E = E* - own outflow(p, fill)                                                        (4)
/// is solved together with the film; E itself is carried as what flowed, so that oil is conserved
/// to round-off. rho is the density of the oil at its supply temperature and ambient pressure, K
/// the bulk modulus of oil and vessel together. Source: textbook (capacity of a hydraulic volume);
/// docs/theory.md, section "Vessels".
#include "bearing/bearing.hpp"
#include "bearing/film/equilibrium.hpp"
#include "core/tape.hpp"

namespace shellback::bearing {

class Vessels {
 public:
  explicit Vessels(const BearingModel& model);

  [[nodiscard]] bool any() const { return !of_patch_.empty(); }
  /// E of vessels at the pressure of their supplies [kg].
  [[nodiscard]] std::vector<double> full() const;
  /// The beginning of a course: all full, and `scene` says so. Gives E [kg].
  [[nodiscard]] std::vector<double> begin(fluid::FilmScene& scene) const;
  /// (1), the smallest of all vessels [Pa].
  [[nodiscard]] double least_pressure(const std::vector<double>& oil) const;
  /// Whether one of them stands at the cavitation pressure in what `solve` found.
  [[nodiscard]] bool any_empty(const fluid::FilmScene& scene) const;
  /// Largest |oil| over what its vessel holds when full [-].
  [[nodiscard]] double largest_share(const std::vector<double>& oil) const;
  /// Instants within the period, or from the beginning of an event, at which lines open or shut
  /// [s].
  [[nodiscard]] std::vector<double> switchings() const;
  /// Lines as they are between two switchings, at time t of the course; vessels whose line is open
  /// are filled up, and what that takes is handed back [kg].
  double set_lines(double t, std::vector<double>& oil);

  /// To which part of itself the gap over their pockets, which hold `pockets` of oil [kg], must be
  /// known for (4) of the vessels whose line is shut; infinite: there are none [-].
  [[nodiscard]] double gap_known_to(const std::vector<double>& pockets) const;
  /// Solves (4) for the vessels whose line is shut. `film` solves the film for what `scene` says of
  /// its supplies and tells the outflow of every patch [kg/s]; `scene` keeps what was found.
  using Film = std::function<Verdict(fluid::OilFlows&)>;
  [[nodiscard]] Verdict solve(double own, const std::vector<double>& oil_star,
                              fluid::FilmScene& scene, const Film& film);
  /// dE/dt by what flows into the film; what open lines hold stays [kg/s].
  [[nodiscard]] std::vector<double> slopes(const fluid::OilFlows& flows) const;
  /// Flow out of the lines of all supplies, through open vessels [kg/s].
  [[nodiscard]] double from_lines(const fluid::OilFlows& flows) const;
  /// For a tape: valves and what a search begins with.
  void members(Tape& tape);

 private:
  /// Of the supply's pressure: as the film in time is solved [-].
  static constexpr double kEnough = 1e-5;
  struct Search;
  void advance(int vessel, double own, double star, double out, Search& s);
  /// One unknown a vessel: above zero p - p_cav, below zero (fill - 1) (p_supply - p_cav) [Pa].
  void put(int vessel, double u, fluid::FilmScene& scene) const;
  [[nodiscard]] double unknown(int vessel, const fluid::FilmScene& scene) const;

  std::vector<int> of_patch_;
  std::vector<double> kappa_;     ///< (1) [kg/Pa]
  std::vector<double> p_supply_;  ///< [Pa]
  std::vector<Vessel> given_;
  double p_cav_ = 0.0;   ///< [Pa]
  double period_ = 0.0;  ///< [s]; infinity: an event
  std::vector<char> open_;
  std::vector<double> conductance_;  ///< d outflow/d u as last found [kg/(s Pa)]
};

}  // namespace shellback::bearing
