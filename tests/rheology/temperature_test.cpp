#include "rheology/temperature.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "rheology/viscosity.hpp"
#include "tests/rheology/oils.hpp"

using namespace shellback;
using namespace shellback::rheology;
using namespace shellback::rheology::test;

TEST_CASE("VogelMeetsThePrintedViscositiesOf0W20") {
  const Oil oil = oil_0W20();
  // Seed 000 Table 1: 37.5 and 6.8 mPa s. A and B are printed to 4 digits, and B/(T + C) is
  // about 6, so that A exp(B/(T + C)) is good to 1e-3.
  CHECK(viscosity(oil, celsius(40.0), 0.0) == Approx(37.5e-3).epsilon(1e-3));
  CHECK(viscosity(oil, celsius(100.0), 0.0) == Approx(6.8e-3).epsilon(1e-3));
}

TEST_CASE("WaltherMeetsItsPointsAndIsAStraightLine") {
  // 32 and 5.29 mm2/s at 40 and 100 degC: of a mineral oil of class ISO VG 32.
  Walther law = walther_through(32.0, celsius(40.0), 5.29, celsius(100.0));
  law.rho = 870.0;
  law.at = celsius(15.0);
  law.expansivity = 6.5e-4;
  const auto nu = [&](double t) {  // [mm2/s]
    const double rho = law.rho * (1.0 - law.expansivity * (t - 15.0));
    return 1e6 * std::exp(log_viscosity(law, celsius(t)).value) / rho;
  };
  CHECK(nu(40.0) == Approx(32.0).epsilon(1e-12));
  CHECK(nu(100.0) == Approx(5.29).epsilon(1e-12));
  // Straight in log T and log log(nu + 0.7), with logarithms of ten as ASTM D341 has them.
  const auto y = [&](double t) { return std::log10(std::log10(nu(t) + 0.7)); };
  const auto x = [](double t) { return std::log10(t + 273.15); };
  const double slope = (y(100.0) - y(40.0)) / (x(100.0) - x(40.0));
  for (const double t : {-20.0, 0.0, 60.0, 80.0, 150.0}) {
    CHECK(y(t) == Approx(y(40.0) + slope * (x(t) - x(40.0))).margin(1e-12));
  }
  // The order of the points does not matter.
  const Walther turned = walther_through(5.29, celsius(100.0), 32.0, celsius(40.0));
  CHECK(turned.a == Approx(law.a).epsilon(1e-12));
  CHECK(turned.B == Approx(law.B).epsilon(1e-12));
}

TEST_CASE("TwoPointsFixTheWorkingRangeWhateverVogelsC") {
  // The rows of the bracket (C = 95, 110, 130 K) agree at 80 degC within the 2.2 % stated with
  // them; half a per mille more for the printed digits.
  const double T = celsius(80.0);
  const double low = std::exp(log_viscosity(Vogel{0.14591e-3, 749.1, 95.0}, T).value);
  const double mid = std::exp(log_viscosity(Vogel{0.09521e-3, 896.4, 110.0}, T).value);
  const double high = std::exp(log_viscosity(Vogel{0.05389e-3, 1112.7, 130.0}, T).value);
  CHECK(low < mid);
  CHECK(mid < high);
  CHECK(high / low < 1.0225);
}

TEST_CASE("ViscosityFallsWithTemperature") {
  Oil oil = oil_0W20();
  for (const TemperatureLaw& law : {TemperatureLaw{Vogel{0.09521e-3, 896.4, 110.0}},
                                    TemperatureLaw{ReynoldsSlope{0.0277, 313.15, 0.0341}},
                                    TemperatureLaw{Walther{23.1, 3.8, 870.0, 288.15, 6.5e-4}}}) {
    oil.temperature = law;
    for (double t = -20.0; t < 180.0; t += 10.0) {
      CHECK(viscosity(oil, celsius(t + 10.0), 0.0) < viscosity(oil, celsius(t), 0.0));
      CHECK(log_viscosity(law, celsius(t)).dT < 0.0);
    }
  }
}

TEST_CASE("TemperatureSlopesAreTheDerivatives") {
  for (const TemperatureLaw& law :
       {TemperatureLaw{ConstantViscosity{0.01}}, TemperatureLaw{Vogel{0.09521e-3, 896.4, 110.0}},
        TemperatureLaw{ReynoldsSlope{0.0277, 313.15, 0.0341}},
        TemperatureLaw{Walther{23.1, 3.8, 870.0, 288.15, 6.5e-4}}}) {
    for (const double T : {273.15, 313.15, 373.15, 423.15}) {
      const double difference =
          central_difference([&](double t) { return log_viscosity(law, t).value; }, T, 1e-2);
      CHECK(log_viscosity(law, T).dT ==
            Approx(difference).epsilon(kDerivativeTolerance).margin(1e-12));
    }
  }
}

TEST_CASE("ReynoldsSlopeIsTheVogelTangent") {
  const Vogel vogel{0.09521e-3, 896.4, 110.0};
  const double at = celsius(90.0);
  const LogAndSlope tangent = log_viscosity(vogel, at);
  const ReynoldsSlope line{std::exp(tangent.value), at, -tangent.dT};
  for (const double dT : {0.4, 0.2, 0.1}) {
    // Second order: the two differ by half of d2 ln eta/dT2 = 2 B/(T_C + C)^3, times dT^2.
    const double curvature = 2.0 * vogel.B / std::pow(200.0, 3);
    const double gap = log_viscosity(vogel, at + dT).value - log_viscosity(line, at + dT).value;
    CHECK(gap == Approx(0.5 * curvature * dT * dT).epsilon(0.01));  // next order: dT/200
  }
}
