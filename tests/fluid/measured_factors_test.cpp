#include "fluid/measured_factors.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/constants.hpp"
#include "fluid/flow_factors.hpp"

using namespace shellback;
using namespace shellback::fluid;

namespace {

constexpr double kTableSigma = 0.4e-6;

/// The laws of Patir and Cheng as a table, so that there is a truth between the rows.
FactorTable tabulated(double gamma, int rows) {
  const RoughPair law = rough_pair({0.0, 1.0}, {1.0, gamma});
  FactorTable t;
  t.sigma = kTableSigma;
  for (int k = 0; k < rows; ++k) {
    const double H = std::pow(10.0, k / (rows - 1.0));  // 1 to 10
    const FlowFactors f = flow_factors(law, H);
    t.H.push_back(H);
    t.average_gap.push_back(gap_flow(law, H).average_gap);
    t.phi_x.push_back(f.phi_x);
    t.phi_z.push_back(f.phi_z);
    t.phi_s.push_back(f.sigma_phi_s);
    t.phi_f.push_back(f.phi_f);
    t.phi_fs.push_back(f.phi_fs);
    t.phi_fp.push_back(f.phi_fp);
  }
  return t;
}

RoughPair pair_of(const FactorTable& table, double shell, double journal) {
  return rough_pair({shell, 1.0}, {journal, 1.0}, &table);
}

}  // namespace

TEST_CASE("ATableOfALawGivesTheLaw") {
  // 41 rows over a decade: monotone cubics of second order at worst (slopes are harmonic means),
  // 0.5 % of the factors between the rows.
  for (const double gamma : {1.0 / 3.0, 1.0, 3.0}) {
    const RoughPair law = rough_pair({0.0, 1.0}, {kTableSigma, gamma});
    const FactorTable table = tabulated(gamma, 41);
    const RoughPair measured = pair_of(table, 0.0, kTableSigma);
    for (double H = 1.02; H < 10.0; H *= 1.07) {
      const FlowFactors a = flow_factors(law, H * kTableSigma), b = flow_factors(measured, H * kTableSigma);
      CHECK(b.phi_x == Approx(a.phi_x).epsilon(5e-3));
      CHECK(b.phi_z == Approx(a.phi_z).epsilon(5e-3));
      CHECK(b.sigma_phi_s == Approx(a.sigma_phi_s).epsilon(5e-3));
      CHECK(b.phi_f == Approx(a.phi_f).epsilon(5e-3));
      CHECK(b.phi_fp == Approx(a.phi_fp).margin(0.03));  // by reciprocity, as the printed laws
      CHECK(b.phi_fs == Approx(a.phi_fs).margin(5e-3));
    }
    for (std::size_t k = 0; k < table.H.size(); ++k) {  // exact at the rows
      const FlowFactors f = flow_factors(measured, table.H[k] * kTableSigma);
      CHECK(f.phi_x == Approx(table.phi_x[k]).epsilon(1e-12));
      CHECK(f.phi_f == Approx(table.phi_f[k]).epsilon(1e-12));
    }
  }
}

TEST_CASE("SlopesOfMeasuredFactorsAreTheDerivatives") {
  // Central differences with 1e-4 sigma: truncation below 1e-6 of slopes, round-off below 1e-9.
  // Below the table, in it, and above it; rows themselves are left out, where the second derivative
  // jumps.
  for (const double gamma : {1.0 / 3.0, 3.0}) {
    const FactorTable table = tabulated(gamma, 12);
    for (const RoughPair& pair : {pair_of(table, 0.0, kTableSigma), pair_of(table, 0.3e-6, 0.1e-6)}) {
      const double s = pair.sigma, step = 1e-4 * s, per = 0.5 / step;
      for (const double H : {-6.0, -1.0, 0.3, 0.97, 1.1, 1.7, 3.1, 7.3, 9.9, 10.3, 25.0, 300.0}) {
        const double h = H * s;
        const GapFlow a = gap_flow(pair, h - step), b = gap_flow(pair, h + step);
        const GapFlow f = gap_flow(pair, h);
        INFO("gamma " << gamma << ", H " << H);
        CHECK(f.daverage_gap == Approx((b.average_gap - a.average_gap) * per).epsilon(1e-5));
        CHECK(f.dh3_x == Approx((b.h3_x - a.h3_x) * per).epsilon(1e-5));
        CHECK(f.dh3_z == Approx((b.h3_z - a.h3_z) * per).epsilon(1e-5));
        CHECK(f.dsigma_phi_s ==
              Approx((b.sigma_phi_s - a.sigma_phi_s) * per).epsilon(1e-5).margin(1e-9));
      }
    }
  }
}

