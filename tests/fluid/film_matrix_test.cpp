// The linearised film equation against central differences of its residual.
#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;

namespace {

/// A film at an arbitrary state, and directions in which to move it.
struct Probe {
  PosedFilm bearing;
  FilmCoefficients oil;
  FilmState state;
  FilmFlow flow;

  explicit Probe(const Setup& s) : bearing(make_bearing(s)) {
    const int n = bearing.scene.grid.cells();
    state.p = random_field(n, 1, 1e6, 2e7);
    state.theta = random_field(n, 2, 0.2, 0.9);
    for (int k = 0; k < n; ++k) state.full.push_back(k % 3 != 0);
    oil.fluidity = random_field(n, 3, 4.0, 12.0);
    oil.chi = random_field(n, 4, 0.4, 0.6);
    oil.alpha = random_field(n, 5, 5e-9, 3e-8);
    oil.density = random_field(n, 6, 800.0, 900.0);
    impose_supply(bearing.scene.supply, state);
    evaluate();
  }
  void evaluate() { evaluate_flow(bearing.scene, bearing.gap, bearing.step, oil, state, flow); }
  [[nodiscard]] int cells() const { return bearing.scene.grid.cells(); }
  [[nodiscard]] Field residual() const { return film_residual(bearing.scene, flow); }
  /// Residual after p += e a_p t, theta += e a_theta t, oil after Barus.
  [[nodiscard]] Field moved(const UnknownMap& u, const Field& t, double e) const {
    Probe q = *this;
    for (int k = 0; k < cells(); ++k) {
      q.state.p[k] += e * u.a_p[k] * t[k];
      q.state.theta[k] += e * u.a_theta[k] * t[k];
      q.oil.fluidity[k] *= std::exp(-oil.alpha[k] * e * u.a_p[k] * t[k]);
    }
    q.evaluate();
    return q.residual();
  }
  /// Residual after the gap has changed on the faces by e times the given amounts.
  [[nodiscard]] Field opened(const std::vector<double>& phi, const std::vector<double>& z,
                             double e) const {
    Probe q = *this;
    for (std::size_t f = 0; f < phi.size(); ++f) q.bearing.gap.phi_face[f] += e * phi[f];
    for (std::size_t f = 0; f < z.size(); ++f) q.bearing.gap.z_face[f] += e * z[f];
    q.evaluate();
    return q.residual();
  }
  /// Zero at supply cells: what is given does not move.
  [[nodiscard]] Field direction(unsigned seed) const {
    Field t = random_field(cells(), seed, -1.0, 1.0);
    for (int k = 0; k < cells(); ++k) t[k] *= bearing.scene.supply.cell[k] < 0;
    return t;
  }
};

/// Central difference by e; the tolerance is relative to the largest entry. Steps as in
/// face_flow_derivative_test.cpp: truncation and round-off below 1e-7.
void check_slope(const Field& slope, const Field& plus, const Field& minus, double e) {
  REQUIRE(largest_magnitude(slope) > 0.0);
  Field difference(slope.size());
  for (std::size_t k = 0; k < slope.size(); ++k) difference[k] = (plus[k] - minus[k]) / (2.0 * e);
  CHECK(largest_difference(slope, difference) < 3e-7 * largest_magnitude(slope));
}

Field product(const RingMatrix& a, const Field& t) {
  Field y;
  a.multiply(t, y);
  return y;
}

void check_assembly(const Probe& q, const UnknownMap& u) {
  RingMatrix a;
  assemble_film(q.bearing.scene, q.flow, u, a);
  const Field t = q.direction(11);
  const double e = 1e-4;  // pressures move by 1e4 Pa, fill ratios by 1e-4
  check_slope(product(a, t), q.moved(u, t, e), q.moved(u, t, -e), e);
}

/// Unknowns of comparable effect: a pressure of 1e8 Pa per unit.
UnknownMap scaled_active_set(const FilmState& s) {
  UnknownMap u = active_set_unknowns(s);
  for (double& x : u.a_p) x *= 1e8;
  return u;
}

UnknownMap mixed_unknowns(int n) {
  return {random_field(n, 21, -1e8, 1e8), random_field(n, 22, -1.0, 1.0)};
}

void check_compliance(const Probe& q) {
  const FilmScene& scene = q.bearing.scene;
  const Field c = random_field(q.cells(), 31, 0.2e-6, 1e-6);
  const Field t = q.direction(32);
  RingMatrix a;
  a.resize(scene.grid.nt, scene.grid.nz);
  add_gap_compliance(scene, q.flow, c, a);
  Field widening(t.size());
  for (std::size_t k = 0; k < t.size(); ++k) widening[k] = c[k] * t[k];
  std::vector<double> phi, z;
  to_faces(scene.grid, widening, phi, z);
  check_slope(product(a, t), q.opened(phi, z, 1e-4), q.opened(phi, z, -1e-4), 1e-4);
  // The same change of the gap, asked for face by face: equal but for the order of sums.
  const Field direct = outflow_by_gap(scene, q.flow, phi, z);
  CHECK(largest_difference(direct, product(a, t)) < 1e-12 * largest_magnitude(direct));
}

void check_position(const Setup& s, const Probe& q) {
  const double step[] = {1e-10, 1e-10, 1e-8, 1e-8};  // [m], [rad]: 1e-10 m at the edge
  for (int k = 0; k < (s.half ? 2 : 4); ++k) {
    Setup ahead = s, behind = s;
    ahead.position.q[k] += step[k];
    behind.position.q[k] -= step[k];
    Probe plus = q, minus = q;
    plus.bearing.gap = make_bearing(ahead).gap;
    minus.bearing.gap = make_bearing(behind).gap;
    plus.evaluate();
    minus.evaluate();
    check_slope(residual_by_position(q.bearing.scene, q.flow, k), plus.residual(), minus.residual(),
                step[k]);
  }
}

void check_gap(const Probe& q) {
  const FilmGrid& g = q.bearing.scene.grid;
  const Field phi = random_field(g.cells(), 41, -1e-6, 1e-6);
  const Field z = random_field(g.nt * (g.nz + 1), 42, -1e-6, 1e-6);
  check_slope(outflow_by_gap(q.bearing.scene, q.flow, phi, z), q.opened(phi, z, 1e-4),
              q.opened(phi, z, -1e-4), 1e-4);
}

void check_everything(const Setup& s) {
  for (const double speed : {12.0, -12.0}) {
    Setup turned = s;
    turned.speed = speed;
    const Probe q(turned);
    check_assembly(q, scaled_active_set(q.state));
    check_assembly(q, mixed_unknowns(q.cells()));
    check_compliance(q);
    check_position(turned, q);
    check_gap(q);
  }
}

double ripples(double phi, double z) { return 6e-6 * (1.0 + std::sin(5.0 * phi + 700.0 * z)); }

Setup tilted_thirteen() {
  Setup s;
  s.nt = 13;
  s.nz = 6;
  s.p_edge = 5e5;
  s.position = {{8e-6, -5e-6, 2e-4, -1e-4}};
  return s;
}

}  // namespace

