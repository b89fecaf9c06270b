/// Films between a shell and a journal that moves.
#include <catch2/catch.hpp>

#include "fluid/fischer_burmeister.hpp"
#include "tests/fluid/film_scenes.hpp"
#include "tests/observed_order.hpp"
#include "tests/read_csv.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;
using shellback::test::observed_order;
using shellback::test::read_csv;
using shellback::test::richardson;

namespace {

FilmSolution solved(const PosedFilm& b) {
  const auto film = solve(b);
  INFO(to_string(film.verdict.status));
  REQUIRE(film.good());
  return film.value;
}

/// Butenschoen's numbers: So = F psi^2/(B D eta eps'), Q = side flow/((D/2)^3 psi eps').
struct Squeeze {
  double sommerfeld;
  double side_flow;
};

/// The journal has come with `velocity` from where it was a little ago; the gap was `before` then.
/// Moves by 1e-3 of the clearance: the gap being linear in it, full film has one rate at any step.
void come_with(const std::array<double, 4>& velocity, const FilmState& before, PosedFilm& b,
               const Setup& s) {
  double speed = 0.0;
  for (int l = 0; l < 4; ++l) {
    speed = std::max(speed, std::abs(velocity[l]) * (l < 2 ? 1.0 : 0.5 * s.width));
  }
  const double dt = 1e-3 * s.clearance / speed;
  JournalPosition from = s.position;
  for (int l = 0; l < 4; ++l) from.q[l] -= dt * velocity[l];
  const Gap gap = film_gap(b.scene.grid, b.scene.angles, s.clearance, from, {}, b.step);
  FilmCoefficients oil;
  b.oil(before, oil);
  b.scene.storage = {dt, oil_content(b.scene, gap, oil, before)};
}

/// Journal at rest but for its centre, which moves along +X; it stands at eps on that line.
Squeeze squeeze(double width_over_diameter, double eps, int nt, int nz) {
  constexpr double kRate = 10.0;  // d eps/dt [1/s]
  Setup s;
  s.width = 2.0 * s.radius * width_over_diameter;
  s.position = eccentric(eps * s.clearance, 0.0);
  s.speed = 0.0;
  s.half = true;
  s.nt = nt;
  s.nz = nz;
  PosedFilm b = make_bearing(s);
  come_with({kRate * s.clearance, 0.0, 0.0, 0.0}, cold_film(b.scene), b, s);
  const FilmSolution v = solved(b);
  const double psi = s.clearance / s.radius;
  const double force = -wrench(b.scene, v.state.p)[0];
  return {force * psi * psi / (s.width * 2.0 * s.radius * s.viscosity * kRate),
          oil_flows(b.scene, v.flow).side / s.density / (std::pow(s.radius, 3) * psi * kRate)};
}

/// A bearing with all that can move: tilted, fed, in rotation, partly cavitated.
Setup busy() {
  Setup s;
  s.nt = 72;
  s.nz = 14;
  s.position = {{0.4 * s.clearance, -0.5 * s.clearance, 2e-4, -1e-4}};
  s.patches = {{.phi = 1.0, .z = 2e-3, .arc = 0.3, .length = 8e-3, .pressure = 2e5}};
  return s;
}

}  // namespace

TEST_CASE("PureSqueezeFollowsButenschoen", "[squeeze]") {
  int rows = 0;
  for (const auto& row : read_csv("validation/data/butenschoen_1976_squeeze.csv")) {
    const double eps = row.at("eps");
    const double own = row.at("own_So");
    // The file flags the entries of the transcription that are off by more than 1.5 %.
    if (std::isfinite(own) && std::abs(row.at("So") / own - 1.0) > 1.5e-2) continue;
    const Squeeze a = squeeze(row.at("B_over_D"), eps, 200, 24);
    const Squeeze b = squeeze(row.at("B_over_D"), eps, 400, 48);
    const double So = richardson(a.sommerfeld, b.sommerfeld);
    INFO("eps " << eps << ", B/D " << row.at("B_over_D") << ": So " << So << ", Q "
                << richardson(a.side_flow, b.side_flow));
    if (std::isfinite(own)) CHECK(So == Approx(own).epsilon(2e-3));  // design 6 asks for 0.5 %
    // Printed: one entry is 0.8 % off its recomputed value, and so is the fit at eps = 0.99.
    CHECK(So == Approx(row.at("So")).epsilon(1e-2));
    // The printed side flows are up to 2.3 % off for B/D = 1; ours is the volume lost, exactly.
    const double printed = row.at("B_over_D") == 1.0 ? 2.5e-2 : 1e-2;
    CHECK(richardson(a.side_flow, b.side_flow) == Approx(row.at("Q")).epsilon(printed));
    ++rows;
  }
  CHECK(rows > 60);
}

TEST_CASE("OilStoredIsWhatIsFedLessWhatLeaves", "[squeeze]") {
  for (const bool rough : {false, true}) {
    Setup s = busy();
    if (rough) s.rough = rough_pair({0.5e-6, 3.0}, {0.3e-6, 1.0});
    PosedFilm b = make_bearing(s);
    const double v = 0.05 * s.speed * s.clearance / s.radius;
    come_with({v, -0.6 * v, 30.0 * v, 20.0 * v}, solved(b).state, b, s);
    const FilmSolution film = solved(b);
    REQUIRE(complementary(b.scene, film.state));
    const OilFlows flows = oil_flows(b.scene, film.flow);
    CHECK(std::abs(flows.stored) > 1e-3 * std::abs(flows.side));
    CHECK(std::abs(flows.supply - flows.side - flows.stored) <
          1e-12 * (std::abs(flows.supply) + std::abs(flows.side)));
  }
}

