#include "coupling/thermal_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "coupling/coldest.hpp"
#include "coupling/fixed_point.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::coupling {
namespace {

constexpr double kSettled = 1e-9;  ///< change per sweep that leaves the balance near round-off [K]
constexpr double kRoughlySettled = 1e-3;  ///< the same where the balance need not close [K]
constexpr int kLaps = 3;                  ///< sweeps for the film's response to its walls
constexpr int kResponseTurn =
    4;  ///< in which that is measured again; a coarser grid's does till then
constexpr double kTemperatureUnit = 10.0;  ///< one unit of the fixed point's temperatures [K]

/// The map of the fixed point, on the states it works on.
class Turn {
 public:
  Turn(const BearingModel& model, const LoadTarget& target, const ThermalOptions& options,
       const SolveControl& control, FilmEquilibrium& film, HeatState& heat, EquilibriumCost& cost,
       std::vector<HistoryEntry>& history)
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
  /// Small steps from the best state on, then accelerated again once they have come near.
  FixedPointEnd creep(const FixedPointOptions& fixed);
  /// Goes on to the value of the last turn, which is nearer to the fixed point.
  void take_last_value();
  /// Solves film, heat and walls of the last turn to the end, so that their balances close.
  void finish();

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
  [[nodiscard]] double relaxation(const std::vector<double>& x, const std::vector<double>& g) const;
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
  /// False, with the verdict set, if the temperatures run away.
  [[nodiscard]] bool sound();
  [[nodiscard]] Verdict runaway(const std::string& what) const;
  [[nodiscard]] Verdict friction_runaway(double from, double to) const;
  /// Refuses a film that is colder than everything around it.
  [[nodiscard]] Verdict second_law();
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
  int turns_ = 0;
  int newton_before_ = 0;  ///< iterations that were spent before this solve
};

std::vector<double> Turn::pack() const {
  std::vector<double> x;
  const double T0 = model_.input.supplies.front().temperature;
  for (const double T : film_.columns.T) x.push_back((T - T0) / kTemperatureUnit);
  for (const double d : heat_.growth) x.push_back(d / model_.clearance);
  return x;
}

void Turn::take_contact_growth() {
  const Physics& has = model_.physics;
  if (film_.contact_growth || !model_.contact || !has.elastic || !has.growth) return;
  if (!(heat_.response.shell_local > 0.0) || film_.p_contact.empty()) return;
  film_.contact_growth = std::make_shared<HarmonicOperator>(
      model_.solids->contact_growth(contact_heat_rate(model_).shell, heat_.response));
  const Field own = model_.solids->widening(*film_.contact_growth, film_.p_contact);
  for (std::size_t k = 0; k < own.size(); ++k) {
    heat_.growth[k] -= own[k];
    film_.elastic[k] += own[k];
  }
}

void Turn::give_contact_growth() {
  if (!film_.contact_growth) return;
  const Field own = model_.solids->widening(*film_.contact_growth, film_.p_contact);
  for (std::size_t k = 0; k < own.size(); ++k) {
    heat_.growth[k] += own[k];
    film_.elastic[k] -= own[k];
  }
  film_.contact_growth.reset();
}

/// No tighter than the temperatures are known: the map's noise stays well below its change.
EquilibriumOptions Turn::film_options() const {
  constexpr double kNoise = 1e-2;  // of the last change
  EquilibriumOptions o = options_.film;
  const double noise = turns_ <= 1 ? kNoise : kNoise * std::min(heat_.residual, 1.0);
  o.film_tolerance = std::max(o.film_tolerance, noise);
  o.load_tolerance = std::max(o.load_tolerance, noise);
  o.elastic_tolerance = std::max(o.elastic_tolerance, noise);
  o.viscosity_tolerance = std::max(o.viscosity_tolerance, noise);
  return o;
}

Verdict Turn::solve_film(const Place& from) {
  constexpr double kShortestStep = 1.0 / 32.0;
  const EquilibriumOptions options = film_options();
  const fluid::FilmState film = film_.film;
  const fluid::JournalPosition position = film_.position;
  const Field elastic = film_.elastic;
  const auto solve = [&](const Field& growth) {
    return solve_equilibrium(model_, target_, growth, options, film_, cost_, control_.stop);
  };
  Verdict verdict = solve(heat_.growth);
  const bool at_once = from.T.empty() || !options_.patient;
  if (verdict.good() || verdict.status == Status::interrupted || at_once) return verdict;
  const Place to{film_.columns.T, heat_.growth};
  film_.film = film;
  film_.position = position;
  film_.elastic = elastic;
  FilmEquilibrium reached = film_;
  double done = 0.0;
  for (double step = 0.25; done < 1.0;) {
    const double here = std::min(1.0, done + step);
    Field growth = to.growth;
    for (std::size_t k = 0; k < to.T.size(); ++k) {
      film_.columns.T[k] = from.T[k] + here * (to.T[k] - from.T[k]);
    }
    for (std::size_t k = 0; k < growth.size(); ++k) {
      growth[k] = from.growth[k] + here * (to.growth[k] - from.growth[k]);
    }
    verdict = solve(growth);
    if (verdict.good()) {
      reached = film_;
      done = here;
      step *= 2.0;
      continue;
    }
    if (verdict.status == Status::interrupted || step < kShortestStep) break;
    film_ = reached;
    step *= 0.25;
  }
  film_.columns.T = to.T;
  return verdict;
}

/// Warmer oil is thinner and makes less heat: the map answers a rise by -beta (T - T_supply) of it.
/// Taking this part of the change cancels that answer for the mean of the film. Nor may growth
/// close more than half of the gap that is there.
double Turn::relaxation(const std::vector<double>& x, const std::vector<double>& g) const {
  constexpr double kMostClosing = 0.5;  // of the smallest film and the roughness [-]
  double mean = 0.0;
  const std::size_t nodes = film_.columns.T.size();
  for (std::size_t k = 0; k < nodes; ++k) mean += g[k];
  const double rise = kTemperatureUnit * mean / static_cast<double>(nodes);
  const double T = model_.input.supplies.front().temperature + rise;
  const double beta = -rheology::viscosity_slopes(model_.oil, T, 0.0, 0.0).dln_dT;
  double closing = 0.0;
  for (std::size_t k = nodes; k < x.size(); ++k) closing = std::max(closing, x[k] - g[k]);
  const double room = std::max(film_.least.h, 0.0) + 3.0 * model_.scene.rough.sigma;
  const double most = kMostClosing * room / std::max(closing * model_.clearance, 1e-300);
  return std::min(1.0 / (1.0 + std::max(beta * rise, 0.0)), most);
}

void Turn::unpack(const std::vector<double>& x) {
  const FilmGrid& g = model_.scene.grid;
  const double T0 = model_.input.supplies.front().temperature;
  const std::size_t nodes = film_.columns.T.size();
  for (std::size_t k = 0; k < nodes; ++k) film_.columns.T[k] = T0 + kTemperatureUnit * x[k];
  for (std::size_t k = 0; k < heat_.growth.size(); ++k) {
    heat_.growth[k] = model_.clearance * x[nodes + k];
  }
  const int n = model_.gl.n;  // the walls' temperatures travel as the film's wall nodes
  for (int c = 0; c < g.cells(); ++c) {
    if (model_.scene.supply.cell[c] < 0) heat_.T_shell[c] = film_.columns.T[c * n];
  }
  for (int j = 0; j < g.nz; ++j) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < g.nt; ++i) {
      const int c = g.index(i, j);
      if (model_.scene.supply.cell[c] >= 0) continue;
      sum += film_.columns.T[c * n + n - 1];
      ++count;
    }
    if (count > 0) heat_.T_shaft[j] = sum / count;
  }
}

