#include "bearing/heat/heat_iteration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "bearing/film/closed_gap.hpp"
#include "bearing/film/film_motion.hpp"
#include "bearing/film/solve_equilibrium.hpp"
#include "bearing/heat/heat_endings.hpp"
#include "bearing/heat/wall_balance.hpp"
#include "core/largest.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {
namespace {

/// The map of the fixed point, on the states it works on.
class HeatIteration {
 public:
  HeatIteration(Solution& s, const ThermalOptions& options, const SolveControl& control,
                const HeatStep* step)
      : s_(s), options_(options), control_(control), walls_(s, step) {
    if (!s.point.load.path || !s.point.load.path->moves) return;
    if (s.heat.thermal_deformation.empty()) return;
    path_from_ = s.point.load.path->from;
    grown_from_ = s.heat.thermal_deformation;
    force_from_ = carrying_force(s.model, s.film);
  }

  bool operator()(const std::vector<double>& x, std::vector<double>& g);
  [[nodiscard]] std::vector<double> pack() const;
  /// From here on the deformation by asperity heat goes with the film (equilibrium.hpp, (3a)).
  void take_contact_widening();
  [[nodiscard]] Field own_widening() const {
    return widening(*s_.model.solids, *s_.film.contact_widening, s_.film.p_contact);
  }
  /// Counts it as thermal deformation again.
  void give_contact_widening();
  [[nodiscard]] const Verdict& verdict() const { return verdict_; }
  [[nodiscard]] int iterations() const { return iterations_; }
  /// True if the last iteration points farther than it was let go: however small the change that
  /// was made, that is no steady state.
  [[nodiscard]] bool limited() const { return limited_; }
  /// Solves film, heat and walls of the last value to the end, so that their balances close.
  void finish();

 private:
  [[nodiscard]] EquilibriumOptions film_options() const;
  void limit_change(const std::vector<double>& x, std::vector<double>& g);
  [[nodiscard]] double relaxation(const std::vector<double>& g) const;
  void unpack(const std::vector<double>& x);
  /// A path is measured from the journal's last place among surfaces that have grown since: where
  /// they move, it moves along (follow.hpp).
  void carry_path();
  void tell_all_growth();
  void report(const std::vector<double>& x, const std::vector<double>& g);
  [[nodiscard]] double supply_temperature() const {
    return mean_supply_temperature(s_.model.input);
  }

