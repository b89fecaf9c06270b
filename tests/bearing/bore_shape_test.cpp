#include "bearing/bore_shape.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "bearing/heat/film_heat.hpp"
#include "bearing/steady/audit.hpp"
#include "bearing/told_ranges.hpp"
#include "core/constants.hpp"
#include "core/make_grid.hpp"
#include "tests/bearing/sample_bearing.hpp"
#include "tests/observed_order.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;
using shellback::test::observed_order;

TEST_CASE("ReliefIsAParabolaAndChamferACone") {
  Bearing b = plain_case().bearing;
  b.edge_relief = EdgeOpening{4e-6, 2e-3};
  b.chamfer = EdgeOpening{50e-6, 0.5e-3};
  const double edge = 0.5 * b.width;
  CHECK(shape_at(b, 1.0, 0.0) == 0.0);
  CHECK(shape_at(b, 1.0, edge - 2e-3) == Approx(0.0).margin(1e-18));
  CHECK(shape_at(b, 1.0, edge - 1e-3) == Approx(1e-6));
  CHECK(shape_at(b, 1.0, -(edge - 1e-3)) == Approx(1e-6));
  CHECK(shape_at(b, 1.0, edge - 0.25e-3) == Approx(4e-6 * 0.875 * 0.875 + 25e-6));
  CHECK(shape_at(b, 1.0, edge) == Approx(54e-6));
}

TEST_CASE("AJournalHasTheRoomThatItsBoreLeaves") {
  constexpr int n = 360;
  constexpr double d = 20e-6;  // of two halves whose centres lie apart, over half
  Bearing b = plain_case().bearing;
  const double c = b.radial_clearance = 50e-6;
  for (const double x : room_around(b, n)) CHECK(x == c);
  Profile moved, lemon;
  moved.z = lemon.z = {0.0};
  for (int i = 0; i < n; ++i) {
    const double phi = 2.0 * kPi * i / n;
    moved.phi.push_back(phi);
    moved.height.push_back(d * std::cos(phi));
    lemon.phi.push_back(phi);
    lemon.height.push_back(-d * std::abs(std::sin(phi)));
  }
  b.shape = moved;  // the circle about (d, 0)
  const std::vector<double> circle = room_around(b, n);
  for (int k = 0; k < n; ++k) {
    const double theta = 2.0 * kPi * k / n;
    const double r = d * std::cos(theta) + std::sqrt(c * c - std::pow(d * std::sin(theta), 2));
    CHECK(circle[k] == Approx(r).epsilon(1e-4));  // the nearest of 360 angles: (pi/360)^2/2
  }
  b.shape = lemon;  // where circles about (0, d) and (0, -d) overlap
  const std::vector<double> both = room_around(b, n);
  CHECK(both[90] == Approx(c - d));
  CHECK(both[0] == Approx(std::sqrt(c * c - d * d)).epsilon(1e-4));
  b.shape.reset();
  b.edge_relief = EdgeOpening{4e-6, 2e-3};  // leaves the middle as it is
  for (const double x : room_around(b, n)) CHECK(x == Approx(c));
}

TEST_CASE("AShapeThatIsEverywhereTheSameIsClearance") {
  Case wider = plain_case();
  wider.bearing.radial_clearance += 4e-6;
  Case shaped = plain_case();
  shaped.bearing.shape = Profile{{0.0}, {0.0}, {4e-6}};
  const Solution a = solve_tier(wider, Tier::isothermal);
  const Solution b = solve_tier(shaped, Tier::isothermal);
  REQUIRE(a.verdict.good());
  REQUIRE(b.verdict.good());
  // the same equations: what iterations leave
  CHECK(b.film.least.h == Approx(a.film.least.h).epsilon(1e-7));
  CHECK(friction_of(b.model, b.point, b.film).viscous ==
        Approx(friction_of(a.model, a.point, a.film).viscous).epsilon(1e-7));
}

