// A dry patch of the film is carried along with the mean speed of the surfaces.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/film_step.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// What the patch lacks of a full film [kg], and where its middle lies, from `zero` on [rad].
struct Lack {
  double oil = 0.0;
  double place = 0.0;
};
Lack lack_of(const FilmSteps& steps, const FilmInTime& now, const Field& full, double zero) {
  const FilmGrid& g = steps.model().scene.grid;
  Lack lack;
  for (int i = 0; i < g.nt; ++i) {
    const double phi = std::remainder(g.phi[i] - zero - kPi, 2.0 * kPi) + kPi;  // 0 to 2 pi
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      if (steps.model().scene.supply.cell[c] >= 0) continue;
      const double missing = g.multiplicity() * g.area(i, j) * (full[c] - now.oil[c]);
      lack.oil += missing;
      lack.place += missing * phi;
    }
  }
  lack.place /= lack.oil;
  return lack;
}

/// Takes seven tenths of the oil from the middle half of the width, between two angles [rad].
void dry(const FilmSteps& steps, double from, double to, FilmInTime& now) {
  const FilmGrid& g = steps.model().scene.grid;
  constexpr double kLeft = 0.3;
  for (int i = 0; i < g.nt; ++i) {
    const double past = std::remainder(g.phi[i] - from - kPi, 2.0 * kPi) + kPi;  // 0 to 2 pi
    if (past > to - from) continue;
    for (int j = 0; j < g.nz; ++j) {
      if (std::abs(g.z[j]) > 0.25 * g.width) continue;
      const int k = g.index(i, j);
      now.film.film.theta[k] *= kLeft;
      now.film.film.full[k] = 0;
      now.film.film.p[k] = steps.model().scene.p_cavitation;
      now.oil[k] *= kLeft;
    }
  }
}

}  // namespace

TEST_CASE("ADryPatchIsCarriedWithTheMeanSpeedAndKeepsWhatItLacks", "[cycle]") {
  // Around a journal in the middle a full film has no pressure anywhere; in the cavitated film
  // behind a load there is none, either: a patch goes on as it is, with U/2, whatever the gap
  // [textbook]. The journal is so heavy that it stays where it is.
  for (const bool loaded : {false, true}) {
    Case c = plain_case();
    c.model.grid = {120, 10};
    const double omega = c.operation.omega;
    LoadCycle load;
    load.t = {0.0, 1.0};
    load.x = {0.0, 0.0};
    load.y.assign(2, loaded ? -2e3 : -1.0);
    const LoadCourse course(load, omega);
    FilmSteps steps(make_bearing(c, physics_of(c, Tier::isothermal), c.model.grid), course, 1e4,
                    {});
    EquilibriumCost cost;
    FilmInTime now = steps.at_rest(c.oil_temperature.value());
    if (loaded) {
      auto steady = steps.steady(c.oil_temperature.value(), cost, nullptr);
      REQUIRE(steady);
      now = *std::move(steady);
    }
    const double zero = 330.0 * kDegree;  // where the loaded film ends, at the latest
    FilmInTime whole = now;               // the same film without the patch
    dry(steps, zero + 10.0 * kDegree, zero + 30.0 * kDegree, now);
    const Lack begun = lack_of(steps, now, whole.oil, zero);
    const double way = 45.0 * kDegree;  // the line at 90 degrees lies far beyond its end
    double left = 0.0;  // oil, by the sides and the line, more than without the patch
    constexpr int kSteps = 60;
    const auto step = [&](FilmInTime& film) {
      FilmStep s = steps.take(way / (0.5 * omega) / kSteps, film, cost, nullptr);
      INFO(app::reason_of(s.verdict));
      REQUIRE(s.verdict.good());
      film = std::move(s.after);
      return s.side - s.supply;
    };
    for (int n = 0; n < kSteps; ++n) {
      left += step(now);
      left -= step(whole);
    }
    const Lack ended = lack_of(steps, now, whole.oil, zero);
    const double cell = 2.0 * kPi / steps.model().scene.grid.nt;
    const double gone = ended.place - begun.place;
    INFO("loaded " << loaded << ", gone " << gone / way << " of the way, left "
                   << left / begun.oil);
    // Van Leer's limiter is not symmetric: the patch's two ends differ by a part of a cell.
    CHECK(std::abs(gone - way) < 0.05 * cell);
    CHECK(std::abs(ended.oil - begun.oil - left) < 1e-12 * begun.oil);
    // What overshoots at the patch's ends makes pressure and is pressed out at the sides.
    CHECK(std::abs(left) < 1e-4 * begun.oil);
  }
}
