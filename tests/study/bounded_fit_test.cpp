// Bounded least squares on formulas: known minima, deviations, bounds, and what data cannot tell.
#include "app/study/bounded_fit.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace shellback::study;

namespace {

using Values = std::vector<double>;

/// y = x0 exp(-x1 t) at 20 times, with normal noise of deviation `sd`.
FitProblem decay(double sd, unsigned seed, double x0 = 2.0, double x1 = 30.0) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, sd);
  Values t, y;
  for (int k = 0; k < 20; ++k) {
    t.push_back(0.005 * k);
    y.push_back(x0 * std::exp(-x1 * t.back()) + noise(random));
  }
  FitProblem p;
  p.parameters = {{1.0, 0.1, 10.0}, {100.0, 1.0, 1000.0}};
  p.residuals = [t, y, sd](const Values& x, Purpose) -> std::optional<Values> {
    Values r;
    for (std::size_t k = 0; k < t.size(); ++k) {
      r.push_back((x[0] * std::exp(-x[1] * t[k]) - y[k]) / sd);
    }
    return r;
  };
  p.accuracy = 1e-12;
  return p;
}

}  // namespace

TEST_CASE("AFitFindsKnownParametersWithinTheirDeviations", "[bounded_fit]") {
  double chi2 = 0.0;
  double squares = 0.0;  // of (found - true)/deviation
  constexpr int kTrials = 40;
  for (unsigned seed = 1; seed <= kTrials; ++seed) {
    const Fit fit = fit_bounded(decay(0.02, seed));
    REQUIRE(fit.status == FitStatus::settled);
    REQUIRE(fit.determined());
    chi2 += fit.chi2;
    squares += std::pow((fit.x[0] - 2.0) / fit.deviation[0], 2);
    squares += std::pow((fit.x[1] - 30.0) / fit.deviation[1], 2);
  }
  // 40 trials of 18 degrees of freedom: the mean's deviation is sqrt(2/720) = 5 %
  CHECK(chi2 / (18.0 * kTrials) == Approx(1.0).margin(0.2));
  // 80 values, correlated by pairs: sqrt(2/40) = 22 %
  CHECK(squares / (2.0 * kTrials) == Approx(1.0).margin(0.7));
}

TEST_CASE("UnknownDeviationsAreThoseOfTheScatter", "[bounded_fit]") {
  FitProblem known = decay(0.02, 3);
  FitProblem unknown = known;
  unknown.deviations_known = false;
  unknown.residuals = [r = known.residuals](const Values& x, Purpose p) {
    auto all = r(x, p);
    for (double& v : *all) v *= 1e-3;  // another unit: the deviations do not know it
    return all;
  };
  const Fit a = fit_bounded(known), b = fit_bounded(unknown);
  REQUIRE(b.status == FitStatus::settled);
  const double scale = std::sqrt(a.chi2 / a.freedom);
  for (int k : {0, 1}) {
    CHECK(b.x[k] == Approx(a.x[k]).epsilon(1e-5));
    CHECK(b.deviation[k] == Approx(scale * a.deviation[k]).epsilon(1e-3));  // of differences
  }
}

TEST_CASE("AnExactFitIsFoundExactly", "[bounded_fit]") {
  FitProblem p = decay(1e-9, 1);
  const Fit fit = fit_bounded(p);
  REQUIRE(fit.status == FitStatus::settled);
  CHECK(fit.x[0] == Approx(2.0).epsilon(1e-7));
  CHECK(fit.x[1] == Approx(30.0).epsilon(1e-7));
}

TEST_CASE("AMinimumBeyondABoundEndsAtTheBound", "[bounded_fit]") {
  FitProblem p = decay(0.02, 5);
  p.parameters[1] = {20.0, 5.0, 25.0};  // 30 is the truth
  const Fit fit = fit_bounded(p);
  CHECK(fit.at_bound[1] == 1);
  CHECK(fit.x[1] == Approx(25.0).epsilon(2e-3));
  CHECK(std::isnan(fit.deviation[1]));
  CHECK(std::isfinite(fit.deviation[0]));
  CHECK(fit.status == FitStatus::settled);
}

TEST_CASE("AProductOfTwoKeysIsNotTakenApart", "[bounded_fit]") {
  for (const double sd : {0.02, 1e-9}) {  // scatter or none: the reason differs, the verdict not
    FitProblem p = decay(sd, 7);
    p.parameters = {{1.0, 0.1, 10.0}, {10.0, 1.0, 100.0}, {10.0, 1.0, 100.0}};
    p.residuals = [r = decay(sd, 7).residuals](const Values& x, Purpose purpose) {
      return r({x[0], 0.1 * x[1] * x[2]}, purpose);
    };
    const Fit fit = fit_bounded(p);
    REQUIRE(fit.directions.size() == 3);
    CHECK_FALSE(fit.determined());
    const FitDirection& loose = fit.directions.back();
    CHECK_FALSE(loose.determined);
    CHECK(fit.directions[1].determined);
    // one up, the other down, the first not at all
    CHECK(std::abs(loose.part[0]) < 1e-3);
    CHECK(loose.part[1] == Approx(-loose.part[2]).epsilon(1e-3));
    CHECK(0.1 * fit.x[1] * fit.x[2] == Approx(30.0).epsilon(0.1));
  }
}

TEST_CASE("AKeyThatDoesNotActIsNotDetermined", "[bounded_fit]") {
  FitProblem p = decay(0.02, 9);
  p.parameters.push_back({0.5, 0.0, 1.0});
  p.residuals = [r = decay(0.02, 9).residuals](const Values& x, Purpose purpose) {
    return r({x[0], x[1]}, purpose);
  };
  const Fit fit = fit_bounded(p);
  CHECK_FALSE(fit.determined());
  CHECK(std::abs(fit.directions.back().part[2]) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("NoStepIsTakenToWhereNothingCanBeComputed", "[bounded_fit]") {
  FitProblem p = decay(0.02, 11);
  int asked = 0;
  p.residuals = [r = p.residuals, &asked](const Values& x, Purpose purpose) {
    if (x[1] < 28.0) {
      ++asked;
      return std::optional<Values>();
    }
    return r(x, purpose);
  };
  const Fit fit = fit_bounded(p);
  CHECK(fit.refused_steps <= asked);
  CHECK(fit.x[1] >= 28.0);
  CHECK(fit.status == FitStatus::settled);
  p.residuals = [](const Values&, Purpose) { return std::optional<Values>(); };
  CHECK(fit_bounded(p).status == FitStatus::not_computed);
}

TEST_CASE("FewerValuesThanKeysSettleNothing", "[bounded_fit]") {
  FitProblem p;
  p.parameters = {{0.5, 0.0, 1.0}, {0.5, 0.0, 1.0}};
  p.residuals = [](const Values& x, Purpose) { return std::optional(Values{x[0] - 0.3}); };
  const Fit fit = fit_bounded(p);
  CHECK(fit.status == FitStatus::unsettled);
  CHECK_FALSE(fit.determined());
}
