#include "surface/map_factors.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "fluid/flow_factors.hpp"
#include "surface/gaussian_surface.hpp"
#include "surface/height_statistics.hpp"

using namespace shellback;
using namespace shellback::surface;

namespace {

/// A patch with as many correlation lengths each way.
HeightMap patch(double gamma, unsigned seed, int lengths, double shortest) {
  const double lx = gamma > 1.0 ? gamma * shortest : shortest;
  const double ly = gamma < 1.0 ? shortest / gamma : shortest;
  GaussianSurface g{static_cast<int>(lengths * lx),
                    static_cast<int>(lengths * ly),
                    1.0,
                    1.0,
                    1.0,
                    lx,
                    ly,
                    CorrelationShape::smooth,
                    seed};
  HeightMap map = gaussian_surface(g);
  double mean = 0.0;
  for (const double z : map.z) mean += z / static_cast<double>(map.z.size());
  for (double& z : map.z) z -= mean;
  return map;
}

struct Spread {
  double mean = 0.0;
  double deviation = 0.0;  ///< of one patch
};
Spread spread(const std::vector<FactorRow>& rows, double FactorRow::*factor) {
  Spread out;
  const auto n = static_cast<double>(rows.size());
  for (const FactorRow& row : rows) out.mean += row.*factor / n;
  for (const FactorRow& row : rows)
    out.deviation += std::pow(row.*factor - out.mean, 2) / (n - 1.0);
  out.deviation = std::sqrt(out.deviation);
  return out;
}

/// Patches of one orientation against Patir and Cheng: 8 of 16 correlation lengths each way, 4
/// pitches to the shorter one; phi_z of an orientation is phi_x of its reciprocal. The published
/// fits are means over patches no larger: within two standard deviations of a patch, and 0.03 for
/// the fit. phi_f is a closed form of heights cut off at 3 sigma, H E[1/h]: 10 %. phi_fs is not
/// compared: ours is up to three times as large (docs/surfaces.md), and right where perturbation
/// theory says what is right (a test below).
void check_patir_cheng(double gamma) {
  constexpr unsigned kPatches = 8;
  const fluid::RoughPair pair = fluid::rough_pair({0.0, 1.0}, {1.0, gamma});
  std::vector<HeightMap> patches;
  for (unsigned k = 0; k < kPatches; ++k) patches.push_back(patch(gamma, 10 + k, 16, 4.0));
  for (const double H : {1.0, 3.0}) {
    std::vector<FactorRow> rows;
    for (const HeightMap& map : patches) {
      rows.push_back(factors_at(map, height_statistics(map).Rq, H, PatchEnds::periodic));
    }
    const fluid::FlowFactors f = fluid::flow_factors(pair, H);
    const auto compare = [&](const char* name, double FactorRow::*factor, double published) {
      const Spread own = spread(rows, factor);
      INFO("gamma " << gamma << ", H " << H << ": " << name << " " << own.mean << " +- "
                    << own.deviation << ", Patir and Cheng " << published);
      CHECK(std::abs(own.mean - published) < 2.0 * own.deviation + 0.03);
    };
    compare("phi_x", &FactorRow::phi_x, f.phi_x);
    compare("phi_z", &FactorRow::phi_z, f.phi_z);
    compare("phi_s", &FactorRow::phi_s, f.sigma_phi_s);
    compare("phi_fp", &FactorRow::phi_fp, f.phi_fp);
    CHECK(spread(rows, &FactorRow::phi_f).mean == Approx(f.phi_f).epsilon(0.1));
  }
}

}  // namespace

TEST_CASE("FactorsOfTransverseSurfacesArePatirAndChengsWithinTheScatterOfPatches") {
  check_patir_cheng(1.0 / 9.0);
  check_patir_cheng(1.0 / 3.0);
}

TEST_CASE("FactorsOfIsotropicAndLongitudinalSurfacesArePatirAndChengsWithinTheScatterOfPatches") {
  check_patir_cheng(1.0);
  check_patir_cheng(3.0);
  check_patir_cheng(9.0);
}

