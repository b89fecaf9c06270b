// A dry patch of the film is carried along with the mean speed of the surfaces.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/film_step.hpp"
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
  const FilmGrid& g = steps.model().domain.grid;
  Lack lack;
  for (int i = 0; i < g.nt; ++i) {
    const double phi = std::remainder(g.phi[i] - zero - kPi, 2.0 * kPi) + kPi;  // 0 to 2 pi
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      if (steps.point().scene.supply.cell[c] >= 0) continue;
      const double missing = g.multiplicity() * g.area(i, j) * (full[c] - now.oil[c]);
      lack.oil += missing;
      lack.place += missing * phi;
    }
  }
  lack.place /= lack.oil;
  return lack;
}

/// Leaves this part of the oil in the middle half of the width, between two angles [rad].
void dry(const FilmSteps& steps, double from, double to, double left, FilmInTime& now) {
  const FilmGrid& g = steps.model().domain.grid;
  for (int i = 0; i < g.nt; ++i) {
    const double past = std::remainder(g.phi[i] - from - kPi, 2.0 * kPi) + kPi;  // 0 to 2 pi
    if (past > to - from) continue;
    for (int j = 0; j < g.nz; ++j) {
      if (std::abs(g.z[j]) > 0.25 * g.width) continue;
      const int k = g.index(i, j);
      now.film.film.theta[k] *= left;
      now.film.film.full[k] = 0;
      now.film.film.p[k] = steps.model().domain.p_cavitation;
      now.oil[k] *= left;
    }
  }
}

/// All oil of the gap [kg].
double oil_of(const FilmSteps& steps, const FilmInTime& now) {
  const FilmGrid& g = steps.model().domain.grid;
  double sum = 0.0;
  for (int c = 0; c < g.cells(); ++c) sum += now.oil[c] * g.area(c);
  return g.multiplicity() * sum;
}

}  // namespace

TEST_CASE("AStepThatOverdrawsACellIsRejectedAndAShorterOneKeepsAllOil", "[cycle]") {
  // Behind a patch that is nearly dry a full cell gives oil and gets none. The first stage carries
  // that slope on for d = 1 - 1/sqrt 2 of a step: where the patch goes more than 1/d = 3.4 cells,
  // that is more oil than the cell holds.
  Case c = plain_case();
  c.model.grid = {60, 6};
  LoadCycle load;
  load.t = {0.0, 1.0};
  load.x = {0.0, 0.0};
  load.y = {-1.0, -1.0};
  const LoadCourse course(load, c.operation.omega);
  FilmSteps steps(make_bearing(c, physics_of(c, Tier::isothermal), c.model.grid), course, 1e4, {});
  EquilibriumCost cost;
  FilmInTime now = steps.at_rest(c.oil_temperature.value());
  dry(steps, 180.0 * kDegree, 240.0 * kDegree, 0.01, now);
  const double cell = 2.0 * kPi / 60.0 / (0.5 * c.operation.omega);  // time of a cell's way [s]
  FilmStep first = steps.take(0.01 * cell, now, cost, nullptr);
  REQUIRE(first.verdict.good());
  now = std::move(first.after);
  for (const double cells : {16.0, 8.0, 4.0}) {
    const FilmStep s = steps.take(cells * cell, now, cost, nullptr);
    const auto* why = s.verdict.as<ending::Plain>();
    INFO(cells << " cells: " << app::reason_of(s.verdict));
    REQUIRE(why);
    CHECK(*why == ending::Plain::overdrawn);
  }
  const FilmStep s = steps.take(2.0 * cell, now, cost, nullptr);
  INFO(app::reason_of(s.verdict));
  REQUIRE(s.verdict.good());
  for (const double fill : s.after.film.film.theta) CHECK(fill > 0.0);
  const double gathered = oil_of(steps, s.after) - oil_of(steps, now);
  CHECK(std::abs(gathered - s.supply + s.side) < 1e-14 * oil_of(steps, now));  // round-off
}

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
      auto steady = steps.steady(c.oil_temperature.value(), {}, cost, nullptr);
      REQUIRE(steady);
      now = *std::move(steady);
    }
    const double zero = 330.0 * kDegree;  // where the loaded film ends, at the latest
    FilmInTime whole = now;               // the same film without the patch
    dry(steps, zero + 10.0 * kDegree, zero + 30.0 * kDegree, 0.3, now);
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
    const double cell = 2.0 * kPi / steps.model().domain.grid.nt;
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
