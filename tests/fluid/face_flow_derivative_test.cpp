// Every derivative that evaluate_flow hands out, against central differences of its flows.
#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;

namespace {

/// A film at an arbitrary state: nothing here is a solution.
struct Tangle {
  Setup setup;
  PosedFilm bearing;
  FilmCoefficients oil;
  FilmState state;

  Tangle(const Setup& s, double spread) : setup(s), bearing(make_bearing(s)) {
    const int n = bearing.scene.grid.cells();
    state.p = random_field(n, 1, 1e6, 2e7);
    state.theta = random_field(n, 2, 0.2, 1.0);
    state.full.assign(static_cast<std::size_t>(n), 1);
    oil.fluidity = random_field(n, 3, 8.0 * (1.0 - spread), 8.0 * (1.0 + spread));
    oil.chi = random_field(n, 4, 0.4, 0.6);
    oil.alpha = random_field(n, 5, 5e-9, 3e-8);
    oil.density = random_field(n, 6, 800.0, 900.0);
  }

  [[nodiscard]] FilmFlow flow() const {
    FilmFlow f;
    evaluate_flow(bearing.scene, bearing.gap, bearing.step, oil, state, f);
    return f;
  }
  /// The same film with the pressure of one cell changed; its oil follows Barus.
  [[nodiscard]] FilmFlow with_pressure(int cell, double dp) const {
    Tangle t = *this;
    t.state.p[cell] += dp;
    t.oil.fluidity[cell] *= std::exp(-oil.alpha[cell] * dp);
    return t.flow();
  }
  [[nodiscard]] FilmFlow with_fill(int cell, double dtheta) const {
    Tangle t = *this;
    t.state.theta[cell] += dtheta;
    return t.flow();
  }
  [[nodiscard]] FilmFlow with_gap(double dh) const {
    Tangle t = *this;
    for (double& h : t.bearing.gap.phi_face) h += dh;
    for (double& h : t.bearing.gap.z_face) h += dh;
    return t.flow();
  }
};

// alpha dp < 3e-4: truncation (alpha dp)^2/6 of 1e-8. Round-off: the flow, up to 1e3 times the
// change, at 1e-16. theta enters linearly; where fronts wander with a third derivative of 12 and
// less: 1e-4 squared of a sixth of that is 2e-8. h: (dh/h)^2 of 1e-10 for smooth surfaces; the
// factors of rough ones change over a tenth of sigma: 1e-8.
constexpr double kPressureStep = 1e4;  // [Pa]
constexpr double kFillStep = 1e-4;     // [-]
constexpr double kGapStep = 1e-10;     // [m]
constexpr double kTolerance = 2e-7;    // of the largest derivative of its kind

struct Worst {
  double error = 0.0;
  double size = 0.0;
  int compared = 0;
  void compare(double derivative, double plus, double minus, double step) {
    error = std::max(error, std::abs(derivative - (plus - minus) / (2.0 * step)));
    size = std::max(size, std::abs(derivative));
    ++compared;
  }
  void check() const {
    REQUIRE(compared > 0);
    REQUIRE(size > 0.0);
    CHECK(error < kTolerance * size);
  }
};

void check_pressure_and_fill(const Tangle& t) {
  const FilmGrid& g = t.bearing.scene.grid;
  const bool forward = t.setup.speed >= 0.0;
  const FilmFlow flow = t.flow();
  Worst left, right, fill, edge, into_line;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      const FilmFlow up = t.with_pressure(k, kPressureStep);
      const FilmFlow down = t.with_pressure(k, -kPressureStep);
      const FilmFlow fuller = t.with_fill(k, kFillStep), emptier = t.with_fill(k, -kFillStep);
      const int west = k, east = g.index(g.next(i), j), low = i * (g.nz + 1) + j, high = low + 1;
      // A supply's pressure is held in the solver, and the oil at a face that it touches too.
      right.compare(flow.phi[west].d_right, up.phi[west].m, down.phi[west].m, kPressureStep);
      if (t.bearing.scene.supply.line[east] < 0) {
        left.compare(flow.phi[east].d_left, up.phi[east].m, down.phi[east].m, kPressureStep);
        if (forward) {
          fill.compare(flow.phi[east].d_theta, fuller.phi[east].m, emptier.phi[east].m, kFillStep);
        }
      }
      if (!forward) {
        fill.compare(flow.phi[west].d_theta, fuller.phi[west].m, emptier.phi[west].m, kFillStep);
      }
      (j == 0 ? edge : right)
          .compare(flow.z[low].d_right, up.z[low].m, down.z[low].m, kPressureStep);
      (j == g.nz - 1 ? edge : left)
          .compare(flow.z[high].d_left, up.z[high].m, down.z[high].m, kPressureStep);
      for (std::size_t l = 0; l < flow.lines.size(); ++l) {
        if (flow.lines[l].face != east) continue;
        into_line.compare(flow.lines[l].west.d_left, up.lines[l].west.m, down.lines[l].west.m,
                          kPressureStep);
        if (forward) {
          fill.compare(flow.lines[l].west.d_theta, fuller.lines[l].west.m, emptier.lines[l].west.m,
                       kFillStep);
        }
      }
    }
  }
  left.check();
  right.check();
  fill.check();
  edge.check();
  if (!flow.lines.empty()) into_line.check();
}

