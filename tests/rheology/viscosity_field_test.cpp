#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "rheology/shear.hpp"
#include "rheology/viscosity.hpp"
#include "tests/rheology/oils.hpp"

using namespace shellback;
using namespace shellback::rheology;
using namespace shellback::rheology::test;

namespace {

/// Vector exp and log are good to 4 units in the last place, the exponents are below 20: the two
/// roads may differ by 20 * 4 * 1.1e-16 = 1e-14.
constexpr double kVectorTolerance = 1e-14;

struct Nodes {
  std::vector<double> T, p, out;
};

Nodes nodes(std::size_t n) {
  Nodes at{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(n);
    at.T[i] = celsius(20.0 + 130.0 * s);
    at.p[i] = 3e8 * std::fmod(7.3 * s, 1.0);
  }
  return at;
}

}  // namespace

TEST_CASE("AFieldHasTheViscosityOfItsNodes") {
  const TemperatureLaw by_T[] = {ConstantViscosity{0.01}, Vogel{0.09521e-3, 896.4, 110.0},
                                 ReynoldsSlope{0.0277, 313.15, 0.0341}};
  const PressureLaw by_p[] = {NoPressureEffect{}, Barus{9.5e-9}, Roelands{0.6},
                              Houpert{0.6, 0.03, 363.15}};
  for (const std::size_t n : {0u, 1u, 7u, 300u}) {  // empty, tails of the vector loop, a block
    Nodes at = nodes(n);
    for (const auto& temperature : by_T) {
      for (const auto& pressure : by_p) {
        Oil oil;
        oil.temperature = temperature;
        oil.pressure = pressure;
        double worst = 0.0, worst_slope = 0.0;
        viscosity(oil, at.T, at.p, at.out);
        for (std::size_t i = 0; i < n; ++i) {
          worst = std::max(worst, std::abs(at.out[i] / viscosity(oil, at.T[i], at.p[i]) - 1.0));
        }
        pressure_slope(oil, at.T, at.p, at.out);
        for (std::size_t i = 0; i < n; ++i) {
          const double one = pressure_slope(oil, at.T[i], at.p[i]);
          worst_slope = std::max(worst_slope, std::abs(at.out[i] - one) / 1e-8);
        }
        CHECK(worst < kVectorTolerance);
        CHECK(worst_slope < kVectorTolerance);
      }
    }
  }
}

TEST_CASE("AFieldThinsAsItsNodesDo") {
  std::vector<double> rate{0.0}, factor, slope;
  for (double r = 1e-3; r < 1e15; r *= 1.1) rate.push_back(r);
  factor = slope = rate;
  for (const Cross& law : {Cross{0.5, 4.5e-8, 0.457}, Cross{0.01, 1e-6, 1.0},
                           Cross{0.04, 1e-7, 1.45}, Cross{0.0, 1e-7, 0.9}, Cross{0.9, 1e-3, 0.2}}) {
    Oil oil;
    oil.shear = law;
    shear_factors(oil, rate, factor, slope);
    for (std::size_t i = 0; i < rate.size(); ++i) {
      const ShearFactor one = shear_factor(law, rate[i]);
      // Exponents of u reach 50: 4 units in the last place of exp, log and pow of each.
      CHECK(factor[i] == Approx(one.value).epsilon(5e-14));
      CHECK(slope[i] == Approx(one.dlnrate).epsilon(5e-14).margin(1e-50));  // (1e-290)^m
    }
  }
}

TEST_CASE("ALawWithoutThinningLeavesTheViscosity") {
  const std::vector<double> rate{0.0, 1e5, 1e9};
  for (const ShearLaw& law : {ShearLaw{NoShearThinning{}}, ShearLaw{Cross{1.0, 1e-7, 0.5}},
                              ShearLaw{Cross{0.5, 0.0, 0.5}}}) {
    Oil oil;
    oil.shear = law;
    std::vector<double> factor(3), slope(3);
    shear_factors(oil, rate, factor, slope);
    for (int i = 0; i < 3; ++i) {
      CHECK(factor[i] == 1.0);
      CHECK(std::abs(slope[i]) < 1e-60);  // (1e-290)^m
    }
  }
}