  Solution& s_;
  const ThermalOptions& options_;
  const SolveControl& control_;
  WallBalance walls_;
  fluid::JournalPosition path_from_;  ///< with a path: where it begins,
  Field grown_from_;                  ///< thermal deformation there [m],
  Field force_from_;                  ///< and what each cell carries [N]
  std::vector<double> last_;          ///< value of the last iteration
  Friction friction_;
  Verdict verdict_;
  bool limited_ = false;
  int iterations_ = 0;
};

std::vector<double> HeatIteration::pack() const {
  std::vector<double> x;
  for (const double T : s_.film.columns.T) x.push_back((T - supply_temperature()) / kHeatUnit);
  for (const double d : s_.heat.thermal_deformation) x.push_back(d / s_.model.clearance);
  return x;
}

void HeatIteration::unpack(const std::vector<double>& x) {
  auto& T = s_.film.columns.T;
  for (std::size_t k = 0; k < T.size(); ++k) T[k] = supply_temperature() + kHeatUnit * x[k];
  for (std::size_t k = 0; k < s_.heat.thermal_deformation.size(); ++k) {
    s_.heat.thermal_deformation[k] = s_.model.clearance * x[T.size() + k];
  }
  walls_.read_from_film();
  if (!grown_from_.empty()) carry_path();
}

void HeatIteration::carry_path() {
  Field grown = s_.heat.thermal_deformation;
  for (std::size_t k = 0; k < grown.size(); ++k) grown[k] -= grown_from_[k];
  const auto moved = motion_of(s_.model, s_.point.load.unknowns, force_from_, grown);
  for (std::size_t k = 0; k < moved.size(); ++k) {
    s_.point.load.path->from.q[k] = path_from_.q[k] - moved[k];
  }
}

void HeatIteration::take_contact_widening() {
  const Physics& has = s_.model.physics;
  if (s_.film.contact_widening || !s_.model.contact || !has.elastic || !has.thermal_deformation)
    return;
  if (!(s_.heat.response.shell_local > 0.0) || s_.film.p_contact.empty()) return;
  s_.film.contact_widening = std::make_shared<ContactWidening>(
      ContactWidening{s_.model.solids->contact_widening(1.0, s_.heat.response, walls_.solid_step()),
                      contact_heat_rate(s_.model, s_.point, s_.film)});
  const Field own = own_widening();
  for (std::size_t k = 0; k < own.size(); ++k) {
    s_.heat.thermal_deformation[k] -= own[k];
    s_.film.elastic[k] += own[k];
    if (!grown_from_.empty()) grown_from_[k] -= own[k];
  }
}

void HeatIteration::give_contact_widening() {
  s_.heat.contact_deformation.clear();
  if (!s_.film.contact_widening) return;
  const Field own = own_widening();
  s_.heat.contact_deformation = own;
  for (std::size_t k = 0; k < own.size(); ++k) {
    s_.heat.thermal_deformation[k] += own[k];
    s_.film.elastic[k] -= own[k];
  }
  s_.film.contact_widening.reset();
}

/// No tighter than the temperatures are known: the map's noise stays well below its change.
EquilibriumOptions HeatIteration::film_options() const {
  EquilibriumOptions o = options_.film;
  const double noise = iterations_ <= 1 ? kWayPoint : kWayPoint * std::min(s_.heat.residual, 1.0);
  o.film_tolerance = std::max(o.film_tolerance, noise);
  o.load_tolerance = std::max(o.load_tolerance, noise);
  o.elastic_tolerance = std::max(o.elastic_tolerance, noise);
  o.viscosity_tolerance = std::max(o.viscosity_tolerance, noise);
  return o;
}

/// Warmer oil is thinner and makes less heat: the map answers a rise by -beta (T - T_supply) of it.
/// Taking this part of the change cancels that answer for the mean of the film.
double HeatIteration::relaxation(const std::vector<double>& g) const {
  double mean = 0.0;
  const std::size_t nodes = s_.film.columns.T.size();
  for (std::size_t k = 0; k < nodes; ++k) mean += g[k];
  const double rise = kHeatUnit * mean / static_cast<double>(nodes);
  const double beta =
      -rheology::viscosity_slopes(s_.model.oil, supply_temperature() + rise, 0.0, 0.0).dln_dT;
  return 1.0 / (1.0 + std::max(beta * rise, 0.0));
}

/// Oil that is still cold makes far more heat in one iteration than it will once warm, and the
/// solids answer that heat: what this leads to is no state, and no iteration goes farther to it.
void HeatIteration::limit_change(const std::vector<double>& x, std::vector<double>& g) {
  constexpr double kMostChange = 100.0 / kHeatUnit;  // of a temperature
  constexpr double kMostClosing = 0.5;  // of the gap, over the smallest film and the roughness [-]
  const std::size_t nodes = s_.film.columns.T.size();
  const std::vector<double> wanted = g;
  for (std::size_t k = 0; k < nodes; ++k) {
    g[k] = x[k] + std::clamp(g[k] - x[k], -kMostChange, kMostChange);
  }
  const double gap = gap_with_summits(s_.model, s_.film);
  for (std::size_t k = nodes; k < x.size(); ++k) {
    g[k] = std::max(g[k], x[k] - kMostClosing * gap / s_.model.clearance);
  }
  limited_ = largest_difference(wanted, g) > options_.tolerance;
}

/// A gap that closed while growth was limited: with all the growth, where the bearing as it is at
/// rest has no room already.
void HeatIteration::tell_all_growth() {
  const BearingModel& m = s_.model;
  if (!m.physics.thermal_deformation) return;
  const auto closed = closed_at_rest(m.input, *m.solids, m.domain.grid);
  if (!closed) return;
  const Field growth(m.domain.grid.cells(), closed->deformation);
  s_.film.gap = gap_at(m, s_.film.position, sum(growth, s_.film.elastic));
  s_.film.least = fluid::smallest_gap(m.domain.grid, s_.film.gap, m.profile, m.supply);
  verdict_ = closed_gap(m, s_.point, growth, s_.film);
  // Closed at one of the temperatures around, it may be open where it runs.
  const bool seized = closed_at_any_rest(m.input, *m.solids, m.domain.grid);
  if (!seized) verdict_.status = Status::iteration_limit;
}

void HeatIteration::report(const std::vector<double>& x, const std::vector<double>& g) {
  s_.heat.residual = largest_difference(g, x);
  const double torque = friction_.torque();
  s_.history.push_back({"thermal", s_.heat.residual, torque, s_.film.least.h});
  if (control_.progress) {
    control_.progress({to_string(s_.model.input.model.tier), iterations_, s_.heat.residual, torque,
                       s_.film.least.h});
  }
}

bool HeatIteration::operator()(const std::vector<double>& x, std::vector<double>& g) {
  ++iterations_;
  unpack(x);
  verdict_ = temperatures_possible(s_);
  if (!verdict_.good()) return false;
  verdict_ = solve_equilibrium_near(
      {s_.model, s_.point, s_.heat.thermal_deformation, film_options(), control_.stop}, s_.film,
      s_.cost);
  if (!verdict_.good()) {
    if (limited_ && verdict_.as<ending::GapClosed>() != nullptr) tell_all_growth();
    return false;
  }
  friction_ = friction_of(s_.model, s_.point, s_.film);
  walls_.begin(friction_, iterations_);
  walls_.balance_roughly(kHeatUnit * options_.tolerance);
  verdict_ = fields_finite(s_);
  if (!verdict_.good()) return false;
  walls_.deform();
  if (s_.film.contact_widening) {
    const Field own = own_widening();
    for (std::size_t k = 0; k < own.size(); ++k) s_.heat.thermal_deformation[k] -= own[k];
  } else {
    take_contact_widening();  // the film's response is known from the first iteration on
  }
  verdict_ = fields_finite(s_);
  if (!verdict_.good()) return false;
  g = pack();
  limit_change(x, g);
  const double part = relaxation(g);
  for (std::size_t k = 0; k < g.size(); ++k) g[k] = x[k] + part * (g[k] - x[k]);
  report(x, g);
  last_ = g;
  return true;
}

void HeatIteration::finish() {
  unpack(last_);
  const Field thermal_deformation = s_.heat.thermal_deformation;
  verdict_ = solve_equilibrium_near(
      {s_.model, s_.point, thermal_deformation, options_.film, control_.stop}, s_.film, s_.cost);
  if (!verdict_.good()) return;
  friction_ = friction_of(s_.model, s_.point, s_.film);
  const double change = walls_.finish(friction_, options_.close);
  s_.heat.thermal_deformation = thermal_deformation;                // that of the film
  if (!walls_.solid_step()) verdict_ = colder_than_all_around(s_);  // in time, walls may be colder
  if (verdict_.good()) verdict_ = walls_unbalanced(change);
}

}  // namespace

