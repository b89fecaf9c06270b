// What the last cells leave of the smallest film at a side edge, against gaps that are known there.
#include "fidelity/edge_error.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/make_grid.hpp"

using namespace shellback;
using namespace shellback::fidelity;

namespace {

constexpr std::array<double, 3> kEven{0.5, 1.5, 2.5};
constexpr std::array<double, 3> kGraded{0.5, 1.7, 3.4};

/// Gap 1 + A s^a at the distances s.
std::array<double, 3> gap(const std::array<double, 3>& s, double A, double a) {
  std::array<double, 3> h{};
  for (int k = 0; k < 3; ++k) h[k] = 1.0 + A * std::pow(s[k], a);
  return h;
}

/// What the straight line through the first two gives on the edge, above the 1 that is there.
double above(const std::array<double, 3>& s, const std::array<double, 3>& h) {
  return h[0] - (h[1] - h[0]) * s[0] / (s[1] - s[0]) - 1.0;
}

}  // namespace

TEST_CASE("TheGapOfAPowerIsKnownOnTheEdge") {
  for (const auto& s : {kEven, kGraded}) {
    for (const double a : {0.5, 0.6, 0.75, 0.9, 1.0}) {
      const auto h = gap(s, 0.3, a);
      INFO(a);
      CHECK(left_of_edge(s, h) == Approx(above(s, h)).margin(1e-6));
    }
  }
}

TEST_CASE("NothingIsLeftWhereTheGapOpensOrFallsStraight") {
  for (const auto& s : {kEven, kGraded}) {
    CHECK(left_of_edge(s, gap(s, -0.3, 0.5)) == 0.0);
    CHECK(left_of_edge(s, gap(s, 0.3, 1.5)) == 0.0);
    CHECK(left_of_edge(s, gap(s, 0.0, 1.0)) == 0.0);
  }
}

TEST_CASE("NoEdgeIsTakenAsSteeperThanAPunch") {
  for (const auto& s : {kEven, kGraded}) {
    const auto h = gap(s, 0.3, 0.2);
    const double drop = (h[1] - h[0]) * s[0] / (s[1] - s[0]);
    const double first = std::sqrt(s[0]), next = std::sqrt(s[1]);
    CHECK(left_of_edge(s, h) == Approx((h[1] - h[0]) * first / (next - first) - drop));
    CHECK(left_of_edge(s, h) < above(s, h));
  }
}

TEST_CASE("BothEdgesOfABearingAndOnlyTheyLeaveSomething") {
  const FilmGrid g = make_grid(1.0, 2.0, 20, 12, false, {}, {});
  Field h(g.cells(), 5.0);
  const int row = 7;
  for (int j = 0; j < g.nz; ++j) h[g.index(row, j)] = 1.0 + std::sqrt(1.0 - g.z[j]);
  const fluid::SmallestGap high{1.2, g.phi[row], g.z_face.back()};
  const Field none(g.cells(), 0.0);
  const double left = edge_error(g, h, none, high);
  CHECK(left > 0.0);
  CHECK(edge_error(g, h, none, fluid::SmallestGap{1.2, g.phi[row], g.z[11]}) == 0.0);
  CHECK(edge_error(g, h, none, fluid::SmallestGap{1.2, g.phi[row + 1], g.z_face.back()}) ==
        0.0);  // even there
  Field mirror(g.cells(), 5.0);
  for (int j = 0; j < g.nz; ++j) mirror[g.index(row, j)] = h[g.index(row, g.nz - 1 - j)];
  CHECK(edge_error(g, mirror, none, fluid::SmallestGap{1.2, g.phi[row], g.z_face.front()}) ==
        Approx(left));
  Field in_supply(g.cells(), 0.0);
  CHECK(edge_error(g, h, in_supply) == Approx(left));  // the row found by itself
  CHECK(edge_error(g, mirror, in_supply) == Approx(left));
  in_supply[g.index(2, 9)] = 1.0;  // a groove, whose depth falls off like no edge of a film
  h[g.index(2, 9)] = 1e3;
  CHECK(edge_error(g, h, in_supply) == Approx(left));
  h[g.index(2, 5)] = 0.5;  // a cell has less
  CHECK(edge_error(g, h, in_supply) == 0.0);
}

TEST_CASE("ALandThatFallsToAGrooveLeavesItsWholeFall") {
  // Pressed land beside a groove: 1 + sqrt(s) from its edge at z = -0.5, the cells told down to
  // their middles. On a power the edge's own gap is found.
  const FilmGrid g = make_grid(1.0, 2.0, 20, 12, false, {}, {});
  Field h(g.cells(), 5.0), in_supply(g.cells(), 0.0);
  const int row = 7, first = 3;  // behind three cells of groove
  for (int j = 0; j < first; ++j) in_supply[g.index(row, j)] = 1.0;
  for (int j = first; j < g.nz; ++j) {
    h[g.index(row, j)] = 1.0 + std::sqrt(g.z[j] - g.z_face[first]);
  }
  const double told = h[g.index(row, first)];
  const fluid::SmallestGap least{told, g.phi[row], g.z[first]};
  CHECK(edge_error(g, h, in_supply, least) == Approx(told - 1.0));
  CHECK(edge_error(g, h, in_supply) == Approx(told - 1.0));    // of a load cycle's smallest gaps
  CHECK(edge_error(g, h, in_supply, {0.9, 0.0, 0.0}) == 0.0);  // less is told elsewhere
  for (double& x : h) x = 6.0 - x;                             // opens towards the groove
  CHECK(edge_error(g, h, in_supply, {6.0 - 1.0, g.phi[row], g.z[first]}) == 0.0);
}
