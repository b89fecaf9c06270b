#include "fidelity/estimate_cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/film/equilibrium.hpp"
#include "bearing/heat/heat_endings.hpp"
#include "bearing/over_time/cycle_instants.hpp"
#include "bearing/over_time/cycle_lumped.hpp"
#include "bearing/over_time/cycle_search.hpp"
#include "bearing/told_ranges.hpp"
#include "core/bracketed_root.hpp"
#include "core/stopwatch.hpp"
#include "fidelity/cycle_bars.hpp"
#include "fidelity/estimate_bars.hpp"
#include "fidelity/journal_path.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

/// The path of the bar of time errs in a step, over the gap that is left, by so much less than the
/// solved film, and the path that is told by so much less again: its bar of time vanishes beside
/// the others.
constexpr double kFiner = 10.0;

/// Rise with which the search for a temperature begins, at most: one in which oils lose half of
/// their viscosity [K].
constexpr double kThinned = 20.0;

/// The temperature at which the heat of a mean cycle leaves: the path there, or why there is none.
Verdict settle_heat(JournalPath& path, const Case& c, double& T) {
  const HeatWays ways = heat_ways(c);
  Verdict last;
  const auto away = [&](double at) {
    return path.motion().scene().heat_away(at, mean_of(path.instants(), &CycleInstant::side_flow),
                                           ways.paths);
  };
  const auto surplus = [&](double at) {
    last = path.find(at);
    return last.good() ? away(at) - mean_of(path.instants(), &CycleInstant::power) : double{NAN};
  };
  T = ways.coldest;
  double below = surplus(T);
  if (!(below < 0.0)) return last;  // no heat to speak of, or no path
  const double hottest = ways.warmest + kHottestRise;
  // The friction of the coldest film would be carried off with this rise; warmer films rub less.
  double rise = std::min(kThinned, -below / (away(T + 1.0) - away(T)));
  while (T < hottest) {
    rise = std::min(rise, hottest - T);
    const double above = surplus(T + rise);
    if (std::isnan(above)) return last;
    if (above < 0.0) {
      T += rise;
      below = above;
      rise *= 2.0;
      continue;
    }
    const BracketedRoot root =
        bracketed_root(surplus, {T, below}, {T + rise, above}, {0.0, kCycleBalance});
    if (root.found) T = root.at.x;
    return last;  // where there is no root the path was lost on the way
  }
  return {Status::iteration_limit,
          ending::AtTemperature{ending::Thermal::unbalanced_cycle, hottest}};
}

/// The state by which the estimate's bars are judged: the extremes of the cycle.
Estimate worst_of(const JournalPath& path, const Case& c, double T) {
  const auto& all = path.instants();
  const CycleInstant& thinnest = extreme(all, &CycleInstant::h_min, Extreme::smallest);
  Estimate e;
  e.T = T;
  e.rise = T - mean_supply_temperature(c);
  e.h_min = thinnest.h_min;
  e.eps = 1.0 - e.h_min / c.bearing.radial_clearance;
  e.eta = path.motion().scene().viscosity(e.eps, T, std::hypot(thinnest.load_x, thinnest.load_y),
                                          std::abs(thinnest.omega));
  e.p_max = extreme(all, &CycleInstant::p_max, Extreme::largest).p_max;
  e.asperity_share = path.asperity_share();
  e.side_flow = mean_of(all, &CycleInstant::side_flow);
  for (const CycleInstant& i : all) e.load = std::max(e.load, std::hypot(i.load_x, i.load_y));
  const double sigma = combined_roughness(c.surfaces);
  e.lambda = sigma > 0.0 ? e.h_min / sigma : INFINITY;
  return e;
}

/// A path on which nothing that Reynolds' equation could describe is left of the film.
Verdict thinner_than_a_molecule(const Case& c, const JournalPath& path) {
  if (path.motion().scene().touches()) return {};
  const CycleInstant& thinnest = extreme(path.instants(), &CycleInstant::h_min, Extreme::smallest);
  if (thinnest.h_min >= kMolecule) return {};
  return {Status::iteration_limit,
          ending::NoStep{thinnest.t, c.cycle->crank_speed, true},
          {},
          {{Status::no_steady_state, ending::NotAtRest{0, thinnest.h_min}}}};
}

/// Means and extremes without bars.
std::vector<CycleQuantity> quantities(const JournalPath& path, double T) {
  const std::vector<CycleInstant>& all = path.instants();
  const bool rough = path.motion().scene().touches();
  std::vector<CycleQuantity> list{mean_quantity("friction_torque", all, &CycleInstant::torque)};
  if (rough) {
    list.push_back(mean_quantity("friction_torque_asperity", all, &CycleInstant::torque_asperity));
  }
  list.push_back(quantity_of("power_loss", mean_of(all, &CycleInstant::power)));
  list.push_back(extreme_of("h_min", all, &CycleInstant::h_min, Extreme::smallest));
  list.push_back(extreme_of("p_max", all, &CycleInstant::p_max, Extreme::largest));
  if (rough) {
    list.push_back(
        extreme_of("p_asperity_max", all, &CycleInstant::p_asperity_max, Extreme::largest));
  }
  list.push_back(quantity_of("side_flow", mean_of(all, &CycleInstant::side_flow)));
  list.push_back(quantity_of("T_film_mean", T));
  return list;
}

/// What the film's history is worth, of the value: measured on cycles of the isothermal tier
/// (docs/load-cycles.md).
struct HistoryParts {
  double torque, film, peak;
  double swinging;  ///< torque of a journal that turns to and fro: it carries no oil round, and
                    ///< half of the film may stand empty
};
constexpr HistoryParts kHistory{0.10, 0.50, 0.80, 0.50};