TEST_CASE("FarFromTheWallTheFactorsAreThoseOfPerturbationTheory") {
  // Tripp 1983 (textbook), R of elliptical contours, e = 1/H:
  //   phi_x = 1 + 3 e^2 (1 - 3/(1 + gamma)),  Phi_s = 3 e/(1 + gamma),  phi_f = 1 + e^2,
  //   Phi_fs = 3 e^2/(1 + gamma),  phi_fp = 1 - 3 e^2/(1 + gamma)
  // At H = 20 the next terms are some 1/H^2 times ten of these, 3 %; a patch of 32 x 32 correlation
  // lengths scatters by 4 % in 1/(1 + gamma), 5 pitches to a length leave 3 %: 10 % of the
  // deviation.
  constexpr double H = 20.0, e = 1.0 / H;
  for (const double gamma : {1.0 / 3.0, 1.0, 3.0}) {
    const double lx = gamma > 1.0 ? 15.0 : 5.0, ly = lx / gamma;
    HeightMap map = gaussian_surface({static_cast<int>(32 * lx), static_cast<int>(32 * ly), 1.0,
                                      1.0, 1.0, lx, ly, CorrelationShape::smooth, 21});
    const double mean =
        std::accumulate(map.z.begin(), map.z.end(), 0.0) / static_cast<double>(map.z.size());
    for (double& z : map.z) z -= mean;
    const FactorRow f = factors_at(map, height_statistics(map).Rq, H, PatchEnds::periodic);
    const double part = 1.0 / (1.0 + gamma), other = gamma / (1.0 + gamma);
    INFO("gamma " << gamma);
    const double scale = 3.0 * e * e;
    CHECK(f.phi_x - 1.0 == Approx(scale * (1.0 - 3.0 * part)).margin(0.1 * scale));
    CHECK(f.phi_z - 1.0 == Approx(scale * (1.0 - 3.0 * other)).margin(0.15 * scale));
    CHECK(f.phi_s == Approx(3.0 * e * part).epsilon(0.1));
    CHECK(f.phi_f - 1.0 == Approx(e * e).epsilon(0.05));
    CHECK(f.phi_fs == Approx(scale * part).epsilon(0.1));
    CHECK(1.0 - f.phi_fp == Approx(scale * part).epsilon(0.1));
    CHECK(f.average_gap == Approx(H).epsilon(1e-12));  // nothing touches
  }
}

TEST_CASE("GroovesOfTheMapHaveTheStriatedLimits") {
  // z = a sin over whole periods: <h^3> = H^3 + 3/2 a^2 H along, 1/<h^-3> across; a = sqrt2 sigma.
  constexpr double H = 3.0;
  HeightMap map{6, 48, 2.0, 1.0, {}};
  for (int j = 0; j < map.ny; ++j) {
    for (int i = 0; i < map.nx; ++i) map.z.push_back(std::sin(2.0 * 3.14159265358979 * j / 24.0));
  }
  const double sigma = height_statistics(map).Rq;
  for (const PatchEnds ends : {PatchEnds::patch, PatchEnds::periodic}) {
    const FactorRow f = factors_at(map, sigma, H, ends);
    double inverse = 0.0;
    for (const double z : map.z) inverse += std::pow(H - z / sigma, -3) / 288.0;
    CHECK(f.phi_x == Approx(1.0 + 3.0 / (H * H)).epsilon(1e-10));
    CHECK(f.phi_z == Approx(1.0 / (inverse * H * H * H)).epsilon(1e-10));
    CHECK(std::abs(f.phi_s) < 1e-12);
    CHECK(f.phi_fp == Approx(1.0).epsilon(1e-12));
  }
}

TEST_CASE("FactorsDoNotChangeIfTheMapIsTurnedAndItsAxesExchanged") {
  const HeightMap map = patch(3.0, 5, 12, 3.0);
  const double sigma = height_statistics(map).Rq;
  const FactorRow a = factors_at(map, sigma, 1.5, PatchEnds::patch);
  const FactorRow b = factors_at(exchanged(map), sigma, 1.5, PatchEnds::patch);
  CHECK(a.phi_x == Approx(b.phi_z).epsilon(1e-9));  // the same equations: round-off
  CHECK(a.phi_z == Approx(b.phi_x).epsilon(1e-9));
  CHECK(a.phi_f == Approx(b.phi_f).epsilon(1e-12));
  CHECK(a.contact == b.contact);
}

