#include "bearing/over_time/cycle_record.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bearing/film/effect_numbers.hpp"
#include "bearing/film/fed_flow.hpp"
#include "bearing/film/pockets.hpp"
#include "bearing/heat/film_heat.hpp"
#include "bearing/over_time/tape_members.hpp"
#include "bearing/steady/audit.hpp"
#include "bearing/told_ranges.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

constexpr int kFrames = 48;  ///< films that are kept: every 15 degrees of two turns

double total(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

}  // namespace

CycleRecord::CycleRecord(const FilmSteps& film, const LoadCourse& course, double length)
    : film_(&film), course_(&course), length_(length) {}

double CycleRecord::oil_in_gap(const Field& oil) const {
  return area_integral(film_->model().domain.grid, oil);
}

Field CycleRecord::shell_surface(const FilmInTime& now) const {
  const auto n = static_cast<std::size_t>(film_->model().gl.n);
  const HeatSteps& heat = *film_->heat();
  const auto nodes = static_cast<std::size_t>(heat.skin().nodes());
  Field T(now.oil.size());
  for (std::size_t c = 0; c < T.size(); ++c) {
    // the film's node of a supply that exchanges no heat with it is the oil there
    const bool wall = meets_walls(film_->model(), static_cast<int>(c));
    T[c] = wall ? now.heat.T[c * n] : heat.walls.shell[c] + now.heat.skin[c * nodes];
  }
  return T;
}

namespace {

/// Mean of a b over a step along which both are straight.
double mean_product(double a, double b, double a_end, double b_end) {
  return (2.0 * (a * b + a_end * b_end) + a * b_end + a_end * b) / 6.0;
}

/// Work of a force, straight over a step, on what moves by `way` with a straight velocity.
double work_over(double force, double force_end, double way, double more_velocity, double dt) {
  return 0.5 * (force + force_end) * way + dt * (force_end - force) * more_velocity / 12.0;
}

}  // namespace

double CycleRecord::work_of_moment(const CycleInstant& from, const CycleInstant& to) const {
  return film_->point().load.work_of_moment(to.tilt_x - from.tilt_x, to.tilt_y - from.tilt_y);
}

double CycleRecord::work_of(const CycleInstant& from, const CycleInstant& to, double t) const {
  const LoadNow begun = course_->at(t - to.dt + kRoundOff * length_);  // behind a jump
  return to.dt * mean_product(from.torque, begun.omega, to.torque, to.omega) +
         work_over(begun.x, to.load_x, to.ex - from.ex, to.vx - from.vx, to.dt) +
         work_over(begun.y, to.load_y, to.ey - from.ey, to.vy - from.vy, to.dt) +
         work_of_moment(from, to);
}

double CycleRecord::stored_by_surfaces(const FilmInTime& now) const {
  const FilmGrid& g = film_->model().domain.grid;
  const FilmEquilibrium& f = now.film;
  double sum = 0.0;
  if (f.elastic.empty()) return sum;
  for (int c = 0; c < g.cells(); ++c) {
    const double straight = f.elastic[c] - (f.layer.empty() ? 0.0 : f.layer[c].now.sum());
    sum += 0.5 * (f.film.p[c] + f.p_contact[c]) * straight * g.area(c);
  }
  return g.multiplicity() * sum;
}

void CycleRecord::add_contact(const FilmEquilibrium& f, CycleInstant& i) {
  const BearingModel& m = film_->model();
  const AsperityStress tau = asperity_stress(m, film_->point(), f);
  power_now_ = sum(power_now_, tau.sum());
  if (!m.input.surfaces.contact->friction_law) return;
  i.torque_abrasive = fluid::torque(m.domain, tau.abrasive);
  i.torque_adhesive = fluid::torque(m.domain, tau.adhesive);
  i.torque_micro_hydrodynamic = fluid::torque(m.domain, tau.micro_hydrodynamic);
}

