/// Roots of a heat balance: found by their signs, all of them, and none where there is no film.
#include "bearing/heat/heat_scan.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/bracketed_root.hpp"
#include "rheology/temperature.hpp"

using namespace shellback;
using namespace shellback::bearing;

namespace {

constexpr double kLow = 313.15;
constexpr double kHigh = 713.15;

rheology::Oil oil() {
  rheology::Oil o;
  o.temperature = rheology::Vogel{0.09521e-3, 896.4, 110.0};
  return o;
}

/// Residual with the given roots, positive below the first.
HeatResidual with_roots(std::vector<double> roots) {
  return [roots = std::move(roots)](double T) -> std::optional<double> {
    double r = 1.0;
    for (const double root : roots) r *= (root - T) / 10.0;
    return r;
  };
}

std::vector<double> found(const HeatResidual& r) {
  const auto samples = scan_heat_balance(r, scan_temperatures(oil(), kLow, kHigh));
  std::vector<double> roots;
  for (const std::size_t k : sign_changes(samples)) {
    const auto f = [&](double T) { return *r(T); };
    const BracketedRoot root =
        bracketed_root(f, {samples[k].T, *samples[k].residual},
                       {samples[k + 1].T, *samples[k + 1].residual}, {1e-9, 1e-9});
    REQUIRE(root.found);
    roots.push_back(root.at.x);
  }
  return roots;
}

}  // namespace

TEST_CASE("ThreeRootsOfAHeatBalanceAreAllFound", "[heat_scan]") {
  // Far apart; hot pair near together; cold pair near together, between two temperatures of the
  // scan.
  for (const std::vector<double>& roots :
       {std::vector{341.0, 402.0, 533.0}, {341.0, 520.0, 527.0}, {333.0, 335.5, 480.0}}) {
    const std::vector<double> are = found(with_roots(roots));
    REQUIRE(are.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) CHECK(are[k] == Approx(roots[k]).margin(1e-6));
  }
}

TEST_CASE("ABalanceThatOnlyComesNearHasNoRoots", "[heat_scan]") {
  const HeatResidual dip = [](double T) -> std::optional<double> {
    return 2.0 + 1e-3 * (T - 420.0) * (T - 420.0);
  };
  CHECK(found(dip).empty());
  CHECK(found(with_roots({341.0})).size() == 1);
}

TEST_CASE("AFilmThatFailsIsNoSign", "[heat_scan]") {
  // The sign differs on the two sides of temperatures at which there is no film.
  const HeatResidual broken = [](double T) -> std::optional<double> {
    if (T > 380.0 && T < 450.0) return std::nullopt;
    return T < 400.0 ? 5.0 : -5.0;
  };
  CHECK(found(broken).empty());
}

TEST_CASE("TheViscosityChangesLittleFromOneTemperatureOfTheScanToTheNext", "[heat_scan]") {
  const auto temperatures = scan_temperatures(oil(), kLow, kHigh);
  REQUIRE(temperatures.size() > 2);
  CHECK(temperatures.front() == kLow);
  CHECK(temperatures.back() == kHigh);
  for (std::size_t k = 1; k < temperatures.size(); ++k) {
    const double before = rheology::log_viscosity(oil().temperature, temperatures[k - 1]).value;
    const double here = rheology::log_viscosity(oil().temperature, temperatures[k]).value;
    CHECK(std::abs(here - before) <= 0.5 * std::log(2.0) + 1e-12);
    CHECK(temperatures[k] - temperatures[k - 1] <= 50.0 + 1e-9);
  }
}

TEST_CASE("TheScanEndsWhereALawOfTheOilEnds", "[heat_scan]") {
  rheology::Oil o = oil();
  o.density = rheology::DowsonHigginson{860.0, 313.15, 4e-3};  // no mass left at 563 K
  const auto temperatures = scan_temperatures(o, kLow, kHigh);
  REQUIRE_FALSE(temperatures.empty());
  CHECK(temperatures.back() < 313.15 + 1.0 / 4e-3);
}

TEST_CASE("ABracketedRootDoesNotLeaveItsBracket", "[heat_scan]") {
  double lowest = 1.0;
  double highest = 2.0;
  const auto steep = [&](double x) {
    lowest = std::min(lowest, x);
    highest = std::max(highest, x);
    return std::exp(20.0 * (1.9 - x)) - 1.0;
  };
  const BracketedRoot root =
      bracketed_root(steep, {1.0, std::exp(18.0) - 1.0}, {2.0, std::exp(-2.0) - 1.0}, {1e-12, 0.0});
  CHECK(root.found);
  CHECK(root.at.x == Approx(1.9).epsilon(1e-12));
  CHECK(lowest >= 1.0);
  CHECK(highest <= 2.0);
  const auto none = [](double) { return static_cast<double>(NAN); };
  CHECK_FALSE(bracketed_root(none, {0.0, 1.0}, {1.0, -1.0}, {1e-9, 1e-9}).found);
}
