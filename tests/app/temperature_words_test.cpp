// Messages tell temperatures that an oil can have, and words beyond.
#include "app/words/temperature_words.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace shellback;
using namespace shellback::app;

namespace {

bool has_digit(const std::string& text) {
  return text.find_first_of("0123456789") != std::string::npos;
}

}  // namespace

TEST_CASE("ATemperatureThatAnOilCanHaveIsToldAsItIs") {
  CHECK(told_temperature(kZeroCelsius + 87.0) == "87 degC");
  CHECK(told_rise(kZeroCelsius + 187.0, kZeroCelsius + 100.0) ==
        "the film is 87 K above the supply");
}

TEST_CASE("ATemperatureBeyondPhysicsIsToldInWords") {
  for (const double T : {249772.0, 8.9e6, 1e300, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN(), -4000.0}) {
    CHECK_FALSE(has_digit(told_temperature(T)));
  }
  CHECK_FALSE(has_digit(told_rise(249772.0, 373.15)));
}
