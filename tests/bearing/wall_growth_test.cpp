// Walls that grow in time: skins between the steps of a cycle, bodies from one cycle to the next.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/cycle_record.hpp"
#include "bearing/over_time/film_step.hpp"
#include "bearing/over_time/skin_growth.hpp"
#include "core/constants.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

constexpr double kPeriod = 0.06;  ///< two turns at 2000 rpm [s]

/// Rigid, but for its heat, under a load that swings.
struct Swinging {
  Case c = cycle_case();
  Physics physics;
  BearingModel model;
  LoadCourse course;
  FilmSteps steps;
  FilmInTime now;
  EquilibriumCost cost;

  static LoadCycle load() {
    LoadCycle out;
    out.period = kPeriod;
    constexpr int kRows = 72;
    for (int k = 0; k < kRows; ++k) {
      out.t.push_back(kPeriod * k / kRows);
      out.x.push_back(0.0);
      out.y.push_back(-1.5e3 * (1.0 + 0.6 * std::sin(2.0 * kPi * k / kRows)));
    }
    out.interpolation = LoadInterpolation::periodic_spline;
    return out;
  }
  static Case cycle_case() {
    Case out = warm_case();
    out.cycle = load();
    return out;
  }
  Swinging()
      : physics{.film_energy = true, .thermal_deformation = true},
        model(make_bearing(c, physics, {48, 6})),
        course(*c.cycle, c.operation.omega),
        steps(model, course, 0.5, EquilibriumOptions{}) {
    const double T = c.supplies[0].temperature;
    auto steady = steps.steady(T, {}, cost, nullptr);
    REQUIRE(steady);
    now = *std::move(steady);
    REQUIRE(stand(uniform_walls(model, T)));
  }
  bool stand(const WallMeans& walls) {
    return steps.set_walls(walls, kPeriod, kPeriod / 720.0, now);
  }
  void go(int n, double dt) {
    for (int k = 0; k < n; ++k) {
      FilmStep s = steps.take(dt, now, cost, nullptr);
      INFO(app::reason_of(s.verdict));
      REQUIRE(s.verdict.good());
      now = std::move(s.after);
    }
  }
  /// What is wider in the film's gap than in that of the rigid bearing [m].
  [[nodiscard]] Field widening() const {
    Field gap = now.film.gap.cell;
    const Field rigid = fluid::film_gap(model.domain.grid, model.domain.angles, model.clearance,
                                        now.film.position, {}, {})
                            .cell;
    for (std::size_t c = 0; c < gap.size(); ++c) gap[c] -= rigid[c];
    return gap;
  }
};

}  // namespace

TEST_CASE("TheSkinNarrowsTheGapAsItSwells", "[wall_growth]") {
  // Its temperatures are carried on in a straight line into each stage: of second order in time.
  const auto missed = [](int steps) {
    Swinging b;
    b.go(steps, 0.25 * kPeriod / steps);
    const Field swelling = b.steps.heat()->swelling(b.model, b.now.heat.skin);
    Field off = b.widening();
    for (std::size_t c = 0; c < off.size(); ++c) {
      off[c] -= b.steps.heat()->walls.thermal_deformation[c] - swelling[c];
    }
    return std::pair{largest_magnitude(off), largest_magnitude(swelling)};
  };
  const auto [coarse, swelling] = missed(20);
  const auto [fine, same] = missed(160);
  INFO(coarse << ", " << fine << " of " << swelling << ", " << same);
  CHECK(swelling > 1e-10);  // something has swollen [m]
  CHECK(coarse < 0.03 * swelling);
  CHECK(coarse / fine == Approx(64.0).epsilon(0.3));  // the cell that is worst is not always one
}

TEST_CASE("TheGapGrowsFromTheWallsOfOneCycleToThoseOfTheNext", "[wall_growth]") {
  Swinging b;
  b.go(60, kPeriod / 360.0);
  const Field before = b.widening();
  const double oil = b.now.oil[7];
  WallMeans warmer = uniform_walls(b.model, b.c.supplies[0].temperature + 20.0);
  const Field standing = warmer.thermal_deformation;
  const double jump = largest_magnitude(standing);
  REQUIRE(jump > 1e-8);
  REQUIRE(b.stand(warmer));
  CHECK(b.now.oil[7] == oil);  // of no cell does the oil change
  // A thousandth of the time over which it grows: 3 (1e-3)^2 of the way, and what the skin does.
  b.go(1, 1e-4 * kPeriod);
  CHECK(largest_difference(b.widening(), before) < 1e-4 * jump);
  b.go(40, 0.1 * kPeriod / 40.0);
  const Field swelling = b.steps.heat()->swelling(b.model, b.now.heat.skin);
  Field whole = standing;
  for (std::size_t c = 0; c < whole.size(); ++c) whole[c] -= swelling[c];
  CHECK(largest_difference(b.widening(), whole) < 1e-3 * jump);
}