bool turns_to_and_fro(const JournalPath& path) {
  const auto& all = path.instants();
  return extreme(all, &CycleInstant::omega, Extreme::smallest).omega < 0.0 &&
         extreme(all, &CycleInstant::omega, Extreme::largest).omega > 0.0;
}

double& bar_of_model(CycleQuantity& q) { return q.quantity.error_model; }

void put_bars(std::vector<CycleQuantity>& list, const std::vector<CycleQuantity>& longer,
              const EstimateBars& bars, bool swings, double closure) {
  const double of_torque = swings ? kHistory.swinging : kHistory.torque;
  const auto most = [](double bar) { return std::min(kMostBar, bar); };
  const auto relative = [&](const std::string& name) {
    if (name == "h_min") return most(bars.film + kHistory.film);
    if (name == "p_max") return most(bars.peak + kHistory.peak);
    if (name == "side_flow") return bars.flow;
    if (name == "friction_torque" || name == "power_loss") {
      return most(bars.torque + of_torque);
    }
    return kMostBar;  // of asperities, as in the steady estimate
  };
  // A film squeezed for long goes with the square of its mobility: int dh/h^(3/2) ~ M times the
  // load's impulse.
  const auto of_table = [](const std::string& name) { return name == "h_min" ? 2.0 : 1.0; };
  for (std::size_t k = 0; k < list.size(); ++k) {
    Quantity& q = list[k].quantity;
    const double size = q.size();
    const bool temperature = q.name == "T_film_mean";
    q.error_grid = temperature ? 0.0 : of_table(q.name) * kMobilityError * size;
    q.error_model = temperature ? bars.temperature : relative(q.name) * size;
    q.error_time = std::abs(longer[k].quantity.value - q.value);
    if (!temperature && std::isfinite(closure)) q.error_time += closure * size;
  }
}

void tell_what_is_left_out(const Case& c, const JournalPath& path, CycleResult& r) {
  r.warnings.assign(c.warnings.begin(), c.warnings.end());
  r.assumptions.assign(c.assumptions.begin(), c.assumptions.end());
  r.assumptions.emplace_back(note::Plain::estimate_of_cycle);
  if (c.cycle->journal_mass > 0.0) {
    r.assumptions.push_back(note::EstimateWithoutMass{c.cycle->journal_mass});
  }
  const bool shut = std::any_of(c.supplies.begin(), c.supplies.end(),
                                [](const Supply& s) { return s.vessel.has_value(); });
  const bool drilled = std::any_of(c.supplies.begin(), c.supplies.end(),
                                   [](const Supply& s) { return s.kind == SupplyKind::drilling; });
  if (shut) r.assumptions.emplace_back(note::Plain::estimate_vessel_open);
  if (drilled) r.assumptions.emplace_back(note::Plain::estimate_drilling);
  if (c.cycle->repeats()) return;
  r.assumptions.emplace_back(path.began_steady() ? note::Plain::event_from_steady
                                                 : note::Plain::estimate_in_the_middle);
}

}  // namespace

CycleResult estimate_cycle(const Case& c, const SolveControl& control) {
  const Stopwatch watch;
  JournalPath rough(c, kOfTolerance / kFiner * c.model.tolerance, control);
  JournalPath path(c, kOfTolerance / (kFiner * kFiner) * c.model.tolerance, control);
  CycleResult r;
  r.tier = Tier::estimate;
  r.title = c.title;
  r.period = path.length();
  r.crank_speed = c.cycle->crank_speed;
  // There is no field to draw a balance of.
  r.audit.mass = r.audit.content = r.audit.load = r.audit.impulse = NAN;
  double T = 0.0;
  r.verdict = settle_heat(rough, c, T);
  const bool settled = r.verdict.good();
  if (settled) {
    path.begin_as(rough);
    r.verdict = path.find(T);
  }
  const JournalPath& last = settled ? path : rough;
  r.cycles = last.cycles();
  r.closure = last.closure();
  r.steps = last.steps();
  r.rejected_steps = last.rejected();
  tell_what_is_left_out(c, last, r);
  if (r.verdict.good()) r.verdict = thinner_than_a_molecule(c, path);
  if (r.verdict.good()) {
    r.instants = path.instants();
    const double p_max = extreme(path.instants(), &CycleInstant::p_max, Extreme::largest).p_max;
    for (Note& w : oil_range_warnings(c.oil, T, T, p_max)) r.warnings.push_back(std::move(w));
    const auto [back, forth] = std::minmax_element(
        r.instants.begin(), r.instants.end(),
        [](const CycleInstant& a, const CycleInstant& b) { return a.omega < b.omega; });
    const double fastest = std::max(std::abs(back->omega), std::abs(forth->omega));
    add_turbulence(c, fastest * c.bearing.radius, T, r.warnings);
    add_squeeze_inertia(c, fastest_motion(r.instants), T, r.warnings);
    add_contact_left_out(c, extreme(r.instants, &CycleInstant::h_min, Extreme::smallest).h_min,
                         r.warnings);
    r.quantities = quantities(path, T);
    put_bars(r.quantities, quantities(rough, T), estimate_bars(c, worst_of(path, c, T)),
             turns_to_and_fro(path), path.closure());
    widen_bars_of_light_contact(c, r, bar_of_model);
  }
  r.cost.wall_s = watch.seconds();
  return r;
}

}  // namespace shellback::fidelity
