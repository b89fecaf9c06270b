/// The table of quantities: names, units and typed values are one.
#include "bearing/quantities.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

TEST_CASE("EveryQuantityHasOneEntry") {
  Quantities values;
  std::set<std::string> names;
  double mark = 0.0;
  for (const QuantityEntry& e : kQuantities) {
    CHECK(names.insert(std::string(e.name)).second);
    CHECK_FALSE(e.unit.empty());
    CHECK(std::isnan(values.*e.member));  // not marked before: no member twice
    values.*e.member = ++mark;
    CHECK(find_quantity(e.name) == &e);
  }
  CHECK(mark * sizeof(double) == sizeof(Quantities));
  CHECK(find_quantity("friction") == nullptr);
}

TEST_CASE("AListOfQuantitiesHoldsWhatIsKnownInTheOrderOfTheTable") {
  Quantities values;
  values.h_min = 2e-6;
  values.friction_torque = 1.5;
  values.p_max = INFINITY;  // no number to report
  const auto list = listed(values);
  REQUIRE(list.size() == 2);
  CHECK(list[0].name == "friction_torque");
  CHECK(list[0].unit == "N m");
  CHECK(std::isnan(list[0].error()));
  CHECK(list[1].name == "h_min");
  const Quantities back = typed(list);
  CHECK(back.friction_torque == 1.5);
  CHECK(back.h_min == 2e-6);
  CHECK(std::isnan(back.p_max));
}

TEST_CASE("AResultGivesItsValuesByNameAndTyped") {
  Case c = warm_case();
  const Result r = solve(c);
  REQUIRE(r.verdict.good());
  const Quantities q = r.values();
  CHECK(q.friction_torque == r.value("friction_torque"));
  CHECK(q.T_film_max > 313.0);
  CHECK(std::isnan(q.T_equivalent));  // tier isothermal alone knows it
  CHECK(std::isnan(q.K_xx));
  for (const Quantity& reported : r.quantities) {
    const QuantityEntry* entry = find_quantity(reported.name);
    REQUIRE(entry != nullptr);
    CHECK(entry->unit == reported.unit);
    CHECK(q.*entry->member == reported.value);
  }
}

TEST_CASE("TheShellsTorqueIsWhatItsHousingFeels", "[quantities]") {
  // In a round bore that of the shear alone, to second order in the cell. In one that is not, the
  // film's pressure turns it, too: - int p d(shape)/dphi dA, here of two lobes of 3 um.
  for (const bool round : {true, false}) {
    for (const double tilt : {0.0, 2e-4}) {
      Case c = plain_case();
      c.model.grid = {200, 13};
      c.operation.alignment = TiltGiven{tilt, 0.5 * tilt};
      Profile lobes;
      lobes.z = {0.0};
      for (int k = 0; k < 360; ++k) {
        lobes.phi.push_back(k * kDegree);
        lobes.height.push_back(3e-6 * std::cos(2.0 * k * kDegree + 0.7));
      }
      if (!round) c.bearing.shape = lobes;
      const Solution s = solve_tier(c, Tier::isothermal);
      REQUIRE(s.verdict.good());
      const Friction f = friction_of(s.model, s.point, s.film);
      double by_shape = 0.0;
      const FilmGrid& g = s.model.domain.grid;
      for (int k = 0; k < g.cells(); ++k) {
        const double slope = -6e-6 * std::sin(2.0 * g.phi[k / g.nz] + 0.7);
        if (!round) by_shape += s.film.film.p[k] * slope * g.multiplicity() * g.area(k);
      }
      const double told = summarize(s, Tier::isothermal).value("friction_torque_shell");
      INFO((round ? "round, " : "lobes, ") << tilt << ": " << told << ", shear alone "
                                           << f.viscous_shell << ", shape " << by_shape);
      CHECK(told == Approx(f.viscous_shell - by_shape).epsilon(2e-3));
    }
  }
}

TEST_CASE("UnderARingGrooveTheFilmAtMidWidthIsThatOfItsEdges", "[quantities]") {
  // Rigid and tilted, the gap is linear along the bearing: at the groove's edges, on either side,
  //   h = c - sqrt((ex + psi_y z)^2 + (ey - psi_x z)^2)
  Case c = plain_case();
  const double edge = 0.15 * c.bearing.width;
  c.supplies[0].arc = 2.0 * kPi;
  c.supplies[0].length = 2.0 * edge;
  c.supplies[0].pressure = 2e5;
  place_journal(c, 0.6, 40.0 * kDegree);
  c.operation.alignment = TiltGiven{3e-4, -1e-4};
  for (const std::array<int, 2>& grid : {std::array{120, 10}, std::array{120, 13}}) {
    c.model.grid = grid;
    const Solution s = solve_tier(c, Tier::isothermal);
    REQUIRE(s.verdict.good());
    const auto& p = s.film.position;
    double least = INFINITY;
    for (const double z : {-edge, edge}) {
      least = std::min(least, c.bearing.radial_clearance -
                                  std::hypot(p.ex() + p.psi_y() * z, p.ey() - p.psi_x() * z));
    }
    // seen in cells and on faces of 1.5 degrees around
    CHECK(value_in(quantities_of(s, Tier::isothermal), "h_min_mid") == Approx(least).epsilon(1e-3));
  }
}
