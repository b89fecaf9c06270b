#include "core/grid.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "core/between.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/make_grid.hpp"

using namespace shellback;

namespace {

constexpr double kRadius = 0.02;    // [m]
constexpr double kWidth = 0.024;    // [m]
constexpr double kOfFaces = 1e-13;  // round-off of a few sums of numbers of order one

double sum(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

double nearest_face(const std::vector<double>& face, double at, double period) {
  double least = INFINITY;
  for (const double f : face) {
    const double d = f - at;
    least = std::min(least, std::abs(period > 0.0 ? std::remainder(d, period) : d));
  }
  return least;
}

GridEdges edges_at(const std::vector<double>& places) { return {places.begin(), places.end()}; }

void check_cells(const FilmGrid& g) {
  CHECK(static_cast<int>(g.phi.size()) == g.nt);
  CHECK(static_cast<int>(g.dphi.size()) == g.nt);
  CHECK(static_cast<int>(g.phi_face.size()) == g.nt + 1);
  CHECK(static_cast<int>(g.z.size()) == g.nz);
  CHECK(static_cast<int>(g.dz.size()) == g.nz);
  CHECK(static_cast<int>(g.z_face.size()) == g.nz + 1);
  for (int i = 0; i < g.nt; ++i) {
    CHECK(g.dphi[i] > 0.0);
    CHECK(std::abs(g.phi_face[i + 1] - g.phi_face[i] - g.dphi[i]) < kOfFaces);
  }
  for (int j = 0; j < g.nz; ++j) {
    CHECK(g.dz[j] > 0.0);
    CHECK(g.z[j] >= g.z_face[j]);
    CHECK(g.z[j] < g.z_face[j + 1]);
  }
  CHECK(std::abs(sum(g.dphi) - 2.0 * kPi) < kOfFaces);
  CHECK(std::abs(g.multiplicity() * sum(g.dz) - g.width) < kOfFaces * g.width);
}

/// The half grid must be the upper half of the full grid, cell by cell.
void check_half(int full_nz, const GridEdges& z_edges) {
  GridEdges both = z_edges;
  for (const GridEdge& e : z_edges) both.emplace_back(-e.at, e.strip);
  const FilmGrid half = make_grid(kRadius, kWidth, 20, full_nz, true, {}, z_edges);
  const FilmGrid full = make_grid(kRadius, kWidth, 20, full_nz, false, {}, both);
  check_cells(half);
  check_cells(full);
  REQUIRE(half.full_nz() == full_nz);
  const int skip = full_nz - half.nz;
  for (int j = 0; j < half.nz; ++j) {
    CHECK(std::abs(half.z[j] - full.z[skip + j]) < kOfFaces * kWidth);
    CHECK(std::abs(half.z_face[j + 1] - full.z_face[skip + j + 1]) < kOfFaces * kWidth);
    const double share = j == 0 && full_nz % 2 == 1 ? 0.5 : 1.0;
    CHECK(std::abs(half.dz[j] - share * full.dz[skip + j]) < kOfFaces * kWidth);
  }
}

}  // namespace

TEST_CASE("CellsCoverTheBearing") {
  for (const bool half : {false, true}) {
    for (const int nz : {1, 2, 5, 12}) {
      check_cells(make_grid(kRadius, kWidth, 16, nz, half));
      check_cells(make_grid(kRadius, kWidth, 37, nz, half, {0.1, 0.5, 6.0, 3.3}));
    }
    check_cells(make_grid(kRadius, kWidth, 16, 15, half, {}, {-0.004, 0.004, 0.009, -0.009}));
  }
}

TEST_CASE("FacesLieOnTheEdgesAskedFor") {
  const std::vector<double> phi{-0.4, 0.4, 2.0, 9.0, 4.9 - 2.0 * kPi};
  const std::vector<double> z{-0.007, 0.002, 0.0051};
  for (const int nt : {20, 61, 200}) {
    const FilmGrid g = make_grid(kRadius, kWidth, nt, 15, false, edges_at(phi), edges_at(z));
    CHECK(g.nt == nt);
    CHECK(g.nz == 15);
    for (const double e : phi) CHECK(nearest_face(g.phi_face, e, 2.0 * kPi) < kOfFaces);
    for (const double e : z) CHECK(nearest_face(g.z_face, e, 0.0) < kOfFaces * kWidth);
  }
  for (const int nz : {15, 16}) {
    const FilmGrid g = make_grid(kRadius, kWidth, 20, nz, true, {}, {-0.007, 0.007, 0.0031});
    for (const double e : {0.007, 0.0031})
      CHECK(nearest_face(g.z_face, e, 0.0) < kOfFaces * kWidth);
  }
}

TEST_CASE("CellsAreAsEvenAsTheEdgesAllow") {
  const FilmGrid g = make_grid(kRadius, kWidth, 40, 10, false, {1.0, 1.3, 4.0});
  // A segment of s even cells holds s rounded cells: at worst 1.5 instead of 1 or 2.
  for (const double d : g.dphi) CHECK(std::abs(std::log(d / (2.0 * kPi / 40))) < std::log(1.51));
  for (const double d : g.dz) CHECK(std::abs(d - kWidth / 10) < kOfFaces);
}

TEST_CASE("EdgesCloserThanAFifthOfACellAreOne") {
  const double cell = 2.0 * kPi / 24;
  const FilmGrid merged = make_grid(kRadius, kWidth, 24, 4, false, {1.0, 1.0 + 0.1 * cell});
  for (const double d : merged.dphi) CHECK(std::abs(d - cell) < kOfFaces);
  const FilmGrid kept = make_grid(kRadius, kWidth, 24, 4, false, {1.0, 1.0 + 0.3 * cell});
  CHECK(nearest_face(kept.phi_face, 1.0 + 0.3 * cell, 2.0 * kPi) < kOfFaces);
  const FilmGrid seam = make_grid(kRadius, kWidth, 24, 4, false, {0.0, -0.1 * cell});
  for (const double d : seam.dphi) CHECK(std::abs(d - cell) < kOfFaces);
}

TEST_CASE("AStripHasCellsOfItsOwnHoweverNarrow") {
  for (const double part : {0.3, 0.1, 1e-3}) {  // of a cell
    INFO(part << " of a cell wide");
    const double arc = part * 2.0 * kPi / 24;
    for (const double at : {1.0, 0.0, 6.28}) {  // at the grid's seam, too
      const FilmGrid g =
          make_grid(kRadius, kWidth, 24, 4, false, {{at - 0.5 * arc, 0}, {at + 0.5 * arc, 0}});
      check_cells(g);
      CHECK(*std::min_element(g.dphi.begin(), g.dphi.end()) == Approx(arc).epsilon(1e-9));
    }
    for (const int nz : {8, 9, 12, 13}) {
      const double length = part * kWidth / nz;
      for (const double z : {0.0, 0.004}) {  // cut by mid-width, or with its image beside it
        GridEdges edges{{z - 0.5 * length, 0}, {z + 0.5 * length, 0}};
        if (z > 0.0) edges.insert(edges.end(), {{-z - 0.5 * length, 1}, {-z + 0.5 * length, 1}});
        const FilmGrid g = full_grid(make_grid(kRadius, kWidth, 24, nz, true, {}, edges));
        check_cells(g);
        CHECK(nearest_face(g.z_face, z - 0.5 * length, 0.0) < kOfFaces * kWidth);
        CHECK(nearest_face(g.z_face, z + 0.5 * length, 0.0) < kOfFaces * kWidth);
        CHECK(nearest_face(g.z_face, -z + 0.5 * length, 0.0) < kOfFaces * kWidth);
      }
    }
  }
}

TEST_CASE("ANarrowLandHasACellOfItsOwnWhileThereAreCells") {
  const double end = 0.5 * kWidth;
  for (const double part : {0.3, 0.1, 1e-3}) {  // of a cell
    for (const int nz : {8, 9, 12, 13}) {
      const double land = part * kWidth / nz;
      const double foot = end - land;
      const GridEdges one{{0.3 * end, 0}, {foot, 0}};
      const GridEdges both{{-foot, 0}, {foot, 0}};
      for (const double grading : {0.0, 2.0}) {
        INFO(part << " of a cell wide, " << nz << " cells, grading " << grading);
        const FilmGrid g = make_grid(kRadius, kWidth, 24, nz, false, {}, one, grading);
        check_cells(g);
        CHECK(nearest_face(g.z_face, foot, 0.0) < kOfFaces * kWidth);
        const FilmGrid h = full_grid(make_grid(kRadius, kWidth, 24, nz, true, {}, both, grading));
        check_cells(h);
        CHECK(nearest_face(h.z_face, foot, 0.0) < kOfFaces * kWidth);
        CHECK(nearest_face(h.z_face, -foot, 0.0) < kOfFaces * kWidth);
      }
    }
  }
  // Two cells, and three strips before that at the end.
  const double foot = 0.999 * end;
  const FilmGrid few = make_grid(kRadius, kWidth, 24, 2, false, {}, {{0.0, 0}, {foot, 0}});
  CHECK(few.full_nz() == 2);
  CHECK(nearest_face(few.z_face, foot, 0.0) > 1e-4 * kWidth);
}

TEST_CASE("AsManyCellsAsEdgesAreEnough") {
  // Edges far out leave the middle of an odd half grid no more cells than the others can do
  // without.
  for (const int nz : {5, 7, 9, 25}) {
    const FilmGrid g =
        make_grid(kRadius, kWidth, 16, nz, true, {}, {-0.0088, 0.0088, -0.0075, 0.0075});
    CHECK(g.full_nz() == nz);
    check_cells(g);
    for (const double e : {0.0088, 0.0075})
      CHECK(nearest_face(g.z_face, e, 0.0) < kOfFaces * kWidth);
  }
}

TEST_CASE("WhereCellsRunShortTheLandKeepsTwo") {
  // Half of ten graded cells, a groove or a hole at mid-width, the foot of an edge relief: of a
  // land and a relief that would have two and three cells, the relief gives one up. The land had
  // one alone, up to 0.56 of the half width.
  const double end = 0.5 * kWidth;
  for (const auto& [supply, foot] : {std::pair{0.12, 0.68}, std::pair{0.291, 0.767}}) {
    GridEdges edges{{-supply * end, 0}, {supply * end, 0}};
    for (const double side : {-1.0, 1.0}) edges.emplace_back(side * foot * end, -1, true);
    const FilmGrid g = make_grid(kRadius, kWidth, 20, 10, true, {}, edges, kEdgeGrading);
    check_cells(g);
    const auto in_land = [&](double z) { return z > supply * end && z < foot * end; };
    CHECK(std::count_if(g.z.begin(), g.z.end(), in_land) == 2);
  }
}

TEST_CASE("CellsGrowFromTheRowsOfAHoleAlsoUpToAnEdgeNearBy") {
  // A hole of 2.75 mm in 34 mm, relief from 5.73 mm on, 25 graded cells: pressure falls off as a
  // logarithm between the two, which one cell of 4.4 mm beside rows of 0.9 mm cannot follow.
  const double hole = 1.375e-3, foot = 5.73e-3;
  GridEdge below(-hole, 0), above(hole, 0);
  below.beside = above.beside = 2.0 * hole;
  const GridEdges edges{below, above, GridEdge(-foot), GridEdge(foot)};
  for (const double grading : {0.0, kEdgeGrading}) {
    const FilmGrid g = make_grid(0.025, 0.0339, 200, 25, true, {}, edges, grading);
    double row = 0.0;
    for (int j = 0; j < g.nz; ++j) {
      if (g.z_face[j + 1] > foot * (1.0 + 1e-9)) break;
      if (j > 0 && g.z_face[j] > 0.5 * hole) {
        INFO("cell " << j << " of " << 1e3 * g.dz[j] << " mm beside " << 1e3 * row);
        // Growth by a half in the coordinate of the grading, whose widths go by 1 - z^2 tanh^2.
        CHECK(g.dz[j] <= 1.5 * row * (1.0 + 1e-9));
      }
      row = j == 0 ? 2.0 * g.dz[j] : g.dz[j];  // the middle one is cut in half
    }
    CHECK(row > 0.0);
  }
}

TEST_CASE("CellsBetweenTwoRowsOfHolesGrowAsThoseBeyond") {
  // Two rows of holes of 0.5 mm at 6 mm on both sides of mid-width: the way between them was cut as
  // if it were a hole, with cells of up to seven times a hole's row beside that.
  GridEdges edges;
  for (const double middle : {-6e-3, 6e-3}) {
    for (const double side : {-0.25e-3, 0.25e-3}) {
      GridEdge e(middle + side, middle < 0.0 ? 0 : 1);
      e.beside = 0.5e-3;
      edges.push_back(e);
    }
  }
  for (const int nz : {32, 40}) {
    const FilmGrid g = make_grid(0.025, 0.02, 200, nz, true, {}, edges, 0.0);
    int at = 0;
    while (g.z_face[at + 1] < 5.75e-3 * (1.0 - 1e-9)) ++at;  // the last cell before the hole
    INFO(nz << ": " << 1e3 * g.dz[at] << " mm beside " << 1e3 * g.dz[at + 1]);
    CHECK(g.dz[at] <= 1.5 * g.dz[at + 1] * (1.0 + 1e-9));
  }
}

TEST_CASE("TheOrderOfSuppliesIsNoMatter") {
  // A hole within a longer groove's stretch, both on mid-width: whichever is named first, the hole
  // is the one that mid-width cuts next.
  const auto edges = [](bool hole_first) {
    GridEdges all;
    for (const double side : {-2e-3, 2e-3}) {
      GridEdge e(side, hole_first ? 0 : 1);
      e.beside = 4e-3;
      all.push_back(e);
    }
    for (const double side : {-20e-3, 20e-3}) all.emplace_back(side, hole_first ? 1 : 0);
    return all;
  };
  for (const int nz : {24, 26, 32}) {
    const FilmGrid a = make_grid(0.05, 0.08, 60, nz, true, {}, edges(true), 0.0);
    const FilmGrid b = make_grid(0.05, 0.08, 60, nz, true, {}, edges(false), 0.0);
    CHECK(a.z_face == b.z_face);
  }
}

TEST_CASE("PlacesAroundLieBetweenTheirNeighboursWhateverTheBranch") {
  const std::vector<double> angles{0.1, 1.0, 4.0};
  for (int k = 0; k < 20000; ++k) {
    const double x = 0.1 + 2.0 * kPi * (k % 7 - 3) + 1e-16 * k;  // by a digit beside the first
    const Between at = between_around(angles, x);
    CHECK((at.left >= 0 && at.left < 3 && at.right >= 0 && at.right < 3));
    CHECK((at.weight >= 0.0 && at.weight <= 1.0 + 1e-12));
  }
  const Between seam = between_around(angles, -1.0);  // between 4 and 0.1 + 2 pi
  CHECK(seam.left == 2);
  CHECK(seam.right == 0);
  CHECK(seam.weight == Approx((2.0 * kPi - 1.0 - 4.0) / (0.1 + 2.0 * kPi - 4.0)));
}

TEST_CASE("HolesBesideMidWidthHaveAsManyRowsAsOneOnIt") {
  const double d = 2.75e-3;
  for (const double middle : {0.0, 4e-3}) {
    GridEdges edges;
    for (const double at : {-middle, middle}) {
      const int strip = at < 0.0 ? 0 : 1;
      for (const double side : {-0.5, 0.5}) {
        GridEdge e(at + side * d, strip);
        e.beside = d;
        edges.push_back(e);
      }
      if (middle == 0.0) break;
    }
    for (const int nz : {25, 26, 40, 41}) {
      const FilmGrid g = make_grid(0.025, 0.0339, 200, nz, true, {}, edges, kEdgeGrading);
      int rows = 0;
      for (int j = 0; j < g.nz; ++j) {
        if (std::abs(g.z[j] - middle) >= 0.5 * d) continue;
        rows += middle > 0.0 ? 1 : g.z[j] == 0.0 ? 1 : 2;
      }
      INFO(nz << " cells, a hole at " << 1e3 * middle << " mm");
      const int uneven = middle == 0.0 && nz % 2 == 1 ? 1 : 0;  // rows that mid-width cuts in half
      CHECK(rows >= std::min(nz / 8, 4) - uneven);
    }
  }
}

TEST_CASE("MoreEdgesThanCellsAreRefused") {
  CHECK_THROWS_AS(make_grid(kRadius, kWidth, 3, 4, false, {0.0, 1.0, 2.0, 3.0}), InputError);
}

TEST_CASE("AnOpeningAtTheEndHasCellsOfItsOwn") {
  const double end = 0.5 * kWidth;
  const auto foot_is_face = [&](int nz, bool half, double length, double grading,
                                const std::vector<double>& supplies = {}) {
    GridEdges edges = edges_at(supplies);
    for (const double side : {-1.0, 1.0}) edges.emplace_back(side * (end - length), -1, true);
    const FilmGrid g = make_grid(kRadius, kWidth, 20, nz, half, {}, edges, grading);
    check_cells(g);
    return nearest_face(g.z_face, end - length, 0.0) < kOfFaces * kWidth;
  };
  for (const double grading : {0.0, kEdgeGrading}) {
    for (const int nz : {9, 12}) {
      for (const bool half : {false, true}) {
        for (const double part : {0.001, 0.03, 0.1, 0.3}) {
          CHECK(foot_is_face(nz, half, part * kWidth, grading));
        }
      }
    }
  }
  // a supply's edge keeps its place, and too few cells hold supplies first
  const double hole = end - 0.09 * kWidth;
  CHECK(foot_is_face(9, true, 0.05 * kWidth, 0.0, {-hole, hole}));
  CHECK_FALSE(foot_is_face(9, true, 0.08 * kWidth, 0.0, {-hole, hole}));
  CHECK_FALSE(foot_is_face(3, true, 0.1 * kWidth, 0.0, {-0.1 * kWidth, 0.1 * kWidth}));
}

TEST_CASE("TheHalfGridIsHalfOfTheFullGrid") {
  for (const int nz : {1, 2, 3, 4, 9, 10, 25}) check_half(nz, {});
  // With edges on faces of the even grid both are that even grid.
  for (const int nz : {8, 16, 24}) check_half(nz, {0.006});
  for (const int nz : {9, 15, 33}) check_half(nz, {kWidth / nz * 2.5});
  check_half(15, {kWidth / 15 * 1.5, kWidth / 15 * 4.5});
}

TEST_CASE("TheHalfGridMirroredHasItsEdgesOnBothSides") {
  for (const int nz : {9, 10, 15, 16, 25, 26}) {
    const FilmGrid half = make_grid(kRadius, kWidth, 20, nz, true, {}, {0.0031, 0.0079});
    const FilmGrid full = full_grid(half);
    check_cells(half);
    check_cells(full);
    CHECK(full.nz == nz);
    for (const double e : {0.0031, 0.0079, -0.0031, -0.0079}) {
      CHECK(nearest_face(full.z_face, e, 0.0) < kOfFaces * kWidth);
    }
  }
}

TEST_CASE("AMirroredFieldIsSymmetricAndHasTheSameIntegral") {
  for (const int nz : {7, 8}) {
    const FilmGrid half = make_grid(kRadius, kWidth, 9, nz, true, {0.3, 1.1}, {0.0042});
    const FilmGrid full = full_grid(half);
    check_cells(full);
    REQUIRE(full.nz == nz);
    Field f(static_cast<std::size_t>(half.cells()));
    double integral = 0.0;
    for (int i = 0; i < half.nt; ++i) {
      for (int j = 0; j < half.nz; ++j) {
        f[half.index(i, j)] = std::cos(half.phi[i]) + 1e4 * half.z[j] * half.z[j];
        integral += half.multiplicity() * half.area(i, j) * f[half.index(i, j)];
      }
    }
    const Field whole = mirror_to_full(half, f);
    for (int i = 0; i < full.nt; ++i) {
      for (int j = 0; j < full.nz; ++j) {
        const double exact = std::cos(full.phi[i]) + 1e4 * full.z[j] * full.z[j];
        CHECK(std::abs(whole[full.index(i, j)] - exact) < kOfFaces);
        integral -= full.area(i, j) * whole[full.index(i, j)];
      }
    }
    CHECK(std::abs(integral) < kOfFaces * kRadius * kWidth * 2.0 * kPi);
  }
}

TEST_CASE("InterpolationIsExactForAFieldLinearInZ") {
  const FilmGrid from = make_grid(kRadius, kWidth, 13, 9, false, {0.4}, {0.003});
  const FilmGrid to = make_grid(kRadius, kWidth, 29, 7, false, {5.0, 1.0});
  Field f(static_cast<std::size_t>(from.cells()));
  for (int k = 0; k < from.cells(); ++k) f[k] = 2.0 + 300.0 * from.z[k % from.nz];
  const Field g = interpolate(from, f, to);
  for (int k = 0; k < to.cells(); ++k) {
    const double z = to.z[k % to.nz];
    const double held = std::max(from.z.front(), std::min(from.z.back(), z));
    CHECK(std::abs(g[k] - (2.0 + 300.0 * held)) < 10.0 * kOfFaces);
  }
}

TEST_CASE("InterpolationConvergesWithSecondOrderAcrossTheSeam") {
  double last = 0.0;
  for (const int nt : {16, 32, 64}) {
    const FilmGrid from = make_grid(kRadius, kWidth, nt, 4, false);
    const FilmGrid to = make_grid(kRadius, kWidth, 101, 4, false, {2.7});
    Field f(static_cast<std::size_t>(from.cells()));
    for (int k = 0; k < from.cells(); ++k) f[k] = std::sin(from.phi[k / from.nz] + 0.3);
    const Field g = interpolate(from, f, to);
    double worst = 0.0;
    for (int k = 0; k < to.cells(); ++k) {
      worst = std::max(worst, std::abs(g[k] - std::sin(to.phi[k / to.nz] + 0.3)));
    }
    CHECK(worst < 1.01 * std::pow(2.0 * kPi / nt, 2) / 8.0);  // d^2/8 of linear interpolation
    if (last > 0.0) CHECK(worst < 0.3 * last);
    last = worst;
  }
}

TEST_CASE("InterpolationOntoTheSameGridChangesNothing") {
  for (const bool half : {false, true}) {
    const FilmGrid g = make_grid(kRadius, kWidth, 17, 7, half, {1.0, 2.2});
    Field f(static_cast<std::size_t>(g.cells()));
    for (int k = 0; k < g.cells(); ++k) f[k] = std::sin(37.0 * k);
    const Field same = interpolate(g, f, g);
    for (int k = 0; k < g.cells(); ++k) CHECK(std::abs(same[k] - f[k]) < 10.0 * kOfFaces);
    const Field whole = interpolate(g, f, full_grid(g));
    const Field mirrored = mirror_to_full(g, f);
    for (std::size_t k = 0; k < whole.size(); ++k) {
      CHECK(std::abs(whole[k] - mirrored[k]) < 10.0 * kOfFaces);
    }
  }
}

TEST_CASE("GradedCellsCoverTheBearingAndKeepTheEdgesOfSupplies") {
  const std::vector<double> edges{-0.003, 0.003};
  for (const int nz : {9, 10, 25}) {
    const FilmGrid g = make_grid(kRadius, kWidth, 20, nz, false, {}, edges_at(edges), kEdgeGrading);
    check_cells(g);
    for (const double z : edges) CHECK(nearest_face(g.z_face, z, 0.0) < kOfFaces);
    const FilmGrid h = make_grid(kRadius, kWidth, 20, nz, true, {}, edges_at(edges), kEdgeGrading);
    check_cells(h);
    for (int j = 0; j < h.nz; ++j) {
      CHECK(std::abs(h.z_face[j + 1] - g.z_face[nz - h.nz + j + 1]) < kOfFaces * kWidth);
    }
  }
}

TEST_CASE("AGridSeenFromItsOtherEndIsTheMirrorImage") {
  // Strips of every width at many places: cells are given out, and edges merged, as from the other
  // end, too.
  for (const double grading : {0.0, 2.0}) {
    for (const double width : {1e-4, 1e-3, 4e-3}) {
      for (int k = 0; k < 40; ++k) {
        const double z = -0.009 + 0.00045 * k;
        const auto cells = [&](double sign) {
          const GridEdges edges{{sign * (z - width), 0},
                                {sign * (z + width), 0},
                                {sign * (z + 0.3e-3)},
                                {sign * 0.0123, -1, true},
                                {-sign * 0.0121, -1, true}};
          return make_grid(0.025, 0.025, 24, 13, false, {}, edges, grading);
        };
        const FilmGrid g = cells(1.0), image = cells(-1.0);
        for (int j = 0; j < g.nz; ++j) {
          CHECK(image.z[g.nz - 1 - j] == -g.z[j]);
          CHECK(image.dz[g.nz - 1 - j] == g.dz[j]);
          CHECK(image.z_face[g.nz - j] == -g.z_face[j]);
        }
      }
    }
  }
}

TEST_CASE("GradedFacesAreThoseOfTheMap") {
  constexpr int kCells = 24;
  const FilmGrid g = make_grid(kRadius, kWidth, 20, kCells, false, {}, {}, kEdgeGrading);
  for (int j = 0; j <= kCells; ++j) {
    const double x = 2.0 * j / kCells - 1.0;
    const double z = 0.5 * kWidth * std::tanh(kEdgeGrading * x) / std::tanh(kEdgeGrading);
    CHECK(std::abs(g.z_face[j] - z) < kOfFaces * kWidth);
  }
  // told beside kEdgeGrading, for ever more cells; of 24 they are up to a sixth off
  CHECK(g.dz.front() / (kWidth / kCells) == Approx(0.15).epsilon(0.2));
  CHECK(g.dz[kCells / 2] / (kWidth / kCells) == Approx(2.1).epsilon(0.04));
}

TEST_CASE("EdgesAreLostOnGradedCellsWhereTheyAreOnEvenOnes") {
  // What counts as one edge is a distance on the bearing: a small hole keeps its size at mid-width,
  // where graded cells are twice as wide, and edges near the sides are merged no less.
  const auto kept = [](int nz, const std::vector<double>& edges, double grading) {
    const FilmGrid g = make_grid(kRadius, kWidth, 20, nz, false, {}, edges_at(edges), grading);
    std::vector<bool> there;
    for (const double z : edges) there.push_back(nearest_face(g.z_face, z, 0.0) < kOfFaces);
    return there;
  };
  for (const int nz : {10, 24, 25}) {
    const double cell = kWidth / nz;
    // holes that stand alone at mid-width, beside the edge of another, and beside the side edge
    for (const double half : {0.05, 0.15, 0.21, 0.25, 0.35, 0.5}) {
      for (const double at : {0.0, 0.12 * kWidth, 0.5 * kWidth - 1.2 * cell}) {
        const std::vector<double> edges{at - half * cell, at + half * cell};
        INFO(nz << " cells, hole of " << 2.0 * half << " cells at " << at / kWidth);
        CHECK(kept(nz, edges, kEdgeGrading) == kept(nz, edges, 0.0));
      }
    }
  }
}
