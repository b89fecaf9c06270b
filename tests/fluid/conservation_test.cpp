// Oil is neither made nor lost, whatever the scene.
#include <catch2/catch.hpp>

#include "fluid/fischer_burmeister.hpp"
#include "tests/fluid/film_scenes.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;

namespace {

Setup loaded() {
  Setup s;
  s.nt = 72;
  s.nz = 15;
  s.position = eccentric(0.7 * s.clearance, 4.9);
  return s;
}

FilmSolution solved(const Setup& s) {
  const auto film = solve(make_bearing(s));
  INFO(to_string(film.verdict.status));
  REQUIRE(film.good());
  return film.value;
}

/// What flows in flows out, what a cell receives it passes on, and no cell is both empty and
/// under pressure.
void check_balance(const Setup& s) {
  const PosedFilm b = make_bearing(s);
  const FilmSolution v = solved(s);
  const OilFlows flows = oil_flows(b.scene, v.flow);
  double through = std::abs(flows.side_inflow) + std::abs(flows.side);
  double patches = 0.0;
  for (const double q : flows.patch) {
    through += std::abs(q);
    patches += q;
  }
  REQUIRE(through > 0.0);
  // Sums over cells of residuals of round-off size.
  CHECK(std::abs(flows.supply - flows.side) < 1e-12 * through);
  CHECK(std::abs(flows.supply - patches) < 1e-12 * through);
  CHECK(largest_magnitude(film_residual(b.scene, v.flow)) < 1e-12 * flow_scale(v.flow));
  CHECK(complementary(b.scene, v.state));
  for (std::size_t k = 0; k < v.state.p.size(); ++k) {
    CHECK(v.state.theta[k] >= 0.0);
    CHECK(v.state.theta[k] <= 1.0);
    CHECK(v.state.p[k] >= s.p_cavitation);
    if (v.state.theta[k] < 1.0) CHECK(v.state.p[k] == s.p_cavitation);
  }
}

SupplyPatch hole(double phi) {
  return {.phi = phi, .arc = 0.3, .length = 6e-3, .round = true, .pressure = 2e5};
}

}  // namespace

TEST_CASE("FlowLeavingEqualsFlowSuppliedByAHole") {
  Setup s = loaded();
  for (const double phi : {0.0, 1.57, 3.0, 4.9}) {
    s.patches = {hole(phi)};
    check_balance(s);
  }
}

TEST_CASE("FlowLeavingEqualsFlowSuppliedByAGroove") {
  Setup s = loaded();
  for (const double length : {0.012, 0.02}) {
    s.patches = {{.phi = 1.6, .arc = 0.3, .length = length, .pressure = 1e5}};
    check_balance(s);
  }
}

TEST_CASE("FlowLeavingEqualsFlowSuppliedByALine") {
  Setup s = loaded();
  s.patches = {line_supply(s, 1.0, 1e5)};
  check_balance(s);
  s.speed = -s.speed;
  check_balance(s);
  s.patches = {{.phi = 1.0, .length = 0.01, .pressure = 1e5}};
  check_balance(s);
}

TEST_CASE("FlowLeavingEqualsFlowSuppliedByCircumferentialGrooves") {
  Setup s = loaded();
  s.patches = {{.arc = 2.0 * kPi, .length = 4e-3, .pressure = 2e5}};
  check_balance(s);
  s.patches = {{.phi = 1.5, .arc = kPi, .length = 4e-3, .pressure = 2e5}};
  check_balance(s);
}

TEST_CASE("FlowLeavingEqualsFlowSuppliedBySeveralSupplies") {
  Setup s = loaded();
  s.patches = {hole(0.3), hole(2.2), {.phi = 3.6, .arc = 0.4, .length = 0.01, .pressure = 8e5}};
  s.patches[1].z = 3e-3;
  s.patches[1].pressure = 0.0;
  check_balance(s);
  // Ahead of the narrow gap the film's pressure exceeds the groove's and presses oil back into it;
  // behind the gap the film is empty and takes oil from the hole.
  const PosedFilm b = make_bearing(s);
  const OilFlows flows = oil_flows(b.scene, solved(s).flow);
  CHECK(flows.patch[2] < 0.0);
  CHECK(flows.patch[0] > 0.0);
}

TEST_CASE("FlowLeavingEqualsFlowSuppliedWithoutAnySupply") {
  // Flooded edges above the cavitation pressure feed what they lose elsewhere.
  Setup s = loaded();
  s.p_cavitation = -1e5;
  check_balance(s);
  s.position = {{5e-6, -8e-6, 3e-4, -2e-4}};
  check_balance(s);
}

TEST_CASE("FlowLeavingEqualsFlowSuppliedBetweenDryAndFloodedEdges") {
  Setup s = loaded();
  s.patches = {hole(1.6)};
  s.p_cavitation = -8e4;
  for (const SideEdges edges : {SideEdges::flooded, SideEdges::dry}) {
    s.edges = edges;
    check_balance(s);
    const PosedFilm b = make_bearing(s);
    const OilFlows flows = oil_flows(b.scene, solved(s).flow);
    if (edges == SideEdges::dry) CHECK(flows.side_inflow == 0.0);
    if (edges == SideEdges::flooded) CHECK(flows.side_inflow > 0.0);
  }
}

TEST_CASE("FlowLeavingEqualsFlowSuppliedUnderTiltAndProfile") {
  Setup s = loaded();
  s.patches = {hole(1.6)};
  s.position = {{3e-6, -11e-6, 3e-4, 2e-4}};
  check_balance(s);
  s.profile = [](double phi, double z) { return 3e-6 * (1.0 + std::sin(9.0 * phi + 900.0 * z)); };
  check_balance(s);
}

TEST_CASE("FlowLeavingEqualsFlowSuppliedOfBarusOilBetweenRoughSurfaces") {
  Setup s = loaded();
  s.patches = {hole(1.6)};
  s.barus = 1.5e-8;
  check_balance(s);
  s.rough = rough_pair({1.0e-6, 6.0}, {0.5e-6, 1.0});
  check_balance(s);
}

TEST_CASE("FlowLeavingEqualsFlowSuppliedOnHalfGrids") {
  Setup s = loaded();
  s.half = true;
  s.patches = {hole(1.6), {.phi = 3.4, .arc = 0.3, .length = 0.01, .pressure = 1e5}};
  for (const int nz : {14, 15}) {
    s.nz = nz;
    check_balance(s);
  }
}

TEST_CASE("TheFlowThroughAnEmptyFilmIsHandedOnUnchanged") {
  // In striated film nothing spreads: theta h stays what it was at rupture, along every strip.
  Setup s = loaded();
  s.patches = {line_supply(s, 4.9 + kPi)};
  const PosedFilm b = make_bearing(s);
  const FilmSolution v = solved(s);
  const FilmGrid& g = b.scene.grid;
  int strips = 0;
  for (int i = 1; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j), west = g.index(i - 1, j);
      const bool lone = v.state.p[west] == 0.0 && v.state.p[k] == 0.0 && i + 1 < g.nt &&
                        v.state.p[g.index(i + 1, j)] == 0.0 &&
                        (j == 0 || v.state.p[k - 1] == 0.0) &&
                        (j + 1 == g.nz || v.state.p[k + 1] == 0.0);
      if (!lone) continue;
      const double in = v.flow.phi[k].m, out = v.flow.phi[g.index(g.next(i), j)].m;
      CHECK(std::abs(in - out) < 1e-12 * flow_scale(v.flow));
      ++strips;
    }
  }
  CHECK(strips > 50);
}
