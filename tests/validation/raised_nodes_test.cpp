// Hot random bearings whose columns beside the supply polynomials alone do not resolve.
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/heat/heat_endings.hpp"
#include "bearing/steady/solve.hpp"
#include "validation/honesty/population.hpp"

using namespace shellback;
using namespace shellback::bearing;

TEST_CASE("FiveNodesAcrossTheFilmKeepHotBearingsAboveAllThatIsColdAroundThem") {
  for (const std::uint64_t seed : {134u, 4u}) {
    Case c = validation::random_case(seed);
    c.model.tier = Tier::thd;
    c.model.grid = {48, 8};
    const Solution five = solve_tier(c, Tier::thd);
    INFO("seed " << seed << ": " << app::reason_of(five.verdict));
    REQUIRE(five.verdict.good());
    CHECK(five.model.gl.n == c.model.film_nodes);
    const auto& T = five.film.columns.T;
    // 2 K: what polynomials may swing below where the weights are still all but positive
    CHECK(*std::min_element(T.begin(), T.end()) >
          coldest_around(five.model.input, *five.model.solids) - 2.0);
    c.model.film_nodes = 9;
    const Solution nine = solve_tier(c, Tier::thd);
    REQUIRE(nine.verdict.good());
    const double torque = summarize(nine, Tier::thd).value("friction_torque");
    // five nodes against nine: up to 2 % in friction in the hottest of about 70 random bearings
    CHECK(summarize(five, Tier::thd).value("friction_torque") == Approx(torque).epsilon(2e-2));
  }
}
