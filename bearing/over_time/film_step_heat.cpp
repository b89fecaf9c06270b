/// Heat of one step in time: temperatures of film and skin, growth of the walls.

#include "bearing/film/pockets.hpp"
#include "bearing/over_time/film_step.hpp"

namespace shellback::bearing {
namespace {

/// Temperatures at stage i in a straight line from those with which the step has begun: through
/// the stage before if there is one, or along their slope.
std::vector<double> carried_on(const Tableau& by, int i, double dt,
                               const std::vector<double>& begun, const std::vector<double>& slope,
                               const std::vector<double>* stage_before) {
  std::vector<double> T = begun;
  if (!stage_before) {
    if (!slope.empty()) add(by.c[i] * dt, slope, T);
    return T;
  }
  // From the first stage of a step that begins anew nothing is carried on: it still settles.
  const double part = by.explicit_first ? by.c[i] / by.c[i - 1] : 1.0;
  for (std::size_t k = 0; k < T.size(); ++k) T[k] += part * ((*stage_before)[k] - T[k]);
  return T;
}

}  // namespace

void FilmSteps::expect_temperatures(int i, double dt, const std::vector<FilmStage>& stages,
                                    const FilmInTime& now, FilmEquilibrium& film) {
  const Tableau by = method_at(now);
  const HeatStage* before = i > (by.explicit_first ? 1 : 0) ? &stages[i - 1].heat : nullptr;
  film.columns.T =
      carried_on(by, i, dt, now.heat.T, now.heat.T_slope, before ? &before->T : nullptr);
  const std::vector<double> skin =
      carried_on(by, i, dt, now.heat.skin, now.heat.skin_slope, before ? &before->skin : nullptr);
  widening_ = widening_at(now.t + by.c[i] * dt, skin);
}

Field FilmSteps::widening_at(double t, const std::vector<double>& skin) const {
  Field widening = heat_->walls.thermal_deformation;
  const double part = (t - growth_.begun) / growth_.length;
  if (!growth_.from.empty() && part < 1.0) {
    const double left = (1.0 - part) * (1.0 - part) * (1.0 + 2.0 * part);  // smooth at both ends
    for (std::size_t c = 0; c < widening.size(); ++c) {
      widening[c] += left * (growth_.from[c] - widening[c]);
    }
  }
  if (!widening.empty()) add(-1.0, heat_->swelling(model_, skin), widening);
  return widening;
}

bool FilmSteps::leave_room(const WallMeans& walls, const FilmInTime& now) const {
  FilmEquilibrium middle = now.film;
  middle.position.q[0] = middle.position.q[1] = 0.0;
  return evaluate(model_, point_, walls.thermal_deformation, options_.viscosity_tolerance, middle);
}

void FilmSteps::renew_heat(FilmInTime& now) const {
  if (!heat_) return;
  std::vector<double> skin = std::move(now.heat.skin);
  now.heat = heat_->begin(model_, now.film.columns.T, per_cell(model_.domain.grid, now.oil));
  if (!skin.empty()) now.heat.skin = std::move(skin);
}

bool FilmSteps::set_walls(WallMeans walls, double period, double shortest, FilmInTime& now) {
  constexpr double kGrows = 0.1;  // of the period: docs/decisions/039
  const bool first = !heat_;
  if (first) heat_.emplace(model_, period, shortest);
  const FilmGrid& g = model_.domain.grid;
  const int n = model_.gl.n;
  const auto nodes = static_cast<std::size_t>(heat_->skin().nodes());
  // From cycle to cycle the film goes on from the temperatures that were found, not from those that
  // they were carried on to, and the bore's skin from where it swings at this instant.
  if (!first) now.film.columns.T = now.heat.T;
  for (int c = 0; c < g.cells(); ++c) {
    if (!meets_walls(model_, c)) continue;
    const double swing = first || now.heat.skin.empty() ? 0.0 : now.heat.skin[c * nodes];
    now.film.columns.T[static_cast<std::size_t>(c) * n] = walls.shell[c] + swing;
    now.film.columns.T[static_cast<std::size_t>(c) * n + n - 1] = walls.shaft[c % g.nz];
  }
  const double deformation_now = mean_deformation(walls);
  const double wider =
      (model_.clearance + deformation_now) / (model_.clearance + now.thermal_deformation);
  now.thermal_deformation = deformation_now;
  now.oil_slope.clear();
  if (first) {
    heat_->walls = std::move(walls);
    now.heat = heat_->begin(model_, now.film.columns.T, per_cell(g, now.oil));
    widening_ = widening_at(now.t, now.heat.skin);
    for (int k = 0; k < 2; ++k) now.film.position.q[k] *= wider;
    if (!reshape(now)) return false;
  } else {
    if (!leave_room(walls, now)) return false;
    growth_ = {widening_, now.t, kGrows * period};
    if (!widening_.empty()) add(1.0, heat_->swelling(model_, now.heat.skin), growth_.from);
    heat_->walls = std::move(walls);
  }
  renew_heat(now);
  return true;
}

void FilmSteps::hold_walls(FilmInTime& now) {
  now.heat.skin.assign(now.heat.skin.size(), 0.0);
  now.heat.skin_slope.assign(now.heat.skin.size(), 0.0);
}

void FilmSteps::rest_walls(FilmInTime& now) {
  const HeatFlows& flows = now.heat.flows;
  if (!heat_ || flows.to_shell.empty()) return;
  heat_->walls.flux = flows.to_shell;
  heat_->walls.shaft_flux = mean_of_rings(model_, per_cell(model_.domain.grid, flows.to_shaft));
  hold_walls(now);
}

Verdict FilmSteps::solve_heat(int i, double dt, const std::vector<FilmStage>& stages,
                              const FilmInTime& now, const FilmEquilibrium& film,
                              FilmStage& found) const {
  const Tableau by = method_at(now);
  const double own = by.a[i][i] * dt;
  std::vector<double> held = now.heat.held;
  std::vector<double> skin = now.heat.skin;
  for (int j = 0; j < i; ++j) {
    add(by.a[i][j] * dt, stages[j].heat.held_slope, held);
    add(by.a[i][j] * dt, stages[j].heat.skin_slope, skin);
  }
  const FilmGrid& g = model_.domain.grid;
  Field after = point_.scene.storage.before;
  add(own, found.oil, after);
  found.heat = heat_->stage(model_, point_, film, own, per_cell(g, point_.scene.storage.before),
                            per_cell(g, std::move(after)), held, skin);
  for (int k = 0; k < 2; ++k) found.heat.flows.work -= film.force[k] * found.velocity[k];
  if (found.heat.possible && found.heat.settled) return {};
  return {Status::iteration_limit,
          found.heat.possible ? ending::Plain::film_unsettled : ending::Plain::film_impossible};
}

void FilmSteps::end_heat(double dt, const FilmInTime& now, const FilmEquilibrium& film,
                         std::vector<FilmStage>& stages, FilmStep& step) const {
  const Tableau by = method_at(now);
  HeatStage& last = stages.back().heat;
  HeatInTime& heat = step.after.heat;
  heat.held = now.heat.held;
  for (int i = 0; i < by.stages; ++i) {
    const bool before = by.explicit_first && i == 0;
    add(by.b(i) * dt, stages[i].heat.held_slope, heat.held);
    step.heat.add(by.b(i) * dt, before ? now.heat.flows : stages[i].heat.flows);
  }
  heat.T_slope = last.T;
  for (std::size_t k = 0; k < heat.T_slope.size(); ++k) {
    heat.T_slope[k] = (heat.T_slope[k] - now.heat.T[k]) / dt;
  }
  heat.T = std::move(last.T);
  heat.skin = std::move(last.skin);
  heat.held_slope = std::move(last.held_slope);
  heat.skin_slope = std::move(last.skin_slope);
  heat.flows = std::move(last.flows);
  step.heat.work += work_of_growth(now, now.t + dt, film, heat.skin);
  step.heat.work += work_on_pockets(model_, now.film, film);
  const auto& tilt = film.position;
  const auto& before = now.film.position;
  step.heat.work +=
      point_.load.work_of_moment(tilt.psi_x() - before.psi_x(), tilt.psi_y() - before.psi_y());
}

double FilmSteps::work_of_growth(const FilmInTime& now, double t, const FilmEquilibrium& film,
                                 const std::vector<double>& skin) const {
  const FilmGrid& g = model_.domain.grid;
  const Field before = widening_at(now.t, now.heat.skin);
  const Field behind = widening_at(t, skin);
  double work = 0.0;
  for (std::size_t c = 0; c < behind.size(); ++c) {
    const auto pressure = [c](const FilmEquilibrium& f) { return f.film.p[c] + f.p_contact[c]; };
    const double mean = 0.5 * (pressure(now.film) + pressure(film));
    const int cell = static_cast<int>(c);
    work += mean * (before[c] - behind[c]) * g.area(cell);
  }
  return g.multiplicity() * work;
}

}  // namespace shellback::bearing
