// Walls that grow in time: skins between the steps of a cycle, bodies from one cycle to the next.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/cycle_record.hpp"
#include "bearing/over_time/film_step.hpp"
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

TEST_CASE("SkinsOpenTheGapAsTheBodiesDoThatTheyBelongTo", "[wall_growth]") {
  Case c = warm_case();
  const solid::Material m = steel();
  c.shell->layers = {{aluminium(), 1e-3}, {m, 4e-3}};
  Housing housing;
  housing.material = m;
  housing.outer_radius = 3.0 * c.bearing.radius;
  c.shell->housing = housing;
  c.shaft->overhang = 0.0;  // it would have no skin
  Physics physics = physics_of(c, Tier::thd);
  physics.thermal_deformation = true;
  const double a = c.bearing.radius, b = housing.outer_radius, T = 10.0;
  const auto opening = [&](const BearingModel& model, std::vector<double> depth, Field T_skin) {
    const int count = static_cast<int>(T_skin.size()) / model.domain.grid.cells();
    return model.solids->widening(model.solids->opening_by_skins({std::move(depth), count}),
                                  T_skin);
  };
  for (const std::array<int, 2> cells : {std::array{48, 6}, std::array{48, 7}}) {
    const BearingModel model = make_bearing(c, physics, cells);
    const FilmGrid& g = model.domain.grid;
    const Solids& solids = *model.solids;
    // As deep as the bodies and as warm all through: shell, housing and shaft one kelvin warmer.
    Field skin = opening(model, {0.0, b - a}, Field(2 * g.cells(), 1.0));
    const Eigen::MatrixXd by_shaft = solids.opening_by_shaft_skins({{0.0, a}, 2});
    const Eigen::VectorXd journal = by_shaft * Eigen::VectorXd::Ones(by_shaft.cols());
    const Field warm = solids.at(solids.uniform_state(314.15)).thermal_deformation;
    const Field cold = solids.at(solids.uniform_state(313.15)).thermal_deformation;
    for (int k = 0; k < g.cells(); ++k) {
      CHECK(skin[k] + journal[k % g.nz] ==
            Approx(warm[k] - cold[k]).margin(1e-9 * m.expansion * a));
    }
  }
  // Lame's ring: one material, warmer by T in its first y, opens by 2 alpha T y a^2/(b^2 - a^2) as
  // a whole, whatever the ends do (textbook; y of a hundredth: T and radii are not quite linear).
  c.shell->layers = {{m, 5e-3}};
  const BearingModel ring = make_bearing(c, physics, {48, 6});
  const double y = 0.01 * a;
  const Field thin = opening(ring, {0.0, 0.999 * y, y}, Field(2 * ring.domain.grid.cells(), T));
  const double lame = 2.0 * m.expansion * T * y * a * a / (b * b - a * a);
  CHECK(area_mean(ring.domain.grid, thin) == Approx(lame).epsilon(0.02));
  // From a harmonic on that the ring does not bend for, and the ends do not reach, it swells, by
  // no more than the long half space's 2 (1 + nu) alpha T y and no less than the free slice's
  // 2 alpha T y (textbook).
  const FilmGrid& g = ring.domain.grid;
  constexpr int kHarmonic = 7;
  Field around(2 * static_cast<std::size_t>(g.cells()));
  for (int k = 0; k < 2 * g.cells(); ++k) {
    around[k] = T * std::cos(kHarmonic * g.phi[k / (2 * g.nz)]);
  }
  const Field swollen = opening(ring, {0.0, 0.999 * y, y}, around);
  const double slice = 2.0 * m.expansion * T * y;
  CHECK(largest_magnitude(swollen) > 0.9 * slice);  // cells round its tops off
  CHECK(largest_magnitude(swollen) < (1.0 + m.poisson_ratio) * slice);
}
