#include "rheology/pressure.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "rheology/viscosity.hpp"
#include "tests/rheology/oils.hpp"

using namespace shellback;
using namespace shellback::rheology;
using namespace shellback::rheology::test;

namespace {

Oil with(const PressureLaw& law) {
  Oil oil = oil_0W20();
  oil.pressure = law;
  return oil;
}

const double kAt = celsius(90.0);
const Houpert kHoupert{0.6, 0.03, kAt};

}  // namespace

TEST_CASE("BarusRaisesTheViscosityNearlySevenfoldAt200MPa") {
  const Oil oil = oil_0W20();
  const double ratio = viscosity(oil, kAt, 200e6) / viscosity(oil, kAt, 0.0);
  // Seed 000 section 4.1.2 says "nearly sevenfold"; the law itself is exact to round-off.
  CHECK(ratio == Approx(std::exp(9.5e-9 * 200e6)).epsilon(1e-13));
  CHECK(ratio > 6.5);
  CHECK(ratio < 7.0);
}

TEST_CASE("RoelandsHasTheBarusSlopeAtAmbientPressureAndLiesBelowItBeyond") {
  const double alpha = 9.5e-9;
  const double eta0 = viscosity(with(NoPressureEffect{}), kAt, 0.0);
  // Seed 002 Eq. 22 with Cp = 1/B = 1.96e8 Pa and eta_inf = exp(-9.67) Pa s.
  const double Z = alpha / (kRoelandsSlope * (std::log(eta0) + kRoelandsLog));
  const Oil roelands = with(Roelands{Z});
  const Oil barus = with(Barus{alpha});
  CHECK(pressure_slope(roelands, kAt, 0.0) == Approx(alpha).epsilon(1e-13));
  for (const double p : {50e6, 200e6, 1e9}) {
    CHECK(viscosity(roelands, kAt, p) < viscosity(barus, kAt, p));
    CHECK(viscosity(roelands, kAt, p) > eta0);
  }
}

TEST_CASE("HoupertIsRoelandsAtItsReferenceTemperature") {
  for (const double p : {0.0, 1e6, 100e6, 1e9}) {
    const double houpert = viscosity(with(kHoupert), kAt, p);
    const double roelands = viscosity(with(Roelands{kHoupert.Z}), kAt, p);
    CHECK(houpert == Approx(roelands).epsilon(1e-12));  // round-off of exp, exponent up to 10
  }
}

TEST_CASE("HoupertHasReynoldsSlopeBetaAtItsReferenceState") {
  const ViscositySlopes s = viscosity_slopes(with(kHoupert), kAt, 0.0, 0.0);
  CHECK(s.dln_dT == Approx(-kHoupert.beta).epsilon(1e-12));
}

TEST_CASE("HoupertReplacesTheTemperatureLawAwayFromItsReference") {
  // Another temperature law with the same viscosity at `at` must change nothing anywhere.
  Oil vogel = with(kHoupert);
  Oil constant = vogel;
  constant.temperature = ConstantViscosity{std::exp(log_viscosity(vogel.temperature, kAt).value)};
  for (const double t : {20.0, 60.0, 90.0, 150.0}) {
    CHECK(viscosity(vogel, celsius(t), 50e6) ==
          Approx(viscosity(constant, celsius(t), 50e6)).epsilon(1e-12));
  }
}

TEST_CASE("WithoutPressureEffectKeepsTheAmbientViscosity") {
  for (const PressureLaw& law : {PressureLaw{Barus{9.5e-9}}, PressureLaw{Roelands{0.6}}}) {
    const Oil off = without_pressure_effect(with(law));
    CHECK(viscosity(off, celsius(60.0), 300e6) ==
          Approx(viscosity(with(law), celsius(60.0), 0.0)).epsilon(1e-13));
  }
  const Oil off = without_pressure_effect(with(kHoupert));
  CHECK(viscosity(off, kAt, 300e6) == Approx(viscosity(with(kHoupert), kAt, 0.0)).epsilon(1e-12));
  CHECK(viscosity_slopes(off, kAt, 0.0, 0.0).dln_dT == Approx(-kHoupert.beta));
}

TEST_CASE("PressureLawSlopesAreTheDerivatives") {
  for (const PressureLaw& law : {PressureLaw{NoPressureEffect{}}, PressureLaw{Barus{9.5e-9}},
                                 PressureLaw{Roelands{0.6}}, PressureLaw{kHoupert}}) {
    const Oil oil = with(law);
    for (const double T : {celsius(40.0), celsius(120.0)}) {
      for (const double p : {0.0, 40e6, 400e6}) {
        const ViscositySlopes s = viscosity_slopes(oil, T, p, 1e6);
        const auto by_T = [&](double t) { return std::log(viscosity(oil, t, p)); };
        const auto by_p = [&](double q) { return std::log(viscosity(oil, T, q)); };
        CHECK(s.dln_dT == Approx(central_difference(by_T, T, 1e-2)).epsilon(kDerivativeTolerance));
        CHECK(s.dln_dp ==
              Approx(central_difference(by_p, p, 1e4)).epsilon(kDerivativeTolerance).margin(1e-16));
        CHECK(pressure_slope(oil, T, p) == s.dln_dp);
      }
    }
  }
}