CycleInstant CycleRecord::instant_of(const FilmInTime& now, const Field& p, double dt) {
  const BearingModel& m = film_->model();
  const FilmEquilibrium& f = now.film;
  const double t = instants_.empty() ? 0.0 : instants_.back().t + dt;
  const LoadNow load = course_->at(now.t, true);
  const Friction friction = friction_of(m, film_->point(), f);
  sheared_ = worse(sheared_, sheared_oil(m.domain.grid, p, friction.stress.journal));
  const double U = film_->point().scene.speed;
  shear_rate_ = larger(shear_rate_, largest_shear_rate(now.film.film, now.film.shear_gap, U));
  p_slope_ = larger(p_slope_, largest_slope(m.domain.grid, p));
  CycleInstant i;
  i.t = t;
  i.dt = dt;
  i.load_x = load.x;
  i.load_y = load.y;
  i.omega = load.omega;
  i.ex = f.position.ex();
  i.ey = f.position.ey();
  i.vx = now.velocity[0];
  i.vy = now.velocity[1];
  i.tilt_x = f.position.psi_x();
  i.tilt_y = f.position.psi_y();
  i.h_min = f.least.h;
  i.h_min_angle = f.least.phi;
  i.p_max = largest(p);
  i.p_asperity_max = largest(f.p_contact);
  i.torque = friction.torque();
  i.torque_asperity = friction.asperity;
  off_moment_ = larger(off_moment_, std::abs(moment_imbalance(m, film_->point(), f, friction)));
  if (m.physics.elastic)
    opening_ = larger(opening_, largest(f.elastic) / yielding_film(m, f.least.h));
  i.power = i.torque * load.omega + load.x * i.vx + load.y * i.vy;
  if (dt > 0.0) i.power += work_of_moment(instants_.back(), i) / dt;
  i.oil = oil_in_gap(now.oil);
  if (film_->vessels().any()) i.p_vessel = film_->vessels().least_pressure(now.vessels);
  if (film_->heat() && !now.heat.T.empty()) {
    i.T_film_max = largest(now.heat.T);
    i.T_shell_max = largest(shell_surface(now));
  }
  pump_now_ = pump_power(m, film_->point(), f);
  power_now_ = friction.stress.journal;
  if (m.contact) add_contact(f, i);
  for (double& power : power_now_) power *= film_->point().scene.speed;
  if (load.omega == 0.0) i.breakaway = breakaway_torque(m, film_->point(), f);
  return i;
}

void CycleRecord::begin(const FilmInTime& now) {
  CycleInstant first = instant_of(now, now.film.film.p, 0.0);
  const double rho = reference_density(film_->model());
  first.supply_flow = now.flows.supply / rho;
  first.side_flow = now.flows.side / rho;
  oil_begun_ = oil_ended_ = first.oil + total(oil_in_pockets(film_->model(), now.film));
  stored_begun_ = stored_ended_ = stored_by_surfaces(now);
  v_begun_ = v_ended_ = now.velocity;
  vessels_begun_ = vessels_ended_ = total(now.vessels);
  p_max_ = now.film.film.p;
  p_asperity_max_ = now.film.p_contact;
  h_min_ = fluid::nominal_depth(now.film.gap, film_->model().supply);
  bent_edges_ = fluid::bent_edges(now.film.gap);
  friction_.assign(p_max_.size(), 0.0);
  if (const auto& worn = film_->model().input.running_in) {
    wear_.begin(wear_load_of(film_->model(), film_->point(), now.film, worn->limit_pressure));
  }
  if (film_->heat()) {
    T_shell_.assign(p_max_.size(), 0.0);
    T_shell_max_ = shell_surface(now);
    const FilmGrid& g = film_->model().domain.grid;
    const HeatFlows& flows = now.heat.flows;
    // Between new walls no step has told any yet.
    if (!flows.to_shell.empty()) first.heat_to_shell = first.heat_to_shaft = 0.0;
    for (std::size_t c = 0; c < flows.to_shell.size(); ++c) {
      const double area = g.multiplicity() * g.area(static_cast<int>(c));
      first.heat_to_shell += area * flows.to_shell[c];
      first.heat_to_shaft += area * flows.to_shaft[c];
    }
  }
  instants_.push_back(first);
  keep_frame(now, now.film.film.p);
}

void CycleRecord::gather_fields(const FilmInTime& now, const Field& p, double dt) {
  const Field before = power_now_;
  const double pump_before = pump_now_;
  instants_.push_back(instant_of(now, p, dt));
  pump_ += 0.5 * dt * (pump_before + pump_now_);
  bent_edges_ = std::max(bent_edges_, fluid::bent_edges(now.film.gap));
  fed_fastest_ = worse(fed_fastest_, fed_flow(film_->point().scene, now.film));
  const Field h = fluid::nominal_depth(now.film.gap, film_->model().supply);
  for (std::size_t c = 0; c < p_max_.size(); ++c) {
    p_max_[c] = larger(p_max_[c], p[c]);
    p_asperity_max_[c] = larger(p_asperity_max_[c], now.film.p_contact[c]);
    h_min_[c] = std::min(h_min_[c], h[c]);
    friction_[c] += 0.5 * dt * (before[c] + power_now_[c]);
  }
  if (const auto& worn = film_->model().input.running_in) {
    wear_.add(wear_load_of(film_->model(), film_->point(), now.film, worn->limit_pressure), dt);
  }
  keep_frame(now, p);
}

