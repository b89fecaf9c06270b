#include "bearing/film/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bearing/solids.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {

fluid::JournalPosition first_position(const Case& c, double clearance) {
  constexpr double kFirstEccentricity = 0.6;             // where most bearings run [-]
  constexpr double kFirstAttitude = 50.0 * kPi / 180.0;  // that of a half-wide bearing there
  fluid::JournalPosition q;
  double angle = 0.0;
  double e = kFirstEccentricity * clearance;
  if (const auto* given = std::get_if<EccentricityGiven>(&c.operation.position)) {
    angle = given->direction(c.operation.omega);
    e = given->ratio * clearance;
  } else {
    const double attitude = c.operation.omega >= 0.0 ? kFirstAttitude : -kFirstAttitude;
    angle = std::get<LoadGiven>(c.operation.position).angle + attitude;
  }
  q.q[0] = e * std::cos(angle);
  q.q[1] = e * std::sin(angle);
  if (const auto* tilt = std::get_if<TiltGiven>(&c.operation.alignment)) {
    q.q[2] = tilt->about_x;
    q.q[3] = tilt->about_y;
  }
  return q;
}

FilmEquilibrium cold_start(const BearingModel& model, const OperatingPoint& point, double T) {
  FilmEquilibrium s;
  s.film = fluid::cold_film(point.scene);
  s.position = first_position(model.input, model.clearance);
  if (model.physics.elastic) s.elastic.assign(model.domain.grid.cells(), 0.0);
  s.columns = uniform_columns(model.domain.grid.cells(), model.gl.n, T);
  return s;
}

Field sum(const Field& a, const Field& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  Field c = a;
  for (std::size_t k = 0; k < c.size(); ++k) c[k] += b[k];
  return c;
}

int beyond_reduced_pressure(const BearingModel& model, const OperatingPoint& point,
                            const FilmEquilibrium& s) {
  const FilmGrid& g = model.domain.grid;
  if (!s.elastic.empty() || !std::holds_alternative<rheology::Barus>(model.oil.pressure)) return -1;
  const auto w = [&](int k) { return -std::expm1(-s.oil.alpha[k] * s.film.p[k]); };  // alpha q
  for (int k = 0; k < g.cells(); ++k) {
    if (!s.film.full[k] || point.scene.supply.cell[k] >= 0) continue;
    const int i = k / g.nz;
    const int j = k % g.nz;
    const double here = w(k);
    const auto drop = [&](int a, int b) { return 2.0 * here - w(a) - w(b); };
    double top = drop(g.index(g.previous(i), j), g.index(g.next(i), j));
    if (j > 0 && j + 1 < g.nz) top += drop(k - 1, k + 1);
    if (j == 0 && g.half && g.nz > 1) {  // beyond the plane of symmetry stands the mirror image
      top += drop(g.z[0] == 0.0 ? k + 1 : k, k + 1);
    }
    if (here + top / 24.0 >= 1.0) return k;
  }
  return -1;
}

double yielding_gap(double h, double sigma) { return 0.5 * (h + std::hypot(h, 2.0 * sigma)); }

double room(const BearingModel& model, const FilmEquilibrium& s) {
  return yielding_gap(s.least.h, model.domain.rough.sigma);
}

double gap_with_summits(const BearingModel& model, const FilmEquilibrium& s) {
  return std::max(s.least.h, 0.0) + kSummits * model.domain.rough.sigma;
}

bool thinner_than_a_molecule(const BearingModel& model, const FilmEquilibrium& s) {
  const bool smooth = model.domain.rough.sigma <= 0.0 && !model.contact;
  if (!smooth || s.least.h >= kMolecule) return false;
  if (s.elastic.empty()) return true;
  const FilmGrid& g = model.domain.grid;
  const Field h = fluid::nominal_depth(s.gap, model.supply);
  for (int j = 0; j < g.nz; ++j) {
    double least = INFINITY;
    for (int i = 0; i < g.nt; ++i) least = std::min(least, h[g.index(i, j)]);
    if (least >= kMolecule) return false;
  }
  return true;
}

bool closing_is_resolved(const BearingModel& model, const FilmEquilibrium& s) {
  if (model.physics.elastic) return true;
  const FilmGrid& g = model.domain.grid;
  const bool low = !g.half && s.least.z == g.z_face.front();
  if (!low && s.least.z != g.z_face.back()) return false;
  const Field h = fluid::nominal_depth(s.gap, model.supply);
  const int edge = low ? 0 : g.nz - 1, other = low ? g.nz - 1 : 0;
  int row = 0;
  for (int i = 1; i < g.nt; ++i) {
    if (h[g.index(i, edge)] < h[g.index(row, edge)]) row = i;
  }
  const double least = h[g.index(row, edge)];
  const double around =
      std::min(h[g.index(g.previous(row), edge)], h[g.index(g.next(row), edge)]) - least;
  return h[g.index(row, other)] - least > around;
}