TEST_CASE("MeasuredFactorsAreContinuousAtTheEndsOfTheTable") {
  // Both ways of writing the same value: 1e-9 sigma apart they differ by the slope times that.
  const FactorTable table = tabulated(1.0, 15);
  const RoughPair pair = pair_of(table, 0.0, kTableSigma);
  for (const double H : {table.H.front(), table.H.back()}) {
    const double h = H * kTableSigma, d = 1e-9 * kTableSigma;
    const GapFlow a = gap_flow(pair, h - d), b = gap_flow(pair, h + d);
    CHECK(a.h3_x == Approx(b.h3_x).epsilon(1e-7));
    CHECK(a.dh3_x == Approx(b.dh3_x).epsilon(1e-6));
    CHECK(a.average_gap == Approx(b.average_gap).epsilon(1e-7));
    CHECK(a.daverage_gap == Approx(b.daverage_gap).epsilon(1e-6));
    CHECK(a.sigma_phi_s == Approx(b.sigma_phi_s).epsilon(1e-7));
    const GapShear x = gap_shear(pair, h - d), y = gap_shear(pair, h + d);
    CHECK(x.phi_f_over_h == Approx(y.phi_f_over_h).epsilon(1e-7));
    CHECK(x.phi_fs_over_h == Approx(y.phi_fs_over_h).epsilon(1e-7));
    CHECK(x.h_phi_fp == Approx(y.h_phi_fp).epsilon(1e-7));
  }
}

TEST_CASE("PressureShearsAsSlidingCarries") {
  // Reciprocity, exact at every gap: h phi_fp = hT - sigma |Phi_s| of one rough surface; the column
  // of the table does not act.
  FactorTable table = tabulated(1.0, 12);
  const RoughPair given = pair_of(table, 0.0, kTableSigma);
  table.phi_fp.clear();
  const RoughPair left_out = pair_of(table, 0.0, kTableSigma);
  for (const double H : {-3.0, 0.2, 0.99, 1.3, 4.0, 9.9, 12.0, 80.0}) {
    const double h = H * kTableSigma;
    const GapFlow f = gap_flow(given, h);
    CHECK(gap_shear(given, h).h_phi_fp == Approx(f.average_gap - f.sigma_phi_s).epsilon(1e-12));
    CHECK(gap_shear(left_out, h).h_phi_fp == gap_shear(given, h).h_phi_fp);
  }
}

TEST_CASE("AboveTheTableTheFactorsTendToTheSmoothFilmAsPerturbationTheorySays") {
  const FactorTable table = tabulated(3.0, 15);
  const RoughPair pair = pair_of(table, 0.0, kTableSigma);
  const FlowFactors a = flow_factors(pair, 20.0 * kTableSigma), b = flow_factors(pair, 40.0 * kTableSigma);
  CHECK((a.phi_x - 1.0) / (b.phi_x - 1.0) == Approx(4.0).epsilon(1e-9));
  CHECK((a.phi_f - 1.0) / (b.phi_f - 1.0) == Approx(4.0).epsilon(1e-9));
  CHECK(a.sigma_phi_s / b.sigma_phi_s == Approx(2.0).epsilon(1e-9));
  const FlowFactors far = flow_factors(pair, 1e5 * kTableSigma);
  CHECK(far.phi_x == Approx(1.0).epsilon(1e-8));
  CHECK(far.phi_fp == Approx(1.0).epsilon(1e-8));
}

