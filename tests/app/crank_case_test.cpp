/// [crank] and its trace of pressure, and every way in which they can be wrong.
#include <cmath>

#include "bearing/over_time/cycle_numbers.hpp"
#include "core/constants.hpp"
#include "tests/app/cycle_case.hpp"

using namespace shellback;
using namespace shellback::app;
using bearing::LoadCycle;

TEST_CASE("ACrankGivesLoadAndSpeedInTheRod") {
  const ScratchFolder folder;
  const auto c = read(folder, "[load_cycle]\nstep = \"2 deg\"\n" + kCrank, kTrace);
  REQUIRE(c.cycle);
  CHECK(c.cycle->period == Approx(2.0 * kTurn));
  CHECK(c.cycle->omega.size() == c.cycle->t.size());
  CHECK(*c.cycle->step == Approx(kTurn / 180.0));
  const double r = 0.0685;
  const double gas = 140e5 * 0.25 * kPi * 0.105 * 0.105;
  const double inertia = (2.5 * (1.0 + r / 0.207) + 1.6) * r * kOmega * kOmega;
  CHECK(c.cycle->y[0] == Approx(gas - inertia));
  const auto numbers = bearing::cycle_numbers(*c.cycle, 0.0);
  CHECK(numbers.largest == Approx(gas - inertia));
  CHECK(numbers.angle == Approx(90.0 * kDeg));
  CHECK(numbers.mean_speed == Approx(kOmega).epsilon(1e-5));  // trapezoids of a degree
  const LoadCycle alone = cycle_of(kCrank, kTrace);           // [load_cycle] may be left out
  CHECK(alone.y == c.cycle->y);
}

TEST_CASE("ACrankGivesTheLoadOfAMainBearingInTheBlock") {
  const LoadCycle pin = cycle_of(kCrank, kTrace);
  const LoadCycle half = cycle_of("[load_cycle]\nframe = \"block\"\n" + kCrank, kTrace);
  CHECK(half.period == pin.period);
  for (const double w : half.omega) CHECK(w == kOmega);
  for (std::size_t k = 0; k < half.t.size(); ++k) {  // half of what acts on the pin, turned
    CHECK(std::hypot(half.x[k], half.y[k]) ==
          Approx(0.5 * std::hypot(pin.x[k], pin.y[k])).epsilon(1e-12));
  }
  CHECK(half.y[0] == Approx(-0.5 * pin.y[0]));  // gas: onto the cap, which lies below
}

TEST_CASE("APressureWithinOneTurnIsThatOfTwoStrokes") {
  const std::string turn = "angle [deg], pressure [bar]\n0, 140\n90, 10\n360, 140\n";
  CHECK(cycle_of(kCrank, turn).period == Approx(kTurn));
  CHECK(cycle_of("[load_cycle]\nperiod = \"720 deg\"\n" + kCrank, turn).period ==
        Approx(2.0 * kTurn));
  check_against(turn, {"case.toml:19:10", "360 deg (two strokes) or 720 deg"},
                "[load_cycle]\nperiod = \"540 deg\"\n" + kCrank);
}

TEST_CASE("APressureTraceInAWrongUnitIsRefused") {
  const auto said = [](const std::string& table, const std::vector<std::string>& parts) {
    check_against(table, parts, kCrank);
  };
  said("angle [deg], pressure [bar]\n0, 1.4\n90, 1\n700, 0.3\n",
       {"p.csv:2:4", "largest cylinder pressure is 1.4 bar", "check the unit"});
  said("angle [deg], pressure [MPa]\n0, 140\n90, 10\n700, 3\n",
       {"p.csv:2:4", "140 MPa", "check the unit"});
  said("angle [deg], pressure [bar]\n0, 140\n90, -1.5\n700, 3\n", {"p.csv:3:5", "below vacuum"});
  said("angle [deg], pressure [bar]\n0, 140\n90, 10\n720, 3\n",
       {"p.csv:4:6", "not periodic", "jumps by 137 bar"});
  said("angle [deg], pressure [bar]\n0, 140\n90, 10\n90, 3\n", {"p.csv:4:1", "sort"});
  said("angle [deg], pressure [bar]\n0, 140\n750, 3\n",
       {"p.csv:3:1", "period of 720 deg after the first row"});
  said("angle [deg], pressure [bar]\n0, 140\n", {"p.csv:1:1", "two rows"});
  said("angle [deg], presure [bar]\n0, 140\n", {"p.csv:1:14", "did you mean \"pressure\"?"});
}

namespace {

/// Gas that is compressed and expands again with exponent 1.3 in a cylinder of volume ratio 17, as
/// a trace every 10 deg up to an angle; `factor`: what a wrong unit makes of it.
std::string trace_row(int written, int angle, double factor = 1.0) {
  const double open = 0.5 * (1.0 - std::cos(angle * kDeg));
  const bool closed = angle < 180 || angle > 540;
  const double p = closed ? 2.5 * std::pow(17.0 / (1.0 + 16.0 * open), 1.3) : 2.5;
  return std::to_string(written) + "," + std::to_string(factor * (p - 1.01325)) + "\n";
}

std::string trace(int to, double factor = 1.0) {
  std::string rows = "angle [deg], pressure [bar]\n";
  for (int a = 0; a <= to; a += 10) rows += trace_row(a, a, factor);
  return rows;
}

std::vector<std::string> crank_warnings(const std::string& table) {
  const ScratchFolder folder;
  return read(folder, "[load_cycle]\nperiod = \"720 deg\"\n" + kCrank, table).warnings;
}

}  // namespace

