#include "rheology/density.hpp"

#include <catch2/catch.hpp>

#include "tests/rheology/oils.hpp"

using namespace shellback;
using namespace shellback::rheology;
using namespace shellback::rheology::test;

namespace {
Oil compressible() {
  Oil oil;
  oil.density = DowsonHigginson{832.5, celsius(40.0), 7e-4};
  return oil;
}
}  // namespace

TEST_CASE("DensityIsTheGivenOneAtTheReferenceState") {
  CHECK(density(compressible(), celsius(40.0), 0.0).rho == 832.5);
}

TEST_CASE("DensityGrowsWithPressureToTheLimitOfDowsonAndHigginson") {
  const Oil oil = compressible();
  const double T = celsius(40.0);
  double last = 0.0;
  for (const double p : {-1e5, 0.0, 1e6, 1e8, 1e9, 1e10}) {
    const double rho = density(oil, T, p).rho;
    CHECK(rho > last);
    last = rho;
  }
  // 1 + 0.6/1.7 as p grows without bound; at 1e15 Pa the rest is 1/(1.7e-9 p) = 6e-7.
  CHECK(density(oil, T, 1e15).rho / 832.5 == Approx(1.0 + 0.6 / 1.7).epsilon(1e-6));
}

TEST_CASE("DensityWithItsOwnConstantsIsTheQuotientOfC1AndC2") {
  const double C1 = 2.22e9, C2 = 1.66;
  const DowsonHigginson law{850.0, celsius(40.0), 0.0, (C2 - 1.0) / C1, 1.0 / C1};
  for (const double p : {0.0, 1e5, 4e7, 1e9}) {
    const double quotient = (C1 + C2 * p) / (C1 + p);
    CHECK(density(law, celsius(90.0), p).rho == Approx(850.0 * quotient).epsilon(1e-14));
  }
}

TEST_CASE("DensityFallsWithTemperatureByTheExpansivity") {
  const Oil oil = compressible();
  CHECK(density(oil, celsius(140.0), 0.0).rho == Approx(832.5 * (1.0 - 0.07)).epsilon(1e-14));
}

TEST_CASE("DensitySlopesAreTheDerivatives") {
  Oil own = compressible();
  std::get<DowsonHigginson>(own.density).rise = 0.66 / 2.22e9;
  std::get<DowsonHigginson>(own.density).limit = 1.0 / 2.22e9;
  for (const Oil& oil : {compressible(), own}) {
    for (const double p : {0.0, 1e8, 1e9}) {
      const double T = celsius(80.0);
      const Density d = density(oil, T, p);
      const auto by_T = [&](double t) { return density(oil, t, p).rho; };
      const auto by_p = [&](double q) { return density(oil, T, q).rho; };
      CHECK(d.dT == Approx(central_difference(by_T, T, 1e-1)).epsilon(kDerivativeTolerance));
      CHECK(d.dp == Approx(central_difference(by_p, p, 1e5)).epsilon(kDerivativeTolerance));
    }
  }
  const Density constant = density(ConstantDensity{860.0}, 300.0, 1e8);
  CHECK(constant.rho == 860.0);
  CHECK(constant.dT == 0.0);
  CHECK(constant.dp == 0.0);
}
