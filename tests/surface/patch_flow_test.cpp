#include "surface/patch_flow.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/constants.hpp"
#include "surface/gaussian_surface.hpp"

using namespace shellback;
using namespace shellback::surface;

namespace {

/// Gap 3 + sin over one period in x.
PatchGap grooves_across(int nx, int ny) {
  PatchGap gap{nx, ny, 1.0, 0.7, {}};
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) gap.h.push_back(3.0 + std::sin(2.0 * kPi * (i + 0.5) / nx));
  }
  return gap;
}

/// Gap of a Gaussian surface; contact where it is closed.
PatchGap rough(double H, std::uint64_t seed) {
  const HeightMap map =
      gaussian_surface({48, 40, 1.0, 1.3, 1.0, 5.0, 3.0, CorrelationShape::smooth, seed});
  PatchGap gap{map.nx, map.ny, map.dx, map.dy, {}};
  for (const double z : map.z) gap.h.push_back(H - z > 0.01 ? H - z : 0.0);
  return gap;
}

double mean_power(const PatchGap& gap, double n) {
  double sum = 0.0;
  for (const double h : gap.h) sum += std::pow(h, n);
  return sum / static_cast<double>(gap.h.size());
}

}  // namespace

TEST_CASE("GroovesAcrossTheFlowHaveTheHarmonicMeanAndAlongTheArithmeticOne") {
  // Cells in series and side by side are exact, whatever the number of cells: round-off only.
  for (const PatchEnds ends : {PatchEnds::patch, PatchEnds::periodic}) {
    const PatchGap across = grooves_across(24, 5), along = exchanged(across);
    CHECK(patch_flow(across, ends).conductance ==
          Approx(1.0 / mean_power(across, -3.0)).epsilon(1e-12));
    CHECK(patch_flow(along, ends).conductance == Approx(mean_power(along, 3.0)).epsilon(1e-12));
  }
}

TEST_CASE("GroovesAcrossTheFlowAreTheClosedFormOfTheSine") {
  // <h^-3> of h = a + sin: (a^2 + 1/2)/(a^2 - 1)^(5/2), textbook. Sums over the points of a period
  // converge exponentially: 24 points leave below 1e-10.
  const double a = 3.0;
  const double mean = (a * a + 0.5) / std::pow(a * a - 1.0, 2.5);
  CHECK(patch_flow(grooves_across(24, 3), PatchEnds::periodic).conductance ==
        Approx(1.0 / mean).epsilon(1e-10));
}

TEST_CASE("SlidingOverGroovesIsTheOneDimensionalSolution") {
  // Across: flow q = <h^-2>/(2 <h^-3>) everywhere, <h/2 dp/dx> = 3 (<1/h> - <h^-2>^2/<h^-3>).
  // Along: no pressure arises, the mean flow is half the mean gap.
  for (const PatchEnds ends : {PatchEnds::patch, PatchEnds::periodic}) {
    const PatchGap across = grooves_across(24, 5), along = exchanged(across);
    const double h1 = mean_power(across, -1.0), h2 = mean_power(across, -2.0),
                 h3 = mean_power(across, -3.0);
    const PatchMeans m = patch_flow(across, ends);
    CHECK(m.couette == Approx(h2 / h3).epsilon(1e-12));
    CHECK(m.sliding_pressure == Approx(3.0 * (h1 - h2 * h2 / h3)).epsilon(1e-10));
    const PatchMeans n = patch_flow(along, ends);
    CHECK(n.couette == Approx(3.0).epsilon(1e-12));
    CHECK(std::abs(n.sliding_pressure) < 1e-12);
  }
}

TEST_CASE("PressureFlowAndSlidingAreReciprocalOnEveryMap") {
  // Onsager; both come of different right-hand sides. Gaps from 0.01 to 5 give the matrix a
  // condition of 1e9: 1e-7 of the mean gap.
  for (const PatchEnds ends : {PatchEnds::patch, PatchEnds::periodic}) {
    for (const double H : {0.5, 1.0, 3.0}) {
      const PatchMeans m = patch_flow(rough(H, 7), ends);
      CHECK(m.couette == Approx(m.pressure_shear).epsilon(1e-7));
      CHECK(m.sliding_pressure > 0.0);
    }
  }
}

TEST_CASE("ATurnByNinetyDegreesWithTheAxesExchangedChangesNothing") {
  // The same equations in another order of unknowns: round-off.
  for (const PatchEnds ends : {PatchEnds::patch, PatchEnds::periodic}) {
    const PatchGap gap = rough(1.0, 3);
    PatchGap turned = exchanged(gap);  // exchanged and mirrored: turned by 90 degrees
    for (int j = 0; j < turned.ny; ++j) {
      std::reverse(turned.h.begin() + j * turned.nx, turned.h.begin() + (j + 1) * turned.nx);
    }
    CHECK(patch_conductance(turned, ends) ==
          Approx(patch_conductance(exchanged(gap), ends)).epsilon(1e-9));
    CHECK(patch_conductance(exchanged(turned), ends) ==
          Approx(patch_conductance(gap, ends)).epsilon(1e-9));
  }
}

