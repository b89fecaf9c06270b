#include "rheology/shear.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "rheology/viscosity.hpp"
#include "tests/rheology/oils.hpp"

using namespace shellback;
using namespace shellback::rheology;
using namespace shellback::rheology::test;

namespace {
const Cross kCross{0.5, 4.5e-8, 0.457};
}

TEST_CASE("CrossMeetsTheTwoPrintedPointsOf0W20") {
  // Seed 000: 25 % less at 2.2e7 1/s (text of 4.1.2); HTHS 2.7 mPa s at 150 degC and 1e6 1/s
  // (Table 1). K and m are rounded to 2 and 3 digits, which moves f by less than 2e-3.
  CHECK(shear_factor(kCross, 2.2e7).value == Approx(0.75).epsilon(2e-3));
  const Oil oil = oil_0W20();
  CHECK(viscosity_slopes(oil, celsius(150.0), 0.0, 1e6).eta == Approx(2.7e-3).epsilon(2e-3));
}

TEST_CASE("ShearThinningRunsFromTheFirstToTheSecondNewtonianViscosity") {
  CHECK(shear_factor(kCross, 0.0).value == 1.0);
  // 1 - f = (1 - r) u/(1 + u), u = (K rate)^m: 1e-13 at 1e-22 1/s; f - r likewise at 1e38 1/s.
  CHECK(shear_factor(kCross, 1e-22).value == Approx(1.0).epsilon(1e-12));
  CHECK(shear_factor(kCross, 1e38).value == Approx(kCross.r).epsilon(1e-12));
  double last = 1.0;
  for (double rate = 1e2; rate < 1e12; rate *= 3.0) {
    const double f = shear_factor(kCross, rate).value;
    CHECK(f < last);
    last = f;
  }
}

TEST_CASE("CrossIsHalfwayAtTheInverseTimeConstant") {
  CHECK(shear_factor(kCross, 1.0 / kCross.K).value == Approx(0.75).epsilon(1e-14));
}

TEST_CASE("ShearSlopeIsTheDerivative") {
  for (const double rate : {1e3, 1e6, 2.2e7, 1e8, 1e10}) {
    const auto f = [&](double w) { return std::log(shear_factor(kCross, std::exp(w)).value); };
    CHECK(shear_factor(kCross, rate).dlnrate ==
          Approx(central_difference(f, std::log(rate), 1e-5)).epsilon(kDerivativeTolerance));
  }
}

TEST_CASE("StressGrowsWithRateExactlyWhereTheCriterionSays") {
  // Steepest descent of ln f is at (K rate)^m = 1/sqrt r: the sign of d ln tau/d ln rate there
  // decides. The cases lie on both sides of m (1 - sqrt r) = 1 + sqrt r.
  for (const Cross& law : {Cross{0.5, 1e-7, 1.0}, Cross{0.01, 1e-7, 1.0}, Cross{0.01, 1e-7, 1.2},
                           Cross{0.01, 1e-7, 1.25}, Cross{0.04, 1e-7, 1.49},
                           Cross{0.04, 1e-7, 1.51}, Cross{0.25, 1e-7, 3.1}}) {
    const double steepest = std::pow(law.r, -0.5 / law.m) / law.K;
    const double slope_of_stress = 1.0 + shear_factor(law, steepest).dlnrate;
    CHECK(stress_is_monotone(law) == (slope_of_stress > 0.0));
    bool grows = true;
    for (double w = -12.0; w < 12.0; w += 0.01) {
      const double rate = std::exp(w) * steepest;
      grows = grows && 1.0 + shear_factor(law, rate).dlnrate > 0.0;
    }
    CHECK(grows == stress_is_monotone(law));
  }
  CHECK(stress_is_monotone(Cross{0.0, 1e-7, 0.9}));
  CHECK_FALSE(stress_is_monotone(Cross{0.0, 1e-7, 1.0}));
}

TEST_CASE("WithoutShearThinningTheOilIsNewtonian") {
  const Oil oil = without_shear_thinning(oil_0W20());
  const ViscositySlopes s = viscosity_slopes(oil, celsius(90.0), 10e6, 1e8);
  CHECK(s.eta == viscosity(oil, celsius(90.0), 10e6));
  CHECK(s.dln_dlnrate == 0.0);
}
