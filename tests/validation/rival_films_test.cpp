// Other methods for the same cavitation: they must end in the same film, or say how they do not.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "tests/fluid/film_scenes.hpp"
#include "validation/rivals/fischer_burmeister_film.hpp"
#include "validation/rivals/p_theta.hpp"
#include "validation/rivals/swift_stieber.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;
using namespace shellback::validation;

namespace {

/// Bearing with a hole under pressure and a film that cavitates and forms again.
Setup cavitating(double ratio, double barus) {
  Setup s;
  s.barus = barus;
  s.half = true;
  SupplyPatch hole;
  hole.phi = 1.6;
  hole.arc = 0.5;
  hole.length = 0.006;
  hole.pressure = 1e5;
  s.patches = {hole};
  s.position.q = {0.3 * ratio * s.clearance, -std::sqrt(1.0 - 0.09) * ratio * s.clearance, 0.0,
                  0.0};
  return s;
}

double largest_gap(const Field& a, const Field& b) {
  double m = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) m = std::max(m, std::abs(a[k] - b[k]));
  return m;
}

double peak(const FilmState& s) { return *std::max_element(s.p.begin(), s.p.end()); }

}  // namespace

TEST_CASE("FischerBurmeisterNewtonEndsInTheFilmOfTheActiveSet") {
  for (const double ratio : {0.3, 0.7, 0.95}) {
    for (const double barus : {0.0, 2e-8}) {
      if (ratio > 0.9 && barus > 0.0) continue;  // no steady film there
      const PosedFilm b = make_bearing(cavitating(ratio, barus));
      const auto known = solve_reynolds(b.scene, b.gap, b.step, b.oil, cold_film(b.scene));
      const auto other =
          solve_fischer_burmeister(b.scene, b.gap, b.step, b.oil, cold_film(b.scene));
      INFO("ratio " << ratio << ", barus " << barus << ": " << app::reason_of(other.verdict));
      REQUIRE(known.good());
      REQUIRE(other.good());
      // both to 1e-12 of the flow; pressures answer to flow with the condition of the matrix
      CHECK(largest_gap(known.value.state.p, other.value.state.p) < 1e-7 * peak(known.value.state));
      CHECK(largest_gap(known.value.state.theta, other.value.state.theta) < 1e-8);
    }
  }
}

TEST_CASE("RelaxationEndsInTheFilmOfTheActiveSet") {
  for (const double ratio : {0.3, 0.7, 0.95}) {
    for (const double barus : {0.0, 2e-8}) {
      if (ratio > 0.9 && barus > 0.0) continue;
      const PosedFilm b = make_bearing(cavitating(ratio, barus));
      const auto known = solve_reynolds(b.scene, b.gap, b.step, b.oil, cold_film(b.scene));
      const auto other = relax_p_theta(b.scene, b.gap, b.step, b.oil, cold_film(b.scene));
      INFO("ratio " << ratio << ", barus " << barus << ": " << app::reason_of(other.verdict));
      REQUIRE(known.good());
      REQUIRE(other.good());
      // residual 1e-10 of the flow, and a condition number of some thousands
      CHECK(largest_gap(known.value.state.p, other.value.state.p) < 1e-6 * peak(known.value.state));
      CHECK(largest_gap(known.value.state.theta, other.value.state.theta) < 1e-6);
    }
  }
}

TEST_CASE("YoungsFactorNeedsFarFewerSweepsThanNoOverRelaxation") {
  const PosedFilm b = make_bearing(cavitating(0.7, 0.0));
  RelaxationOptions plain;
  plain.over_relaxation = 1.0;
  const auto slow = relax_p_theta(b.scene, b.gap, b.step, b.oil, cold_film(b.scene), plain);
  const auto fast = relax_p_theta(b.scene, b.gap, b.step, b.oil, cold_film(b.scene));
  REQUIRE(slow.good());
  REQUIRE(fast.good());
  CHECK(3 * fast.value.sweeps < slow.value.sweeps);
}

TEST_CASE("RelaxationThatRunsOutOfSweepsSaysSo") {
  const PosedFilm b = make_bearing(cavitating(0.7, 0.0));
  RelaxationOptions few;
  few.max_sweeps = 20;
  const auto film = relax_p_theta(b.scene, b.gap, b.step, b.oil, cold_film(b.scene), few);
  CHECK(film.verdict.status == Status::iteration_limit);
  const auto* e = film.verdict.as<ending::Unsettled>();
  REQUIRE(e != nullptr);
  CHECK(e->of == ending::Iteration::p_theta);
  CHECK(e->steps == 20);
  CHECK(e->left == film.history.back());
}

TEST_CASE("SwiftStieberFilmsSatisfyTheirComplementarity") {
  for (const double ratio : {0.3, 0.7, 0.95}) {
    const PosedFilm b = make_bearing(cavitating(ratio, 0.0));
    const auto film = solve_swift_stieber(b.scene, b.gap, b.step, b.oil, cold_film(b.scene));
    INFO("ratio " << ratio << ": " << app::reason_of(film.verdict));
    REQUIRE(film.good());
    const FilmState& s = film.value.state;
    const Field r = film_residual(b.scene, film.value.flow);
    const double slack = 1e-11 * flow_scale(film.value.flow);
    int empty = 0;
    for (std::size_t k = 0; k < s.p.size(); ++k) {
      if (b.scene.supply.cell[k] >= 0) continue;
      CHECK(s.p[k] >= b.scene.p_cavitation);
      CHECK(s.theta[k] == 1.0);
      CHECK(r[k] > -slack);
      if (s.full[k]) CHECK(r[k] < slack);
      empty += s.full[k] == 0;
    }
    CHECK(empty > 0);
  }
}

TEST_CASE("SwiftStieberFilmsMakeOilWhereTheyCavitate") {
  const PosedFilm b = make_bearing(cavitating(0.7, 0.0));
  const auto kept = solve_reynolds(b.scene, b.gap, b.step, b.oil, cold_film(b.scene));
  const auto lost = solve_swift_stieber(b.scene, b.gap, b.step, b.oil, cold_film(b.scene));
  REQUIRE(kept.good());
  REQUIRE(lost.good());
  const auto imbalance = [&](const FilmFlow& flow) {
    const OilFlows f = oil_flows(b.scene, flow);
    return (f.side - f.supply) / f.side;
  };
  CHECK(std::abs(imbalance(kept.value.flow)) < 1e-10);
  CHECK(imbalance(lost.value.flow) > 0.1);  // more leaves than is fed
}