namespace {

/// The opening at the edges as a table.
Profile table_of(const Bearing& b) {
  Profile p{{0.0}, {}, {}};
  constexpr int kPoints = 2000;  // bilinear: wrong by (B/2000)^2/8 of the curvature, 1e-7 of it
  for (int k = 0; k <= kPoints; ++k) {
    const double z = (static_cast<double>(k) / kPoints - 0.5) * b.width;
    p.z.push_back(z);
    p.height.push_back(shape_at(b, 0.0, z));
  }
  return p;
}

}  // namespace

TEST_CASE("ATableOfTheReliefIsTheRelief") {
  Case key = plain_case();
  // two of nine cells: the table's grid, too, has a face where the relief begins
  key.bearing.edge_relief = EdgeOpening{10e-6, 2.0 / 9.0 * key.bearing.width};
  Case table = plain_case();
  table.bearing.shape = table_of(key.bearing);
  const Solution a = solve_tier(key, Tier::isothermal), b = solve_tier(table, Tier::isothermal);
  REQUIRE(a.verdict.good());
  REQUIRE(b.verdict.good());
  CHECK(b.film.least.h == Approx(a.film.least.h).epsilon(1e-5));
  CHECK(friction_of(b.model, b.point, b.film).viscous ==
        Approx(friction_of(a.model, a.point, a.film).viscous).epsilon(1e-5));
  // relief takes away what carries: the film is thinner than without it
  const Solution none = solve_tier(plain_case(), Tier::isothermal);
  CHECK(a.film.position.ey() * -1.0 > -none.film.position.ey());
}

TEST_CASE("AReliefConvergesWithSecondOrderUpToTheSideEdge") {
  // A full film between held surfaces; the foot of the relief, given as a table, lies inside the
  // cells, and the pressure falls to nothing where the gap is known at the edge itself.
  for (const AxialSpacing spacing : {AxialSpacing::even, AxialSpacing::graded}) {
    std::array<double, 3> load{}, torque{};
    for (int k = 0; k < 3; ++k) {
      Case c = plain_case();
      Bearing relieved = c.bearing;
      relieved.edge_relief = EdgeOpening{9e-6, 8e-3};
      c.bearing.shape = table_of(relieved);
      c.model.axial_spacing = spacing;
      c.model.grid = {60 << k, 12 << k};
      c.model.cavitation_pressure = -1e12;  // never reached: a front would move by cells
      place_journal(c, 0.6, 0.3);
      const Solution s = solve_tier(c, Tier::isothermal);
      REQUIRE(s.verdict.good());
      load[k] = std::hypot(s.film.force[0], s.film.force[1]);
      torque[k] = torque_of(s);
    }
    CAPTURE(static_cast<int>(spacing));
    // three grids at a cell's size over the relief's length of an eighth and less
    CHECK(std::abs(observed_order(load[0], load[1], load[2]) - 2.0) < 0.15);
    CHECK(std::abs(observed_order(torque[0], torque[1], torque[2]) - 2.0) < 0.15);
  }
}

namespace {

/// Ten lands and ten grooves of 18 degrees around, as deep as the clearance.
Profile lands_and_grooves(double depth) {
  Profile p;
  p.z = {0.0};
  for (int k = 0; k < 720; ++k) {
    p.phi.push_back((0.25 + 0.5 * k) * kDegree);
    p.height.push_back(k / 36 % 2 == 0 ? depth : 0.0);
  }
  return p;
}

template <class NoteOf>
bool tells(const Solution& s) {
  const auto notes = summarize(s, Tier::isothermal).warnings;
  return std::any_of(notes.begin(), notes.end(),
                     [](const Note& n) { return std::holds_alternative<NoteOf>(n); });
}

}  // namespace

TEST_CASE("WherePressurePushesOnStepsTheMomentIsBalanced") {
  // A full film over lands and grooves whose edges lie on faces: what the film's pressure turns the
  // shell by at the steps is the difference of the two shear torques, on every grid, and from 80
  // cells on the torque has come to its limit within a hundredth.
  std::array<double, 3> torque{};
  for (int k = 0; k < 3; ++k) {
    Case c = plain_case();
    c.bearing.profile = lands_and_grooves(c.bearing.radial_clearance);
    c.model.grid = {80 << k, 8};
    c.model.cavitation_pressure = -1e12;
    place_journal(c, 0.3, 0.3);
    const Solution s = solve_tier(c, Tier::isothermal);
    REQUIRE(s.verdict.good());
    // what the eccentric gap leaves, of second order in the cell
    CHECK(audit_of(s, friction_of(s.model, s.point, s.film)).moment < 1e-3);
    torque[k] = torque_of(s);
  }
  CHECK(torque[0] == Approx(torque[2]).epsilon(0.02));
  CHECK(std::abs(torque[1] - torque[2]) < 0.6 * std::abs(torque[0] - torque[1]));
}

