/// The closed formulas behind `shellback check`, against printed values.
#include "app/derived.hpp"

#include <cmath>
#include <fstream>
#include <sstream>

#include "app/check.hpp"
#include "app/indicators.hpp"
#include "app/reading/library.hpp"
#include "core/constants.hpp"
#include "fluid/gap.hpp"
#include "tests/app/sample_case.hpp"

using namespace shellback;
using namespace shellback::app;

namespace {

Indicator find(const std::vector<Indicator>& list, const std::string& effect) {
  for (const Indicator& i : list) {
    if (i.effect == effect) return i;
  }
  FAIL("no indicator " << effect);
  return {};
}

}  // namespace

TEST_CASE("TheEstimatedSommerfeldNumberIsNearButenschoens") {
  std::ifstream file(std::string(SHELLBACK_SOURCE_DIR) +
                     "/validation/data/butenschoen_1976_rotation.csv");
  REQUIRE(file);
  std::string line;
  int rows = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#' || line[0] == 'e') continue;
    std::istringstream cells(line);
    double eps = 0.0;
    double b = 0.0;
    double so = 0.0;
    char comma = 0;
    cells >> eps >> comma >> b >> comma >> so;
    if (eps < 0.1 || eps > 0.99 || b < 0.25 || b > 1.0) continue;
    INFO("eps " << eps << ", B/D " << b);
    CHECK(estimated_sommerfeld(eps, b) == Approx(so).epsilon(0.16));  // as the header promises
    ++rows;
  }
  CHECK(rows > 20);
}

TEST_CASE("TheEstimateTendsToOcvirkForNarrowBearings") {
  // Ocvirk's half film as validation data 3.3 print it.
  const double eps = 0.5;
  const double b = 1e-3;
  const double ocvirk = b * b * eps / (2.0 * std::pow(1.0 - eps * eps, 2)) *
                        std::sqrt(16.0 * eps * eps + kPi * kPi * (1.0 - eps * eps));
  CHECK(estimated_sommerfeld(eps, b) == Approx(ocvirk).epsilon(1e-5));  // next order is b^2
}

TEST_CASE("TheEccentricityIsTheInverseOfTheSommerfeldNumber") {
  for (const double eps : {0.05, 0.3, 0.6, 0.9, 0.99}) {
    const double so = estimated_sommerfeld(eps, 0.5);
    CHECK(estimated_eccentricity(so, 0.5) == Approx(eps).epsilon(1e-12));  // bisected to round-off
  }
  CHECK(estimated_eccentricity(0.0, 0.5) == Approx(0.0).margin(1e-12));
}

TEST_CASE("PrintedNumbersOfTheKsRigAreReproduced") {
  const auto d = derive(read_case(case_path("ks-rig-test-bearing").string()));
  CHECK(d.eta == Approx(6.8e-3).epsilon(1e-3));          // seed 000 Table 1: 6.8 mPa s at 100 degC
  CHECK(d.specific_load == Approx(10e6).epsilon(0.03));  // "10 MPa", rounded in the paper
  CHECK(d.speed == Approx(7.508).epsilon(1e-3));         // pi 47.8 mm 50/s, four figures
  CHECK(d.reynolds_limit == Approx(41.2 * std::sqrt(1000.0)).epsilon(1e-9));
  // Combined roughness of Rq 0.34 and 0.20 um.
  CHECK(*d.lambda == Approx(d.h_min / 0.39446e-6).epsilon(1e-4));
}

TEST_CASE("PetroffHeatsTheCouetteFlow") {
  const auto c = read_case_text(kSampleCase, "case.toml");
  const auto d = derive(c);
  const auto& b = c.bearing;
  const double flow = 0.5 * d.speed * b.radial_clearance * b.width;
  // An identity: the two formulas of the header say the same.
  CHECK(d.heat_per_pass == Approx(d.petroff_power / (d.rho * d.cp * flow)).epsilon(1e-12));
  CHECK(d.so == Approx(d.specific_load * 1e-6 / (d.eta * c.operation.omega)).epsilon(1e-12));
}

TEST_CASE("ThePressureRatioPassesThroughThePrintedPoints") {
  // Raimondi, Boyd 1958, L/D = 1/2: P/p_max 0.441 at 0.4, 0.365 at 0.6, 0.206 at 0.9.
  CHECK(estimated_pressure_ratio(0.4) == Approx(0.441));
  CHECK(estimated_pressure_ratio(0.5) == Approx(0.403));
  CHECK(estimated_pressure_ratio(0.9) == Approx(0.206));
  CHECK(estimated_pressure_ratio(0.0) == Approx(0.523));
  CHECK(estimated_pressure_ratio(0.999) == Approx(0.126));
}

