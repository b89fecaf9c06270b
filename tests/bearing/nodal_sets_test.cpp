// Other nodal sets across the film: how near they come to that of Lobatto.
#include <algorithm>
#include <catch2/catch.hpp>

#include "bearing/steady/audit.hpp"
#include "tests/bearing/sample_bearing.hpp"
#include "tests/observed_order.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

Solution solved(Case c, const Methods& methods) {
  c.model.methods = methods;
  return solve_tier(c, c.model.tier);
}

Case on_sixty_cells(Case c) {
  c.model.grid = {60, 9};
  return c;
}

}  // namespace

TEST_CASE("LayersAcrossTheFilmApproachTheLobattoFilmWithSecondOrder") {
  Case c = on_sixty_cells(grooved_case());
  c.model.film_nodes = 11;
  const double exact = torque_of(solved(c, {}));
  const auto error = [&](int layers) {
    Methods m;
    m.across = AcrossFilm::layers;
    m.layers = layers;
    const Solution s = solved(c, m);
    REQUIRE(s.verdict.good());
    return torque_of(s) - exact;
  };
  const double coarse_error = error(8);
  // the turns' own tolerance leaves some of the order
  CHECK(shellback::test::order_of_errors(coarse_error, error(16)) == Approx(2.0).margin(0.3));
}

TEST_CASE("EveryNodalSetBalancesItsHeat") {
  for (const auto across : {AcrossFilm::layers, AcrossFilm::mean}) {
    Methods m;
    m.across = across;
    m.layers = 10;
    const Solution s = solved(on_sixty_cells(grooved_case()), m);
    REQUIRE(s.verdict.good());
    CHECK(audit_of(s, friction_of(s.model, s.point, s.film)).energy < 1e-6);
  }
}

TEST_CASE("FilmMeanTemperatureMissesThePeakThatTheResolvedFilmHas") {
  Case c = on_sixty_cells(grooved_case());
  const auto hottest = [&](const Methods& m) {
    const Solution s = solved(c, m);
    REQUIRE(s.verdict.good());
    return *std::max_element(s.film.columns.T.begin(), s.film.columns.T.end());
  };
  Methods mean;
  mean.across = AcrossFilm::mean;
  CHECK(hottest(mean) < hottest({}) - 0.2);
}
