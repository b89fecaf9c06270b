// A hot random bearing whose film is not resolved by the usual nodes across it.
#include <algorithm>
#include <catch2/catch.hpp>

#include "coupling/solve.hpp"
#include "proof/population.hpp"

using namespace shellback;
using namespace shellback::coupling;

namespace {

Case coarse(std::uint64_t seed) {
  Case c = proof::random_case(seed);
  c.model.tier = Tier::thd;
  c.model.grid = {48, 8};
  return c;
}

}  // namespace

TEST_CASE("NodesAcrossTheFilmAreRaisedWhereTheyDoNotResolveItAndTheResultSaysSo") {
  const Case c = coarse(134);
  const Solution raised = solve_tier(c, Tier::thd);
  REQUIRE(raised.verdict.good());
  REQUIRE(raised.asked_nodes == c.model.film_nodes);
  const int nodes = raised.model.input.model.film_nodes;
  CHECK(nodes > raised.asked_nodes);
  const auto warnings = summarize(raised, Tier::thd).warnings;
  CHECK(std::any_of(warnings.begin(), warnings.end(), [](const std::string& w) {
    return w.find("model.film_nodes was raised from") != std::string::npos;
  }));
  Case asked = c;
  asked.model.film_nodes = nodes;
  const Solution same = solve_tier(asked, Tier::thd);
  REQUIRE(same.verdict.good());
  CHECK(same.asked_nodes == 0);
  // The same equations: only the turns' tolerance, 3e-4 of 10 K, lies between.
  CHECK(summarize(raised, Tier::thd).value("friction_torque") ==
        Approx(summarize(same, Tier::thd).value("friction_torque")).epsilon(1e-3));
}

TEST_CASE("NodesThatResolveTheFilmAreKept") {
  const Case c = coarse(4);
  const Solution s = solve_tier(c, Tier::thd);
  REQUIRE(s.verdict.good());
  CHECK(s.asked_nodes == 0);
  CHECK(s.model.input.model.film_nodes == c.model.film_nodes);
}