TEST_CASE("StoredOilIsTheRateOfTheOilInTheGap", "[squeeze]") {
  Setup s = busy();
  s.rough = rough_pair({0.5e-6, 3.0}, {0.3e-6, 1.0});
  PosedFilm b = make_bearing(s);
  const int n = b.scene.grid.cells();
  const FilmState state = [&] {
    FilmState f = cold_film(b.scene);
    f.theta = random_field(n, 5, 0.2, 1.0);
    return f;
  }();
  FilmState earlier = state;
  earlier.theta = random_field(n, 4, 0.2, 1.0);
  const double dt = 1e-3;
  JournalPosition from = s.position;
  for (int l = 0; l < 4; ++l) from.q[l] *= 0.9;
  FilmCoefficients oil;
  b.oil(state, oil);
  const Gap before = film_gap(b.scene.grid, b.scene.angles, s.clearance, from, {}, b.step);
  b.scene.storage = {dt, oil_content(b.scene, before, oil, earlier)};
  FilmFlow flow;
  evaluate_flow(b.scene, b.gap, b.step, oil, state, flow);
  /// Oil in a cell, by the mean gap itself [kg].
  const auto content = [&](const Gap& gap, const FilmState& film, int k) {
    return s.density * film.theta[k] * gap_flow(s.rough, gap.cell[k]).average_gap *
           b.scene.grid.area(k);
  };
  for (int k = 0; k < n; k += 7) {
    if (b.scene.supply.cell[k] >= 0) {
      CHECK(flow.stored[k] == 0.0);
      continue;
    }
    const double rate = (content(b.gap, state, k) - content(before, earlier, k)) / dt;
    CHECK(flow.stored[k] == Approx(rate).epsilon(1e-12));
  }
}

TEST_CASE("FilmMatrixKnowsTheStoredOil", "[squeeze]") {
  PosedFilm b = make_bearing(busy());
  come_with({1e-3, -2e-3, 0.1, -0.05}, cold_film(b.scene), b, busy());
  const int n = b.scene.grid.cells();
  FilmState state = cold_film(b.scene);
  for (int k = 0; k < n; ++k) {
    if (b.scene.supply.cell[k] >= 0 || k % 3 == 0) continue;
    state.full[k] = 0;
    state.theta[k] = 0.5;
  }
  FilmCoefficients oil;
  b.oil(state, oil);
  const auto residual = [&](const FilmState& at, FilmFlow& flow) {
    evaluate_flow(b.scene, b.gap, b.step, oil, at, flow);
    return film_residual(b.scene, flow);
  };
  FilmFlow flow, other;
  const Field r = residual(state, flow);
  RingMatrix matrix;
  assemble_film(b.scene, flow, active_set_unknowns(state), matrix);
  Field t = random_field(n, 9, -0.1, 0.1);
  FilmState moved = state;
  for (int k = 0; k < n; ++k) {
    if (b.scene.supply.cell[k] >= 0 || state.full[k]) t[k] = 0.0;
    moved.theta[k] += t[k];
  }
  const Field after = residual(moved, other);  // linear in theta: exact
  Field change;
  matrix.multiply(t, change);
  for (int k = 0; k < n; ++k) {
    CHECK(std::abs(after[k] - r[k] - change[k]) < 1e-13 * flow_scale(flow));
  }
}

TEST_CASE("JournalWhirlingAtHalfSpeedCarriesNothing", "[squeeze]") {
  // The wedge then turns as fast as the oil: U/2 dh/dx + dh/dt = 0 [textbook].
  double coarser = 0.0;
  for (const int nt : {40, 80, 160}) {
    Setup s;
    s.nt = nt;
    s.p_cavitation = -1e9;  // full film
    s.position = eccentric(0.6 * s.clearance, 0.3);
    PosedFilm b = make_bearing(s);
    const double load =
        std::hypot(wrench(b.scene, solved(b).state.p)[0], wrench(b.scene, solved(b).state.p)[1]);
    const double half = 0.5 * s.speed / s.radius;
    come_with({-half * s.position.ey(), half * s.position.ex(), 0.0, 0.0}, cold_film(b.scene), b,
              s);
    const Wrench w = wrench(b.scene, solved(b).state.p);
    const double rest = std::hypot(w[0], w[1]) / load;
    CHECK(rest < 1.1 * std::pow(2.0 * kPi / nt, 2) / 24.0);  // sine over a cell, second order
    if (coarser > 0.0) CHECK(std::log2(coarser / rest) > 1.9);
    coarser = rest;
  }
}

TEST_CASE("MirroredMotionGivesTheMirroredFilm", "[squeeze]") {
  Setup s;
  s.position = {{0.2 * s.clearance, -0.6 * s.clearance, 0.0, 0.0}};
  Setup m = s;
  m.position.q[0] = -s.position.ex();
  m.speed = -s.speed;
  PosedFilm a = make_bearing(s);
  PosedFilm b = make_bearing(m);
  const double v = 0.1 * s.speed * s.clearance / s.radius;
  come_with({v, -0.5 * v, 0.0, 0.0}, cold_film(a.scene), a, s);
  come_with({-v, -0.5 * v, 0.0, 0.0}, cold_film(b.scene), b, m);
  const Wrench fa = wrench(a.scene, solved(a).state.p);
  const Wrench fb = wrench(b.scene, solved(b).state.p);
  const double size = std::hypot(fa[0], fa[1]);
  CHECK(std::abs(fa[0] + fb[0]) < 1e-9 * size);
  CHECK(std::abs(fa[1] - fb[1]) < 1e-9 * size);
}