void check_gap(const Tangle& t) {
  const FilmFlow flow = t.flow(), wide = t.with_gap(kGapStep), narrow = t.with_gap(-kGapStep);
  Worst phi, z, lines;
  for (std::size_t f = 0; f < flow.phi.size(); ++f) {
    phi.compare(flow.phi[f].d_h, wide.phi[f].m, narrow.phi[f].m, kGapStep);
  }
  for (std::size_t f = 0; f < flow.z.size(); ++f) {
    z.compare(flow.z[f].d_h, wide.z[f].m, narrow.z[f].m, kGapStep);
  }
  for (std::size_t f = 0; f < flow.lines.size(); ++f) {
    lines.compare(flow.lines[f].west.d_h, wide.lines[f].west.m, narrow.lines[f].west.m, kGapStep);
  }
  phi.check();
  z.check();
  if (!flow.lines.empty()) lines.check();
}

void check_all(const Setup& s) {
  for (const double speed : {12.0, -12.0}) {
    for (const double spread : {0.6, 0.01}) {  // both branches of the logarithmic mean
      Setup turned = s;
      turned.speed = speed;
      const Tangle t(turned, spread);
      check_pressure_and_fill(t);
      check_gap(t);
    }
  }
}

Setup tilted() {
  Setup s;
  s.nt = 11;
  s.nz = 5;
  s.p_edge = 5e5;
  s.position = {{8e-6, -5e-6, 2e-4, -1e-4}};
  return s;
}

}  // namespace

TEST_CASE("FlowDerivativesOfAPlainFilm") { check_all(tilted()); }

TEST_CASE("FlowDerivativesOverASteppedGap") {
  Setup s = tilted();
  s.profile = [](double phi, double z) { return 6e-6 * (1.0 + std::sin(5.0 * phi + 700.0 * z)); };
  check_all(s);
}

TEST_CASE("FlowDerivativesWhereTheBoreOpensAndCloses") {
  for (const bool rough : {false, true}) {
    Setup s = tilted();
    if (rough) s.rough = rough_pair({1.2e-6, 3.0}, {0.8e-6, 0.5});
    s.patches = {{.phi = 2.0, .z = 1e-3, .arc = 1.2, .length = 9e-3, .pressure = 3e5}};
    Tangle t(s, 0.6);
    // from half closed to three times as open within a half cell
    const int faces = t.bearing.scene.grid.nt * (t.bearing.scene.grid.nz + 1);
    t.bearing.scene.shape_beside = {random_field(faces, 8, -1e-5, 6e-5),
                                    random_field(faces, 9, -1e-5, 6e-5)};
    check_pressure_and_fill(t);
    check_gap(t);
  }
}

