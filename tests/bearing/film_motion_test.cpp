/// What a change of the gap is worth as a motion of the journal, and the error of a step from it.
#include "bearing/film/film_motion.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bearing/steady/solve.hpp"
#include "fluid/gap.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// The change of the gap by a motion of the journal.
Field moved(const FilmGrid& g, const std::array<double, 4>& a) {
  Field dh(g.cells(), 0.0);
  for (int c = 0; c < g.cells(); ++c) {
    const double phi = g.phi[c / g.nz];
    for (int k = 0; k < 4; ++k) {
      dh[c] += a[k] * fluid::gap_slope(k, std::cos(phi), std::sin(phi), g.z[c % g.nz]);
    }
  }
  return dh;
}

Solution sample() {
  Case c = plain_case();
  c.model.grid = {60, 9};
  Solution s = solve_tier(c, Tier::isothermal);
  REQUIRE(s.verdict.good());
  return s;
}

}  // namespace

TEST_CASE("AMotionOfTheJournalIsFoundInTheGap") {
  const Solution s = sample();
  const Field force = carrying_force(s.model, s.film);
  const std::array<double, 4> plain{2e-8, -3e-8, 0.0, 0.0};
  const auto found = motion_of(s.model, 2, force, moved(s.model.domain.grid, plain));
  for (int k = 0; k < 4; ++k) CHECK(found[k] == Approx(plain[k]).margin(1e-20));
  // Tilts stand on both halves of the width: a grid of the whole of it.
  Case c = plain_case();
  c.operation.alignment = TiltGiven{1e-5, 2e-5};
  c.model.grid = {60, 9};
  const Solution whole = solve_tier(c, Tier::isothermal);
  REQUIRE(whole.verdict.good());
  const std::array<double, 4> tilted{2e-8, -3e-8, 4e-6, 1e-6};
  const auto all = motion_of(whole.model, 4, carrying_force(whole.model, whole.film),
                             moved(whole.model.domain.grid, tilted));
  for (int k = 0; k < 4; ++k) CHECK(all[k] == Approx(tilted[k]).epsilon(1e-9));
}

TEST_CASE("TheErrorOfAStepIsThatOfTheFilmAsAWhole") {
  const Solution s = sample();
  const FilmGrid& g = s.model.domain.grid;
  const std::vector<char> all(g.cells(), 1);
  const double loaded = 0.01 * largest(s.film.film.p);
  const auto error = [&](const Field& dh) {
    return loaded_film_error(s.model, 2, s.film, dh, all, loaded).value();
  };
  // Of a motion: its largest change of the loaded film over the film's height.
  const Field dh = moved(g, {2e-8, -3e-8, 0.0, 0.0});
  double largest_part = 0.0;
  for (int c = 0; c < g.cells(); ++c) {
    if (!s.film.film.full[c] || s.film.film.p[c] < loaded || s.model.supply.cell[c] >= 0) continue;
    largest_part = std::max(largest_part, std::abs(dh[c]) / s.film.gap.cell[c]);
  }
  CHECK(error(dh) == Approx(largest_part).epsilon(1e-9));
  Field twice = dh;
  for (double& x : twice) x *= 2.0;
  CHECK(error(twice) == Approx(2.0 * error(dh)).epsilon(1e-9));
  // A cell of the thick film that is off by itself is hardly seen; all of them by as much are.
  int thick = -1;
  for (int c = 0; c < g.cells(); ++c) {
    if (s.film.film.full[c] && s.film.film.p[c] >= loaded && s.film.film.p[c] < 2.0 * loaded)
      thick = c;
  }
  REQUIRE(thick >= 0);
  Field one(g.cells(), 0.0);
  one[thick] = 0.01 * s.film.gap.cell[thick];
  CHECK(error(one) < 1e-3);
  Field height = s.film.gap.cell;
  for (double& h : height) h *= 0.01;
  CHECK(error(height) >= 0.01 * (1.0 - 1e-12));
  // Without a cell that counts nothing is known.
  CHECK_FALSE(loaded_film_error(s.model, 2, s.film, dh, std::vector<char>(g.cells(), 0), loaded));
}
