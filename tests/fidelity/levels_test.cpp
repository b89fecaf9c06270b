// Grids beside that of the result: every case gets bars, near cases get them cheaply.

#include <catch2/catch.hpp>

#include "../bearing/sample_bearing.hpp"
#include "bearing/bearing.hpp"
#include "fidelity/solve.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// Three supplies of different length, of which one is a line close to another's edge: seven
/// axial cells resolve their edges, six do not.
Case crowded_case() {
  Case c = plain_case();
  const auto supply = [](SupplyKind kind, double angle, double arc, double length) {
    Supply s;
    s.kind = kind;
    s.angle = angle * kDegree;
    s.arc = arc * kDegree;
    s.length = length;
    s.pressure = 1e5;
    s.temperature = 313.15;
    return s;
  };
  c.supplies = {supply(SupplyKind::axial_groove, 270.0, 49.0, 14.5e-3),
                supply(SupplyKind::axial_groove, 240.0, 0.0, 17.3e-3),
                supply(SupplyKind::circumferential_groove, 120.0, 197.0, 6.4e-3)};
  c.operation.position = LoadGiven{500.0, 90.0 * kDegree};
  return c;
}

double bar_of(const Result& r, const std::string& name) {
  for (const Quantity& q : r.quantities) {
    if (q.name == name) return q.error_grid;
  }
  return NAN;
}

}  // namespace

TEST_CASE("CoarseGridsResolveTheSupplies") {
  Case c = crowded_case();
  c.model.grid = {60, 9};
  const auto grids = fidelity::coarse_grids(c);
  REQUIRE_FALSE(grids.empty());
  for (const auto& grid : grids) {
    CHECK_NOTHROW(make_bearing(c, {}, grid));
    CHECK(grid[0] < 60);
    CHECK(grid[1] < 9);
  }
  const Result r = fidelity::solve(c);
  REQUIRE(r.verdict.good());
  CHECK(bar_of(r, "friction_torque") > 0.0);
}

TEST_CASE("CoarseGridsShowTheChamfer") {
  // Left out, as yielding edges are on few cells, it would open the last cells by half its depth.
  Case c = bearing::tests::warm_case();
  c.bearing.chamfer = EdgeOpening{200e-6, 0.4e-3};
  c.model.grid = {60, 9};
  const double foot = 0.5 * c.bearing.width - c.bearing.chamfer->length;
  const auto grids = fidelity::coarse_grids(c);
  REQUIRE_FALSE(grids.empty());
  for (const auto& grid : grids) {
    const auto faces = film_grid(c, grid).z_face;
    const auto near = [&](double z) { return std::abs(z - foot) < 1e-9; };
    CHECK(std::any_of(faces.begin(), faces.end(), near));
  }
}

TEST_CASE("WhereNoCoarserGridHoldsTheSuppliesAFinerOneGivesTheBars") {
  Case c = crowded_case();
  c.model.grid = {48, 7};
  REQUIRE(fidelity::coarse_grids(c).empty());
  const Result r = fidelity::solve(c);
  REQUIRE(r.verdict.good());
  c.model.grid = {192, 28};
  const Result fine = fidelity::solve(c);
  REQUIRE(fine.verdict.good());
  for (const char* name : {"friction_torque", "h_min", "side_flow"}) {
    INFO(name);
    CHECK(std::isfinite(bar_of(r, name)));
    CHECK(std::abs(r.value(name) - fine.value(name)) <= bar_of(r, name) + bar_of(fine, name));
  }
}

TEST_CASE("WhereSummitsMakeTheHeatAFinerGridIsAskedToo") {
  // Slow, most of the friction is that of summits; fast it is the film's.
  Case c = rig_case();
  c.model.tier = Tier::thd;
  c.model.grid = {48, 8};
  set_load(c, 8e3);
  const auto finest = [&](double rpm) {
    c.operation.omega = rpm * kRpm;
    const Solution s = solve_tier(c, c.model.tier);
    REQUIRE(s.verdict.good());
    const auto sequence = fidelity::grid_sequence(s, {}, nullptr);
    REQUIRE(sequence.coarse);
    CHECK(sequence.levels.size() > 2);  // beside the coarser ones
    return sequence.levels.back().grid;
  };
  CHECK(finest(30.0) == fidelity::finer_grid(c));
  CHECK(finest(3000.0) == c.model.grid);
}

TEST_CASE("BarsFromTheFineSolutionAreThoseFromCold") {
  // Both end on the same coarse films; what iteration leaves open (1e-4 of a quantity) is within a
  // twentieth of bars of per cents.
  constexpr double kAlike = 0.05;
  for (const Case& c : {plain_case(), warm_case()}) {
    const Solution s = solve_tier(c, c.model.tier);
    REQUIRE(s.verdict.good());
    const Result cold = fidelity::summarize(s, c.model.tier, {}, fidelity::WantedBars::grid);
    fidelity::KeptSolids kept;
    for (int turn = 0; turn < 2; ++turn) {  // the second with operators kept
      const Result warm =
          fidelity::summarize(s, c.model.tier, {}, fidelity::WantedBars::grid, &kept);
      for (const char* name : {"friction_torque", "h_min", "p_max", "side_flow"}) {
        INFO(c.title << " " << name);
        CHECK(bar_of(warm, name) == Approx(bar_of(cold, name)).epsilon(kAlike));
      }
    }
  }
}

TEST_CASE("OperatorsAreKeptForTheirOwnBodiesAndGrid") {
  const Case c = warm_case();
  fidelity::KeptSolids kept;
  const auto built = [&](const Case& of, std::array<int, 2> grid) {
    BearingModel m = make_bearing(of, physics_of(of, of.model.tier), grid, kept.find(grid));
    m.input.model.grid = grid;
    return m;
  };
  const BearingModel coarse = built(c, {34, 6});
  REQUIRE(coarse.solids);
  kept.keep(coarse);
  CHECK(built(c, {34, 6}).solids == coarse.solids);
  CHECK(kept.find({48, 9}) == nullptr);
  Case other = c;
  other.shell->layers[0].thickness *= 2.0;
  CHECK(built(other, {34, 6}).solids != coarse.solids);
}