TEST_CASE("AHalfCellThatOpensTakesThePressureThatAStraightGapTakes") {
  // From the face, a gap h, to the unknown, h + rise, over the length l: the flow per pressure is
  // that of the integral of dz/h^3, here by ten thousand trapezia.
  Setup s = tilted();
  s.position = eccentric(0.0, 0.0);
  for (const double rise : {2e-6, 3e-5, 3e-4}) {
    Tangle t(s, 0.6);
    const FilmGrid& g = t.bearing.scene.grid;
    const FilmFlow even = t.flow();
    const auto faces = static_cast<std::size_t>(g.nt) * (g.nz + 1);
    t.bearing.scene.shape_beside = {Field(faces, rise), Field(faces, rise)};
    const FilmFlow opening = t.flow();
    const double h = s.clearance;
    constexpr int kParts = 10000;
    double taken = 0.0;  // of what an even gap takes
    for (int k = 0; k < kParts; ++k) {
      taken += std::pow(h / (h + rise * (k + 0.5) / kParts), 3) / kParts;
    }
    for (int j = 1; j <= g.nz; ++j) {  // mid-points: wrong by (rise/h/10000)^2 and less
      CHECK(even.z[j].m / opening.z[j].m == Approx(taken).epsilon(1e-5));
    }
  }
}

TEST_CASE("FlowDerivativesAtASupplyLine") {
  Setup s = tilted();
  s.patches = {{.phi = 1.0, .length = s.width, .pressure = 3e5}};
  s.profile = [](double phi, double z) { return 6e-6 * (1.0 + std::sin(5.0 * phi + 700.0 * z)); };
  check_all(s);
}

TEST_CASE("FlowDerivativesAtAShortSupplyLine") {
  Setup s = tilted();
  s.patches = {{.phi = 1.0, .z = 1e-3, .length = 0.4 * s.width, .pressure = 3e5}};
  check_all(s);
}

TEST_CASE("FlowDerivativesWhereFrontsWander") {
  Setup s = tilted();
  s.patches = {{.phi = 1.0, .length = s.width, .pressure = 3e5}};
  Tangle t(s, 0.6);
  t.bearing.scene.storage.front = random_field(t.bearing.scene.grid.cells(), 7, -0.5, 1.0);
  check_pressure_and_fill(t);
  check_gap(t);
}

TEST_CASE("FlowDerivativesAtAGroove") {
  Setup s = tilted();
  s.patches = {{.phi = 2.0, .z = 1e-3, .arc = 1.2, .length = 9e-3, .pressure = 3e5}};
  s.profile = [](double phi, double) { return 4e-6 * (1.0 + std::cos(3.0 * phi)); };
  check_all(s);
}

TEST_CASE("FlowDerivativesOfRoughSurfaces") {
  Setup s = tilted();
  s.clearance = 12e-6;
  s.rough = rough_pair({1.2e-6, 3.0}, {0.8e-6, 0.5});
  s.profile = [](double phi, double z) { return 3e-6 * std::sin(5.0 * phi + 700.0 * z); };
  check_all(s);
}

TEST_CASE("FlowDerivativesOnAHalfGrid") {
  Setup s = tilted();
  s.position = eccentric(9e-6, 0.4);
  s.half = true;
  s.patches = {{.phi = 2.0, .arc = 1.2, .length = 9e-3, .pressure = 3e5}};
  for (const int nz : {8, 9}) {
    s.nz = nz;
    check_all(s);
  }
}

TEST_CASE("ADryEdgeLetsOilOutOnly") {
  Setup s = tilted();
  s.edges = SideEdges::dry;
  s.p_edge = 1e7;
  const Tangle t(s, 0.6);
  const FilmFlow flow = t.flow();
  int closed = 0;
  for (int i = 0; i < s.nt; ++i) {
    const FaceFlow& low = flow.z[i * (s.nz + 1)];
    const FaceFlow& high = flow.z[i * (s.nz + 1) + s.nz];
    CHECK(low.m <= 0.0);
    CHECK(high.m >= 0.0);
    closed += low.m == 0.0 && low.d_right == 0.0 && low.d_h == 0.0;
    CHECK((low.m == 0.0) == (t.state.p[i * s.nz] <= s.p_edge));
  }
  CHECK(closed > 0);
  CHECK(closed < s.nt);
}