TEST_CASE("TheFilmMatrixIsTheSlopeOfTheResidual") {
  check_everything(tilted_thirteen());
  Setup s = tilted_thirteen();
  s.nz = 1;
  check_everything(s);
}

TEST_CASE("TheFilmMatrixIsTheSlopeOverASteppedGap") {
  Setup s = tilted_thirteen();
  s.profile = ripples;
  check_everything(s);
}

TEST_CASE("TheFilmMatrixIsTheSlopeAtSupplyLines") {
  Setup s = tilted_thirteen();
  s.profile = ripples;
  s.patches = {line_supply(s, 1.0, 3e5), {.phi = 3.0, .z = 2e-3, .length = 0.01, .pressure = 1e5}};
  check_everything(s);
}

TEST_CASE("TheFilmMatrixIsTheSlopeAtGroovesAndHoles") {
  Setup s = tilted_thirteen();
  s.nt = 17;
  s.nz = 9;
  s.patches = {{.phi = 2.0, .z = 1e-3, .arc = 1.2, .length = 9e-3, .pressure = 3e5},
               {.phi = 4.6, .arc = 0.9, .length = 0.018, .round = true, .pressure = 1e5}};
  check_everything(s);
}

TEST_CASE("TheFilmMatrixIsTheSlopeAtACircumferentialGroove") {
  Setup s = tilted_thirteen();
  s.nz = 9;
  s.patches = {{.arc = 2.0 * kPi, .length = 4e-3, .pressure = 3e5}};
  check_everything(s);
}

TEST_CASE("TheFilmMatrixIsTheSlopeForRoughSurfaces") {
  Setup s = tilted_thirteen();
  s.clearance = 12e-6;
  s.rough = rough_pair({1.2e-6, 3.0}, {0.8e-6, 0.5});
  check_everything(s);
}

TEST_CASE("TheFilmMatrixIsTheSlopeWithDryEdges") {
  Setup s = tilted_thirteen();
  s.edges = SideEdges::dry;
  s.p_edge = 1e7;
  check_everything(s);
}

TEST_CASE("TheFilmMatrixIsTheSlopeOnAHalfGrid") {
  Setup s = tilted_thirteen();
  s.position = eccentric(9e-6, 0.4);
  s.half = true;
  s.patches = {{.phi = 2.0, .arc = 1.2, .length = 9e-3, .pressure = 3e5}};
  for (const int nz : {10, 11}) {
    s.nz = nz;
    check_everything(s);
  }
}

TEST_CASE("SupplyRowsAreIdentityAndMoveNobody") {
  Setup s = tilted_thirteen();
  s.patches = {{.phi = 2.0, .arc = 1.2, .length = 9e-3, .pressure = 3e5}};
  const Probe q(s);
  RingMatrix a;
  assemble_film(q.bearing.scene, q.flow, scaled_active_set(q.state), a);
  const RingMatrix before = a;
  add_gap_compliance(q.bearing.scene, q.flow, Field(q.cells(), 1e-6), a);
  Field t(q.cells());
  for (int k = 0; k < q.cells(); ++k) t[k] = q.bearing.scene.supply.cell[k] >= 0;
  CHECK(largest_difference(product(before, t), t) == 0.0);
  CHECK(largest_difference(product(a, t), t) == 0.0);
}