TEST_CASE("APressureTraceCoversItsPeriod") {
  check_against(trace(400),
                {"p.csv:42:1", "from 400 deg to 0 deg of the next period no row tells the pressure",
                 "32 times", "(taken: 720 deg)"},
                kCrank);
  CHECK(crank_warnings(trace(710)).empty());
  const auto told = crank_warnings(trace(640));
  REQUIRE(told.size() == 1);
  check_parts(told.front(), {"crank.pressure", "from 640 deg to 0 deg", "8 times"});
}

TEST_CASE("ATraceMayBeginAnywhereOfItsPeriod") {
  // Indicating systems count from -360 deg, with the last row repeated or not.
  const LoadCycle whole = cycle_of(kCrank, trace(710));
  const auto from = [](int begin, int end) {
    std::string rows = "angle [deg], pressure [bar]\n";
    for (int a = begin; a <= end; a += 10) rows += trace_row(a, (a + 720) % 720);
    return rows;
  };
  for (const std::string& other : {from(-360, 350), from(-360, 360), from(-90, 620),
                                   from(-720, -10), from(10, 720), from(360, 1070)}) {
    const LoadCycle turned = cycle_of(kCrank, other);
    CHECK(turned.period == whole.period);
    REQUIRE(turned.y.size() == whole.y.size());
    for (std::size_t k = 0; k < whole.y.size(); ++k) {
      CHECK(turned.y[k] == Approx(whole.y[k]).margin(1e-6));  // [N] of 1e5: round-off
    }
  }
  check_against(from(-360, 370),
                {"p.csv:75:1", "370 deg lies more than the period of 720 deg", "-360 deg"}, kCrank);
}

TEST_CASE("ATraceWhosePeakIsFarFromADeadCentreIsTold") {
  const auto counted = [](int shift) {  // from `shift` degrees before the dead centre on
    std::string rows = "angle [deg], pressure [bar]\n";
    for (int a = 0; a < 720; a += 10) rows += trace_row(a, (a - shift + 720) % 720);
    return crank_warnings(rows);
  };
  CHECK(counted(20).empty());   // late combustion
  CHECK(counted(360).empty());  // counted from the change of gas: the same load half a period later
  const auto told = counted(180);
  REQUIRE(told.size() == 1);
  check_parts(told.front(), {"crank.pressure", "stands at 180 deg", "180 deg from the nearest"});
}

TEST_CASE("ARodThatNoEngineHasIsTold") {
  for (const char* length : {"2.07 m", "120 mm"}) {
    std::string crank = kCrank;
    crank.replace(crank.find("207 mm"), 6, length);
    const ScratchFolder folder;
    const auto told = read(folder, crank, trace(710)).warnings;
    REQUIRE_FALSE(told.empty());
    check_parts(told.front(), {"crank.rod_length", "engines have 0.2 to 0.35"});
  }
}

TEST_CASE("APressureTraceThatSpansLessThanCompressionIsTold") {
  CHECK(crank_warnings(trace(710)).empty());  // gas alone spans 17^1.3 = 39.8
  // A compressor whose valve opens at 8 bar: no engine, and no wrong unit.
  std::string rows = "angle [deg], pressure [bar]\n";
  for (int a = 0; a <= 710; a += 10) {
    const bool shut = a < 180 || a > 540;
    const double open = 0.5 * (1.0 - std::cos(a * kDeg));
    const double p = shut ? std::pow(17.0 / (1.0 + 16.0 * open), 1.3) : 1.0;
    rows += std::to_string(a) + "," + std::to_string(std::min(p, 9.0) - 1.0) + "\n";
  }
  const auto told = crank_warnings(rows);
  REQUIRE(told.size() == 1);
  check_parts(told.front(), {"p.csv", "crank.pressure", "both absolute", "14.9 times", "psi"});
}

TEST_CASE("APressureTraceInATenthOfItsUnitIsRefused") {
  // Beside the ambient pressure that is added, the rise of gas in a shut cylinder is lost.
  for (const double factor : {1.0 / 14.5038, 0.1}) {  // psi and MPa, given as bar
    check_against(trace(710, factor),
                  {"p.csv:2:3", "gas which is shut in", "psi or MPa given as bar"}, kCrank);
  }
}

TEST_CASE("ACrankThatCannotTurnIsRefused") {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = kCrank;
    return text.replace(text.find(from), from.size(), to);
  };
  check_against(kTrace, {"case.toml:20:14", "shorter than half the stroke"},
                changed("207 mm", "60 mm"));
  check_against(kTrace, {"case.toml:22:15", "must not be negative"}, changed("2.5 kg", "-1 kg"));
  check_against(kTrace, {"case.toml:21:15", "no gas and no mass"},
                "[crank]\nstroke = \"137 mm\"\nrod_length = \"207 mm\"\npiston_mass = \"0 kg\"\n"
                "rod_mass = \"0 kg\"\n");
  check_against(kTrace, {"case.toml:25:17", "belongs to a main bearing", "\"block\""},
                kCrank + "counterweight = \"1 kg m\"\n");
  const std::string block = "[load_cycle]\nframe = \"block\"\n" + kCrank;
  check_against(kTrace, {"case.toml:27:9", "at most the whole throw"}, block + "share = 2\n");
  check_against(kTrace, {"case.toml:27:17", "kg m"}, block + "counterweight = \"1 kg\"\n");
  check_against(kTrace, {"case.toml:19:8", "comes from [crank]"},
                "[load_cycle]\nfile = \"load.csv\"\n" + kCrank);
  check_against(kTrace, {"case.toml:19:9", "write \"rod\""},
                "[load_cycle]\nframe = \"shell\"\n" + kCrank);
  check_against(kTrace, {"case.toml:18:1", "crank", "vanishes", "rod_mass"},
                changed("1.6 kg", "0 kg"));
  check_parts(against(kCrank, kTrace, "0 rpm"), {"case.toml:16:9", "operation.speed", "zero"});
}
