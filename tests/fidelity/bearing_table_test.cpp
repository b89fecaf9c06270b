#include "fidelity/bearing_table.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/constants.hpp"
#include "fidelity/closed_forms.hpp"
#include "tests/read_csv.hpp"

namespace shellback::fidelity {
namespace {

using test::CsvRow;
using test::read_csv;

/// Tangent of the attitude angle of the infinitely narrow bearing (Ocvirk, textbook).
double ocvirk_attitude_tangent(double eps) {
  return kPi * std::sqrt(1.0 - eps * eps) / (4.0 * eps);
}

/// Torque on the journal with full shear over eta omega R^3 B/c.
double full_torque(double eps, const BearingNumbers& n) {
  return couette_torque(eps) + eps * n.so * std::sin(n.attitude);
}

}  // namespace

TEST_CASE("TableOfTheFiniteBearingIsThatOfRaimondiAndBoyd") {
  // Their chart numbers are read to three figures; at eps 0.97 the film is resolved coarsely.
  int rows = 0;
  for (const CsvRow& row : read_csv("validation/data/raimondi_boyd_1958.csv")) {
    const double eps = row.at("eps");
    const BearingNumbers n = BearingCurve(row.at("L_over_D")).at(eps);
    INFO("B/D " << row.at("L_over_D") << ", eps " << eps);
    const double tolerance = eps > 0.95 ? 0.04 : 0.025;
    CHECK(1.0 / (2.0 * kPi * n.so) == Approx(row.at("pub_S")).epsilon(tolerance));
    CHECK(n.attitude * 180.0 / kPi == Approx(row.at("pub_phi_deg")).epsilon(tolerance));
    // Their peak pressures at eps 0.97 lie 5 % off every fine solution.
    CHECK(1.0 / n.pressure == Approx(row.at("pub_PP"))
                                  .epsilon(eps > 0.95  ? 0.07
                                           : eps > 0.7 ? 0.04
                                                       : 0.025));
    CHECK(1.0 / n.pressure == Approx(row.at("own_PP")).epsilon(0.01));
    // f R/c = torque / (F c): full_torque / (2 So) in these units.
    CHECK(full_torque(eps, n) / (2.0 * n.so) == Approx(row.at("pub_f")).epsilon(tolerance));
    // An independent solution of the same equations, on its own grid.
    CHECK(1.0 / (2.0 * kPi * n.so) == Approx(row.at("own_S")).epsilon(0.01));
    CHECK(n.attitude * 180.0 / kPi == Approx(row.at("own_phi_deg")).epsilon(0.01));
    // Q = inflow/(R c N L); omega = 2 pi N.
    CHECK(2.0 * kPi * n.side == Approx(row.at("own_Q") * row.at("own_QsQ")).epsilon(0.01));
    ++rows;
  }
  CHECK(rows >= 20);
}

TEST_CASE("InterpolatedNumbersLieWithinTheStatedError") {
  // The solver itself, asked at the middle of every field of the table.
  int points = 0;
  int inside = 0;
  double worst = 0.0;
  for (const CsvRow& row : read_csv("validation/tables/plain_bearing_between.csv")) {
    const BearingNumbers n = BearingCurve(row.at("B_over_D")).at(row.at("eps"));
    const double off[] = {n.so / row.at("so") - 1.0,
                          n.attitude * 180.0 / kPi / row.at("attitude_deg") - 1.0,
                          n.couette / row.at("couette") - 1.0, n.side / row.at("side") - 1.0,
                          n.pressure / row.at("p_max") - 1.0};
    for (int k = 0; k < 5; ++k) {
      const double d = off[k];
      ++points;
      inside += std::abs(d) < kTableError;
      worst = std::max(worst, std::abs(d));
      if (std::abs(d) > kTableError) {
        UNSCOPED_INFO("B/D " << row.at("B_over_D") << " eps " << row.at("eps") << " " << k << ": "
                             << d);
      }
    }
  }
  INFO("worst " << worst << ", inside " << inside << " of " << points);
  CHECK(inside > 0.99 * points);
  CHECK(worst < 4.0 * kTableError);
}

TEST_CASE("TableTendsToSommerfeldAndOcvirk") {
  // eps -> 0 and b -> 0: Ocvirk's load and attitude; the error of the narrow-bearing theory is of
  // order b^2.
  const BearingNumbers narrow = BearingCurve(0.01).at(0.3);
  CHECK(narrow.so == Approx(ocvirk(0.3, 0.01)).epsilon(5e-3));
  CHECK(std::tan(narrow.attitude) == Approx(ocvirk_attitude_tangent(0.3)).epsilon(5e-3));
  CHECK(narrow.side == Approx(0.3).epsilon(2e-3));  // U c B eps leaves the narrow bearing
  // Half and full Sommerfeld film bracket nothing, but at b = 8 the load of a film with free
  // rupture exceeds the half film's by less than a sixth.
  for (const double eps : {0.2, 0.5, 0.8, 0.95}) {
    const double so = BearingCurve(8.0).at(eps).so;
    CHECK(so > 0.93 * sommerfeld_half(eps));
    CHECK(so < 1.25 * sommerfeld_half(eps));
  }
  // eps -> 1: So (1 - eps) is constant, as in the wide bearing.
  const BearingCurve half(0.5);
  CHECK(half.at(1.0 - 1e-7).so * 1e-7 == Approx(half.at(1.0 - 1e-6).so * 1e-6).epsilon(5e-3));
}

TEST_CASE("LoadRisesWithEccentricityAndIsFoundBack") {
  for (const double b : {0.03, 0.12, 0.33, 0.5, 0.83, 1.0, 2.6, 9.0}) {
    const BearingCurve curve(b);
    double before = 0.0;
    for (double u = 0.002; u < 12.0; u += 0.01) {
      const double eps = -std::expm1(-u);
      const BearingNumbers n = curve.at(eps);
      REQUIRE(n.so > before);
      REQUIRE(n.attitude > 0.0);
      REQUIRE(n.attitude < 0.5 * kPi);
      REQUIRE(n.couette > 0.0);
      REQUIRE(n.couette < 1.0);
      before = n.so;
    }
    for (const double eps : {1e-4, 0.02, 0.3, 0.77, 0.95, 0.999, 0.99999}) {
      const double wanted = curve.at(eps).so;
      const auto beyond = [&](double e) { return std::log(curve.at(e).so / wanted); };
      CHECK(eccentricity_where(beyond) == Approx(eps).epsilon(1e-9));
    }
  }
}

}  // namespace shellback::fidelity
