#include "coupling/film_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/constants.hpp"
#include "core/largest.hpp"
#include "coupling/closed_gap.hpp"
#include "coupling/elastic_step.hpp"
#include "coupling/equilibrium_step.hpp"
#include "coupling/film_verdicts.hpp"
#include "coupling/load_path.hpp"
#include "coupling/other_equilibrium.hpp"
#include "coupling/solids.hpp"
#include "fluid/empty_rings.hpp"
#include "fluid/fischer_burmeister.hpp"
#include "fluid/reduced_pressure.hpp"

namespace shellback::coupling {

double LoadTarget::scale() const { return std::hypot(force[0], force[1]); }

LoadTarget load_target(const Case& c) {
  LoadTarget t;
  if (const auto* load = std::get_if<LoadGiven>(&c.operation.position)) {
    t.force = {-load->force * std::cos(load->angle), -load->force * std::sin(load->angle), 0.0,
               0.0};
  } else {
    t.unknowns = 0;
  }
  if (const auto* moment = std::get_if<MomentGiven>(&c.operation.alignment)) {
    t.unknowns = 4;
    t.force[2] = -moment->about_x;
    t.force[3] = -moment->about_y;
  }
  return t;
}

fluid::JournalPosition first_position(const Case& c, double clearance) {
  constexpr double kFirstEccentricity = 0.6;             // where most bearings run [-]
  constexpr double kFirstAttitude = 50.0 * kPi / 180.0;  // that of a half-wide bearing there
  fluid::JournalPosition q;
  double angle = 0.0;
  double e = kFirstEccentricity * clearance;
  if (const auto* given = std::get_if<EccentricityGiven>(&c.operation.position)) {
    angle = given->load_angle + given->attitude;
    e = given->ratio * clearance;
  } else {
    const double turn = c.operation.omega >= 0.0 ? kFirstAttitude : -kFirstAttitude;
    angle = std::get<LoadGiven>(c.operation.position).angle + turn;
  }
  q.q[0] = e * std::cos(angle);
  q.q[1] = e * std::sin(angle);
  if (const auto* tilt = std::get_if<TiltGiven>(&c.operation.alignment)) {
    q.q[2] = tilt->about_x;
    q.q[3] = tilt->about_y;
  }
  return q;
}

FilmEquilibrium cold_start(const BearingModel& model, double T) {
  FilmEquilibrium s;
  s.film = fluid::cold_film(model.scene);
  s.position = first_position(model.input, model.clearance);
  if (model.physics.elastic) s.elastic.assign(model.scene.grid.cells(), 0.0);
  s.columns = uniform_columns(model.scene.grid.cells(), model.gl.n, T);
  return s;
}

namespace {

Field sum(const Field& a, const Field& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  Field c = a;
  for (std::size_t k = 0; k < c.size(); ++k) c[k] += b[k];
  return c;
}

void evaluate_contact(const BearingModel& model, FilmEquilibrium& s) {
  s.p_contact.assign(s.film.p.size(), 0.0);
  s.dp_contact.assign(s.film.p.size(), 0.0);
  if (!model.contact) return;
  model.contact->evaluate(s.gap.cell, s.p_contact, s.dp_contact);
  for (std::size_t k = 0; k < s.p_contact.size(); ++k) {
    if (model.scene.supply.cell[k] < 0) continue;
    s.p_contact[k] = 0.0;  // nothing to touch over a groove
    s.dp_contact[k] = 0.0;
  }
}

/// How far a force is from the wanted one, in logarithms: |ln(target/F)|, forces as complex
/// numbers.
double distance(const fluid::Wrench& force, const LoadTarget& target) {
  const std::complex<double> now(force[0], force[1]);
  const std::complex<double> aim(target.force[0], target.force[1]);
  return std::abs(now) > 0.0 && std::abs(aim) > 0.0 ? std::abs(std::log(aim / now)) : INFINITY;
}

/// (3) or (3a) of the pressures p and p_a.
Field displacement(const BearingModel& model, const FilmEquilibrium& s) {
  Field d = model.solids->compliance(sum(s.film.p, s.p_contact));
  return s.contact_growth ? sum(d, model.solids->widening(*s.contact_growth, s.p_contact)) : d;
}

Residuals residuals_of(const BearingModel& model, const LoadTarget& target,
                       const FilmEquilibrium& s) {
  Residuals r;
  r.film = fluid::film_residual(model.scene, s.flow);
  r.film_norm = largest_magnitude(r.film) / fluid::flow_scale(model.scene, s.flow);
  if (target.unknowns > 0) {
    const double arm = 0.5 * model.scene.grid.width;
    for (int k = 0; k < target.unknowns; ++k) {
      const double unit = k < 2 ? target.scale() : target.scale() * arm;
      r.load_norm = larger(r.load_norm, std::abs(s.force[k] - target.force[k]) / unit);
    }
  }
  if (!s.elastic.empty()) {
    r.displacement = displacement(model, s);
    for (std::size_t k = 0; k < r.displacement.size(); ++k) r.displacement[k] -= s.elastic[k];
    r.elastic_norm = largest_magnitude(r.displacement) /
                     (std::max(s.least.h, 0.0) + model.scene.rough.sigma + 1e-9);
  }
  return r;
}

/// Little oil may pass where much goes round: what is lost is measured by what passes. Two further
/// steps usually balance it, for they square the residual. Where what passes is nine orders less
/// than what goes round, the rest is round-off, new in every step: then the first step will do that
/// leaves the audit's bound (docs/stability.md) far enough away.
bool oil_balanced(const BearingModel& model, const FilmEquilibrium& s,
                  const EquilibriumOptions& options, int polished) {
  constexpr double kUsual = 1e-11;  // film tolerance of a result [-]
  constexpr double kLost = 1e-9;    // of what passes, at the usual film tolerance [-]
  constexpr double kLostToRounding = 4e-9;
  constexpr int kMostPolish = 2;
  constexpr int kMostRounding = 20;
  const auto flows = fluid::oil_flows(model.scene, s.flow);
  const double passes = std::max(std::abs(flows.supply), std::abs(flows.side));
  const double lost = std::abs(flows.supply - flows.side);
  const double looser = std::max(1.0, options.film_tolerance / kUsual);
  if (lost <= looser * kLost * passes) return true;
  if (polished < kMostPolish) return false;
  return looser > 1.0 || lost <= kLostToRounding * passes || polished >= kMostRounding;
}

/// The unknowns, to go back to.
struct Unknowns {
  fluid::FilmState film;
  fluid::JournalPosition position;
  Field elastic;
};

Unknowns unknowns_of(const FilmEquilibrium& s) { return {s.film, s.position, s.elastic}; }

void restore(const Unknowns& u, FilmEquilibrium& s) {
  s.film = u.film;
  s.position = u.position;
  s.elastic = u.elastic;
}

/// Takes the step; the elastic displacement follows the pressures as they come out of cavitation
/// and of the pressure law, not as the linear step has them.
fluid::UpdateReport take(const BearingModel& model, const NewtonStep& step, double fraction,
                         FilmEquilibrium& s) {
  for (int k = 0; k < 4; ++k) s.position.q[k] += fraction * step.q[k];
  const Field before = s.film.p;
  const std::vector<char> full = s.film.full;
  const auto report = fluid::advance(model.scene, s.oil, step.film, fraction, s.film);
  if (!s.elastic.empty()) {
    Field beyond(before.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
      const bool free = full[k] && model.scene.supply.cell[k] < 0;
      beyond[k] = s.film.p[k] - before[k] - (free ? fraction * step.film[k] : 0.0);
    }
    const Field more = model.solids->compliance(beyond);
    for (std::size_t k = 0; k < before.size(); ++k) {
      s.elastic[k] += fraction * step.elastic[k] + more[k];
    }
  }
  return report;
}

/// Film of a given position from its reduced pressure, or the proof that there is none.
Verdict reduced_start(const BearingModel& model, FilmEquilibrium& s) {
  const auto oil = [&](const fluid::FilmState& film, fluid::FilmCoefficients& c) {
    const Field none(film.p.size(), 0.0);
    update_columns(model.oil, model.gl, model.scene.speed, s.shear_gap, film, none, none, 1e-3,
                   s.columns, c);
  };
  auto film = fluid::film_by_reduced_pressure(model.scene, s.gap, model.step, oil, s.film);
  if (film.good()) s.film = std::move(film.value);
  return film.verdict;
}

}  // namespace

bool evaluate(const BearingModel& model, const Field& growth, double tolerance,
              FilmEquilibrium& s) {
  const fluid::FilmScene& scene = model.scene;
  s.gap = fluid::film_gap(scene.grid, scene.angles, model.clearance, s.position,
                          sum(growth, s.elastic), model.step);
  s.least = fluid::smallest_gap(scene.grid, s.gap, model.step);
  if (is_closed(model, s) || !std::isfinite(largest_magnitude(s.gap.cell))) return false;
  s.shear_gap = shear_gap(model, s.gap.cell);
  s.gradient_x = fluid::pressure_gradient_x(scene, s.film);
  s.gradient_z = fluid::pressure_gradient_z(scene, s.film);
  update_columns(model.oil, model.gl, scene.speed, s.shear_gap, s.film, s.gradient_x, s.gradient_z,
                 tolerance, s.columns, s.oil);
  fluid::evaluate_flow(scene, s.gap, model.step, s.oil, s.film, s.flow);
  evaluate_contact(model, s);
  s.force = fluid::wrench(scene, sum(s.film.p, s.p_contact));
  return true;
}

Verdict newton_equilibrium(const BearingModel& model, const LoadTarget& target, const Field& growth,
                           const EquilibriumOptions& options, FilmEquilibrium& s,
                           EquilibriumCost& cost, const std::atomic<bool>* stop) {
  constexpr double kShortestReach =
      1e-5;                              // a step shortened this far shows that there is no way on
  constexpr double kSettledFilm = 0.03;  // the film has followed the journal: it may move on [-]
  constexpr double kWorseMerit = 3.0;  // a step may worsen the elastic film's residuals so far [-]
  constexpr double kThinner = 0.25;    // and thin its smallest gap so far [-]
  constexpr double kLittleGain = 0.2;  // part of the gain asked for: a step that gained little [-]
  constexpr double kNearLoad = 0.1;    // from here on film and journal move together [-]
  constexpr int kMostRefills = 5;      // a ring that stays empty is one
  Unknowns settled = unknowns_of(s);   // last state whose film had followed
  // Rough surfaces stay apart by their asperities: the nominal gap may go through zero, and as far
  // below it as contact presses it.
  const auto room = [&](const FilmEquilibrium& f) {
    return 0.5 * (f.least.h + std::hypot(f.least.h, 2.0 * model.scene.rough.sigma));
  };
  double reach = 1.0;
  double carried = 0.0;
  double settled_merit = INFINITY;  // elastic: judge of a step (methods 2.2)
  double settled_gap = -INFINITY;
  double settled_off = INFINITY;  // rigid: judge of a step
  double damping = 1.0;
  double viscosity_tolerance = 1e-3;
  int polished = 0;  // further steps for the oil balance
  int refilled = 0;  // steps that had emptied whole rings
  bool retreated = false;
  int worst_cell = -1;
  Residuals r;
  /// The last state that was settled, evaluated, goes with every refusal.
  const auto refuse = [&](const auto& verdict) {
    restore(settled, s);
    if (evaluate(model, growth, viscosity_tolerance, s)) r = residuals_of(model, target, s);
    return verdict();
  };
  const auto retreat = [&] {
    restore(settled, s);
    reach *= s.elastic.empty() ? 0.35 : 0.5;
    retreated = true;
    ++cost.rejected_steps;
    return reach >= kShortestReach;
  };
  for (int it = 0; it <= options.max_iterations; ++it) {
    if (stop && stop->load()) return {Status::interrupted, "stopped by the user", "", ""};
    if (cost.spent()) return given_up();
    bool possible = evaluate(model, growth, viscosity_tolerance, s);
    if (possible) {
      r = residuals_of(model, target, s);
      possible =
          std::isfinite(r.film_norm) && std::isfinite(r.load_norm) && !std::isnan(r.elastic_norm);
    }
    if (!possible) {
      if (it == 0 && open_gap(model, target, growth, s)) continue;
      const Verdict none = no_film(model, target, growth, s);
      if (it == 0) return none;
      if (retreat()) continue;
      return refuse([&] {
        if (none.status == Status::invalid_number) return none;
        return s.elastic.empty() ? limit_load(model, target, carried, worst_cell)
                                 : stuck(model, s, r, it);
      });
    }
    if (r.within(options) && s.columns.mismatch <= options.viscosity_tolerance &&
        fluid::complementary(model.scene, s.film) && oil_balanced(model, s, options, polished++)) {
      return {};
    }
    const double merit = r.film_norm + r.load_norm + std::min(r.elastic_norm, 1e3);
    const bool follows =
        s.elastic.empty() ? r.film_norm < kSettledFilm
                          : merit < kWorseMerit * settled_merit && room(s) > kThinner * settled_gap;
    if (!s.elastic.empty() && !follows && !retreated) {
      if (retreat()) continue;
      return refuse([&] { return stuck(model, s, r, it); });
    }
    if (follows && !retreated) {
      // Where cavitation moves with the journal the predicted force misleads: ask for less.
      const double off = distance(s.force, target);
      const bool little = off > (1.0 - kLittleGain * damping) * settled_off;
      damping = little ? std::max(0.1, 0.5 * damping) : std::min(1.0, 2.0 * damping);
      settled_off = off;
      settled_merit = merit;
      settled_gap = room(s);
      settled = unknowns_of(s);
      carried = std::hypot(s.force[0], s.force[1]);
      reach = std::min(1.0, (s.elastic.empty() ? 1.5 : 2.0) * reach);
    }
    retreated = false;
    viscosity_tolerance =
        std::clamp(1e-2 * (r.film_norm + r.load_norm), 0.3 * options.viscosity_tolerance, 1e-3);
    ++cost.newton_iterations;
    cost.work += model.scene.grid.cells();
    LoadTarget now = target;
    if (s.elastic.empty() && !follows && r.load_norm > kNearLoad) now.unknowns = 0;
    const NewtonStep step = s.elastic.empty()
                                ? rigid_step(model, now, s, r.film, {reach, damping}, cost)
                                : elastic_step(model, now, s, r.film, r.displacement, cost);
    if (!step.good) {
      if (refilled++ < kMostRefills && fluid::refill_empty_rings(model.scene, s.film)) continue;
      return singular_film(model, s);
    }
    const auto report = take(model, step, s.elastic.empty() ? 1.0 : reach, s);
    // A rigid film of that gap has no pressure; an elastic one gives way, the step was only long.
    if (report.beyond_barus == 0 || !s.elastic.empty()) continue;
    worst_cell = report.worst_cell;
    if (target.unknowns > 0) {
      if (!retreat()) return refuse([&] { return limit_load(model, target, carried, worst_cell); });
    } else if (const Verdict v = reduced_start(model, s); !v.good()) {
      return v;
    }
  }
  return stuck(model, s, r, options.max_iterations);
}

Verdict solve_equilibrium(const BearingModel& model, const LoadTarget& target, const Field& growth,
                          const EquilibriumOptions& options, FilmEquilibrium& s,
                          EquilibriumCost& cost, const std::atomic<bool>* stop) {
  if (solved_otherwise(model, s)) {
    return solve_otherwise(model, target, growth, options, s, cost, stop);
  }
  const Verdict v = newton_equilibrium(model, target, growth, options, s, cost, stop);
  const bool lost = v.status == Status::iteration_limit || v.status == Status::no_steady_state;
  const Methods& by = model.input.model.methods;
  const bool other = by.cavitation != CavitationMethod::active_set ||
                     by.elastic != ElasticMethod::newton;  // shown as they are, without our help
  if (!lost || other || target.unknowns == 0) return v;
  if (!options.follow_load || !s.elastic.empty()) return v;
  return follow_load(model, target, growth, options, s, cost, stop);
}

}  // namespace shellback::coupling