void Turn::impose_walls(std::vector<double>& T) const {
  const FilmGrid& g = model_.scene.grid;
  const int n = model_.gl.n;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      if (model_.scene.supply.cell[c] >= 0) continue;
      T[c * n] = heat_.T_shell[c];
      T[c * n + n - 1] = heat_.T_shaft[j];
    }
  }
}

thermal::FilmEnergy Turn::film_energy() {
  friction_ = friction_of(model_, film_);
  return thermal::FilmEnergy(film_energy_problem(model_, film_, friction_));
}

void Turn::warm_the_walls(const thermal::FilmEnergy& energy, Solids::Wanted wanted) {
  const FilmGrid& g = model_.scene.grid;
  const thermal::WallHeat walls = energy.wall_heat(film_.columns.T);
  const ContactHeat rubbed = contact_heat(model_, film_);
  WallFlux q{walls.shell, std::vector<double>(g.nz, 0.0), heat_.response};
  heat_.contact_heat = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      q.shell[c] = q.shell[c] / g.area(i, j) + rubbed.shell[c];
      q.shaft[j] += (walls.shaft[c] / g.area(i, j) + rubbed.shaft[c]) * g.dphi[i] / (2.0 * kPi);
      heat_.contact_heat += g.multiplicity() * g.area(i, j) * (rubbed.shell[c] + rubbed.shaft[c]);
    }
  }
  heat_.solids = model_.solids->answer(q, heat_.T_shell, heat_.T_shaft, wanted);
}