TEST_CASE("ANextCycleWithoutRoomIsRefused", "[wall_growth]") {
  Swinging b;
  b.go(3, kPeriod / 360.0);
  WallMeans walls = uniform_walls(b.model, b.c.supplies[0].temperature);
  for (double& d : walls.thermal_deformation) d = -1.1 * b.c.bearing.radial_clearance;
  CHECK_FALSE(b.stand(walls));
}

TEST_CASE("TheShaftsSwingThatIsToldIsThatOfAHalfSpaceUnderTheFluxOfTheCycle", "[wall_growth]") {
  // A flux that stands still while the shaft turns, q_1 cos phi, and one that swings all round by
  // q_0 once in the period: each swings the surface by q/(k sqrt(omega/a)) [textbook].
  constexpr double kStanding = 3e4;  // q_1 [W/m2]
  constexpr double kSwinging = 2e4;  // q_0 [W/m2]
  constexpr int kSteps = 24;
  constexpr double kStep = kPeriod / kSteps;
  Swinging b;
  b.now.heat.flows.balance.to_shaft = 0.0;
  CycleRecord record(b.steps, b.course, kPeriod);
  record.begin(b.now);
  const FilmGrid& g = b.model.domain.grid;
  for (int n = 0; n < kSteps; ++n) {
    FilmStep s = b.steps.take(kStep, b.now, b.cost, nullptr);
    REQUIRE(s.verdict.good());
    for (int c = 0; c < g.cells(); ++c) {
      const double q = kStanding * std::cos(g.phi[c / g.nz]) + (n < 12 ? kSwinging : -kSwinging);
      s.heat.to_shaft[c] = kStep * q;
    }
    record.add(s, kStep, {});
    b.now = std::move(s.after);
  }
  CycleResult r;
  record.write(r);
  double told = NAN;
  for (const Note& n : r.assumptions) {
    if (const auto* swing = std::get_if<note::ShaftSwing>(&n)) told = swing->T;
  }
  const solid::Material& m = b.c.shaft->material;
  const auto swing = [&](double q, double omega) {
    const double a = m.conductivity / (m.density * m.heat_capacity);
    return q / (m.conductivity * std::sqrt(omega / a));
  };
  const double wanted =
      swing(kStanding, b.c.operation.omega) + swing(kSwinging, 2.0 * kPi / kPeriod);
  CHECK(told == Approx(wanted).epsilon(1e-3));  // cells of unequal length beside the groove
}

TEST_CASE("ASkinGrowsAsItsHarmonicLetsIt", "[wall_growth]") {
  // One material, warmer by T cos(n phi) in a depth y. Textbook: the surface of a half space rises
  // by 2 (1 + nu) alpha T y, and a ring of free ends opens by 2 alpha T y a^2/(b^2 - a^2) as a
  // whole (Lame's ring, T in its first y). The first harmonic, (2), is our own derivation.
  Case c = warm_case();
  const solid::Material m = steel();
  c.shell->layers = {{m, 5e-3}};
  Housing housing;
  housing.material = m;
  housing.outer_radius = 3.0 * c.bearing.radius;
  c.shell->housing = housing;
  const BearingModel model = make_bearing(c, physics_of(c, Tier::thd), {48, 6});
  const FilmGrid& g = model.domain.grid;
  const double T = 10.0, y = 0.5e-3, nu = m.poisson_ratio, unit = m.expansion * T * y;
  const thermal::SkinLayer layer = skin_of_shell(m, y, m);
  for (const auto& [n, exact] : {std::pair{0, -2.0 / 8.0},
                                 {1, 0.5 * (1.0 + nu) / (1.0 - nu)},
                                 {2, 2.0 * (1.0 + nu)},
                                 {5, 2.0 * (1.0 + nu)}}) {
    std::vector<thermal::SkinGrowth> skins;
    for (int k = 0; k < g.cells(); ++k) {
      const double warm = T * y * std::cos(n * g.phi[k / g.nz]);
      skins.push_back({layer.own * warm, layer.push * warm, layer.stretch * warm});
    }
    const Field narrower = narrowed_by_shell(model, skins);
    for (int k = 0; k < g.cells(); ++k) {
      const double wanted = exact * unit * std::cos(n * g.phi[k / g.nz]);
      // Cells beside the groove are not even: sums around know harmonics to second order.
      CHECK(narrower[k] == Approx(wanted).margin(0.01 * unit));
    }
  }
  // A coating without stiffness grows in its thickness, and pushes nothing.
  solid::Material soft = m;
  soft.youngs_modulus *= 1e-9;
  const thermal::SkinLayer coating = skin_of_shell(soft, y, m);
  const std::vector<thermal::SkinGrowth> warm(
      g.cells(), {coating.own * T * y, coating.push * T * y, coating.stretch * T * y});
  CHECK(narrowed_by_shell(model, warm)[0] == Approx((1.0 + nu) / (1.0 - nu) * unit).epsilon(1e-6));
}
