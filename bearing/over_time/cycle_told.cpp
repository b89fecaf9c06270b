/// What a record of a cycle tells once it has been passed: its numbers, its audit, how it closes.

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "bearing/film/effect_numbers.hpp"
#include "bearing/film/fed_flow.hpp"
#include "bearing/heat/film_heat.hpp"
#include "bearing/over_time/cycle_instants.hpp"
#include "bearing/over_time/cycle_record.hpp"
#include "bearing/told_ranges.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"
#include "rheology/heat.hpp"

namespace shellback::bearing {
namespace {

struct LiftOff {
  double t = 0.0;      ///< [s]
  double omega = 0.0;  ///< [rad/s]
};

/// When, behind a rest in contact, asperities come to rub with a hundredth of the breakaway torque;
/// none: no start, or none that ends in a full film. Between instants their torque falls about
/// exponentially, as the tail of the heights does.
std::optional<LiftOff> lift_off(const std::vector<CycleInstant>& all, double slow) {
  constexpr double kLifted = 0.01;  // a hundredth of a torque is not seen in any measured one
  double breakaway = 0.0;
  for (std::size_t k = 1; k < all.size(); ++k) {
    const CycleInstant& i = all[k];
    if (all[k - 1].omega == 0.0) breakaway = all[k - 1].breakaway;
    if (std::abs(i.omega) <= slow || breakaway == 0.0) continue;
    const double wanted = kLifted * breakaway;
    const double now = std::abs(i.torque_asperity);
    const double before = std::abs(all[k - 1].torque_asperity);
    if (now >= wanted) continue;
    const bool between = before > wanted && now > 0.0;
    const double part = between ? std::log(before / wanted) / std::log(before / now) : 1.0;
    return LiftOff{all[k - 1].t + part * i.dt,
                   all[k - 1].omega + part * (i.omega - all[k - 1].omega)};
  }
  return std::nullopt;
}

double largest_torque(const std::vector<CycleInstant>& all) {
  double most = 0.0;
  for (const CycleInstant& i : all) most = larger(most, std::abs(i.torque));
  return most;
}

}  // namespace

std::vector<CycleQuantity> CycleRecord::quantities() const {
  std::vector<CycleQuantity> out;
  const auto add_mean = [&](const char* name, double CycleInstant::*v) {
    out.push_back(mean_quantity(name, instants_, v));
  };
  const auto add_extreme = [&](const char* name, double CycleInstant::*v, Extreme which) {
    out.push_back(extreme_of(name, instants_, v, which));
  };
  add_mean("friction_torque", &CycleInstant::torque);
  add_mean("friction_torque_asperity", &CycleInstant::torque_asperity);
  if (std::isfinite(instants_.front().torque_abrasive)) {
    add_mean("friction_torque_abrasive", &CycleInstant::torque_abrasive);
    add_mean("friction_torque_adhesive", &CycleInstant::torque_adhesive);
    add_mean("friction_torque_micro_hydrodynamic", &CycleInstant::torque_micro_hydrodynamic);
  }
  out.push_back(quantity_of("power_loss", work_ / told()));
  out.back().quantity.magnitude = mean_magnitude_of(instants_, &CycleInstant::power);
  add_extreme("h_min", &CycleInstant::h_min, Extreme::smallest);
  add_extreme("p_max", &CycleInstant::p_max, Extreme::largest);
  if (film_->model().contact) {
    add_extreme("p_asperity_max", &CycleInstant::p_asperity_max, Extreme::largest);
  }
  if (extreme(instants_, &CycleInstant::breakaway, Extreme::largest).breakaway > 0.0) {
    add_extreme("breakaway_torque", &CycleInstant::breakaway, Extreme::largest);
    const double slow = solid::BoundaryFriction::kSliding / film_->model().domain.grid.radius;
    if (const auto lifted = lift_off(instants_, slow)) {
      out.push_back(quantity_of("lift_off_speed", lifted->omega, lifted->t));
    }
  }
  const double rho = reference_density(film_->model());
  out.push_back(quantity_of("side_flow", side_ / told() / rho));
  out.push_back(quantity_of("supply_flow", supply_ / told() / rho));
  if (film_->vessels().any())
    add_extreme("p_vessel_min", &CycleInstant::p_vessel, Extreme::smallest);
  if (!layer_depth_.empty()) {
    out.push_back(quantity_of("layer_depth", largest(layer_depth_), instants_.back().t));
    out.push_back(quantity_of("layer_loss",
                              film_->model().domain.grid.multiplicity() * layer_loss_ / told()));
  }
  if (heat_.to_shell.empty()) {
    out.push_back(quantity_of("T_film_mean", T_film_ / told()));
  } else {
    add_heat(out);
  }
  return out;
}

void CycleRecord::add_heat(std::vector<CycleQuantity>& out) const {
  out.push_back(extreme_of("T_film_max", instants_, &CycleInstant::T_film_max, Extreme::largest));
  out.push_back(quantity_of("T_film_mean", T_film_ / told()));
  out.push_back(extreme_of("T_shell_max", instants_, &CycleInstant::T_shell_max, Extreme::largest));
  const double both = film_->model().domain.grid.multiplicity();
  const auto& b = heat_.balance;
  out.push_back(quantity_of("heat_by_oil", both * (b.carried_out - b.carried_in) / told()));
  const HeatTaken taken = heat_taken();
  out.push_back(quantity_of("heat_to_shell", taken.shell));
  out.push_back(quantity_of("heat_to_shaft", taken.shaft));
}

HeatTaken CycleRecord::heat_taken() const {
  const auto over_area = [&](const Field& heat) {
    return area_integral(film_->model().domain.grid, heat) / told();
  };
  return {over_area(heat_.to_shell), over_area(heat_.to_shaft)};
}

CycleAudit CycleRecord::audit() const {
  CycleAudit a;
  const double gathered = oil_ended_ - oil_begun_;
  const double in_vessels = vessels_ended_ - vessels_begun_;
  a.mass = larger(std::abs(supply_ - side_ - gathered),
                  std::abs(line_ - side_ - gathered - in_vessels)) /
           oil_ended_;
  a.content = off_content_;
  a.load = off_balance_ / course_->largest_load();
  a.impulse = NAN;
  a.moment = off_moment_ / std::max(largest_torque(instants_), 1e-300);
  if (!heat_.to_shell.empty()) {
    const double both = film_->model().domain.grid.multiplicity();
    a.energy = std::abs(heat_.balance.imbalance()) / heat_.balance.heat;
    const double made = heat_.balance.heat + heat_.rubbed + layer_loss_;
    a.work = (heat_.work - both * made - (stored_ended_ - stored_begun_)) / heat_.work;
  }
  if (std::abs(told() / length_ - 1.0) > kRoundOff) return a;  // stopped before the end
  const auto load = course_->impulse();
  double off = 0.0;
  for (int k = 0; k < 2; ++k) {
    off =
        larger(off, std::abs(impulse_[k] + load[k] - film_->mass() * (v_ended_[k] - v_begun_[k])));
  }
  a.impulse = off / (course_->largest_load() * length_);
  return a;
}

CycleMeans CycleRecord::means() const {
  CycleMeans m{mean_of(instants_, &CycleInstant::torque),
               mean_of(instants_, &CycleInstant::torque_asperity),
               T_film_ / told(),
               (work_ + pump_) / told(),
               side_ / told(),
               fed_};
  for (double& fed : m.fed) fed /= told();
  return m;
}

double CycleRecord::part_of_vessels(double oil) const {
  const std::vector<double> vessels = film_->vessels().full();
  const double full = std::accumulate(vessels.begin(), vessels.end(), 0.0);
  return full > 0.0 ? std::abs(oil) / full : 0.0;
}

double CycleRecord::oil_drift() const {
  return larger(std::abs(oil_gathered()), part_of_vessels(vessels_ended_ - vessels_begun_));
}

double CycleRecord::momentum_drift() const {
  return part_of_impulse(std::hypot(v_ended_[0] - v_begun_[0], v_ended_[1] - v_begun_[1]));
}

double CycleRecord::part_of_impulse(double change) const {
  const double load =
      mean_over(instants_, [](const CycleInstant& i) { return std::hypot(i.load_x, i.load_y); });
  return load > 0.0 ? film_->mass() * change / (load * told()) : 0.0;
}

double CycleRecord::change_of_film(double h, double other) const {
  return std::abs(other - h) / yielding_gap(h, film_->model().domain.rough.sigma);
}

double CycleRecord::drift() const {
  const CycleInstant& first = instants_.front();
  const CycleInstant& last = instants_.back();
  const double most = larger(oil_drift(), change_of_film(first.h_min, last.h_min));
  const double torque = largest_torque(instants_);
  return torque > 0.0 ? larger(most, std::abs(last.torque - first.torque) / torque) : most;
}

std::vector<double> CycleRecord::mark() const {
  return {extreme(instants_, &CycleInstant::h_min, Extreme::smallest).h_min,
          largest_torque(instants_),
          mean_of(instants_, &CycleInstant::torque),
          oil_ended_,
          vessels_ended_,
          v_ended_[0],
          v_ended_[1]};
}

double CycleRecord::difference(const std::vector<double>& mark) const {
  const std::vector<double> own = this->mark();
  double most = larger(change_of_film(own[0], mark[0]), std::abs(mark[3] / own[3] - 1.0));
  most = larger(most, part_of_vessels(own[4] - mark[4]));
  most = larger(most, part_of_impulse(std::hypot(own[5] - mark[5], own[6] - mark[6])));
  if (own[1] == 0.0) return most;  // nothing turns
  for (const int k : {1, 2}) most = larger(most, std::abs(mark[k] - own[k]) / own[1]);
  return most;
}

double CycleRecord::difference(const CycleRecord& other) const {
  const double h = extreme(instants_, &CycleInstant::h_min, Extreme::smallest).h_min;
  const double h_other = extreme(other.instants_, &CycleInstant::h_min, Extreme::smallest).h_min;
  const double torque = largest_torque(instants_);
  double most = larger(larger(oil_drift(), momentum_drift()), change_of_film(h, h_other));
  if (torque == 0.0) return most;  // nothing turns
  most = larger(most, std::abs(largest_torque(other.instants_) - torque) / torque);
  const double change =
      mean_of(other.instants_, &CycleInstant::torque) - mean_of(instants_, &CycleInstant::torque);
  return larger(most, std::abs(change) / torque);
}

void CycleRecord::tell_missed_load(std::vector<Note>& warnings) const {
  constexpr double kMissed =
      0.1;                    // of the largest load: of a sine in steps of 30 degrees a fiftieth
  constexpr int kLooks = 32;  // in a step
  const double unit = course_->largest_load();
  note::LoadMissed most;
  for (std::size_t k = 1; k < instants_.size(); ++k) {
    const CycleInstant& end = instants_[k];
    const LoadNow a = course_->at(end.t - end.dt), b = course_->at(end.t, true);
    double x = 0.0, y = 0.0;  // mean of the load less that of its ends
    for (int i = 0; i < kLooks; ++i) {
      const LoadNow here = course_->at(end.t - end.dt * (i + 0.5) / kLooks);
      x += (here.x - 0.5 * (a.x + b.x)) / kLooks;
      y += (here.y - 0.5 * (a.y + b.y)) / kLooks;
    }
    const double part = unit > 0.0 ? std::hypot(x, y) / unit : 0.0;
    if (part > most.part) most = {part, end.t - end.dt, end.t};
  }
  if (most.part > kMissed) warnings.push_back(most);
}

void CycleRecord::write(CycleResult& r) const {
  const BearingModel& m = film_->model();
  const FilmGrid& g = m.domain.grid;
  r.title = m.input.title;
  r.period = length_;
  r.crank_speed = m.input.cycle->crank_speed;
  r.grid = {g.nt, g.full_nz()};
  r.warnings.assign(m.input.warnings.begin(), m.input.warnings.end());
  r.assumptions.assign(m.input.assumptions.begin(), m.input.assumptions.end());
  if (instants_.size() < 2) return;
  r.instants = instants_;
  if (course_->repeats() && std::isnan(r.instants.front().heat_to_shell)) {
    r.instants.front().heat_to_shell = r.instants.back().heat_to_shell;  // of the step before
    r.instants.front().heat_to_shaft = r.instants.back().heat_to_shaft;
  }
  r.quantities = quantities();
  r.audit = audit();
  r.fields.grid = full_grid(g);
  r.fields.p_max = mirror_to_full(g, p_max_);
  if (m.contact) r.fields.p_asperity_max = mirror_to_full(g, p_asperity_max_);
  r.fields.h_min = mirror_to_full(g, h_min_);
  r.fields.in_supply = mirror_to_full(g, fluid::in_supply(m.supply));
  Field friction = friction_;
  for (double& x : friction) x /= told();
  r.fields.friction_power = mirror_to_full(g, friction);
  if (!layer_depth_.empty()) r.fields.layer_depth = mirror_to_full(g, layer_depth_);
  if (m.input.cycle->journal_mass > 0.0 && film_->point().load.unknowns == 4) {
    r.assumptions.emplace_back(note::Plain::tilt_without_inertia);
  }
  const auto [back, forth] = std::minmax_element(
      instants_.begin(), instants_.end(),
      [](const CycleInstant& a, const CycleInstant& b) { return a.omega < b.omega; });
  if (back->omega < 0.0 && forth->omega > 0.0) {
    r.assumptions.emplace_back(note::Plain::torque_both_ways);
  }
  r.frames = frames_;
  if (dry_ > 0.0) {
    r.warnings.push_back(note::VesselEmpty{dry_ / told()});
  }
  for (const note::MouthWidened& w : film_->drillings().widened(film_->point().scene))
    r.warnings.push_back(w);
  if (m.input.cycle->step) tell_missed_load(r.warnings);
  tell_ranges(r);
  if (film_->heat() && !heat_.to_shell.empty()) write_heat(r);
  r.effects = effects(r);
}

std::vector<Effect> CycleRecord::effects(const CycleResult& r) const {
  const BearingModel& m = film_->model();
  const CycleMeans mean = means();
  EffectNumbers n;
  n.T = mean.T_film;
  n.U = course_->largest_speed() * m.input.bearing.radius;
  n.h_min = extreme(instants_, &CycleInstant::h_min, Extreme::smallest).h_min;
  n.p_max = largest(p_max_);
  const double capacity = mean.side_mass_flow * rheology::heat_capacity(m.oil, n.T).cp;
  n.rise = capacity > 0.0 ? mean.power / capacity : INFINITY;
  n.fed = fed_fastest_.part;
  if (m.physics.elastic) n.opening = opening_;
  if (m.physics.thermal_deformation) n.widening = largest_magnitude(r.fields.thermal_deformation);
  return effects_of(m, n, m.physics.film_energy || r.tier == Tier::lumped);
}

void CycleRecord::tell_ranges(CycleResult& r) const {
  const BearingModel& m = film_->model();
  const auto at = static_cast<int>(std::min_element(h_min_.begin(), h_min_.end()) - h_min_.begin());
  const FilmGrid& g = m.domain.grid;
  const double h_min =
      extreme(instants_, &CycleInstant::h_min, Extreme::smallest).h_min;  // of edges, too
  const fluid::SmallestGap least{h_min_[at], g.phi[at / g.nz], g.z[at % g.nz]};
  const double T = extreme(instants_, &CycleInstant::T_film_max, Extreme::largest).T_film_max;
  FilmReach reach{NAN, T, largest(p_max_), h_min_, least, h_min};
  if (film_->heat()) reach.T_shell = largest(T_shell_max_);
  reach.shear_rate = shear_rate_;
  reach.p_slope = p_slope_;
  if (!layer_depth_.empty()) reach.layer_depth = largest(layer_depth_);
  for (Note& w : range_warnings(m, reach)) r.warnings.push_back(std::move(w));
  add_turbulence(m.input, course_->largest_speed() * m.input.bearing.radius, T_film_ / told(),
                 r.warnings);
  add_squeeze_inertia(m.input, fastest_motion(instants_), T_film_ / told(), r.warnings);
  add_fed_flow(fed_fastest_, r.warnings);
  add_sheared_oil(sheared_, r.warnings);
  for (const LimiterCount& l : contact_limiters(m, h_min_)) r.limiters.push_back(l);
  if (bent_edges_ > 0) r.limiters.push_back({Limiter::bent_edges, (g.half ? 2 : 1) * bent_edges_});
}

note::ShaftSwing CycleRecord::shaft_swing() const {
  const BearingModel& m = film_->model();
  const FilmGrid& g = m.domain.grid;
  std::array<double, 2> first{};
  for (int c = 0; c < g.cells(); ++c) {
    const double phi = g.phi[c / g.nz];
    const double heat = 2.0 * heat_.to_shaft[c] / told() * g.area(c);
    first[0] += heat * std::cos(phi);
    first[1] += heat * std::sin(phi);
  }
  const double area = 2.0 * kPi * g.radius * g.width;
  const double turning = g.multiplicity() * std::hypot(first[0], first[1]) / area;
  const solid::Material& steel = m.input.shaft->material;
  const auto swing = [&](double q, double omega) {
    const double effusivity = std::sqrt(steel.conductivity * steel.density * steel.heat_capacity);
    return omega > 0.0 ? q / (effusivity * std::sqrt(omega)) : 0.0;
  };
  double speed = 0.0;
  std::complex<double> seen = 0.0;  // by a place of the shaft, of a heat that goes around once
  for (const CycleInstant& i : instants_) {
    speed += i.dt / told() * std::abs(i.omega);
    seen += i.dt / told() * std::polar(1.0, course_->turned(i.t));
  }
  const double as_it_turns = swing(turning, speed);
  if (!course_->repeats()) return {as_it_turns, true, 0.0};  // of an event that is passed once
  // What it sees all the time, of a solid cylinder q_1 R/k (textbook; the film evens it out): as
  // far as the next period begins where this one did, else that goes around, too.
  const double net = std::remainder(course_->turned(length_), 2.0 * kPi);
  const bool stays = std::abs(net) < kRoundOff;
  const double slow = stays ? INFINITY : swing(1.0, std::abs(net) / length_);  // a kelvin by q_1
  const double standing = std::abs(seen) * turning * std::min(g.radius / steel.conductivity, slow);
  double low = INFINITY, high = -INFINITY;
  for (const CycleInstant& i : instants_) {
    low = std::min(low, i.heat_to_shaft);
    high = std::max(high, i.heat_to_shaft);
  }
  return {as_it_turns + swing(0.5 * (high - low) / area, 2.0 * kPi / length_), false, standing};
}

void CycleRecord::write_heat(CycleResult& r) const {
  const FilmGrid& g = film_->model().domain.grid;
  const auto mean_over_time = [&](Field x) {
    for (double& v : x) v /= told();
    return mirror_to_full(g, x);
  };
  r.walls = film_->heat()->walls;
  // Of the radius, or of the width where a shaft goes on beyond it, which skins do not know: rises
  // are then told a twentieth too high.
  constexpr double kSideways = 0.25;
  r.assumptions.push_back(shaft_swing());
  add_layer_of_constant_thickness(film_->model(), r.assumptions);
  const double reach = reach_of_heat(film_->model().input, length_);
  const bool goes_on = film_->model().input.shaft->overhang > 0.0;
  const double near = kSideways * (goes_on ? std::min(g.radius, g.width) : g.radius);
  if (!course_->repeats() && reach > near) r.warnings.push_back(note::LongEvent{reach, near});
  r.fields.T_shell = mean_over_time(T_shell_);
  const double warm = area_mean(full_grid(g), r.fields.T_shell);
  add_joint_that_pulls(film_->model(), warm, warm, r.assumptions);
  r.fields.heat_to_shell = mean_over_time(heat_.to_shell);
  r.fields.T_shell_max = mirror_to_full(g, T_shell_max_);
  if (!film_->heat()->walls.thermal_deformation.empty()) {
    r.fields.thermal_deformation = mirror_to_full(g, film_->heat()->walls.thermal_deformation);
  }
}

}  // namespace shellback::bearing