bool Turn::sound() {
  const auto hottest = std::max_element(film_.columns.T.begin(), film_.columns.T.end());
  const double rise = *hottest - model_.input.supplies.front().temperature;
  const bool finite = std::all_of(film_.columns.T.begin(), film_.columns.T.end(),
                                  [](double T) { return std::isfinite(T); });
  constexpr double kFrozen = 150.0;  // colder than that no oil is a liquid, and no law holds [K]
  if (finite && *std::min_element(film_.columns.T.begin(), film_.columns.T.end()) < kFrozen) {
    verdict_ = second_law();
    return false;
  }
  if (finite && rise < options_.runaway) return true;
  verdict_ = runaway(finite ? fmt::format("the film is {:.0f} K above the supply and rises", rise)
                            : "the film temperature is not a number any more");
  return false;
}

Verdict Turn::runaway(const std::string& what) const {
  const auto hottest = std::max_element(film_.columns.T.begin(), film_.columns.T.end());
  const int cell = static_cast<int>(hottest - film_.columns.T.begin()) / model_.gl.n;
  return {Status::no_steady_state, "thermal runaway: " + what,
          fluid::place_of(model_.scene.grid, cell),
          "lower speed or load, feed more or cooler oil, or improve the cooling of the shell"};
}

Verdict Turn::friction_runaway(double from, double to) const {
  return runaway(
      fmt::format("followed in small steps, the friction torque rose from {:.3g} to {:.3g} N m "
                  "without coming to rest: heat thins the film, or makes the shell bulge, faster "
                  "than it flows off",
                  from, to));
}

void Turn::name_the_failure() {
  constexpr double kLost = 3.0;  // |ln| of the change of viscosity from which heat is the cause [-]
  if (verdict_.status != Status::iteration_limit) return;
  const double lost = viscosity_change(model_, film_);
  if (!(lost > kLost)) return;
  const double T0 = model_.input.supplies.front().temperature;
  const double T = *std::max_element(film_.columns.T.begin(), film_.columns.T.end());
  verdict_ =
      runaway(fmt::format("the film is {:.0f} K above the supply, its viscosity is {:.1e} "
                          "times that of the supplied oil, and no film is found any more",
                          T - T0, std::exp(-lost)));
}

