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

/// A patch with as many correlation lengths each way, of the surfaces of Patir (1978).
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
                    CorrelationShape::linear,
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

}  // namespace

TEST_CASE("FactorsOfGaussianSurfacesArePatirAndChengsWithinTheScatterOfPatches") {
  // 6 patches of 16 correlation lengths each way, 4 pitches to the shorter one; phi_z of an
  // orientation is phi_x of its reciprocal. The published fits are means over patches no larger:
  // phi_x and phi_fp must lie within two standard deviations of a patch, and 0.03 for the fit.
  // phi_f is a closed form of a cut-off distribution, H E[1/h]: 8 %. phi_s of the coarser published
  // grids lies below ours where ridges lie along the motion or gaps are small: 0.9 to 1.45 of it.
  // phi_fs is not compared: ours is above it by up to 2.5 times (docs/surfaces.md), and right where
  // perturbation theory says what is right (test below).
  constexpr unsigned kPatches = 6;
  for (const double gamma : {1.0 / 9.0, 1.0 / 3.0, 1.0, 3.0, 9.0}) {
    const fluid::RoughPair pair = fluid::rough_pair({0.0, 1.0}, {1.0, gamma});
    std::vector<HeightMap> patches;
    for (unsigned k = 0; k < kPatches; ++k) patches.push_back(patch(gamma, 10 + k, 16, 4.0));
    for (const double H : {1.0, 2.0, 4.0}) {
      std::vector<FactorRow> rows;
      for (const HeightMap& map : patches) {
        rows.push_back(factors_at(map, height_statistics(map).Rq, H, PatchEnds::periodic));
      }
      const fluid::FlowFactors f = fluid::flow_factors(pair, H);
      const Spread x = spread(rows, &FactorRow::phi_x), z = spread(rows, &FactorRow::phi_z),
                   s = spread(rows, &FactorRow::phi_s), fp = spread(rows, &FactorRow::phi_fp),
                   ff = spread(rows, &FactorRow::phi_f);
      UNSCOPED_INFO("gamma " << gamma << ", H " << H);
      UNSCOPED_INFO("phi_x " << x.mean << " +- " << x.deviation << ", Patir-Cheng " << f.phi_x);
      UNSCOPED_INFO("phi_z " << z.mean << " +- " << z.deviation << ", Patir-Cheng " << f.phi_z);
      UNSCOPED_INFO("phi_s " << s.mean << ", Patir-Cheng " << f.sigma_phi_s);
      UNSCOPED_INFO("phi_fp " << fp.mean << " +- " << fp.deviation << ", " << f.phi_fp);
      CHECK(std::abs(x.mean - f.phi_x) < 2.0 * x.deviation + 0.03);
      CHECK(std::abs(z.mean - f.phi_z) < 2.0 * z.deviation + 0.03);
      CHECK(std::abs(fp.mean - f.phi_fp) < 2.0 * fp.deviation + 0.03);
      CHECK(ff.mean == Approx(f.phi_f).epsilon(0.08));
      CHECK(s.mean > 0.9 * f.sigma_phi_s);
      CHECK(s.mean < 1.45 * f.sigma_phi_s);
    }
  }
}

TEST_CASE("FarFromTheWallTheFactorsAreThoseOfPerturbationTheory") {
  // Tripp 1983 (textbook), R of elliptical contours, e = 1/H:
  //   phi_x = 1 + 3 e^2 (1 - 3/(1 + gamma)),  Phi_s = 3 e/(1 + gamma),  phi_f = 1 + e^2,
  //   Phi_fs = 3 e^2/(1 + gamma),  phi_fp = 1 - 3 e^2/(1 + gamma)
  // At H = 12 the next terms are below 4 % of these; a patch of 32 x 32 correlation lengths
  // scatters by 4 % in 1/(1 + gamma), 4 pitches to a length leave 4 %: 10 % of the deviation.
  constexpr double H = 12.0, e = 1.0 / H;
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
    const FactorRows one = map_factors(map, 1.0, {2.0}, {});
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
