// What is said of a result's bars against its tolerance holds when it is tried.
#include "fidelity/tolerance.hpp"

#include <catch2/catch.hpp>

#include "../bearing/sample_bearing.hpp"
#include "fidelity/grid_error.hpp"
#include "fidelity/solve.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;
using fidelity::shortfall;
using fidelity::told_apart;

namespace {

/// A result with one bar of the grid on torque and film.
Result with_bars(double grid, double model, double order) {
  Result r;
  r.grid = {200, 25};
  r.quantities = {{"friction_torque", 2.0, "N m", 2.0 * grid, 2.0 * model, order},
                  {"h_min", 5e-6, "m", 0.5 * 5e-6 * grid, 5e-6 * model, order}};
  return r;
}

}  // namespace

TEST_CASE("TheGridProposedMeetsTheTolerance") {
  Case c = plain_case();
  const Result coarse = fidelity::solve(c);
  REQUIRE(coarse.verdict.good());
  const auto before = shortfall(coarse, 1.0);
  // Half the wider bar: a grid about twice as fine.
  const double tolerance = 0.5 * std::max(before.friction.total(), before.h_min.total());
  const auto missed = shortfall(coarse, tolerance);
  REQUIRE_FALSE(missed.met);
  REQUIRE_FALSE(missed.physics);
  CHECK(missed.grid[0] > c.model.grid[0]);
  CHECK(missed.grid[1] > c.model.grid[1]);
  CHECK(missed.expected <= tolerance * (1.0 + 1e-12));
  c.model.grid = missed.grid;
  CHECK(shortfall(fidelity::solve(c), tolerance).met);
}

TEST_CASE("CellsWantedFollowTheObservedOrder") {
  // (1): half the bar takes 2^(1/p) times the cells in each direction.
  const auto first = shortfall(with_bars(0.02, NAN, 1.0), 0.01);
  CHECK(first.grid == std::array<int, 2>{400, 50});
  const auto second = shortfall(with_bars(0.02, NAN, 2.0), 0.01);
  CHECK(second.grid == std::array<int, 2>{290, 36});  // 1.414 times, rounded up
  // The physics left out uses up half of the tolerance.
  const auto less = shortfall(with_bars(0.01, 0.005, 1.0), 0.01);
  CHECK(less.grid == std::array<int, 2>{400, 50});
}

TEST_CASE("WhatNodesAcrossTheFilmLeaveIsMendedByNodes") {
  // A bar of 2 %, three quarters of it of the nodes: what is left is within 1 % on the same cells.
  Result r = with_bars(0.02, NAN, 1.0);
  for (Quantity& q : r.quantities) q.error_nodes = 0.75 * q.error_grid;
  const auto nodes = shortfall(r, 0.01);
  CHECK(nodes.more_nodes);
  CHECK(nodes.grid == r.grid);
  CHECK(nodes.expected == Approx(0.005));
  // A tenth: cells have to make up for it, 0.018/(0.01 - 0.002) times as many a direction.
  for (Quantity& q : r.quantities) q.error_nodes = 0.1 * q.error_grid;
  const auto cells = shortfall(r, 0.01);
  CHECK_FALSE(cells.more_nodes);
  CHECK(cells.grid == std::array<int, 2>{450, 57});
  CHECK(cells.expected <= 0.01 * (1.0 + 1e-12));
  // No more nodes to be had: where they leave more than is allowed, no cells help.
  for (Quantity& q : r.quantities) q.error_nodes = 0.75 * q.error_grid;
  const auto stuck = shortfall(r, 0.01, true);
  CHECK_FALSE(stuck.more_nodes);
  CHECK(stuck.grid == r.grid);
  CHECK(stuck.expected == Approx(0.02));
  // Cells that no step of ten divides stay as they are.
  r.grid = {48, 7};
  CHECK(shortfall(r, 0.01).grid == r.grid);
}

TEST_CASE("WhatAGridCannotMendIsToldAsPhysics") {
  const auto s = shortfall(with_bars(0.001, 0.3, 1.0), 0.01);
  CHECK_FALSE(s.met);
  CHECK(s.physics);
}

TEST_CASE("NoGridIsProposedBeyondTheFinest") {
  const auto s = shortfall(with_bars(0.3, NAN, 1.0), 0.001);
  CHECK(s.grid == fidelity::kFineGrid);
  CHECK(s.expected > s.tolerance);  // and it does not promise what that grid cannot keep
}

TEST_CASE("ABarWithinTheToleranceIsMetAndAnUnknownOneMissesNothing") {
  CHECK(shortfall(with_bars(0.009, NAN, 1.0), 0.01).met);
  CHECK(shortfall(with_bars(NAN, NAN, NAN), 0.01).met);
}

TEST_CASE("BarsOfWhatChangesItsSignAreMeasuredByItsMagnitude") {
  Result r = with_bars(0.005, NAN, 1.0);
  r.quantities[0].value = 0.0;  // the mean torque of a pin that swings
  r.quantities[0].magnitude = 2.0;
  CHECK(fidelity::relative_bars(r, "friction_torque").grid == Approx(0.005));
  CHECK(shortfall(r, 0.01).met);
  r.quantities[0].magnitude = 0.5;
  CHECK_FALSE(shortfall(r, 0.01).met);
}

TEST_CASE("ResultsAreToldApartByMoreThanTheSumOfTheirBars") {
  const auto q = [](double value, double bar) {
    return Quantity{"friction_torque", value, "N m", bar, NAN};
  };
  CHECK_FALSE(told_apart(q(0.5398, 0.011), q(0.5385, 0.013)));
  CHECK_FALSE(told_apart(q(1.0, 0.06), q(1.1, 0.05)));
  CHECK(told_apart(q(1.0, 0.04), q(1.1, 0.05)));
  CHECK(told_apart(q(1.1, 0.05), q(1.0, 0.04)));  // whichever comes first
  CHECK(told_apart(q(1.0, 0.0), q(1.0, 0.0)));    // bars of nothing hide nothing
  CHECK(told_apart(q(1.0, NAN), q(1.1, 0.05)));   // nothing is said of what is not known
}