namespace {

/// Residual, response to the gap and to the position, and preconditioner against differences, at
/// the displacement `d`, which bends the gap somewhere; the evaluated film there.
Probe check_bent(const Setup& s, const Probe& q, const Field& d, unsigned seed) {
  const FilmGrid& g = q.bearing.scene.grid;
  const SupplyMap& supply = q.bearing.scene.supply;
  const auto moved = [&](const Field& by, double e, const JournalPosition& at) {
    Field with = d;
    for (std::size_t k = 0; k < d.size(); ++k) with[k] += e * by[k];
    Probe p = q;
    p.bearing.gap = film_gap(g, p.bearing.scene.angles, s.clearance, at, with, p.bearing.step,
                             nullptr, 0.0, &supply);
    p.evaluate();
    return p;
  };
  const Field by = random_field(g.cells(), seed, -1e-6, 1e-6);
  Probe here = moved(by, 0.0, s.position);
  check_slope(residual_by_gap(here.bearing.scene, here.flow, by),
              moved(by, 1e-4, s.position).residual(), moved(by, -1e-4, s.position).residual(),
              1e-4);
  for (int k = 0; k < (s.half ? 2 : 4); ++k) {
    const double step = k < 2 ? 1e-10 : 1e-8;
    JournalPosition ahead = s.position, behind = s.position;
    ahead.q[k] += step;
    behind.q[k] -= step;
    check_slope(residual_by_position(here.bearing.scene, here.flow, k),
                moved(by, 0.0, ahead).residual(), moved(by, 0.0, behind).residual(), step);
  }
  const Field c = random_field(g.cells(), seed + 1, 0.2e-6, 1e-6);
  const Field t = here.direction(seed + 2);
  RingMatrix a;
  a.resize(g.nt, g.nz);
  add_gap_compliance(here.bearing.scene, here.flow, c, a);
  Field widening(t.size());
  for (std::size_t k = 0; k < t.size(); ++k) {
    widening[k] = supply.cell[k] < 0 ? c[k] * t[k] : 0.0;  // nothing yields in a supply
  }
  const Field direct = residual_by_gap(here.bearing.scene, here.flow, widening);
  CHECK(largest_difference(direct, product(a, t)) < 1e-12 * largest_magnitude(direct));
  return here;
}

}  // namespace

TEST_CASE("TheFilmMatrixIsTheSlopeWherePressedLandsCloseBesideAGroove") {
  // The lands stand 12 um back, the groove between them 25 um in: the mean of both on the groove's
  // edges would be less than half of the land's gap.
  Setup s = tilted_thirteen();
  s.position = eccentric(14e-6, 0.4);
  s.patches = {{.phi = 0.5, .arc = 1.2, .length = 9e-3, .pressure = 3e5, .depth = 1e-3}};
  for (const auto& [half, profile] : {std::pair{false, false}, {false, true}, {true, false}}) {
    s.half = half;
    if (profile) s.profile = ripples;
    const Probe q(s);
    Field d(q.cells());
    for (int k = 0; k < q.cells(); ++k) {
      d[k] = q.bearing.scene.supply.cell[k] < 0 ? 12e-6 : -25e-6;
    }
    const Probe here = check_bent(s, q, d, 61);
    CHECK_FALSE(here.flow.bent_phi.empty());
    CHECK_FALSE(here.flow.bent_z.empty());
    CHECK(bent_edges(here.bearing.gap) ==
          static_cast<int>(here.flow.bent_phi.size() + here.flow.bent_z.size()));
    for (const BentFace& f : here.flow.bent_z) CHECK(here.bearing.gap.z_face[f.face] > 0.0);
  }
}

TEST_CASE("TheFilmMatrixIsTheSlopeWherePressedEdgesClose") {
  // Displacements that fall so steeply towards the side edges that the straight line to them would
  // close the gap.
  Setup s = tilted_thirteen();
  s.position = eccentric(9e-6, 0.4);
  for (const auto& [half, profile] : {std::pair{false, false}, {false, true}, {true, false}}) {
    s.half = half;
    if (profile) s.profile = ripples;
    const Probe q(s);
    const FilmGrid& g = q.bearing.scene.grid;
    const auto crown = [&](int j) { return 60e-6 * std::pow(2.0 * g.z[j] / g.width, 4); };
    Field d(g.cells());  // leaves 15 um less what the journal takes in the last cells
    for (int k = 0; k < g.cells(); ++k) {
      d[k] = crown(g.nz - 1) - crown(k % g.nz) + 15e-6 - s.clearance;
    }
    CHECK_FALSE(check_bent(s, q, d, 51).flow.edge.empty());
  }
}