void CycleRecord::keep_frame(const FilmInTime& now, const Field& p) {
  const std::vector<double>& at = film_->model().input.cycle->fields_at;
  const double round = kRoundOff * length_;
  const auto is_now = [&](double t) { return std::abs(t - told()) <= round; };
  const bool due =
      at.empty() ? told() >= next_frame_ - round : std::any_of(at.begin(), at.end(), is_now);
  if (!due) return;
  const FilmGrid& g = film_->model().domain.grid;
  frames_.push_back({told(), mirror_to_full(g, p), mirror_to_full(g, now.film.film.theta),
                     mirror_to_full(g, fluid::nominal_depth(now.film.gap, film_->model().supply))});
  const double between = length_ / kFrames;
  next_frame_ = between * (std::floor((told() + round) / between) + 1.0);
}

void CycleRecord::gather_heat(const FilmStep& step, double dt) {
  const FilmGrid& g = film_->model().domain.grid;
  heat_.add(1.0, step.heat);
  const Field T = shell_surface(step.after);
  CycleInstant& i = instants_.back();
  i.heat_to_shell = i.heat_to_shaft = 0.0;
  const CrossFilmNodes& gl = film_->model().gl;
  double mass = 0.0;
  double by_mass = 0.0;
  for (int c = 0; c < g.cells(); ++c) {
    const double oil = step.after.oil[c] * g.area(c);
    mass += oil;
    for (int k = 0; k < gl.n; ++k) {
      by_mass += oil * gl.w[k] * step.after.heat.T[static_cast<std::size_t>(c) * gl.n + k];
    }
    T_shell_[c] += dt * T[c];
    T_shell_max_[c] = larger(T_shell_max_[c], T[c]);
    const double area = g.multiplicity() * g.area(c);
    i.heat_to_shell += area * step.heat.to_shell[c] / dt;
    i.heat_to_shaft += area * step.heat.to_shaft[c] / dt;
  }
  T_film_ += dt * by_mass / mass;
}

void CycleRecord::add(const FilmStep& step, double dt, const SolveControl& control) {
  gather_fields(step.after, step.p, dt);
  CycleInstant& i = instants_.back();
  work_ += work_of(instants_[instants_.size() - 2], i, step.after.t);
  const double rho = reference_density(film_->model());
  i.supply_flow = step.supply / dt / rho;
  i.side_flow = step.side / dt / rho;
  if (film_->heat()) {
    gather_heat(step, dt);
  } else {
    T_film_ = told() * step.after.film.columns.T.front();  // the same at all places and instants
  }
  oil_ended_ = i.oil + total(oil_in_pockets(film_->model(), step.after.film));
  v_ended_ = step.after.velocity;
  stored_ended_ = stored_by_surfaces(step.after);
  supply_ += step.supply;
  fed_.resize(step.patch.size(), 0.0);
  for (std::size_t k = 0; k < fed_.size(); ++k) fed_[k] += step.patch[k];
  side_ += step.side;
  side_inflow_ += step.side_inflow;
  line_ += step.line;
  vessels_ended_ = total(step.after.vessels);
  if (film_->vessels().any_empty(film_->point().scene)) dry_ += dt;
  for (int k = 0; k < 2; ++k) impulse_[k] += step.impulse[k];
  off_balance_ = larger(off_balance_, step.off_balance);
  const double sides = film_->model().domain.grid.multiplicity();
  off_content_ = larger(off_content_, sides * step.off_content / i.oil);
  layer_loss_ += step.layer_loss;
  layer_depth_ = lasting_depth(step.after.layer.now);
  if (control.progress) {
    control.progress(
        {"cycle", static_cast<int>(instants_.size()) - 1, told() / length_, i.torque, i.h_min});
  }
}

void CycleRecord::members(Tape& tape) {
  auto& [film, course, length, instants, frames, next_frame, oil_begun, oil_ended, supply, side,
         side_inflow, fed, line, vessels_begun, vessels_ended, dry, impulse, v_begun, v_ended,
         pump_now, pump, off_balance, off_moment, opening, off_content, stored_begun, stored_ended,
         work, layer_loss, layer_depth, p_max, p_asperity_max, h_min, friction, power_now, heat,
         T_film, T_shell, T_shell_max, wear, bent_edges, fed_fastest, sheared, shear_rate,
         p_slope] = *this;
  tape(instants, frames, next_frame, oil_begun, oil_ended, supply, side, side_inflow, fed, impulse,
       v_begun, v_ended, line, vessels_begun, vessels_ended, dry, stored_begun, stored_ended, work,
       layer_loss, layer_depth);
  tape(pump_now, pump, off_balance, off_moment, opening, off_content, p_max, p_asperity_max, h_min,
       friction, power_now, heat, T_film, T_shell, T_shell_max, wear, bent_edges, fed_fastest,
       sheared, shear_rate, p_slope);
}

}  // namespace shellback::bearing