void Turn::report(const std::vector<double>& x, const std::vector<double>& g) {
  heat_.residual = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    heat_.residual = std::max(heat_.residual, std::abs(g[k] - x[k]));
  }
  const double signed_torque = friction_.viscous + friction_.asperity;
  history_.push_back({"thermal", heat_.residual, signed_torque, film_.least.h});
  if (control_.progress) {
    control_.progress(
        {to_string(model_.input.model.tier), turns_, heat_.residual, signed_torque, film_.least.h});
  }
}

double Turn::take_wall_temperatures() {
  double change = 0.0;
  for (std::size_t c = 0; c < heat_.T_shell.size(); ++c) {
    change = std::max(change, std::abs(heat_.solids.shell.surface[c] - heat_.T_shell[c]));
  }
  for (std::size_t j = 0; j < heat_.T_shaft.size(); ++j) {
    change = std::max(change, std::abs(heat_.solids.shaft.temperature[j] - heat_.T_shaft[j]));
  }
  heat_.T_shell = heat_.solids.shell.surface;
  heat_.T_shaft = heat_.solids.shaft.temperature;
  impose_walls(film_.columns.T);
  return change;
}

bool Turn::operator()(const std::vector<double>& x, std::vector<double>& g) {
  // Within a turn the walls come to balance but for this part of their first change: they answer
  // the film slowly, and each of their rounds costs far less than a film.
  constexpr double kWallPart = 0.1;
  constexpr int kWallRounds = 6;
  ++turns_;
  unpack(x);
  if (!sound()) return false;
  const Place before{std::move(turn_T_), std::move(turn_growth_)};
  turn_T_ = film_.columns.T;
  turn_growth_ = heat_.growth;
  verdict_ = solve_film(before);
  if (!verdict_.good()) {
    name_the_failure();
    return false;
  }
  thermal::FilmEnergy energy = film_energy();
  for (int k = 0; k < options_.sweeps; ++k) energy.sweep(film_.columns.T);
  if (!sound()) return false;
  if (!(heat_.response.shell_local > 0.0) || turns_ == kResponseTurn) {
    heat_.response = energy.wall_response(kLaps);
  }
  const double change = wall_round(energy);
  const double enough =
      std::max(kWallPart * change, kWallPart * kTemperatureUnit * options_.tolerance);
  if (change > enough) balance_walls(energy, enough, kWallRounds);
  for (int k = 0; k < options_.sweeps; ++k) energy.sweep(film_.columns.T);
  if (!sound()) return false;
  warm_the_walls(energy, {true, false});
  take_wall_temperatures();
  if (!heat_.growth.empty()) {
    heat_.growth = heat_.solids.growth;
    if (film_.contact_growth) {
      const Field own = model_.solids->widening(*film_.contact_growth, film_.p_contact);
      for (std::size_t k = 0; k < own.size(); ++k) heat_.growth[k] -= own[k];
    } else {
      take_contact_growth();  // the film's response is known from the first turn on
    }
  }
  g = pack();
  const double part = relaxation(x, g);
  for (std::size_t k = 0; k < g.size(); ++k) g[k] = x[k] + part * (g[k] - x[k]);
  report(x, g);
  last_ = g;
  if (heat_.residual < best_.residual) {
    best_ = {heat_.residual, torque(), film_, heat_, turn_T_, turn_growth_};
  }
  return true;
}

