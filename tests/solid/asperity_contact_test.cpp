#include "solid/asperity_contact.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "core/contract.hpp"

using namespace shellback;
using namespace shellback::solid;

namespace {

// New shell and shaft of the KS rig, validation/data and seed 000 Table 3.
const RoughSurface kShell{0.34e-6, 12.0, 0.28e-6, 0.39e-6};
const RoughSurface kShaft{0.20e-6, 4.0, 0.13e-6, 0.21e-6};
const ContactParameters kExact{0.001, 53.3e9, 0.02, ContactIntegral::exact};
const ContactParameters kPowerLaw{0.001, 53.3e9, 0.02, ContactIntegral::power_law};

/// K E*: the pressure per unit of F.
constexpr double kScale = 0.001 * 53.3e9;

double gap(const AsperityContact& contact, double H) {
  return contact.delta() + H * contact.sigma();
}

/// Rows of the table of integrals: H, F52, F52 power law, F52 quintic, F2, F2 quintic.
std::vector<std::vector<double>> printed_integrals() {
  std::ifstream file(SHELLBACK_SOURCE_DIR "/validation/data/greenwood_tripp_integrals.csv");
  REQUIRE(file.good());
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'H') continue;
    std::vector<double> row;
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    rows.push_back(row);
  }
  return rows;
}

/// Gaps from deep contact to none, in and across the polynomial intervals.
std::vector<double> many_H() {
  std::vector<double> H;
  for (double x = -29.987; x < 10.0; x += 0.0931) H.push_back(x);
  return H;
}

}  // namespace

TEST_CASE("TheIntegralsMeetTheTable") {
  const AsperityContact contact(kShell, kShaft, kExact);
  const auto rows = printed_integrals();
  REQUIRE(rows.size() == 9);
  for (const auto& row : rows) {
    // The table prints six digits: half a unit of the last is up to 5e-6/1.06 relative.
    CHECK(gt_integral(2.5, row[0]) == Approx(row[1]).epsilon(5e-6));
    CHECK(gt_integral(2.0, row[0]) == Approx(row[4]).epsilon(5e-6));
    CHECK(contact.at(gap(contact, row[0])).p / kScale == Approx(row[1]).epsilon(5e-6));
  }
}

TEST_CASE("TheSecondIntegralIsTheClosedForm") {
  // F_2(H) = (1 + H^2) Q(H) - H phi(H), Q the normal tail, phi its density. The two terms cancel
  // by a factor H^4 for H > 0: round-off below 1e-12 up to H = 4.
  for (double H = -20.0; H <= 4.0; H += 0.37) {
    const double Q = 0.5 * std::erfc(H / std::sqrt(2.0));
    const double phi = std::exp(-0.5 * H * H) / std::sqrt(2.0 * kPi);
    CHECK(gt_integral(2.0, H) == Approx((1.0 + H * H) * Q - H * phi).epsilon(1e-12));
  }
}

TEST_CASE("TheIntegralsAtZeroAreGammaFunctions") {
  for (const double n : {0.5, 1.5, 2.0, 2.5}) {
    const double exact =
        std::pow(2.0, 0.5 * n - 1.0) * std::tgamma(0.5 * (n + 1.0)) / std::sqrt(kPi);
    CHECK(gt_integral(n, 0.0) == Approx(exact).epsilon(1e-12));
  }
}

TEST_CASE("TheIntegralsObeyTheirRecurrence") {
  // By parts: F_{n+1} + H F_n = n F_{n-1}. The left side cancels for H < 0 by about H^2.
  for (double H = -8.0; H <= 10.0; H += 0.41) {
    const double left = gt_integral(2.5, H) + H * gt_integral(1.5, H);
    CHECK(left == Approx(1.5 * gt_integral(0.5, H)).epsilon(1e-10));
  }
}

TEST_CASE("ContactPressureIsThatOfTheIntegralEverywhere") {
  const AsperityContact contact(kShell, kShaft, kExact);
  double worst = 0.0, worst_slope = 0.0;
  for (const double H : many_H()) {
    const ContactPressure c = contact.at(gap(contact, H));
    // H itself comes back from the gap with an error of 1e-16 delta/sigma (2) plus 1e-16 H, and
    // d ln F/dH is up to 10: 1e-14, far below the 1e-10 promised.
    const double p = kScale * gt_integral(2.5, H);
    const double slope = -2.5 * kScale / contact.sigma() * gt_integral(1.5, H);
    worst = std::max(worst, std::abs(c.p / p - 1.0));
    worst_slope = std::max(worst_slope, std::abs(c.dp_dh / slope - 1.0));
  }
  CHECK(worst < 1e-10);
  CHECK(worst_slope < 1e-10);
}

TEST_CASE("DeepContactJoinsTheIntegral") {
  const AsperityContact contact(kShell, kShaft, kExact);
  for (const double H : {-30.0, -30.001, -45.0, -90.0}) {
    const ContactPressure c = contact.at(gap(contact, H));
    CHECK(c.p == Approx(kScale * gt_integral(2.5, H)).epsilon(1e-10));
    CHECK(c.dp_dh == Approx(-2.5 * kScale / contact.sigma() * gt_integral(1.5, H)).epsilon(1e-10));
  }
  // Far below, every summit touches: F_{5/2} -> |H|^{5/2} (1 + 15/8 H^-2).
  const double p = contact.at(gap(contact, -1000.0)).p;
  CHECK(p / kScale == Approx(std::pow(1000.0, 2.5)).epsilon(2e-6));
}

