// Rigid films of Barus oil: pressures follow from the isoviscous film, up to a limit load.
//
// With g = exp(-alpha p)/(12 eta) the film equation is that of the isoviscous film for
// q = (1 - exp(-alpha p))/alpha, and p = 0 where q = 0. Hence p = -ln(1 - alpha q)/alpha as long as
// alpha q < 1 everywhere, and no steady film if not.
#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;

namespace {

/// All given pressures are zero, where p and q agree.
Setup bearing(double eps) {
  Setup s;
  s.nt = 100;
  s.nz = 20;
  s.half = true;
  s.position = eccentric(eps * s.clearance, 0.0);
  s.patches = {{.phi = 2.6, .arc = 0.3, .length = s.width / 2.0, .pressure = 0.0}};
  return s;
}

struct Pair {
  FilmSolution isoviscous;
  Outcome<FilmSolution> barus;
  double alpha;
};

/// Both films, with alpha such that alpha times the isoviscous peak is `share`.
Pair films(Setup s, double share) {
  const auto plain = solve(make_bearing(s));
  REQUIRE(plain.good());
  s.barus = share / largest_magnitude(plain.value.state.p);
  return {plain.value, solve(make_bearing(s)), s.barus};
}

}  // namespace

TEST_CASE("BarusPressuresFollowFromTheIsoviscousFilm") {
  for (const double eps : {0.2, 0.6, 0.9, 0.97}) {
    for (const double share : {0.1, 0.5, 0.9, 0.99, 0.999}) {
      CAPTURE(eps, share);
      const Pair f = films(bearing(eps), share);
      INFO(to_string(f.barus.verdict.status));
      REQUIRE(f.barus.good());
      double worst = 0.0, fill = 0.0;
      for (std::size_t k = 0; k < f.isoviscous.state.p.size(); ++k) {
        const double p = -std::log1p(-f.alpha * f.isoviscous.state.p[k]) / f.alpha;
        worst = std::max(worst, std::abs(f.barus.value.state.p[k] - p));
        fill = std::max(fill, std::abs(f.barus.value.state.theta[k] - f.isoviscous.state.theta[k]));
      }
      // Newton's residual of 1e-12, amplified by the film's conductance (1e3) and, in p, by
      // dp/dq = 1/(1 - alpha q).
      CHECK(worst * f.alpha < 1e-9 / (1.0 - share));
      CHECK(fill < 1e-9);
    }
  }
}

TEST_CASE("AFilmBeyondTheBarusLimitIsRefused") {
  for (const double eps : {0.2, 0.6, 0.9, 0.97}) {
    for (const double share : {1.001, 1.1, 3.0, 100.0}) {
      CAPTURE(eps, share);
      const Pair f = films(bearing(eps), share);
      CHECK(f.barus.verdict.status == Status::no_steady_state);
      CHECK(f.barus.verdict.is(ending::Plain::no_pressure));
      CHECK(std::isfinite(f.barus.verdict.place.phi));
    }
  }
}

TEST_CASE("TheRefusalNamesThePlaceOfThePeak") {
  Setup s = bearing(0.8);
  const auto plain = solve(make_bearing(s));
  const Field& p = plain.value.state.p;
  const int peak = static_cast<int>(std::max_element(p.begin(), p.end()) - p.begin());
  // Only the peak cell exceeds the limit.
  double second = 0.0;
  for (int k = 0; k < static_cast<int>(p.size()); ++k) {
    if (k != peak) second = std::max(second, p[k]);
  }
  s.barus = 2.0 / (p[peak] + second);
  const PosedFilm b = make_bearing(s);
  const auto film = solve(b);
  REQUIRE(film.verdict.status == Status::no_steady_state);
  CHECK(film.verdict.place == place_of(b.scene.grid, peak));
}

TEST_CASE("TheStepAlongTheBarusCurveIsLinearInQ") {
  Setup s = bearing(0.5);
  s.barus = 2e-8;
  s.patches.clear();
  const PosedFilm b = make_bearing(s);
  FilmState state = cold_film(b.scene);
  const Field start = random_field(b.scene.grid.cells(), 3, 1e6, 5e7);
  state.p = start;
  FilmCoefficients oil;
  b.oil(state, oil);
  const Field step = random_field(b.scene.grid.cells(), 4, -1e5, 4e7);
  const UpdateReport report = advance(b.scene, oil, step, 0.7, state);
  CHECK(report.moved == 0);
  CHECK(report.beyond_barus == 0);
  for (std::size_t k = 0; k < start.size(); ++k) {
    // q' - q = exp(-alpha p) dp, dp the linearised step.
    const auto q = [&](double p) { return -std::expm1(-s.barus * p) / s.barus; };
    const double exact = q(start[k]) + std::exp(-s.barus * start[k]) * 0.7 * step[k];
    CHECK(std::abs(q(state.p[k]) / exact - 1.0) < 1e-12);  // round-off of exp and log
  }
}