TEST_CASE("AnOpeningNarrowerThanACellIsSeen") {
  // Deep chamfers take their width from the bearing: on cells of two to seven times their length
  // they take from the load (by a tenth and a quarter) what they take on fine cells, of which two
  // and six lie within one.
  const auto load_on = [](int nz, double length) {
    Case c = plain_case();
    c.bearing.chamfer = EdgeOpening{200e-6, length};
    if (length == 0.0) c.bearing.chamfer.reset();
    c.model.grid = {48, nz};
    place_journal(c, 0.7, 0.3);
    const Solution s = solve_tier(c, Tier::isothermal);
    REQUIRE(s.verdict.good());
    return std::hypot(s.film.force[0], s.film.force[1]);
  };
  for (const double length : {0.4e-3, 1.2e-3}) {
    CHECK(load_on(9, length) / load_on(9, 0.0) ==
          Approx(load_on(127, length) / load_on(127, 0.0)).epsilon(0.02));
  }
}

TEST_CASE("WhatTheCellsDoNotShowOfTheBoreIsTold") {
  const auto solved = [](const Case& c) { return solve_tier(c, Tier::isothermal); };
  Case c = plain_case();
  Bearing relieved = c.bearing;
  relieved.edge_relief = EdgeOpening{9e-6, 0.2e-3};
  c.bearing.shape = table_of(relieved);
  CHECK(tells<note::ShapeBetweenCells>(solved(c)));
  relieved.edge_relief->length = 10e-3;
  c.bearing.shape = table_of(relieved);
  CHECK_FALSE(tells<note::ShapeBetweenCells>(solved(c)));
  c.bearing.shape.reset();
  c.bearing.edge_relief = EdgeOpening{9e-6, 0.2e-3};  // has a cell of its own
  CHECK_FALSE(tells<note::ShapeBetweenCells>(solved(c)));
  c.bearing.edge_relief.reset();
  CHECK_FALSE(tells<note::ShapeBetweenCells>(solved(c)));
  // A groove of 0.4 mm along the middle of cells of 2.8 mm.
  c.bearing.profile = Profile{{0.0}, {-0.01, 0.0058, 0.0059, 0.0062, 0.0063, 0.01}, {}};
  c.bearing.profile->height = {0.0, 0.0, 30e-6, 30e-6, 0.0, 0.0};
  c.model.grid = {24, 9};
  CHECK(tells<note::ProfileBetweenCells>(solved(c)));
  c.model.grid = {24, 121};
  CHECK_FALSE(tells<note::ProfileBetweenCells>(solved(c)));
  c.bearing.profile = lands_and_grooves(5e-6);
  c.model.grid = {80, 8};
  CHECK_FALSE(tells<note::ProfileBetweenCells>(solved(c)));
}

TEST_CASE("ATableThatBeginsAnywhereIsPeriodic") {
  // One turn on, the angle comes back to its first row but for a last digit, and lay before it.
  for (int half = 0; half < 720; ++half) {
    Bearing b = plain_case().bearing;
    Profile p;
    p.z = {0.0};
    for (int k = 0; k < 4; ++k) {
      p.phi.push_back(0.5 * half * kDegree + 0.5 * k * kPi);
      p.height.push_back(1e-6 * (k + 1));
    }
    const double front = p.phi.front();
    b.profile = p;
    FilmGrid g = make_grid(b.radius, b.width, 8, 4, false, {}, {});
    g.phi[0] = front + 2.0 * kPi;
    g.phi[1] = front - 2.0 * kPi;
    const Field h = profile_of_cells(b, g);
    CHECK(h[g.index(0, 0)] == Approx(1e-6));
    CHECK(h[g.index(1, 0)] == Approx(1e-6));
  }
}