TEST_CASE("TheSmallestFilmOfAGivenPlaceIsThatOfItsTiltedGap") {
  bearing::Case c = read_case_text(kSampleCase, "case.toml");
  const double clearance = c.bearing.radial_clearance, B = c.bearing.width;
  c.operation.position = bearing::EccentricityGiven{0.5, 0.7, 4.0};
  c.operation.alignment = bearing::TiltGiven{0.4 * clearance / B, -0.3 * clearance / B};
  const fluid::JournalPosition at{{0.5 * clearance * std::cos(4.7), 0.5 * clearance * std::sin(4.7),
                                   0.4 * clearance / B, -0.3 * clearance / B}};
  double least = clearance;
  for (int i = 0; i < 3600; ++i) {
    const double phi = 2.0 * kPi * i / 3600.0;
    for (const double z : {-0.5 * B, 0.0, 0.5 * B}) {
      double h = clearance;
      for (int k = 0; k < 4; ++k) {
        h += at.q[k] * fluid::gap_slope(k, std::cos(phi), std::sin(phi), z);
      }
      least = std::min(least, h);
    }
  }
  CHECK(derive(c).h_min == Approx(least).epsilon(1e-5));
  CHECK(least < 0.45 * clearance);  // without tilt a half
}

TEST_CASE("IndicatorsNameTheEffectsThatMatter") {
  const auto list = [](const char* name) {
    const auto c = read_case(case_path(name).string());
    return indicators(c, derive(c));
  };
  const auto ks = list("ks-rig-test-bearing");
  CHECK(find(ks, "elastic deformation").weight == Weight::important);
  CHECK(find(ks, "heating of the film").weight == Weight::important);
  CHECK(find(ks, "turbulence").weight == Weight::negligible);
  const auto rb = list("raimondi-boyd");
  CHECK(find(rb, "heating of the film").weight == Weight::negligible);
  CHECK(find(rb, "heating of the film").value == 0.0);  // constant viscosity
}

TEST_CASE("OilFedByAHoleIsAsFastAsFromACircleIntoAPlane") {
  const auto c = read_case(case_path("ks-rig-test-bearing").string());
  const Derived d = derive(c);
  const bearing::Supply& hole = c.supplies.front();
  REQUIRE(hole.kind == bearing::SupplyKind::hole);
  const double rim = 0.5 * hole.diameter;
  const double edge = 0.5 * c.bearing.width;
  const double h = c.bearing.radial_clearance;
  // Q = pi h^3 p/(6 eta ln(r2/r1)) through the circle of the rim; the head over the pressure.
  const double Q = kPi * h * h * h * hole.pressure / (6.0 * d.eta * std::log(edge / rim));
  const double u = Q / (2.0 * kPi * rim * h);
  CHECK(find(indicators(c, d), "inertia of the fed oil").value ==
        Approx(0.5 * d.rho * u * u / hole.pressure).epsilon(1e-9));
}

TEST_CASE("TheEquivalentTemperatureFollowsItsFormula") {
  const auto c = read_case_text(sample_with("temperature = \"90 degC\"\n", ""), "case.toml",
                                {parse_override("measured.shell_back_temperature=88 degC"),
                                 parse_override("model.equivalent_temperature.kappa=0.5")});
  // T_supply = 80 degC, halfway to 88 degC.
  CHECK(derive(c).T - kZeroCelsius == Approx(84.0).epsilon(1e-12));
}

TEST_CASE("TheCheckTellsTheWarningsOfARunThatFollowFromTheCaseAlone") {
  const auto checked = [](const char* name, const std::vector<Override>& set) {
    std::ostringstream out;
    print_check(out, read_case(case_path(name).string(), set));
    return out.str();
  };
  const auto flat = parse_override("surfaces.shell.orientation=9");
  const auto round = parse_override("surfaces.shaft.orientation=1");
  const std::string beyond = "orientation lies outside the range";
  check_parts(checked("ks-rig-test-bearing", {}), {"Warnings\n", beyond});
  check_parts(checked("ks-rig-test-bearing", {parse_override("model.tier=auto")}), {beyond});
  CHECK(checked("ks-rig-test-bearing", {flat, round}).find(beyond) == std::string::npos);
  CHECK(checked("ks-rig-test-bearing", {parse_override("model.flow_factors=false")}).find(beyond) ==
        std::string::npos);
  check_parts(checked("shell-polymer", {parse_override("shell.layers.0.elasto_plastic=true"),
                                        parse_override("model.elastic_deformation=false")}),
              {"elasto-plastic layer does not yield"});
}

TEST_CASE("TheCheckNamesNumbersWarningsAndAssumptions") {
  std::ostringstream out;
  print_check(out, read_sample("temperature = \"90 degC\"", "temperature = \"160 degC\""));
  check_parts(out.str(), {"surface speed", "Sommerfeld", "Petroff", "Reynolds", "Effects",
                          "Warnings\n  - case.toml:26:15", "Assumptions\n  - "});
}