TEST_CASE("MeasuredConductanceStaysPositiveAndTransportNeverTurnsRound") {
  const FactorTable table = tabulated(1.0 / 3.0, 10);
  const RoughPair pair = pair_of(table, 0.0, kTableSigma);
  for (double H = -40.0; H < 30.0; H += 0.1) {
    const GapFlow f = gap_flow(pair, H * kTableSigma);
    CHECK(f.h3_x > 0.0);
    CHECK(f.dh3_x > 0.0);
    CHECK(f.dh3_z > 0.0);
    CHECK(f.daverage_gap > 0.0);
    CHECK(std::abs(f.sigma_phi_s) < f.average_gap);
    const GapShear s = gap_shear(pair, H * kTableSigma);
    CHECK(s.phi_f_over_h > 0.0);
    CHECK(s.h_phi_fp >= 0.0);
    CHECK(std::isfinite(s.phi_total_over_h));
  }
}

TEST_CASE("TheSignOfMeasuredTransportIsThatOfTheRougherSurface") {
  const FactorTable table = tabulated(1.0, 15);
  const double h = 2.0 * kTableSigma;
  const double moving = gap_flow(pair_of(table, 0.0, kTableSigma), h).sigma_phi_s;
  CHECK(moving > 0.0);
  CHECK(gap_flow(pair_of(table, kTableSigma, 0.0), h).sigma_phi_s == Approx(-moving).epsilon(1e-14));
  const double both = kTableSigma / std::sqrt(2.0);
  CHECK(std::abs(gap_flow(pair_of(table, both, both), h).sigma_phi_s) < 1e-14 * h);
}

TEST_CASE("ManyGapsAtOnceAreTheSameMeasuredFactors") {
  const RoughPair pair = pair_of(tabulated(1.0, 9), 0.0, kTableSigma);
  const std::vector<double> h{-1e-6, 0.1e-6, 1e-6, 5e-6, 1e-3};
  std::vector<double> v[8];
  for (auto& column : v) column.resize(h.size());
  gap_flow(pair, h, {v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]});
  for (std::size_t i = 0; i < h.size(); ++i) {
    const GapFlow f = gap_flow(pair, h[i]);
    CHECK((v[0][i] == f.average_gap && v[1][i] == f.h3_x && v[7][i] == f.dsigma_phi_s));
  }
}

TEST_CASE("FactorsThatNoSurfaceHasAreNamedWithTheirRow") {
  const auto fault = [](auto change) {
    FactorTable t = tabulated(1.0, 5);
    change(t);
    return fault_of(t);
  };
  CHECK(fault([](FactorTable&) {}).problem.empty());
  const FactorFault f = fault([](FactorTable& t) { t.phi_x[2] = -0.1; });
  CHECK(f.row == 2);
  CHECK(f.column == "phi_x");
  CHECK(fault([](FactorTable& t) { t.H[1] = t.H[0]; }).column == "h_over_sigma");
  CHECK(fault([](FactorTable& t) { t.phi_s[3] = 9.0; }).row == 3);
  CHECK(fault([](FactorTable& t) { t.average_gap[4] = 5.0; }).column == "average_gap");
  CHECK_FALSE(fault([](FactorTable& t) { t = FactorTable{}; }).problem.empty());
  CHECK(fault([](FactorTable& t) { t.phi_fp.clear(); }).problem.empty());
  const FactorFault shear = fault([](FactorTable& t) { t.phi_fp[1] += 0.1; });
  CHECK(shear.row == 1);
  CHECK(shear.column == "phi_fp");
  CHECK(fault([](FactorTable& t) { t.phi_fp.assign(5, 1.0); }).column == "phi_fp");
}