HeatState cold_heat(const BearingModel& model, double T) {
  HeatState h;
  const FilmGrid& g = model.domain.grid;
  if (model.physics.thermal_deformation) h.thermal_deformation.assign(g.cells(), 0.0);
  h.T_shell.assign(g.cells(), T);
  h.T_shaft.assign(g.nz, T);
  return h;
}

Verdict solve_heat(Solution& s, const ThermalOptions& options, const SolveControl& control,
                   const HeatStep* step) {
  constexpr double kSlack = 10.0;  // of the change, where it is seen to fall fast [-]
  HeatIteration iteration(s, options, control, step);
  iteration.take_contact_widening();
  std::vector<double> x = iteration.pack();
  const FixedPointEnd end = fixed_point(
      std::ref(iteration),
      {options.anderson_depth, 1, options.max_iterations, options.tolerance, kSlack}, x);
  Verdict v = iteration.verdict();
  if (end == FixedPointEnd::converged && !iteration.limited()) {
    iteration.finish();
    v = iteration.verdict();
  } else if (v.good()) {
    v = {Status::iteration_limit,
         ending::Unsettled{ending::Iteration::heat, iteration.iterations(), s.heat.residual}};
  }
  iteration.give_contact_widening();
  return v;
}

}  // namespace shellback::bearing
