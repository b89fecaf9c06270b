// The interval of a counted share against closed forms and printed values.
#include "validation/honesty/wilson.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace shellback::validation;

TEST_CASE("NothingCountedTellsNothing") {
  CHECK(wilson(0, 0).low == 0.0);
  CHECK(wilson(0, 0).high == 1.0);
}

TEST_CASE("AtNoneAndAtAllTheIntervalHasItsClosedForm") {
  const double z2 = kNormal95 * kNormal95;
  for (const int n : {1, 2, 5, 10, 200}) {
    CHECK(wilson(0, n).low == Approx(0.0).margin(1e-15));
    CHECK(wilson(0, n).high == Approx(z2 / (n + z2)));
    CHECK(wilson(n, n).low == Approx(n / (n + z2)));
    CHECK(wilson(n, n).high == Approx(1.0));
  }
  // One success in one trial: between 20.7 % and certainty, printed so in textbooks.
  CHECK(wilson(1, 1).low == Approx(0.2065).margin(5e-5));
}

TEST_CASE("PrintedExamplesAreMet") {
  // Newcombe, Statistics in Medicine 17 (1998) 857-872, table I, method 3 (score), 95 %.
  const auto printed = [](double held, double count, double low, double high) {
    CHECK(wilson(held, count).low == Approx(low).margin(5e-5));
    CHECK(wilson(held, count).high == Approx(high).margin(5e-5));
  };
  printed(81, 263, 0.2553, 0.3662);
  printed(15, 148, 0.0624, 0.1605);
  printed(0, 20, 0.0, 0.1611);
  printed(1, 29, 0.0061, 0.1718);
}

TEST_CASE("ItsEndsAreTheSharesThatTheTestJustRejects") {
  for (const double held : {1.0, 7.0, 19.0}) {
    const double n = 20.0;
    const ShareInterval i = wilson(held, n);
    for (const double p : {i.low, i.high}) {
      CHECK(std::abs(held / n - p) == Approx(kNormal95 * std::sqrt(p * (1.0 - p) / n)));
    }
    const ShareInterval mirrored = wilson(n - held, n);
    CHECK(mirrored.low == Approx(1.0 - i.high));
    CHECK(mirrored.high == Approx(1.0 - i.low));
  }
}
