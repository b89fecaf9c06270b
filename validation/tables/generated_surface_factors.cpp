/// Flow factors of generated Gaussian surfaces beside Patir and Cheng's: the table of
/// docs/surfaces.md. Means over patches of 16 x 16 correlation lengths, 4 pitches to the shorter
/// one, smooth autocorrelation, periodic; +- the standard deviation of one patch.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "fluid/flow_factors.hpp"
#include "surface/gaussian_surface.hpp"
#include "surface/height_statistics.hpp"
#include "surface/map_factors.hpp"

namespace {

using namespace shellback;
using surface::FactorRow;

constexpr unsigned kPatches = 8;
constexpr int kLengths = 16;
constexpr double kShortest = 4.0;  ///< pitches

surface::HeightMap patch(double gamma, unsigned seed) {
  const double lx = kShortest * std::max(gamma, 1.0), ly = kShortest * std::max(1.0 / gamma, 1.0);
  auto map =
      surface::gaussian_surface({static_cast<int>(kLengths * lx), static_cast<int>(kLengths * ly),
                                 1.0, 1.0, 1.0, lx, ly, surface::CorrelationShape::smooth, seed});
  double mean = 0.0;
  for (const double z : map.z) mean += z / static_cast<double>(map.z.size());
  for (double& z : map.z) z -= mean;
  return map;
}

void print(double gamma, double H) {
  constexpr std::array kFactors{&FactorRow::phi_x, &FactorRow::phi_z,  &FactorRow::phi_s,
                                &FactorRow::phi_f, &FactorRow::phi_fs, &FactorRow::phi_fp};
  const auto f = fluid::flow_factors(fluid::rough_pair({0.0, 1.0}, {1.0, gamma}), H);
  const std::array<double, 6> published{f.phi_x, f.phi_z,  f.sigma_phi_s,
                                        f.phi_f, f.phi_fs, f.phi_fp};
  std::array<double, 6> sum{}, squares{};
  for (unsigned k = 0; k < kPatches; ++k) {
    const auto map = patch(gamma, 10 + k);
    const double sigma = surface::height_statistics(map).Rq;
    const FactorRow row = surface::factors_at(map, sigma, H, surface::PatchEnds::periodic);
    for (std::size_t q = 0; q < kFactors.size(); ++q) {
      sum[q] += row.*kFactors[q];
      squares[q] += std::pow(row.*kFactors[q], 2);
    }
  }
  std::printf("%7.3f %5.1f", gamma, H);
  for (std::size_t q = 0; q < kFactors.size(); ++q) {
    const double mean = sum[q] / kPatches;
    const double variance = (squares[q] - kPatches * mean * mean) / (kPatches - 1);
    std::printf("  %6.3f +- %5.3f (%6.3f)", mean, std::sqrt(std::max(variance, 0.0)), published[q]);
  }
  std::printf("\n");
}

}  // namespace

int main() {
  std::printf("# mean +- deviation of a patch (Patir and Cheng)\n  gamma     H");
  for (const char* name : {"phi_x", "phi_z", "phi_s", "phi_f", "phi_fs", "phi_fp"}) {
    std::printf("  %-24s", name);
  }
  std::printf("\n");
  for (const double gamma : {1.0 / 9.0, 1.0 / 3.0, 1.0, 3.0, 9.0}) {
    for (const double H : {1.0, 2.0, 4.0}) print(gamma, H);
  }
}