FixedPointEnd Turn::creep(const FixedPointOptions& fixed) {
  constexpr double kStep = 0.3;     // of the way to the map's value
  constexpr double kNear = 0.05;    // change per turn from which acceleration is tried again
  constexpr double kRisen = 1.1;    // friction over that of the best state: it has risen [-]
  constexpr double kRunaway = 1.5;  // the same: it rises for good [-]
  const double before = best_.torque;
  film_ = best_.film;
  heat_ = best_.heat;
  turn_T_ = best_.T;
  turn_growth_ = best_.growth;
  std::vector<double> x = pack();
  std::vector<double> g;
  double near = kNear;
  for (int k = 0; k < fixed.max_iterations; ++k) {
    if (!(*this)(x, g)) {
      if (verdict_.status != Status::iteration_limit) return FixedPointEnd::map_failed;
      if (heated() && torque() > kRisen * before) verdict_ = friction_runaway(before, torque());
      return FixedPointEnd::map_failed;
    }
    const double now = torque();
    const bool spent = cost_.newton_iterations - newton_before_ > options_.most_newton;
    if (spent && !(heated() && now > kRisen * before)) return FixedPointEnd::iteration_limit;
    if ((spent || now > kRunaway * before) && heated() && heat_.residual > kNear) {
      verdict_ = friction_runaway(before, now);
      return FixedPointEnd::map_failed;
    }
    for (std::size_t c = 0; c < x.size(); ++c) x[c] += kStep * (g[c] - x[c]);
    if (heat_.residual > near) continue;
    std::vector<double> y = x;
    FixedPointOptions again = fixed;
    again.max_iterations = std::max(10, fixed.max_iterations / 2);
    if (fixed_point(std::ref(*this), again, y) == FixedPointEnd::converged) {
      return FixedPointEnd::converged;
    }
    near *= 0.1;
    film_ = best_.film;
    heat_ = best_.heat;
    turn_T_ = best_.T;
    turn_growth_ = best_.growth;
    x = pack();
  }
  return FixedPointEnd::iteration_limit;
}

Verdict Turn::second_law() {
  constexpr double kRipple = 0.5;  // of the rise: beyond it is no ripple of the polynomials [-]
  constexpr double kMargin = 2.0;  // [K]
  const double coldest = coldest_around(model_);
  const auto [low, high] = std::minmax_element(film_.columns.T.begin(), film_.columns.T.end());
  if (*low >= coldest - kMargin - kRipple * (*high - coldest)) return {};
  const int cell = static_cast<int>(low - film_.columns.T.begin()) / model_.gl.n;
  ++cost_.unresolved;
  return {Status::iteration_limit,
          fmt::format("the film temperature falls to {:.0f} degC, below everything around it: the "
                      "nodes across the film do not resolve it",
                      *low - kZeroCelsius),
          fluid::place_of(model_.scene.grid, cell),
          "more model.film_nodes, a finer grid, or methods.across = \"layers\""};
}

double Turn::wall_round(thermal::FilmEnergy& energy) {
  for (int k = 0; k < options_.sweeps; ++k) energy.sweep(film_.columns.T);
  warm_the_walls(energy, {false, false});
  return take_wall_temperatures();
}

double Turn::balance_walls(thermal::FilmEnergy& energy, double enough, int rounds) {
  constexpr int kDepth = 12;
  const std::size_t cells = heat_.T_shell.size();
  double least = INFINITY;  // of the best round: the walls are left as they were there
  std::vector<double> best_T = film_.columns.T;
  HeatState best = heat_;
  const auto round = [&](const std::vector<double>& x, std::vector<double>& g) {
    std::copy_n(x.begin(), cells, heat_.T_shell.begin());
    std::copy(x.begin() + cells, x.end(), heat_.T_shaft.begin());
    impose_walls(film_.columns.T);
    const double change = wall_round(energy);
    if (change < least) {
      least = change;
      best_T = film_.columns.T;
      best = heat_;
    }
    g = heat_.T_shell;
    g.insert(g.end(), heat_.T_shaft.begin(), heat_.T_shaft.end());
    return true;
  };
  std::vector<double> x = heat_.T_shell;
  x.insert(x.end(), heat_.T_shaft.begin(), heat_.T_shaft.end());
  const auto end = fixed_point(round, {kDepth, 1, rounds, enough}, x);
  if (end != FixedPointEnd::converged) {
    film_.columns.T = best_T;
    heat_ = best;
  }
  return least;
}

void Turn::take_last_value() {
  unpack(last_);
  turn_T_ = film_.columns.T;
  turn_growth_ = heat_.growth;
}

