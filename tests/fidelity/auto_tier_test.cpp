#include "fidelity/auto_tier.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/words/note_words.hpp"
#include "fidelity/grid_error.hpp"
#include "fidelity/held_film.hpp"
#include "fidelity/quantities.hpp"
#include "fidelity/solve_case.hpp"
#include "fidelity/tolerance.hpp"
#include "tests/bearing/sample_bearing.hpp"

namespace shellback::fidelity {
namespace {

using namespace bearing;
using namespace bearing::tests;

const Effect& effect(const Result& r, EffectKind kind) {
  for (const Effect& e : r.effects) {
    if (e.kind == kind) return e;
  }
  throw std::runtime_error("no such effect");
}

Case automatic(Case c, double tolerance) {
  c.model.tier = Tier::automatic;
  c.model.tolerance = tolerance;
  c.model.grid = {200, 25};
  return c;
}

}  // namespace

TEST_CASE("ValueOfTheFineGridAndTheLimitAreFound") {
  for (const double order : {1.0, 1.4, 1.75, 2.0}) {
    INFO(order);
    const auto f = [order](double n) { return 1.0 + std::pow(n, -order); };
    // Along: 12 and 24 cells; exact for the highest order, else within the bar.
    const GridLimit along = grid_limit({f(12)}, {f(24)}, 12, 24);
    if (order == kMostOrder) CHECK(along.value == Approx(f(kFineGrid[1])).epsilon(1e-12));
    CHECK(std::abs(along.value - f(kFineGrid[1])) <= along.bar);
    CHECK(std::abs(along.value - 1.0) <= along.bar + along.beyond);
    // Around: the film on 80 cells after a solution on 40.
    const GridLimit around = film_limit(f(40), f(80), 40, 80);
    CHECK(std::abs(around.value - f(kFineGrid[0])) <= around.bar);
    CHECK(std::abs(around.value - 1.0) <= around.bar + around.beyond);
    // The fine grid itself, after 400 cells.
    const GridLimit at_end = film_limit(f(400), f(kFineGrid[0]), 400, kFineGrid[0]);
    CHECK(at_end.value == f(kFineGrid[0]));
    CHECK(at_end.bar == 0.0);
    CHECK(std::abs(at_end.value - 1.0) <= at_end.beyond * (1.0 + 1e-12));
  }
  // Nothing is left on the fine grid itself.
  CHECK(onward(400, 800, kFineGrid[0], 1.3) == 0.0);
  CHECK(onward(400, 800, INFINITY, 1.0) == Approx(1.0));
}

TEST_CASE("HeldFilmOnItsOwnGridIsTheSolution") {
  for (const AcrossFilm across : {AcrossFilm::lobatto, AcrossFilm::layers, AcrossFilm::mean}) {
    Case c = warm_case();
    c.model.tier = Tier::tehd;
    c.model.methods.across = across;
    const Solution s = solve_tier(c, Tier::tehd);
    REQUIRE(s.verdict.good());
    const Solution f = held_film(s, c.model.grid, {s.model.physics});
    REQUIRE(f.verdict.good());
    // To the tolerance of the thermal loop, which leaves the last change of temperature open.
    CHECK(f.film.least.h == Approx(s.film.least.h).epsilon(1e-4));
    CHECK(friction_of(f.model, f.point, f.film).viscous ==
          Approx(friction_of(s.model, s.point, s.film).viscous).epsilon(1e-4));
  }
}

TEST_CASE("TiersWithAHeatBalanceSayThatHeatingIsIn") {
  Case c = warm_case();
  for (const Tier tier : {Tier::isothermal, Tier::lumped, Tier::thd}) {
    c.model.tier = tier;
    const Result r = bearing::summarize(solve_tier(c, tier), tier);
    CHECK(effect(r, EffectKind::heating).included == (tier != Tier::isothermal));
  }
}

TEST_CASE("OfAFilmThatIsNotLaminarNoToleranceIsMet") {
  Case c = automatic(warm_case(), 0.05);
  c.bearing.radial_clearance = 400e-6;
  c.operation.omega = 20000.0 * kRpm;
  const Result r = solve_case(c);
  REQUIRE(r.verdict.good());
  CHECK_FALSE(is_laminar(r.warnings));
  REQUIRE(r.choice);
  CHECK_FALSE(r.choice->met);
  CHECK_FALSE(shortfall(r, 0.05).met);
}

TEST_CASE("AutoIsWithinToleranceOfAFineSolution") {
  for (const double tolerance : {0.03, 0.01}) {
    const Case c = automatic(warm_case(), tolerance);
    const Result r = solve_case(c);
    REQUIRE(r.verdict.good());
    REQUIRE(r.choice);
    CHECK(r.choice->met);
    Case fine = warm_case();
    fine.model.grid = {200, 50};
    const Result truth = summarize(solve_tier(fine, Tier::tehd), Tier::tehd);
    REQUIRE(truth.verdict.good());
    CHECK(r.value("friction_torque") == Approx(truth.value("friction_torque")).epsilon(tolerance));
    CHECK(r.value("h_min") == Approx(truth.value("h_min")).epsilon(tolerance));
    CHECK(r.grid[0] * r.grid[1] < 0.3 * 200 * 50);  // with far fewer cells
    for (const Quantity& q : r.quantities) {
      INFO(q.name);
      CHECK(q.error_grid >= 0.0);
    }
  }
}

TEST_CASE("TighterTolerancesTakeMoreCellsAndAgree") {
  Case c = automatic(warm_case(), 0.03);
  const Result loose = solve_case(c);
  REQUIRE(loose.choice);
  // What the fine grid itself lacks is in the bars, though not in what the tolerance is held to.
  for (const Quantity& q : loose.quantities) {
    if (q.name == "h_min") CHECK(q.error_grid >= loose.choice->bar_h_min * q.value * 0.99);
  }
  c.model.tolerance = 0.005;
  const Result tight = solve_case(c);
  REQUIRE(tight.choice);
  CHECK(tight.grid[0] * tight.grid[1] > loose.grid[0] * loose.grid[1]);
  CHECK(tight.choice->bar_h_min < loose.choice->bar_h_min);
  CHECK(loose.value("h_min") == Approx(tight.value("h_min")).epsilon(0.03));
  CHECK(loose.value("friction_torque") == Approx(tight.value("friction_torque")).epsilon(0.03));
}

TEST_CASE("WhereNoExtrapolationIsGoodEnoughTheFineGridIsSolved") {
  Case c = automatic(plain_case(), 1e-8);
  const Result r = solve_case(c);
  REQUIRE(r.verdict.good());
  CHECK(r.grid == kFineGrid);
  c.model.grid = kFineGrid;
  const Result direct = summarize(solve_tier(c, r.tier), r.tier);
  // To the tolerance of the film's Newton iteration.
  CHECK(r.value("h_min") == Approx(direct.value("h_min")).epsilon(1e-6));
  CHECK(r.value("friction_torque") == Approx(direct.value("friction_torque")).epsilon(1e-6));
}

TEST_CASE("AutoThatIsInterruptedSaysSoWhereverItIs") {
  // Some stops fall into the probe, some into its nodes and effects, some into finer grids.
  for (const int turns : {2, 9, 12, 15, 20}) {
    INFO(turns);
    std::atomic<bool> stop{false};
    int told = 0;
    SolveControl control;
    control.stop = &stop;
    control.progress = [&](const Progress&) { stop = stop || ++told >= turns; };
    const Result r = solve_auto(automatic(warm_case(), 1e-4), control);
    CHECK(stop);
    CHECK(r.verdict.status == Status::interrupted);
  }
}

TEST_CASE("AutoLeavesOutWhatChangesNothingAndSaysSo") {
  const Result r = solve_case(automatic(warm_case(), 0.05));
  REQUIRE(r.verdict.good());
  // The oil has neither pressure nor shear law.
  CHECK_FALSE(effect(r, EffectKind::viscosity_with_pressure).included);
  CHECK(effect(r, EffectKind::viscosity_with_pressure).change_in_friction == 0.0);
  CHECK_FALSE(effect(r, EffectKind::shear_thinning).included);
  // Heated oil is thinner: heating lowers friction and film.
  CHECK(effect(r, EffectKind::heating).included);
  CHECK(effect(r, EffectKind::heating).change_in_friction < -0.05);
  CHECK(effect(r, EffectKind::heating).change_in_h_min < 0.0);
}

TEST_CASE("WhatIsLeftOutIsInTheBarsOfEveryQuantity") {
  // A little of Barus' law, left out at a loose tolerance: what it changes on a grid of its own is
  // within the model bar, 1.75 times what it changed in the probe's film, of whatever is told.
  Case c = warm_case();
  c.oil.pressure = rheology::Barus{4e-9};
  const Result loose = solve_case(automatic(c, 0.1));
  REQUIRE(loose.verdict.good());
  REQUIRE_FALSE(effect(loose, EffectKind::viscosity_with_pressure).included);
  c.model.tier = Tier::tehd;
  c.model.grid = {60, 36};
  const Result with = solve_case(c);
  c.model.switches.pressure_dependence = false;
  const Result without = solve_case(c);
  for (const char* name : {"attitude_angle", "eccentricity_ratio", "side_flow", "p_max",
                           "T_film_max", "T_shell_max", "h_min", "friction_torque"}) {
    INFO(name);
    const Quantity* q = quantity_in(loose.quantities, name);
    REQUIRE(q != nullptr);
    CHECK(q->error_model > 0.0);
    CHECK(std::abs(with.value(name) - without.value(name)) <= q->error_model);
  }
}

TEST_CASE("AutoRespectsSwitchesAndGridOfTheCase") {
  Case c = automatic(warm_case(), 0.01);
  c.model.switches.elastic_deformation = false;
  c.model.grid = {96, 13};
  c.model.grid_given = true;
  const Result r = solve_case(c);
  REQUIRE(r.verdict.good());
  CHECK(r.grid == std::array<int, 2>{96, 13});
  CHECK_FALSE(effect(r, EffectKind::elastic_deformation).included);
  const Result direct = summarize(solve_tier(c, Tier::tehd), Tier::tehd);
  // The values are those of the given grid, to the tolerance of the thermal loop.
  CHECK(r.value("h_min") == Approx(direct.value("h_min")).epsilon(2e-3));
}

TEST_CASE("AutoLeavesSummitsOutOnlyWhereTheFilmDoesNotFeelThem") {
  // Honed smooth between its summits: the flow knows no roughness, the contact does.
  Case c = rig_case();
  c.surfaces.shell.roughness = c.surfaces.shaft.roughness = 0.0;
  c.operation.omega /= 3.0;
  set_load(c, 10e3);
  const Result r = solve_case(automatic(c, 0.05));
  REQUIRE(r.verdict.good());
  CHECK(effect(r, EffectKind::roughness_and_contact).included);
  const Result fine = solve_case(c);
  REQUIRE(fine.verdict.good());
  const double asperities = fine.value("friction_torque_asperity");
  REQUIRE(asperities > 0.2 * fine.value("friction_torque"));
  const Quantity* told = quantity_in(r.quantities, "friction_torque_asperity");
  const Quantity* known = quantity_in(fine.quantities, "friction_torque_asperity");
  CHECK(std::abs(told->value - asperities) <= told->error_grid + known->error_grid);
}

TEST_CASE("BarsOfCoefficientsFromCoarseGridsHoldThoseOfAFineOne") {
  Case c = grooved_case();
  c.model.coefficients = true;
  const Result r = solve_case(automatic(c, 0.03));
  REQUIRE(r.verdict.good());
  c.model.tier = Tier::tehd;
  c.model.grid = {200, 48};
  const Result fine = solve_case(c);
  REQUIRE(fine.verdict.good());
  int judged = 0;
  for (const Quantity& q : r.quantities) {
    if (!is_coefficient(q) && !q.name.starts_with("whirl_")) continue;
    INFO(q.name);
    const Quantity* known = quantity_in(fine.quantities, q.name);
    REQUIRE(known != nullptr);
    CHECK(std::abs(q.value - known->value) <= q.error() + known->error_grid);
    ++judged;
  }
  CHECK(judged >= 8);
}

TEST_CASE("AutoKeepsTheGridOfTheCaseHoweverTightTheTolerance") {
  Case c = automatic(warm_case(), 1e-3);
  c.model.grid = {60, 9};
  c.model.grid_given = true;
  const Result r = solve_case(c);
  REQUIRE(r.verdict.good());
  CHECK(r.grid == c.model.grid);
  CHECK_FALSE(r.choice->met);
}

TEST_CASE("SuppliesThatTheProbeCannotHoldAreSolvedOnTheGridOfTheCase") {
  Case c = plain_case();
  Supply hole = hole_case().supplies[0];
  hole.diameter = 1e-3;
  c.supplies.clear();
  for (int k = 0; k < 7; ++k) {
    hole.z = (k - 3) * 0.12 * c.bearing.width;
    c.supplies.push_back(hole);
  }
  c.model.grid = {96, 41};
  const Result alone = summarize(solve_tier(c, Tier::isothermal), Tier::isothermal);
  REQUIRE(alone.verdict.good());
  Case by_auto = automatic(c, 0.01);
  by_auto.model.grid = c.model.grid;
  by_auto.model.grid_given = true;
  const Result r = solve_case(by_auto);
  REQUIRE(r.verdict.good());
  CHECK(r.grid == c.model.grid);
  CHECK(r.value("h_min") == Approx(alone.value("h_min")).epsilon(1e-6));
  // Oil that thins as it warms, and no walls to warm: how warm it is, is not known well enough.
  by_auto.oil.temperature = rheology::ReynoldsSlope{0.03, 313.15, 0.035};
  const Result warm = solve_case(by_auto);
  REQUIRE(warm.verdict.good());
  CHECK(warm.tier == Tier::lumped);
  CHECK_FALSE(warm.choice->met);
}

TEST_CASE("WithoutWallsAutoSaysThatTheHeatIsUncertain") {
  Case c = automatic(warm_case(), 0.01);
  c.shell.reset();
  c.shaft.reset();
  const Result r = solve_case(c);
  REQUIRE(r.verdict.good());
  CHECK(r.tier == Tier::lumped);
  CHECK_FALSE(r.choice->met);
  REQUIRE_FALSE(r.warnings.empty());
  CHECK(app::words_of(r.warnings.back()).find("shell and shaft") != std::string::npos);
  // Constant viscosity does not mind the heat.
  c.oil.temperature = rheology::ConstantViscosity{0.02};
  const Result constant = solve_case(c);
  CHECK(constant.tier == Tier::isothermal);
  CHECK(constant.choice->met);
}

}  // namespace shellback::fidelity