TEST_CASE("TheStandardErrorIsTheScatterOfWholeMaps") {
  // Told from the quarters of one map against the deviation over 12 maps: of four values and of
  // twelve, good to a factor of 2.
  std::vector<FactorRow> rows;
  double told = 0.0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const HeightMap map = patch(1.0, seed, 20, 3.0);
    const FactorRows one = map_factors(map, height_statistics(map).Rq, {2.0}, {});
    rows.push_back(one.rows[0]);
    told += one.errors[0].phi_x / 12.0;
  }
  const double scatter = spread(rows, &FactorRow::phi_x).deviation;
  INFO("told " << told << ", scatter " << scatter);
  CHECK(told > 0.5 * scatter);
  CHECK(told < 2.0 * scatter);
}

TEST_CASE("ATableLeavesOutTheGapsThroughWhichNothingFlows") {
  const HeightMap map = patch(1.0, 3, 12, 3.0);
  const FactorRows all = map_factors(map, 1.0, {0.01, 0.5, 1.0, 2.0}, {});
  REQUIRE(all.rows.size() == 4);
  CHECK(all.rows[0].contact > 0.4);
  const fluid::FactorTable table = factor_table(all.rows, 1.0);
  CHECK(table.H.size() <= 4);
  CHECK(fluid::fault_of(table).problem.empty());
  std::atomic<bool> stop{true};
  FactorOptions options;
  options.stop = &stop;
  CHECK(map_factors(map, 1.0, {1.0}, options).rows.empty());
}

TEST_CASE("GroovesAcrossThatTouchLetNothingThroughWhateverRoundOffSays") {
  // z = sin over the motion, a = sqrt2 sigma: closed along the motion at H <= sqrt2 + 0.01, while
  // across the grooves stay open. Round-off would leave a conductance of either sign there.
  HeightMap map{96, 16, 1.0, 1.0, {}};
  for (int j = 0; j < map.ny; ++j) {
    for (int i = 0; i < map.nx; ++i) map.z.push_back(std::sin(2.0 * 3.14159265358979 * i / 24.0));
  }
  const double sigma = height_statistics(map).Rq;
  std::vector<double> gaps;
  for (double H = 0.1; H < 1.42; H += 0.06) gaps.push_back(H);
  for (const double H : {1.5, 2.0, 3.0, 4.0}) gaps.push_back(H);
  for (const PatchEnds ends : {PatchEnds::patch, PatchEnds::periodic}) {
    FactorOptions options;
    options.ends = ends;
    const FactorRows all = map_factors(map, sigma, gaps, options);
    for (const FactorRow& row : all.rows) {
      INFO(row.H << ": " << row.phi_x * std::pow(row.H, 3) << " " << row.phi_z);
      CHECK(row.phi_z > 0.0);
      CHECK(is_open(row) == (row.H > std::sqrt(2.0) + kTouching));
      if (!is_open(row)) CHECK(row.phi_x == 0.0);
    }
    const fluid::FactorTable table = factor_table(all.rows, sigma);
    CHECK(table.H == std::vector<double>{1.5, 2.0, 3.0, 4.0});
    CHECK(fluid::fault_of(table).problem.empty());
  }
}

TEST_CASE("ATableBeginsBehindTheLastClosedGap") {
  // Of a conductance that seems to be open below a closed gap, nothing is believed.
  std::vector<FactorRow> rows;
  for (const double H : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0}) {
    FactorRow row{H, 0.0, H, 0.5, 0.5, 0.1, 1.0, 0.1, 0.9};
    if (H == 1.0) row.phi_x = -1e-17;
    rows.push_back(row);
  }
  CHECK(factor_table(rows, 1.0).H == std::vector<double>{1.5, 2.0, 3.0, 4.0});
}

TEST_CASE("AChannelOfTheNarrowestGapThroughALargeMapIsOpen") {
  // One cell in 2000 of the gap below which surfaces touch: 0.01^3/2000 = 5e-10 sigma^3.
  const int n = 2000;
  HeightMap map{8, n, 1.0, 1.0, std::vector<double>(8 * n, 2.0)};
  for (int i = 0; i < map.nx; ++i) map.z[map.index(i, n / 2)] = 1.0 - 1.001 * kTouching;
  for (int i = 0; i < map.nx; ++i) map.z[map.index(i, n / 3)] = 1.0 - 0.999 * kTouching;
  const FactorRow f = factors_at(map, 1.0, 1.0, PatchEnds::patch);
  CHECK(f.phi_x == Approx(std::pow(1.001 * kTouching, 3) / n).epsilon(1e-10));
  CHECK(f.phi_x > kOpen);
}