void Turn::finish() {
  constexpr int kMostSweeps = 400;
  constexpr int kMostRounds = 60;
  constexpr double kWalls = 1e-7;      // change per round that leaves their heat balanced [K]
  constexpr double kUnbalanced = 0.1;  // change that the walls must not be left with [K]
  const std::vector<double> after = film_.columns.T;
  film_.columns.T = turn_T_;
  verdict_ =
      solve_equilibrium(model_, target_, turn_growth_, options_.film, film_, cost_, control_.stop);
  film_.columns.T = after;
  thermal::FilmEnergy energy = film_energy();
  const double change = options_.close ? balance_walls(energy, kWalls, kMostRounds) : 0.0;
  const double settled = options_.close ? kSettled : kRoughlySettled;
  for (int k = 0; k < kMostSweeps; ++k) {
    if (energy.sweep(film_.columns.T) < settled) break;
  }
  warm_the_walls(energy, {true, true});
  heat_.growth = turn_growth_;  // that of the film
  heat_.balance = energy.balance(film_.columns.T);
  heat_.T_mix = energy.mix_temperatures();
  heat_.backflow_nodes = energy.backflow_nodes();
  if (verdict_.good()) verdict_ = second_law();
  if (verdict_.good() && !(change < kUnbalanced)) {
    verdict_ = {Status::iteration_limit,
                fmt::format("film and walls do not come to balance (last change {:.2g} K)", change),
                "", "try a finer grid or another cooling of shell and shaft"};
  }
}

}  // namespace

double viscosity_change(const BearingModel& model, const FilmEquilibrium& film) {
  const double T0 = model.input.supplies.front().temperature;
  const double T = *std::max_element(film.columns.T.begin(), film.columns.T.end());
  const double hot = rheology::viscosity(model.oil, T, 0.0);
  return std::abs(std::log(rheology::viscosity(model.oil, T0, 0.0) / hot));
}

HeatState cold_heat(const BearingModel& model, double T) {
  HeatState h;
  const FilmGrid& g = model.scene.grid;
  if (model.physics.growth) h.growth.assign(g.cells(), 0.0);
  h.T_shell.assign(g.cells(), T);
  h.T_shaft.assign(g.nz, T);
  return h;
}

Verdict solve_thermal(const BearingModel& model, const LoadTarget& target,
                      const ThermalOptions& options, const SolveControl& control,
                      FilmEquilibrium& film, HeatState& heat, EquilibriumCost& cost,
                      std::vector<HistoryEntry>& history) {
  Turn turn(model, target, options, control, film, heat, cost, history);
  turn.take_contact_growth();
  std::vector<double> x = turn.pack();
  constexpr double kSlack = 10.0;  // of the change, where it is seen to fall fast [-]
  const FixedPointOptions fixed{options.anderson_depth, 1, options.max_turns, options.tolerance,
                                kSlack};
  FixedPointEnd end = fixed_point(std::ref(turn), fixed, x);
  if (end != FixedPointEnd::converged && options.patient && turn.may_go_on())
    end = turn.creep(fixed);
  if (end == FixedPointEnd::map_failed) {
    turn.give_contact_growth();
    if (!turn.verdict().good()) return turn.verdict();
    return {Status::invalid_number, "the accelerated temperatures are not numbers", "",
            "try a finer grid"};
  }
  if (end == FixedPointEnd::converged) turn.take_last_value();
  if (end == FixedPointEnd::converged || options.patient) turn.finish();
  turn.give_contact_growth();
  if (end == FixedPointEnd::converged) return turn.verdict();
  return {Status::iteration_limit,
          fmt::format("film and heat did not settle in {} turns (last change {:.1e} of 10 K)",
                      turn.turns(), heat.residual),
          fluid::place_of(model.scene.grid, 0), "try a finer grid or a tighter range of operation"};
}

}  // namespace shellback::coupling
