/// What is not a number ends a solve under its own name; a closed gap is told by the gap.
#include <catch2/catch.hpp>
#include <functional>

#include "app/words/ending_words.hpp"
#include "bearing/film/solve_equilibrium.hpp"
#include "core/fixed_point.hpp"
#include "fluid/reynolds.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// A solved film of the plain bearing, to be spoilt.
Solution solved_film() {
  Case c = plain_case();
  c.oil.temperature = rheology::ReynoldsSlope{0.015, 313.15, 0.03};
  Solution s = solve_tier(c, Tier::isothermal);
  REQUIRE(s.verdict.good());
  return s;
}

Verdict solved_again(Solution& s, const Field& thermal_deformation) {
  return solve_equilibrium({s.model, s.point, thermal_deformation}, s.film, s.cost);
}

bool found_in(const Verdict& v, FieldName field) {
  const auto* e = v.as<ending::NotANumber>();
  return v.status == Status::invalid_number && e && e->field == field && !e->other_method;
}

}  // namespace

TEST_CASE("ANotANumberIsNamedByFieldAndPlaceNotAsPhysics", "[not_a_number]") {
  struct Spoilt {
    FieldName field;
    std::function<void(Solution&, Field&, int)> spoil;
  };
  const std::vector<Spoilt> ways{
      {FieldName::film_pressure, [](Solution& s, Field&, int c) { s.film.film.p[c] = NAN; }},
      {FieldName::fill_ratio, [](Solution& s, Field&, int c) { s.film.film.theta[c] = NAN; }},
      {FieldName::film_temperature,
       [](Solution& s, Field&, int c) { s.film.columns.T[c * s.model.gl.n] = NAN; }},
      {FieldName::thermal_deformation,
       [](Solution&, Field& thermal_deformation, int c) { thermal_deformation[c] = NAN; }}};
  for (const Spoilt& way : ways) {
    Solution s = solved_film();
    const FilmGrid& g = s.model.domain.grid;
    const int cell = g.index(17, 2);
    Field thermal_deformation(g.cells(), 0.0);
    way.spoil(s, thermal_deformation, cell);
    const Verdict v = solved_again(s, thermal_deformation);
    INFO(app::reason_of(v));
    CHECK(found_in(v, way.field));
    CHECK(v.place == fluid::place_of(g, cell));
  }
}

TEST_CASE("AFilmWithoutPositionNamesItToo", "[not_a_number]") {
  const Solution s = solved_film();
  fluid::Gap gap = s.film.gap;
  gap.cell[40] = NAN;
  const fluid::OilLaw oil = [&](const fluid::FilmState&, fluid::FilmCoefficients& c) {
    c = s.film.oil;
    c.fluidity[40] = NAN;
  };
  const auto by_gap = fluid::solve_reynolds(s.point.scene, gap, {}, oil, s.film.film);
  CHECK(found_in(by_gap.verdict, FieldName::gap));  // the cause comes first
  const auto by_oil = fluid::solve_reynolds(s.point.scene, s.film.gap, {}, oil, s.film.film);
  CHECK(found_in(by_oil.verdict, FieldName::viscosity));
  CHECK(by_oil.verdict.place == fluid::place_of(s.model.domain.grid, 40));
}

TEST_CASE("AFixedPointThatHoldsANotANumberIsNotConverged", "[not_a_number]") {
  std::vector<double> x{1.0, 2.0, 3.0};
  const auto map = [](const std::vector<double>& from, std::vector<double>& to) {
    to = from;
    to[1] = NAN;
    return true;
  };
  CHECK(fixed_point(map, {}, x) != FixedPointEnd::converged);
}

TEST_CASE("AClearanceClosedByGrowthIsToldByTheGap", "[closed_gap]") {
  Solution s = solved_film();
  const Field thermal_deformation(s.model.domain.grid.cells(), -1.2 * s.model.clearance);
  const Verdict v = solved_again(s, thermal_deformation);
  INFO(app::reason_of(v));
  CHECK(v.status == Status::no_steady_state);
  const auto* e = v.as<ending::GapClosed>();
  REQUIRE(e != nullptr);
  CHECK(e->by_growth());
  CHECK(e->by_heat == Approx(-36e-6));
  CHECK(e->across == Approx(2.0 * (30e-6 - 36e-6)).epsilon(1e-6));  // cells lie opposite each other
  CHECK(std::isnan(e->by_elasticity));
  CHECK(e->h == Approx(e->by_position + e->by_heat));
  CHECK(std::isfinite(v.place.phi));
}

TEST_CASE("GrowthThatClosesOneSideMovesAFreeJournal", "[closed_gap]") {
  // More than half of the clearance is left and carries the load, only not where the journal was.
  Solution s = solved_film();
  const double before = s.film.least.h;
  const Field thermal_deformation(s.model.domain.grid.cells(), -1.01 * before);
  REQUIRE(before < 0.5 * s.model.clearance);
  const Verdict v = solved_again(s, thermal_deformation);
  INFO(app::reason_of(v));
  CHECK(v.good());
  CHECK(s.film.least.h > 0.0);
  CHECK(std::hypot(s.film.force[0], s.film.force[1]) == Approx(s.point.load.scale()).epsilon(1e-8));
  // With the position given there is nothing to move.
  Solution held = solved_film();
  held.point.load.unknowns = 0;
  CHECK(solved_again(held, thermal_deformation).status == Status::no_steady_state);
}