namespace {

void evaluate_contact(const BearingModel& model, const OperatingPoint& point, FilmEquilibrium& s) {
  s.p_contact.assign(s.film.p.size(), 0.0);
  s.dp_contact.assign(s.film.p.size(), 0.0);
  if (!model.contact) return;
  model.contact->evaluate(s.gap.cell, s.p_contact, s.dp_contact);
  for (std::size_t k = 0; k < s.p_contact.size(); ++k) {
    if (point.scene.supply.cell[k] < 0) continue;
    s.p_contact[k] = 0.0;  // nothing to touch over a groove
    s.dp_contact[k] = 0.0;
  }
}

/// The gap of every cell; in supplies, whose oil is that of the film which begins at their edge, no
/// less than the smallest film: lands are pressed away from the shaft, a groove's ground is not
/// [m].
Field film_beside_supplies(const fluid::SupplyMap& supply, const FilmEquilibrium& s) {
  Field h = s.gap.cell;
  for (std::size_t k = 0; k < h.size(); ++k) {
    if (supply.cell[k] >= 0) h[k] = std::max(h[k], s.least.h);
  }
  return h;
}

/// (3) or (3a) of the pressures p and p_a.
Field displacement(const BearingModel& model, const FilmEquilibrium& s) {
  Field d = model.solids->compliance(sum(s.film.p, s.p_contact));
  for (std::size_t k = 0; k < s.layer.size(); ++k) d[k] += s.layer[k].now.sum();
  return s.contact_widening ? sum(d, widening(*model.solids, *s.contact_widening, s.p_contact)) : d;
}

}  // namespace

Field widening(const Solids& solids, const ContactWidening& by, const Field& p_contact) {
  Field heat = p_contact;
  for (std::size_t c = 0; c < heat.size(); ++c) heat[c] *= by.rate[c];
  return solids.widening(by.by_heat, heat);
}

bool evaluate(const BearingModel& model, const OperatingPoint& point,
              const Field& thermal_deformation, double tolerance, FilmEquilibrium& s) {
  const fluid::FilmScene& scene = point.scene;
  EXPECTS(scene.grid.cells() == model.domain.grid.cells());  // a point is of one bearing
  s.gap = gap_at(model, s.position, sum(thermal_deformation, s.elastic));
  s.least = fluid::smallest_gap(scene.grid, s.gap, model.profile, scene.supply);
  if (is_closed(model, s) || !std::isfinite(largest_magnitude(s.gap.cell))) return false;
  s.shear_gap = shear_gap(model, film_beside_supplies(scene.supply, s));
  if (no_gap_shears(model, scene.speed, s)) return false;
  s.gradient_x = fluid::pressure_gradient_x(scene, s.film);
  s.gradient_z = fluid::pressure_gradient_z(scene, s.film);
  update_columns(model.oil, model.gl, scene.speed, s.shear_gap, scene.supply.cell, s.film,
                 s.gradient_x, s.gradient_z, tolerance, s.columns, s.oil);
  fluid::evaluate_flow(scene, s.gap, model.profile, s.oil, s.film, s.flow);
  if (!model.profile.empty()) {  // what friction and heat see; the oil above, but to first order
    s.gradient_x = fluid::pressure_gradient_x(scene, s.film, s.flow);
  }
  evaluate_contact(model, point, s);
  if (point.layer && !s.elastic.empty()) s.layer = point.layer->press(s.film.p, s.p_contact);
  s.force = fluid::wrench(scene, sum(s.film.p, s.p_contact));
  return true;
}

bool Residuals::finite() const {
  return std::isfinite(film_norm) && std::isfinite(load_norm) && !std::isnan(elastic_norm);
}

Residuals residuals_of(const BearingModel& model, const OperatingPoint& point,
                       const FilmEquilibrium& s) {
  constexpr double kRoundings = 4.0;  // of two terms, their difference and the flows beside [-]
  Residuals r;
  r.film = fluid::film_residual(point.scene, s.flow);
  const double most = largest_magnitude(r.film);
  const double flow = fluid::flow_scale(s.flow);
  // A residual is a difference of flows by pressures, in time of what cells hold, too, and known to
  // their round-off: as a film comes to rest, or hardly turns under a high pressure of supply,
  // nothing flows around that it could be measured by.
  const double terms = larger(largest_magnitude(s.flow.stored_by_theta),
                              fluid::flow_by_pressure(point.scene, s.flow, s.film.p));
  const double round_off = kRoundings * std::numeric_limits<double>::epsilon();
  r.film_norm = most <= round_off * terms ? 0.0 : most / flow;
  const fluid::Wrench wanted = point.load.wanted(s);
  const double unit = point.load.scale() * std::exp(s.ln_load);
  for (int k = 0; k < point.load.unknowns; ++k) {
    const double arm = k < 2 ? 1.0 : 0.5 * model.domain.grid.width;
    r.load_norm = larger(r.load_norm, std::abs(s.force[k] - wanted[k]) / (unit * arm));
  }
  if (point.load.path) r.load_norm = larger(r.load_norm, std::abs(point.load.path->missing(s)));
  if (!s.elastic.empty()) {
    r.displacement = displacement(model, s);
    for (std::size_t k = 0; k < r.displacement.size(); ++k) r.displacement[k] -= s.elastic[k];
    r.elastic_norm = largest_magnitude(r.displacement) /
                     (std::max(s.least.h, 0.0) + model.domain.rough.sigma + kMolecule);
  }
  return r;
}

}  // namespace shellback::bearing