TEST_CASE("ContactPressureFallsWithTheGapToNothing") {
  const AsperityContact contact(kShell, kShaft, kExact);
  double last = 1e30;
  for (double H = -40.0; H <= 10.0; H += 0.05) {
    const ContactPressure c = contact.at(gap(contact, H));
    CHECK(c.p > 0.0);
    CHECK(c.p < last);
    CHECK(c.dp_dh < 0.0);
    last = c.p;
  }
  CHECK(gt_integral(2.5, 10.0) < 1e-24);
  CHECK(contact.at(gap(contact, 10.01)).p == 0.0);
  CHECK(contact.at(gap(contact, 10.01)).dp_dh == 0.0);
}

TEST_CASE("ContactStiffnessIsTheDerivative") {
  for (const ContactParameters& law : {kExact, kPowerLaw}) {
    const AsperityContact contact(kShell, kShaft, law);
    for (const double H : {-35.0, -12.3, -1.5, 0.2, 1.7, 3.1}) {
      const double h = gap(contact, H), step = 1e-4 * contact.sigma();
      const double difference = (contact.at(h + step).p - contact.at(h - step).p) / (2.0 * step);
      // Truncation step^2 p'''/(6 p') is at most 1e-8 (8)/6 near the end of the power law.
      CHECK(contact.at(h).dp_dh == Approx(difference).epsilon(1e-7));
    }
  }
}

TEST_CASE("ThePowerLawIsThePrintedFit") {
  const AsperityContact contact(kShell, kShaft, kPowerLaw);
  for (const auto& row : printed_integrals()) {
    const double F = contact.at(gap(contact, row[0])).p / kScale;
    CHECK(F == Approx(row[2]).epsilon(5e-6).margin(1e-12));  // six digits printed
  }
  CHECK(contact.at(gap(contact, 4.0 + 1e-9)).p == 0.0);
  CHECK(contact.at(gap(contact, 4.0 + 1e-9)).dp_dh == 0.0);
}

TEST_CASE("SummitsStandAboveTheMeanPlanes") {
  // KS rig, new: sigma 0.3087 um, delta 0.60 um. Raising the summits by 0.1 um has the effect of
  // closing the gap by 0.1 um.
  const AsperityContact contact(kShell, kShaft, kExact);
  CHECK(contact.sigma() == Approx(0.3087e-6).epsilon(2e-4));  // four digits
  CHECK(contact.delta() == Approx(0.60e-6).epsilon(1e-12));
  RoughSurface taller = kShell;
  taller.summit_height += 0.1e-6;
  const AsperityContact higher(taller, kShaft, kExact);
  CHECK(higher.at(1.1e-6).p == Approx(contact.at(1.0e-6).p).epsilon(1e-12));
  CHECK(higher.at(1.0e-6).p > contact.at(1.0e-6).p);
}

TEST_CASE("WhichSurfaceIsWhichDoesNotMatterToContact") {
  const AsperityContact a(kShell, kShaft, kExact), b(kShaft, kShell, kExact);
  CHECK(a.at(1e-6).p == Approx(b.at(1e-6).p).epsilon(1e-14));
}

TEST_CASE("ManyGapsAtOnceAreTheSameLaw") {
  for (const ContactParameters& law : {kExact, kPowerLaw}) {
    const AsperityContact contact(kShell, kShaft, law);
    std::vector<double> h, p, slope;
    for (const double H : {-50.0, -29.0, -0.3, 0.0, 2.2, 3.99, 4.01, 9.9, 11.0}) {
      h.push_back(gap(contact, H));
    }
    p.resize(h.size());
    slope.resize(h.size());
    contact.evaluate(h, p, slope);
    for (std::size_t i = 0; i < h.size(); ++i) {
      // H by division or by multiplication with 1/sigma: some 1e-16 H, times d ln F/dH < 10.
      CHECK(p[i] == Approx(contact.at(h[i]).p).epsilon(1e-12));
      CHECK(slope[i] == Approx(contact.at(h[i]).dp_dh).epsilon(1e-12));
    }
  }
}

TEST_CASE("AContactWithoutSummitsIsRefused") {
  CHECK_THROWS_AS(AsperityContact(RoughSurface{}, RoughSurface{}, kExact), InputError);
  CHECK_THROWS_AS(AsperityContact(kShell, kShaft, ContactParameters{0.0, 53.3e9, 0.02}),
                  InputError);
  CHECK_THROWS_AS(AsperityContact(kShell, kShaft, ContactParameters{0.001, 0.0, 0.02}), InputError);
}

TEST_CASE("SummitsFlowAtTheHardnessAndNotBefore") {
  ContactParameters hard = kExact;
  hard.hardness = 30e6;
  const AsperityContact elastic(kShell, kShaft, kExact), flowing(kShell, kShaft, hard);
  const double h_f = flowing.flow_gap();
  CHECK(elastic.at(h_f).p == Approx(30e6).epsilon(1e-9));  // bisected to round-off
  std::vector<double> h{h_f - 1e-6, h_f - 1e-9, h_f + 1e-9, h_f + 1e-6};
  std::vector<double> p(4), slope(4);
  flowing.evaluate(h, p, slope);
  for (int k = 0; k < 4; ++k) {
    CHECK(p[k] == Approx(flowing.at(h[k]).p).epsilon(1e-12));
    CHECK(p[k] == Approx(std::min(30e6, elastic.at(h[k]).p)).epsilon(1e-12));
    CHECK(slope[k] == Approx(k < 2 ? 0.0 : elastic.at(h[k]).dp_dh).epsilon(1e-12));
  }
  CHECK(elastic.flow_gap() == -INFINITY);
  hard.hardness = -1.0;
  CHECK_THROWS_AS(AsperityContact(kShell, kShaft, hard), InputError);
}
