#include "bearing/over_time/film_step.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/film/newton.hpp"
#include "bearing/film/pockets.hpp"
#include "bearing/film/pseudo_time.hpp"
#include "bearing/temperature_limits.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"
#include "fluid/fill_front.hpp"

namespace shellback::bearing {
namespace {

/// An elasto-plastic layer, if there is one, begins a stage of length `own` from these columns.
void begin_layer(double own, Columns columns, OperatingPoint& point) {
  if (!point.layer) return;
  point.layer->own = own;
  point.layer->before = std::move(columns);
}

/// And what the stage has made of it.
LayerInTime layer_of(const OperatingPoint& point, const FilmEquilibrium& film) {
  if (!point.layer) return {};
  return stage_of(*point.layer, point.scene.grid, film.film.p, film.p_contact, film.layer);
}

/// Oil that these flows gather in every cell, zero in supply cells [kg/(m2 s)].
Field gathered(const fluid::FilmScene& scene, const fluid::FilmFlow& flow) {
  const FilmGrid& g = scene.grid;
  Field oil = fluid::net_outflow(scene, flow);
  for (int c = 0; c < g.cells(); ++c) {
    oil[c] = scene.supply.cell[c] >= 0 ? 0.0 : -oil[c] / g.area(c);
  }
  return oil;
}

/// Sum over the cells of how much more or less oil this film holds than was carried there [kg].
double off_content(const fluid::FilmScene& scene, const FilmEquilibrium& film,
                   const Field& carried) {
  const FilmGrid& g = scene.grid;
  const Field held = fluid::oil_content(scene, film.gap, film.oil, film.film);
  double off = 0.0;
  for (int c = 0; c < g.cells(); ++c) {
    if (scene.supply.cell[c] < 0) off += std::abs(held[c] - carried[c]) * g.area(c);
  }
  return off;
}

/// Velocity, acceleration and force of the journal at the end of a stage of length `own` [s], begun
/// with v [m/s].
void tell_motion(const FilmEquilibrium& film, const LoadTarget& load, double own,
                 const std::array<double, 2>& v, FilmStage& found) {
  const fluid::Wrench wanted = load.wanted(film);
  for (int k = 0; k < 2; ++k) {
    found.force[k] = film.force[k];
    if (k < load.unknowns) {
      found.off_balance = std::max(found.off_balance, std::abs(film.force[k] - wanted[k]));
    }
    const double gained = film.flight[k] / own;  // of velocity
    found.velocity[k] = v[k] + gained;
    found.acceleration[k] = load.inertial_stiffness > 0.0 ? gained / own : 0.0;
  }
}

/// What the search for a steady film takes for the limit of its load says in a step only that the
/// step has no film.
Verdict in_a_step(const Verdict& v) {
  if (!v.as<ending::BeyondPressureBound>()) return v;
  return {Status::iteration_limit, ending::Plain::out_of_the_law, v.place};
}

}  // namespace

FilmSteps::FilmSteps(const BearingModel& model, const LoadCourse& course, double mass,
                     const EquilibriumOptions& options)
    : model_(model),
      course_(course),
      mass_(mass),
      options_(options),
      point_(operating_point(model)),
      drillings_(model, course),
      vessels_(model) {
  point_.load.unit = course.largest_load();
}

FilmInTime FilmSteps::at_rest(double T) {
  FilmInTime now;
  heat_.reset();  // that of another beginning
  growth_ = {};
  widening_.clear();
  now.vessels = vessels_.begin(point_.scene);
  point_.scene.speed = course_.begins().omega * model_.input.bearing.radius;
  now.film = cold_start(model_, point_, T);
  for (int k = 0; k < point_.load.unknowns; ++k) now.film.position.q[k] = 0.0;
  [[maybe_unused]] const bool open =
      evaluate(model_, point_, widening_, options_.viscosity_tolerance, now.film);
  EXPECTS(open);
  now.oil = fluid::oil_content(point_.scene, now.film.gap, now.film.oil, now.film.film);
  if (point_.layer) now.layer.now.assign(model_.domain.grid.cells(), {});
  return now;
}

void FilmSteps::open_mouths(double t, FilmEquilibrium& film) {
  if (!drillings_.any()) return;
  [[maybe_unused]] const bool open =
      evaluate(model_, point_, widening_, options_.viscosity_tolerance, film);
  EXPECTS(open);
  drillings_.take(model_, film);
  drillings_.place(t, point_.scene);
}

fluid::FilmState filled_as_carried(const BearingModel& model, const OperatingPoint& point,
                                   const fluid::FilmState& steady) {
  fluid::FilmState middle = steady;
  if (model.input.model.methods.transport != FillTransport::van_leer) return middle;
  const Field fill = fluid::cell_fill(point.scene, steady);
  for (std::size_t k = 0; k < fill.size(); ++k) {
    if (!middle.full[k]) middle.theta[k] = fill[k];
  }
  return middle;
}

std::optional<FilmInTime> FilmSteps::steady(double T, const Field& deformed, EquilibriumCost& cost,
                                            const std::atomic<bool>* stop) {
  const LoadNow load = course_.begins();
  LoadTarget target = point_.load;
  target.force[0] = -load.x;
  target.force[1] = -load.y;
  target.unit = 0.0;
  target.inertial_stiffness = 0.0;         // that of a step
  const bool at_rest = load.omega == 0.0;  // the film carries nothing: asperities may
  if ((at_rest && !model_.contact) || !(target.scale() > 0.0)) return std::nullopt;
  point_.scene.speed = load.omega * model_.input.bearing.radius;
  point_.scene.storage = {};
  if (point_.layer) point_.layer->hold(model_.domain.grid.cells());
  widening_ = deformed;
  FilmInTime now;
  now.vessels = vessels_.begin(point_.scene);
  now.film = cold_start(model_, point_, T);
  open_mouths(0.0, now.film);
  OperatingPoint point = point_;
  point.load = target;
  const Verdict v =
      at_rest ? come_to_rest({model_, point, deformed, options_, stop}, now.film, cost)
              : newton_or_through_time({model_, point, deformed, {}, stop}, now.film, cost);
  if (!v.good()) return std::nullopt;
  point_.scene.storage = {};
  now.film.film = filled_as_carried(model_, point_, now.film.film);
  now.oil = fluid::oil_content(point_.scene, now.film.gap, now.film.oil, now.film.film);
  now.flows = fluid::oil_flows(point_.scene, now.film.flow);
  for (const solid::PressedColumn& c : now.film.layer) now.layer.now.push_back(c.now);
  return now;
}

Verdict FilmSteps::solve_stage(int i, double dt, const std::vector<FilmStage>& stages,
                               const FilmInTime& now, FilmEquilibrium& film, FilmStage& found,
                               EquilibriumCost& cost, const std::atomic<bool>* stop) {
  const Tableau by = method_at(now);
  const double own = by.a[i][i] * dt;
  const LoadNow load = course_.at(now.t + by.c[i] * dt, true);
  Field before = now.oil;
  Columns layer = now.layer.now;
  std::array<double, 2> q{now.film.position.q[0], now.film.position.q[1]};
  std::array<double, 2> v = now.velocity;
  for (int j = 0; j < i; ++j) {
    const double f = by.a[i][j] * dt;
    add(f, stages[j].oil, before);
    add(f, stages[j].layer.slope, layer);
    for (int k = 0; k < 2; ++k) {
      q[k] += f * stages[j].velocity[k];
      v[k] += f * stages[j].acceleration[k];
    }
  }
  point_.scene.speed = load.omega * model_.input.bearing.radius;
  point_.scene.storage = {own, std::move(before), fronts_of(film)};
  begin_layer(own, std::move(layer), point_);
  point_.load.force[0] = -load.x;
  point_.load.force[1] = -load.y;
  point_.load.inertial_stiffness = mass_ / (own * own);
  if (i > (by.explicit_first ? 1 : 0)) {
    const double since = (by.c[i] - by.c[i - 1]) * dt;
    carry_on(FilmTrend(now.film, film, by.c[i - 1] * dt), since, film);
  } else if (by.explicit_first) {
    carry_on(now.trend, by.c[i] * dt, film);
  }
  for (int k = 0; k < 2; ++k) film.flight[k] = film.position.q[k] - (q[k] + own * v[k]);
  if (heat_) {
    expect_temperatures(i, dt, stages, now, film);
    if (!oil_can_be(film.columns.T)) {  // carried on too far
      return {Status::iteration_limit, ending::Plain::film_impossible};
    }
  }
  if (drillings_.any()) drillings_.place(now.t + by.c[i] * dt, point_.scene);
  const SuppliesStar star = supplies_star(i, dt, stages, now);
  const Verdict verdict = solve_film_and_fronts(star, film, cost, stop);
  if (!verdict.good()) return in_a_step(verdict);
  if (thinner_than_a_molecule(model_, film)) {
    return {Status::no_steady_state, ending::NotAtRest{0, film.least.h}, film.least.place()};
  }
  found.oil = gathered(point_.scene, film.flow);
  found.flows = fluid::oil_flows(point_.scene, film.flow);
  count_pockets(model_, film, star.pockets, own, found.flows);
  found.layer = layer_of(point_, film);
  tell_motion(film, point_.load, own, v, found);
  return heat_ ? solve_heat(i, dt, stages, now, film, found) : verdict;
}

Field FilmSteps::fronts_of(const FilmEquilibrium& film) const {
  if (model_.input.model.methods.transport == FillTransport::upwind) return {};
  return fluid::fill_fronts(point_.scene, film.film, film.flow);
}

FilmSteps::SuppliesStar FilmSteps::supplies_star(int i, double dt,
                                                 const std::vector<FilmStage>& stages,
                                                 const FilmInTime& now) const {
  const Tableau by = method_at(now);
  SuppliesStar star{by.a[i][i] * dt, vessels_begun_, oil_in_pockets(model_, now.film)};
  for (int j = 0; j < i; ++j) {
    add(by.a[i][j] * dt, vessels_.slopes(stages[j].flows), star.vessels);
    add(by.a[i][j] * dt, stages[j].flows.pocket, star.pockets);
  }
  return star;
}

Verdict FilmSteps::solve_film_and_fronts(const SuppliesStar& star, FilmEquilibrium& film,
                                         EquilibriumCost& cost, const std::atomic<bool>* stop) {
  if (model_.input.model.methods.transport == FillTransport::upwind) {
    return solve_film(star, options_, film, cost, stop);
  }
  EquilibriumOptions loose = options_;
  loose.film_tolerance = kFilmOfFronts;
  loose.load_tolerance *= kLooser;
  loose.elastic_tolerance *= kLooser;
  loose.viscosity_tolerance *= kLooser;
  const Verdict v = solve_film(star, loose, film, cost, stop);
  if (!v.good()) return v;
  point_.scene.storage.front = fronts_of(film);
  return solve_film(star, options_, film, cost, stop);
}

double FilmSteps::filled_in(double own, const FilmEquilibrium& film) const {
  constexpr double kLeast = 1e-4;  // the film of a bearing at rest is not known better
  const Field oil = fluid::oil_content(point_.scene, film.gap, film.oil, film.film);
  const FilmGrid& g = model_.domain.grid;
  const double flown = own * fluid::flow_scale(film.flow);       // of the part that is solved
  const double held = area_integral(g, oil) / g.multiplicity();  // there, too
  return flown > held ? std::max(kLeast, held / flown) : 1.0;
}

Verdict FilmSteps::solve_film(const SuppliesStar& star, const EquilibriumOptions& options,
                              FilmEquilibrium& film, EquilibriumCost& cost,
                              const std::atomic<bool>* stop) {
  EquilibriumOptions within = options;
  within.film_tolerance *= filled_in(star.own, film);
  if (vessels_.any()) {
    // A hundredth of the gap may be all that a vessel holds.
    constexpr double kLeast = 1e-10;  // what the elastic surfaces can be solved to
    within.elastic_tolerance =
        std::min(within.elastic_tolerance, std::max(kLeast, vessels_.gap_known_to(star.pockets)));
  }
  const auto solve = [&] {
    return newton({model_, point_, widening_, within, stop, &memory_}, film, cost);
  };
  if (!vessels_.any()) return solve();
  return vessels_.solve(star.own, star.vessels, point_.scene, [&](fluid::OilFlows& flows) {
    fluid::impose_supply(point_.scene.supply, film.film);
    Verdict v = solve();
    flows = fluid::oil_flows(point_.scene, film.flow);
    count_pockets(model_, film, star.pockets, star.own, flows);
    return v;
  });
}

void FilmSteps::carry_on(const FilmTrend& trend, double ahead, FilmEquilibrium& film) const {
  constexpr double kMost = 0.3;  // of the room that is left
  if (trend.p.empty()) return;
  double move = std::hypot(trend.q[0], trend.q[1]);
  if (!trend.elastic.empty()) move = std::max(move, largest_magnitude(trend.elastic));
  const double most = kMost * room(model_, film);
  if (ahead * move > most) ahead = std::max(most / move, 0.0);
  const double p_cavitation = model_.domain.p_cavitation;
  for (std::size_t c = 0; c < trend.p.size(); ++c) {
    if (model_.supply.cell[c] >= 0) continue;
    double& p = film.film.p[c];
    double& theta = film.film.theta[c];
    if (film.film.full[c]) {
      p += ahead * trend.p[c];
      film.film.full[c] = p >= p_cavitation;
    } else {
      theta = std::max(theta + ahead * trend.theta[c], 0.0);
      film.film.full[c] = theta >= 1.0;
    }
    p = std::max(p, p_cavitation);
    theta = std::min(theta, 1.0);
  }
  for (std::size_t c = 0; c < film.elastic.size(); ++c) film.elastic[c] += ahead * trend.elastic[c];
  for (int k = 0; k < point_.load.unknowns; ++k) film.position.q[k] += ahead * trend.q[k];
}

namespace {

/// (3), from the film at the last stage but one and at the step's end [Pa].
Field told_pressure(const Tableau& by, const State& between, const State& end) {
  Field p = end.film.p;
  if (by.explicit_first) return p;
  for (std::size_t c = 0; c < p.size(); ++c) {
    p[c] = by.b(0) * between.film.p[c] + by.b(1) * end.film.p[c];
  }
  return p;
}

}  // namespace

void FilmSteps::sum_up(const Tableau& by, double dt, const std::vector<FilmStage>& stages,
                       FilmStep& step) const {
  for (int i = 0; i < by.stages; ++i) {
    const double f = by.b(i) * dt;
    add(f, stages[i].oil, step.after.oil);
    step.supply += f * stages[i].flows.supply;
    step.patch.resize(stages[i].flows.patch.size(), 0.0);
    add(f, stages[i].flows.patch, step.patch);
    add(-f, stages[i].flows.pocket, step.patch);
    step.side += f * stages[i].flows.side;
    step.side_inflow += f * stages[i].flows.side_inflow;
    step.line += f * vessels_.from_lines(stages[i].flows);
    add(f, vessels_.slopes(stages[i].flows), step.after.vessels);
    step.layer_loss += f * stages[i].layer.loss;
    for (int k = 0; k < 2; ++k) step.impulse[k] += f * stages[i].force[k];
  }
}

FilmStep FilmSteps::take(double dt, const FilmInTime& now, EquilibriumCost& cost,
                         const std::atomic<bool>* stop) {
  const Tableau by = method_at(now);
  FilmStep step;
  vessels_begun_ = now.vessels;
  memory_ = {};  // no step hangs on what was solved before it: runs go on as if never stopped
  if (drillings_.any()) drillings_.take(model_, now.film);
  step.line = vessels_.set_lines(now.t + 0.5 * dt, vessels_begun_);
  std::vector<FilmStage> stages(by.stages);
  FilmEquilibrium film = now.film;
  if (by.explicit_first) {
    stages[0] = {now.oil_slope, now.velocity, now.acceleration, now.flows, {}, 0.0, {}, now.layer};
    stages[0].heat.held_slope = now.heat.held_slope;
    stages[0].heat.skin_slope = now.heat.skin_slope;
    for (int k = 0; k < 2; ++k) stages[0].force[k] = now.film.force[k];
  }
  State between;  // the last stage but one
  for (int i = by.explicit_first ? 1 : 0; i < by.stages; ++i) {
    if (i + 1 == by.stages) between = film;
    step.verdict = solve_stage(i, dt, stages, now, film, stages[i], cost, stop);
    if (!step.verdict.good()) return step;
    step.off_balance = std::max(step.off_balance, stages[i].off_balance);
  }
  step.p = told_pressure(by, between, film);
  step.error = error_of(now, film, stages, dt);
  if (std::isnan(step.error)) {
    const bool by_heat = heat_ && std::isnan(heat_->surprise(model_, film, stages.back().heat.T));
    const FieldName field = by_heat ? FieldName::film_temperature : FieldName::gap;
    step.verdict = {Status::invalid_number, ending::NotANumber{field}};
    return step;
  }
  step.after.oil = now.oil;
  step.after.vessels = vessels_begun_;
  sum_up(by, dt, stages, step);
  step.off_content = off_content(point_.scene, film, step.after.oil);
  if (heat_) end_heat(dt, now, film, stages, step);
  FilmStage& last = stages.back();
  step.after.t = now.t + dt;
  step.after.full_before = now.film.film.full;
  step.after.thermal_deformation = now.thermal_deformation;
  step.after.trend = FilmTrend(between, film, (1.0 - by.c[by.stages - 2]) * dt);
  step.after.film = std::move(film);
  step.after.velocity = last.velocity;
  step.after.acceleration = last.acceleration;
  step.after.oil_slope = std::move(last.oil);
  step.after.flows = std::move(last.flows);
  step.after.layer = std::move(last.layer);  // stiffly accurate: the last stage is the end
  return step;
}

FilmSteps::Supplies FilmSteps::supplies() const {
  return {vessels_, point_.scene.supply.patches, point_.scene.supply.mouths};
}

void FilmSteps::put_back(const Supplies& before) {
  vessels_ = before.vessels;
  point_.scene.supply.patches = before.patches;
  point_.scene.supply.mouths = before.mouths;
}

}  // namespace shellback::bearing
