/// Tier tehd: thermal deformation and elastic deformation with the heat that causes them.
#include <catch2/catch.hpp>

#include "bearing/heat/heat_endings.hpp"
#include "bearing/solids.hpp"
#include "core/make_grid.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// Thermal deformation of the gap with film, shell and shaft all at one temperature.
Field deformation_at(const Case& c, double T) {
  const FilmGrid grid = make_grid(c.bearing.radius, c.bearing.width, 48, 9, true);
  const Solids solids(c, grid, {false, true, true});
  WallFlux none{Field(grid.cells(), 0.0), std::vector<double>(grid.nz, 0.0), {}};
  none.response.shaft = 1e6;  // a film that holds the shaft at T
  return solids.answer(none, Field(grid.cells(), T), std::vector<double>(grid.nz, T), {true, false})
      .thermal_deformation;
}

Case all_steel(double back) {
  Case c = warm_case();
  c.shell->housing->material = steel();
  c.shell->housing->support = HousingSupport::free;
  c.shell->back = ConvectiveBack{200.0, back};
  c.shaft->ambient = back;
  return c;
}

}  // namespace

TEST_CASE("SteelBearingOnSteelShaftKeepsItsRelativeClearance", "[deformation]") {
  const double T = 393.15;
  const Case c = all_steel(T);
  // Shell and shaft of radius R grow alike: the gap by alpha dT times the difference of their
  // radii, which the linear theory leaves out.
  const Field d = deformation_at(c, T);
  const double one = steel().expansion * (T - c.bearing.reference_temperature) * c.bearing.radius;
  CHECK(largest_magnitude(d) < 1e-6 * one);  // 27 um each; round-off of the stiffness matrix
}

TEST_CASE("AluminiumHousingOpensTheGapAndABronzeShaftClosesIt", "[deformation]") {
  const double T = 393.15;
  const double dT = T - 293.15;
  Case c = all_steel(T);
  c.shell = Shell{{{aluminium(), 5e-3}},
                  Housing{aluminium(), 0.06, HousingSupport::free},
                  ConvectiveBack{200.0, T},
                  50.0};
  const double R = c.bearing.radius;
  for (const double x : deformation_at(c, T)) {  // one free body: R (alpha_Al - alpha_steel) dT
    CHECK(x == Approx(R * (23e-6 - 11e-6) * dT).epsilon(1e-6));
  }
  c.shaft->material.expansion = 30e-6;
  for (const double x : deformation_at(c, T)) {
    CHECK(x == Approx(R * (23e-6 - 30e-6) * dT).epsilon(1e-6));
  }
}

TEST_CASE("AShaftThatOutgrowsItsBoreClosesTheBearingBeforeItTurns", "[deformation]") {
  // One free steel body around a shaft that grows by x more: the gap loses R x dT. 303 K around the
  // bearing, 313 K in the supply, 293 K where the clearance was measured.
  using At = ending::NoClearance::At;
  Case c = all_steel(303.15);
  const FilmGrid grid = make_grid(c.bearing.radius, c.bearing.width, 24, 5, true);
  const double R = c.bearing.radius, gap = c.bearing.radial_clearance;
  const auto closed = [&](double x) {
    c.shaft->material.expansion = steel().expansion + x;
    return closed_at_rest(c, Solids(c, grid, {false, true, true}), grid);
  };
  CHECK_FALSE(closed(0.99 * gap / (R * 20.0)));
  const auto warmest = closed(1.01 * gap / (R * 20.0));
  REQUIRE(warmest);
  CHECK(warmest->at == At::warmest);
  CHECK(warmest->T == Approx(313.15));
  CHECK(warmest->deformation == Approx(-1.01 * gap).epsilon(1e-6));
  const auto coldest = closed(1.01 * gap / (R * 10.0));
  REQUIRE(coldest);
  CHECK(coldest->at == At::coldest);
  CHECK(coldest->T == Approx(303.15));
  CHECK(coldest->deformation == Approx(-1.01 * gap).epsilon(1e-6));
}

TEST_CASE("StiffSolidsThatDoNotGrowAreThoseOfTierThd", "[deformation]") {
  Case c = warm_case();
  set_load(c, 5e3);
  const Solution thd = solve_tier(c, Tier::thd);
  const auto stiffen = [](solid::Material& m) {
    m.youngs_modulus *= 1e5;
    m.expansion = 0.0;
  };
  for (ShellLayer& layer : c.shell->layers) stiffen(layer.material);
  stiffen(c.shell->housing->material);
  stiffen(c.shaft->material);
  const Solution tehd = solve_tier(c, Tier::tehd);
  REQUIRE(thd.verdict.good());
  REQUIRE(tehd.verdict.good());
  CHECK(largest_magnitude(tehd.heat.thermal_deformation) == 0.0);
  // fixed points to 1e-3 K and beta = 0.035 1/K
  CHECK(torque_of(tehd) == Approx(torque_of(thd)).epsilon(1e-4));
  CHECK(tehd.film.least.h == Approx(thd.film.least.h).epsilon(1e-4));
}

TEST_CASE("SwitchesTurnTierTehdIntoTierThd", "[deformation]") {
  Case c = rig_case();
  c.model.switches.elastic_deformation = false;
  c.model.switches.thermal_deformation = false;
  set_load(c, 3e3);
  const Solution a = solve_tier(c, Tier::tehd);
  const Solution b = solve_tier(c, Tier::thd);
  REQUIRE(a.verdict.good());
  CHECK(torque_of(a) == torque_of(b));  // the same physics: the same digits
}

TEST_CASE("ThermalGrowthIsThatOfTheSolidsTemperature", "[deformation]") {
  const Solution s = solve_tier(grooved_case(), Tier::tehd);
  REQUIRE(s.verdict.good());
  // the film was solved for a thermal deformation that its heat makes again, to the loop's 3e-4
  // clearances
  CHECK(largest_difference(s.heat.thermal_deformation, s.heat.solids.thermal_deformation) <
        3e-4 * s.model.clearance);
  CHECK(largest_difference(s.heat.T_shell, s.heat.solids.shell.surface) < 2e-3);  // [K]
}

TEST_CASE("WarmShaftInAColdShellLosesClearance", "[deformation]") {
  Case c = warm_case();
  c.shell->housing->material = steel();
  c.shell->back = PrescribedBack{303.15};
  c.shaft->heat_transfer = 0.0;
  Case rigid = c;
  rigid.model.switches.thermal_deformation = false;
  const Solution grown = solve_tier(c, Tier::tehd);
  const Solution unchanged = solve_tier(rigid, Tier::tehd);
  REQUIRE(grown.verdict.good());
  REQUIRE(unchanged.verdict.good());
  for (const double d : grown.heat.thermal_deformation) CHECK(d < 0.0);
  CHECK(torque_of(grown) > torque_of(unchanged));
}