TEST_CASE("TheConductanceLiesBetweenTheMeansInSeriesAndSideBySide") {
  // Wiener's bounds of the mobility h^3, textbook.
  const PatchGap gap = rough(4.0, 11);
  const double k = patch_conductance(gap, PatchEnds::periodic);
  CHECK(k > 1.0 / mean_power(gap, -3.0));
  CHECK(k < mean_power(gap, 3.0));
}

TEST_CASE("APatchIsTheSameMirroredAgainAndAgain") {
  // The ends of a patch are planes of symmetry of (1); both ways of closing it must agree.
  const PatchGap gap = rough(1.5, 5);
  PatchGap mirrored{2 * gap.nx, 2 * gap.ny, gap.dx, gap.dy, {}};
  for (int j = 0; j < mirrored.ny; ++j) {
    for (int i = 0; i < mirrored.nx; ++i) {
      const int a = i < gap.nx ? i : mirrored.nx - 1 - i, b = j < gap.ny ? j : mirrored.ny - 1 - j;
      mirrored.h.push_back(gap.h[static_cast<std::size_t>(b) * gap.nx + a]);
    }
  }
  const PatchMeans one = patch_flow(gap, PatchEnds::patch);
  const PatchMeans four = patch_flow(mirrored, PatchEnds::periodic);
  CHECK(four.conductance == Approx(one.conductance).epsilon(1e-8));
  CHECK(four.couette == Approx(one.couette).epsilon(1e-8));
  CHECK(four.sliding_pressure == Approx(one.sliding_pressure).epsilon(1e-7));
}

TEST_CASE("EnclosedOilFlowsNowhereAndAClosedPatchLetsNothingThrough") {
  PatchGap gap{5, 5, 1.0, 1.0, std::vector<double>(25, 1.0)};
  for (const int c : {7, 11, 13, 17}) gap.h[static_cast<std::size_t>(c)] = 0.0;  // round the middle
  for (const PatchEnds ends : {PatchEnds::patch, PatchEnds::periodic}) {
    const PatchMeans m = patch_flow(gap, ends);
    PatchGap filled = gap;
    filled.h[12] = 0.0;
    CHECK(m.conductance == Approx(patch_conductance(filled, ends)).epsilon(1e-12));
    CHECK(m.couette == Approx(m.pressure_shear).epsilon(1e-12));
  }
  for (int j = 0; j < 5; ++j) gap.h[static_cast<std::size_t>(5 * j + 2)] = 0.0;
  CHECK(std::abs(patch_conductance(gap, PatchEnds::patch)) < 1e-12);  // round-off of h^3 = 1
  CHECK(patch_conductance({2, 2, 1.0, 1.0, std::vector<double>(4, 0.0)}, PatchEnds::patch) == 0.0);
}

TEST_CASE("ASmoothGapConvergesWithSecondOrder") {
  // h = 2 + sin x cos y + 0.5 cos 2x: errors against 4 times finer cells fall by 4 with the pitch;
  // 3 to 5.5 allows for the finite reference.
  const auto conductance = [](int n) {
    PatchGap gap{n, n, 1.0 / n, 1.0 / n, {}};
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const double x = 2.0 * kPi * (i + 0.5) / n, y = 2.0 * kPi * (j + 0.5) / n;
        gap.h.push_back(2.0 + std::sin(x) * std::cos(y) + 0.5 * std::cos(2.0 * x));
      }
    }
    return patch_conductance(gap, PatchEnds::periodic);
  };
  const double exact = conductance(128), coarse = conductance(16), fine = conductance(32);
  const double ratio = (coarse - exact) / (fine - exact);
  CHECK(ratio > 3.0);
  CHECK(ratio < 5.5);
}

TEST_CASE("OnlyAChannelThatGoesRoundOpensAPeriodicPatch") {
  // Diagonal staircase of open cells, one cell up per cell along: it closes on itself after a round
  // along x if the patch is as high as long. A wall across every row but with a way up and back on
  // the same side of the seam opens nothing.
  const int n = 12;
  PatchGap stairs{n, n, 1.0, 1.0, std::vector<double>(n * n, 0.0)};
  for (int i = 0; i < n; ++i) {
    stairs.h[static_cast<std::size_t>(i * n + i)] = 1.0;
    stairs.h[static_cast<std::size_t>(i * n + (i + 1) % n)] = 1.0;
  }
  CHECK(patch_conductance(stairs, PatchEnds::periodic) > 1e-3);
  PatchGap walled{n, n, 1.0, 1.0, std::vector<double>(n * n, 1.0)};
  for (int j = 0; j < n; ++j) walled.h[static_cast<std::size_t>(j * n + 5)] = 0.0;
  CHECK(patch_conductance(walled, PatchEnds::periodic) == 0.0);
  CHECK(patch_conductance(walled, PatchEnds::patch) == 0.0);
  CHECK(patch_conductance(exchanged(walled), PatchEnds::periodic) > 0.5);
  PatchGap seam{n, n, 1.0, 1.0, std::vector<double>(n * n, 1.0)};
  for (int j = 0; j < n; ++j) seam.h[static_cast<std::size_t>(j * n)] = 0.0;
  CHECK(patch_conductance(seam, PatchEnds::periodic) == 0.0);
}
