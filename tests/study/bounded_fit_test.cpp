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

TEST_CASE("WideBoundsHoldNoKeyThatTheDataDetermine", "[bounded_fit]") {
  // 0.02 of 20 and 2e4: the second range makes a thousandth of itself of what is found.
  const auto found = [](double high) {
    FitProblem p = decay(0.02, 5);
    p.parameters[0] = {1.0, 0.0, high};
    return fit_bounded(p);
  };
  const Fit narrow = found(20.0), wide = found(2e4);
  REQUIRE(narrow.status == FitStatus::settled);
  REQUIRE(wide.status == FitStatus::settled);
  CHECK(wide.at_bound[0] == 0);
  for (const int k : {0, 1}) {
    // a tenth of a deviation is where the search may end
    CHECK(std::abs(wide.x[k] - narrow.x[k]) <= 0.2 * narrow.deviation[k]);
    CHECK(wide.deviation[k] == Approx(narrow.deviation[k]).epsilon(0.02));
  }
}

TEST_CASE("AsManyValuesAsKeysTellNoDeviations", "[bounded_fit]") {
  FitProblem p;
  p.parameters = {{0.5, 0.0, 1.0}};
  p.deviations_known = false;
  p.residuals = [](const Values& x, Purpose) { return std::optional(Values{x[0] - 0.3}); };
  const Fit fit = fit_bounded(p);
  CHECK(fit.x[0] == Approx(0.3).epsilon(1e-6));
  CHECK(std::isnan(fit.deviation[0]));
  CHECK(std::isnan(fit.directions[0].deviation));
  CHECK(fit.determined());  // it acts; how well it is known is another matter
  p.deviations_known = true;
  CHECK(fit_bounded(p).deviation[0] == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("WhatHasNoZeroThatMeansAnythingIsNotFittedByItsLogarithm", "[bounded_fit]") {
  CHECK(in_logarithms({10.0, 5.0, 60.0}));
  CHECK_FALSE(in_logarithms({10.0, 5.0, 60.0, false}));
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

TEST_CASE("TheDeviationsOfAStraightLineAreTheClosedForm", "[bounded_fit]") {
  // y = a + b t with known deviation sd: var(b) = sd^2/Stt, var(a) = sd^2 (1/n + m^2/Stt), cov =
  // -m sd^2/Stt; m mean of t, Stt = sum (t - m)^2. Linear: differences are exact to round-off,
  // 1e-6.
  const Values t{0.0, 0.1, 0.3, 0.4, 0.8, 0.9, 1.0};
  const double sd = 0.05, n = 7.0, m = 0.5;
  double Stt = 0.0;
  for (const double v : t) Stt += (v - m) * (v - m);
  for (const bool known : {true, false}) {
    FitProblem p;
    p.parameters = {{1.0, -5.0, 5.0}, {1.0, -20.0, 20.0}};
    p.deviations_known = known;
    p.residuals = [t, sd](const Values& x, Purpose) {
      Values r;
      for (std::size_t k = 0; k < t.size(); ++k) {
        const double y = 2.0 - 3.0 * t[k] + (k % 2 == 0 ? 0.06 : -0.07);
        r.push_back((x[0] + x[1] * t[k] - y) / sd);
      }
      return std::optional(r);
    };
    const Fit fit = fit_bounded(p);
    REQUIRE(fit.status == FitStatus::settled);
    CHECK(fit.freedom == 5);
    const double s = sd * (known ? 1.0 : std::sqrt(fit.chi2 / 5.0));
    CHECK(fit.deviation[1] == Approx(s / std::sqrt(Stt)).epsilon(1e-6));
    CHECK(fit.deviation[0] == Approx(s * std::sqrt(1.0 / n + m * m / Stt)).epsilon(1e-6));
    CHECK(fit.correlation[0][1] == Approx(-m / std::sqrt(Stt / n + m * m)).epsilon(1e-6));
  }
}

TEST_CASE("WhatComputingAddsIsInTheDeviations", "[bounded_fit]") {
  // (4) with s^2 = 1 + noise^2
  FitProblem p = decay(0.02, 13);
  const Fit exact = fit_bounded(p);
  p.noise = 3.0;
  const Fit noisy = fit_bounded(p);
  for (int k : {0, 1}) {
    CHECK(noisy.deviation[k] == Approx(std::sqrt(10.0) * exact.deviation[k]).epsilon(1e-2));
  }
}

TEST_CASE("ACoarseModelIsFittedToATenthOfTheDeviations", "[bounded_fit]") {
  // Data of many more digits than the differences have: what is "settled" lies within a tenth of a
  // deviation of the minimum, and what the slopes' error, 1e-4^(2/3) of |r|, moves it by.
  for (const double sd : {1e-3, 1e-5, 1e-7}) {
    FitProblem p = decay(sd, 15);
    const Fit fine = fit_bounded(p);
    REQUIRE(fine.status == FitStatus::settled);
    p.accuracy = 1e-4;
    const Fit coarse = fit_bounded(p);
    REQUIRE(coarse.status == FitStatus::settled);
    for (int k : {0, 1}) {
      INFO(sd << ": " << (coarse.x[k] - fine.x[k]) / fine.deviation[k] << " deviations");
      CHECK(std::abs(coarse.x[k] - fine.x[k]) < 0.2 * fine.deviation[k]);
    }
  }
}

TEST_CASE("ASearchThatIsCutShortIsNotCalledSettledFarFromTheMinimum", "[bounded_fit]") {
  // Cut after each number of steps: what is called settled is within a tenth of a deviation along
  // both directions of the ellipse.
  for (const double sd : {1e-2, 1e-3, 1e-4, 1e-5}) {
    FitProblem p = decay(sd, 21);
    const Fit fine = fit_bounded(p);
    p.accuracy = 1e-4;
    int settled = 0;
    for (int steps = 1; steps <= 30; ++steps) {
      p.most_iterations = steps;
      const Fit fit = fit_bounded(p);
      if (fit.status != FitStatus::settled) continue;
      ++settled;
      for (int k : {0, 1}) {
        INFO(sd << ", " << steps << ": " << (fit.x[k] - fine.x[k]) / fine.deviation[k]);
        CHECK(std::abs(fit.x[k] - fine.x[k]) < 0.2 * fine.deviation[k]);
      }
    }
    CHECK(settled > 10);
  }
}

TEST_CASE("AnInterruptedFitGivesTheBestThatItFound", "[bounded_fit]") {
  // Stopped while the n-th evaluation runs: as a film solver, it then computes nothing more.
  for (const int last : {0, 1, 7, 12, 18}) {
    FitProblem p = decay(0.02, 17);
    int asked = 0;
    double best = INFINITY;
    Values at;
    p.stopped = [&] { return asked > last; };
    p.residuals = [&, r = p.residuals](const Values& x, Purpose purpose) {
      ++asked;
      auto out = asked > last ? std::optional<Values>() : r(x, purpose);
      double chi2 = 0.0;
      for (const double v : out.value_or(Values{})) chi2 += v * v;
      if (out && purpose == Purpose::step && chi2 < best) best = chi2, at = x;
      return out;
    };
    const Fit fit = fit_bounded(p);
    INFO("stopped after " << last);
    CHECK(fit.status == FitStatus::interrupted);
    CHECK(fit.refused_steps == 0);
    CHECK(fit.computed() == (last > 0));
    if (last == 0) continue;
    CHECK(fit.x == at);
    CHECK(fit.chi2 == best);
    CHECK(fit.freedom == 18);
    if (last > 12) CHECK(fit.chi2 < 0.5 * fit.chi2_start);
  }
}

TEST_CASE("AFitThatLosesItsSlopesGivesTheBestThatItFound", "[bounded_fit]") {
  FitProblem p = decay(0.02, 19);
  double near = INFINITY;
  p.residuals = [&near, r = p.residuals](const Values& x, Purpose purpose) {
    if (purpose == Purpose::difference && near < 1.0) return std::optional<Values>();
    if (purpose == Purpose::step) near = std::min(near, std::abs(x[0] - 2.0));
    return r(x, purpose);
  };
  const Fit fit = fit_bounded(p);
  CHECK(fit.status == FitStatus::not_computed);
  CHECK(fit.chi2 < fit.chi2_start);
  CHECK(fit.freedom == 18);
  double chi2 = 0.0;
  const auto again = p.residuals(fit.x, Purpose::step);
  REQUIRE(again);
  for (const double v : *again) chi2 += v * v;
  CHECK(chi2 == Approx(fit.chi2).epsilon(1e-12));
}

TEST_CASE("AKeyWithoutEffectTakesNothingFromAnother", "[bounded_fit]") {
  const Fit alone = fit_bounded(decay(0.02, 5));
  FitProblem p = decay(0.02, 5);
  p.parameters.push_back({0.5, 0.0, 1.0});  // of no effect
  const Fit fit = fit_bounded(p);
  CHECK_FALSE(fit.determined());
  for (const int k : {0, 1}) CHECK(fit.deviation[k] == Approx(alone.deviation[k]).epsilon(1e-6));
}
