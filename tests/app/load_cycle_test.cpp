/// A load cycle from its table, and every way in which one can be wrong.
#include <cmath>
#include <sstream>

#include "app/check.hpp"
#include "app/init.hpp"
#include "app/reading/library.hpp"
#include "bearing/over_time/cycle_numbers.hpp"
#include "core/constants.hpp"
#include "tests/app/cycle_case.hpp"

using namespace shellback;
using namespace shellback::app;
using bearing::LoadCycle;

TEST_CASE("ATableInCrankAngleBecomesACycleInTime") {
  const ScratchFolder folder;
  const auto c = read(folder, kInDegrees, "# a comment\n\n" + kRows);
  REQUIRE(c.cycle);
  CHECK(c.cycle->t.size() == 4);
  CHECK(c.cycle->t[1] == Approx(0.25 * kTurn));
  CHECK(c.cycle->period == Approx(kTurn));
  CHECK(c.cycle->crank_speed == Approx(kOmega));
  CHECK(c.cycle->x[1] == 500.0);
  CHECK(c.cycle->y[2] == -3000.0);
  CHECK(c.cycle->omega.empty());
  CHECK(c.cycle->interpolation == bearing::LoadInterpolation::linear);
  CHECK(c.cycle->journal_mass == 0.0);
  CHECK_FALSE(c.cycle->step);
  const auto load = std::get<bearing::LoadGiven>(c.operation.position);
  CHECK(load.force == Approx(3000.0));
  CHECK(load.angle == Approx(270.0 * kDeg));
  CHECK(c.warnings.empty());
  const auto files = files_of_case(sample_of(kInDegrees), folder.path("case.toml"));
  CHECK(files.back() == folder.path("load.csv"));
}

TEST_CASE("AShareIsNoValueOfAColumnThatHasAUnit") {
  const std::string begin = "angle [deg], load_x [kN], load_y [kN]\n0, 1, 1\n";
  check_against(begin + "90, 50%, 1\n", {"load.csv:3:5", "\"50%\"", "kN", "number alone"});
  check_against(begin + "90, 50 %, 1\n", {"load.csv:3:5", "\"50 %\"", "kN"});
  check_against(begin + "90, 2 kN, 1\n", {"load.csv:3:5", "first line of the table names"});
  check_against("angle [deg], load_x [%], load_y [kN]\n0, 1, 1\n", {"load.csv:1:14", "a force"});
}

TEST_CASE("ABulkModulusThatNoVesselHasIsRefusedOrTold") {
  const ScratchFolder folder;
  folder.write("load.csv", kRows);
  const auto with = [&](const std::string& modulus) {
    std::string text = sample_of(kInDegrees);
    const std::string open = "open = [\"0 deg\", \"180 deg\"]\n";
    text.insert(text.find("[operation]"), "vessel_volume = \"20 cm3\"\n" + open +
                                              "vessel_bulk_modulus = \"" + modulus + "\"\n");
    return read_case_text(text, folder.path("case.toml"));
  };
  CHECK_THROWS_WITH(with("1.5 Pa"), Catch::Contains("supply.0.vessel_bulk_modulus") &&
                                        Catch::Contains("check its unit"));
  CHECK_THROWS_AS(with("1e6 GPa"), InputError);
  CHECK(with("1.5 GPa").warnings.empty());
  CHECK(with("5 MPa").warnings.empty());                // a hose
  for (const char* modulus : {"0.2 MPa", "1.5 MPa"}) {  // the latter a liquid's, a unit off
    const auto soft = with(modulus).warnings;
    REQUIRE(soft.size() == 1);
    check_parts(soft[0], {"supply.0.vessel_bulk_modulus", "unusual"});
  }
}

TEST_CASE("ATableThatCannotBeReadIsCalledATable") {
  check_against("", {"load.csv: the file is empty", "names columns and units"});
  check_against("angle [deg]\n\x01\xFF", {"load.csv:2:2", "is this a table?"});
  check_against(kRows, {"case.toml", "load_cycle.file", "names no file"},
                "[load_cycle]\nfile = \"\"\n");
  const ScratchFolder folder;
  const auto said = [&](const std::string& file) {
    try {
      static_cast<void>(read(folder, "[load_cycle]\nfile = \"" + file + "\"\n", kRows));
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  check_parts(said("."), {"this is a folder; give the table in it"});
  check_parts(said("none.csv"), {"case.toml:", "load_cycle.file", "none.csv: there is no such file",
                                 "from the folder of the case"});
}

TEST_CASE("ACrankTurningClockwiseCountsItsAngleForwards") {
  const LoadCycle c = cycle_of(kInDegrees, kRows, "-3000 rpm");
  CHECK(c.t[1] == Approx(0.25 * kTurn));
  CHECK(c.crank_speed == Approx(kOmega));
}

TEST_CASE("ATableInTimeIsTakenInItsUnits") {
  const LoadCycle c = cycle_of(
      kInTime +
          "journal_mass = \"1.2 kg\"\nstep = \"0.1 ms\"\ninterpolation = "
          "\"periodic_spline\"\nframe = \"shell\"\n",
      "speed [rpm]; direction [deg]; load [kN]; time [us]\n3000; 270; 1; 0\n3300; 0; 2; 5000\n"
      "2700; 90; 3; 10000\n");
  CHECK(c.t[1] == Approx(0.005));
  CHECK(c.x[1] == Approx(2000.0));
  CHECK(std::abs(c.y[1]) < 1e-9);
  CHECK(c.y[0] == Approx(-1000.0));
  CHECK(c.omega[1] == Approx(1.1 * kOmega));
  CHECK(c.crank_speed == 0.0);
  CHECK(c.journal_mass == Approx(1.2));
  REQUIRE(c.step);
  CHECK(*c.step == Approx(1e-4));
  CHECK(c.interpolation == bearing::LoadInterpolation::periodic_spline);
}

TEST_CASE("AStepMayBeAnAngle") {
  const LoadCycle c = cycle_of(kInDegrees + "step = \"1 deg\"\n", kRows);
  CHECK(*c.step == Approx(kTurn / 360.0));
}

TEST_CASE("InstantsOfFieldsAreAnglesOrTimes") {
  const LoadCycle c = cycle_of(kInDegrees + "fields_at = [\"90 deg\", \"1 ms\"]\n", kRows);
  REQUIRE(c.fields_at.size() == 2);
  CHECK(c.fields_at[0] == Approx(kTurn / 4.0));
  CHECK(c.fields_at[1] == Approx(1e-3));
  check_against(kRows, {"case.toml:", "fields_at", "\"2 mm\"", "neither a crank angle nor a time"},
                kInDegrees + "fields_at = [\"2 mm\"]\n");
  check_against(kRows, {"case.toml:", "load_cycle.fields_at", "450 deg lies outside the cycle"},
                kInDegrees + "fields_at = [\"450 deg\"]\n");
}

TEST_CASE("WithoutAPeriodItIsASingleEvent") {
  const std::string once = "[load_cycle]\nfile = \"load.csv\"\n";
  const LoadCycle c =
      cycle_of(once, "time [ms], load_x [N], load_y [N]\n0, 0, -1\n5, 0, -2\n9, 0, -1\n");
  CHECK_FALSE(c.repeats());
  CHECK(c.t.back() == Approx(0.009));
  check_against("time [ms], load_x [N], load_y [N]\n1, 0, -1\n5, 0, -2\n",
                {"load.csv:2:1", "begins at 0"}, once);
  check_against("time [ms], load_x [N], load_y [N]\n-1, 0, -1\n5, 0, -2\n",
                {"load.csv:2:1", "begins at 0, not at -1 ms", "shift the column"}, once);
}

TEST_CASE("SpeedsOfATableThatAreNotThoseOfItsCrankAreTold") {
  const auto told = [](const std::string& rpm) {
    std::string table = "angle [deg], load_x [N], load_y [N], speed [rpm]\n";
    for (const char* row : {"0, 0, -1000", "120, 500, -2000", "240, 0, -3000"}) {
      table += std::string(row) + ", " + rpm + "\n";
    }
    const ScratchFolder folder;
    return read(folder, kInDegrees, table).warnings;
  };
  CHECK(told("3000").empty());
  CHECK(told("-3000").empty());
  const auto warnings = told("1500");
  REQUIRE(warnings.size() == 1);
  check_parts(warnings.front(), {"operation.speed", "1500 rpm in the mean", "3000 rpm"});
}

TEST_CASE("ALastRowThatRepeatsTheFirstIsDropped") {
  CHECK(cycle_of(kInDegrees, kRows + "360, 0, -1000\n").t.size() == 4);
  check_against(kRows + "360, 0, -1500\n",
                {"load.csv:6:1", "not periodic", "from 360 deg back to 0 deg",
                 "the load jumps by 500 N", "two rows at 0"});
  check_against("angle [deg], load_x [N], load_y [N], speed [rpm]\n0,0,-1,3000\n360,0,-1,3100\n",
                {"load.csv:3:1", "not periodic", "speed jumps by 100 rpm"});
}

TEST_CASE("AJumpAtTheEndOfThePeriodStandsAtItsBeginning") {
  const std::string rows = "angle [deg], load_x [N], load_y [N]\n0, 0, -1000\n90, 0, -2000\n";
  const LoadCycle c = cycle_of(kInDegrees, rows + "360, 0, -3000\n360, 0, -1000\n");
  REQUIRE(c.t.size() == 3);
  CHECK(c.t[0] == 0.0);
  CHECK(c.y[0] == -3000.0);  // before the jump
  CHECK(c.t[1] == 0.0);
  CHECK(c.y[1] == -1000.0);
}

TEST_CASE("AJumpAtTheEndNeedsNoRowAtTheBeginning") {
  const std::string head = "angle [deg], load_x [N], load_y [N]\n";
  const std::string rows = "120, 0, -1000\n240, 0, -1500\n360, 0, -2000\n360, 0, -1000\n";
  const auto jump = cycle_of(kInDegrees, head + rows);
  const auto with_first = cycle_of(kInDegrees, head + "0, 0, -1000\n" + rows);
  CHECK(jump.t == with_first.t);
  CHECK(jump.y == with_first.y);
  REQUIRE(jump.t.size() == 4);
  CHECK((jump.t[0] == 0.0 && jump.t[1] == 0.0));
  CHECK((jump.y[0] == -2000.0 && jump.y[1] == -1000.0));
  const auto twice = cycle_of(kInDegrees, head + "0, 0, -2000\n0, 0, -1000\n" + rows);  // both ends
  CHECK(twice.t == jump.t);
  CHECK(twice.y == jump.y);
}

TEST_CASE("AMomentOverACycleIsJudgedByItsLargestLoad") {
  const ScratchFolder folder;
  folder.write("load.csv", kRows);
  std::string with = sample_of(kInDegrees);
  const std::string operation = "[operation]\n";
  with.insert(with.find(operation) + operation.size(), "moment = { about_x = \"1e6 N m\" }\n");
  std::string said;
  try {
    static_cast<void>(read_case_text(with, folder.path("case.toml")));
  } catch (const InputError& error) {
    said = error.what();
  }
  CHECK(said.find("operation.moment") != std::string::npos);
  CHECK(said.find("largest load") != std::string::npos);
}

TEST_CASE("ATableThatBeginsLaterGoesOnFromItsEnd") {
  const std::string rows = "angle [deg], load_x [N], load_y [N]\n";
  const LoadCycle c = cycle_of(kInDegrees, rows + "90, 0, -1000\n270, 0, -3000\n");
  REQUIRE(c.t.size() == 3);
  CHECK(c.t[0] == 0.0);
  CHECK(c.y[0] == Approx(-2000.0));  // half of the 180 deg from the last row to the first
  const LoadCycle end = cycle_of(kInDegrees, rows + "90, 0, -1000\n360, 0, -3000\n");
  CHECK(end.t[0] == 0.0);
  CHECK(end.y[0] == -3000.0);
  CHECK(end.t.back() == Approx(0.25 * kTurn));
  check_against(rows + "90, 0, -1000\n180, 0, -2000\n270, 0, -3000\n",
                {"load.csv:2:1", "spline begins with a row at 0"},
                kInDegrees + "interpolation = \"periodic_spline\"\n");
}

TEST_CASE("RowsInDisorderAreRefused") {
  const std::string head = "angle [deg], load_x [N], load_y [N]\n";
  check_against(head + "0,0,-1\n90,0,-1\n80,0,-1\n",
                {"load.csv:4:1", "80 deg comes after 90 deg", "sort"});
  check_against(head + "0,0,-1\n90,0,-1\n90,0,-2\n90,0,-3\n",
                {"load.csv:5:1", "third time", "a jump has two rows"});
  check_against(head + "-5,0,-1\n90,0,-1\n",
                {"load.csv:2:1", "before the period", "add one period"});
  check_against(head + "0,0,-1\n400,0,-1\n", {"load.csv:3:1", "400 deg lies out of the period"});
  check_against(head + "0,0,-1\n", {"load.csv:1:1", "one row", "operation.load"});
  check_against(head, {"load.csv:1:1", "no row"});
  check_against("# nothing\n", {"load.csv:1:1", "empty", "angle [deg], load_x [N]"});
}

namespace {

/// A load that turns with its angle: rows from one angle to another, `step` apart [deg].
std::string turning(int from, int to, int step = 10) {
  std::string rows;
  for (int a = from; a <= to; a += step)
    rows += std::to_string(a) + ",1," + std::to_string(a) + "\n";
  return rows;
}

const std::string kTurning = "angle [deg], load [kN], direction [deg]\n";

}  // namespace

TEST_CASE("AStretchWithoutRowsIsRefusedWithItsEnds") {
  check_against(kTurning + turning(0, 100),
                {"load.csv:12:1", "from 100 deg to 0 deg of the next period no row tells the load",
                 "26 times", "add the rows, or correct load_cycle.period", "half way"});
  check_against(kTurning + turning(0, 100) + turning(220, 350),
                {"load.csv:12:1", "from 100 deg to 220 deg no row", "12 times", "add the rows;"});
  check_against(kTurning + turning(40, 140),  // a row at 0 that nobody gave does not count
                {"load.csv:12:1", "from 140 deg to 40 deg of the next period", "26 times"});
  check_against("time [ms], load_x [N], load_y [N]\n0,0,-1\n1,0,-2\n2,0,-3\n13,0,-1\n",
                {"load.csv:4:1", "from 2 ms to 13 ms no row", "11 times"},
                "[load_cycle]\nfile = \"load.csv\"\n");
  check_against(
      "time [ms], load_x [N], load_y [N], speed [rpm]\n0,0,-1,0\n1,0,-1,1\n2,0,-1,2\n"
      "13,0,-1,300\n",
      {"load.csv:4:1", "from 2 ms to 13 ms no row"}, "[load_cycle]\nfile = \"load.csv\"\n");
}

TEST_CASE("ATableOfOneTurnIsNoneOfTwo") {
  const std::string two = "[load_cycle]\nfile = \"load.csv\"\nperiod = \"720 deg\"\n";
  check_against(kTurning + turning(0, 360),  // whose ends are alike
                {"load.csv:38:1", "from 360 deg to 0 deg of the next period", "36 times",
                 "correct load_cycle.period"},
                two);
  CHECK_NOTHROW(cycle_of(two, kTurning + turning(0, 720)));
}

TEST_CASE("AStraightLineThatIsMeantIsSaidByARow") {
  CHECK_NOTHROW(cycle_of(kInDegrees, kTurning + turning(0, 100) + "230,1,50\n"));   // half way
  CHECK_NOTHROW(cycle_of(kInDegrees, kTurning + turning(0, 100) + "350,1,100\n"));  // it stays
}

TEST_CASE("TablesOfAFewCornersHaveNoGaps") {
  const std::string head = "angle [deg], load_x [N], load_y [N]\n";
  for (const std::string rows :
       {"0,0,-1000\n1,0,-2000\n",                            // two rows
        "0,0,-1000\n1,0,-2000\n180,0,-2500\n181,0,-1000\n",  // a roof on short ramps
        "0,0,-1000\n0,0,-2000\n180,0,-2500\n180,0,-1000\n",  // on jumps
        "0,0,-1000\n1,0,-1500\n2,0,-2000\n3,0,-1500\n5,0,-1000\n360,0,-1000\n"}) {  // a pulse
    CHECK_NOTHROW(cycle_of(kInDegrees, head + rows));
  }
}

TEST_CASE("AFewRowsThatAreLostAreTold") {
  const ScratchFolder folder;
  const auto warnings = [&](const std::string& rows) {
    return read(folder, kInDegrees, kTurning + rows).warnings;
  };
  const auto told = warnings(turning(0, 100) + turning(150, 350));
  REQUIRE(told.size() == 1);
  check_parts(told.front(), {"case.toml:19:8", "load_cycle.file", "no row tells the load",
                             "5 times", "half way"});
  CHECK(warnings(turning(0, 100) + turning(120, 350)).empty());
  // Behind the last row: told once, alike or not, from 0 on or not.
  const auto end = [&](const std::string& rows) {
    const auto list = warnings(rows);
    REQUIRE(list.size() == 1);
    return list.front();
  };
  CHECK(end(turning(0, 310)).find("5 times") != std::string::npos);
  CHECK(end(turning(0, 300) + "310,1,0\n").find("310 deg to 0 deg of the next") !=
        std::string::npos);
  CHECK(end(turning(30, 340)).find("340 deg to 30 deg of the next") != std::string::npos);
}

TEST_CASE("FieldsThatAreNoNumbersAreRefused") {
  const std::string head = "angle [deg], load_x [N], load_y [N]\n0, 0, -1\n";
  check_against(head + "90, , -1\n", {"load.csv:3:4", "load_x is missing", "fill the gap"});
  check_against(head + "90, nan, -1\n", {"load.csv:3:5", "not a finite number"});
  check_against(head + "90, 0, -inf\n", {"load.csv:3:8", "not a finite number"});
  check_against(head + "90, 0, big\n", {"load.csv:3:8", "does not begin with a number"});
  check_against(head + "90, 0, 1e400\n", {"load.csv:3:8", "out of range"});
  check_against(head + "90, 0\n", {"load.csv:3:5", "2 fields", "3 columns"});
  check_against(head + "90, 0, 1, 2\n", {"load.csv:3:11", "4 fields", "3 columns"});
}

TEST_CASE("ColumnsAreKnownAndHaveUnits") {
  const std::string rows = "0, 0, -1\n90, 0, -2\n";
  check_against("angle [deg], load_x [N], laod_y [N]\n" + rows,
                {"load.csv:1:26", "\"laod_y\" is not known", "did you mean \"load_y\"?"});
  check_against("angle [deg], load_x, load_y [N]\n" + rows,
                {"load.csv:1:14", "load_x names no unit", "load_x [N]"});
  check_against("angle [deg], load_x [mm], load_y [N]\n" + rows,
                {"load.csv:1:14", "a length", "a force"});
  check_against("angle [deg], load_x [N], load_x [N]\n" + rows,
                {"load.csv:1:26", "two columns load_x"});
  check_against("angle [deg], time [ms], load_x [N]\n" + rows, {"load.csv:1:1", "both angle"});
  check_against("load [N], load_x [N], load_y [N]\n" + rows, {"load.csv:1:1", "given twice"});
  check_against("angle [deg], load_x [N]\n0, 1\n9, 1\n", {"load.csv:1:1", "no column load_y"});
  check_against("angle [deg], load [N]\n0, 1\n9, 1\n", {"load.csv:1:1", "no column direction"});
  check_against("load_x [N], load_y [N]\n0, 1\n9, 1\n", {"load.csv:1:1", "angle or time"});
  check_against("angle [deg], load [N], direction [deg]\n0, 1, 270\n9, -1, 270\n",
                {"load.csv:3:", "not negative", "180 deg"});
}

TEST_CASE("AngleAndTimeAreNotMixed") {
  check_against(kRows, {"case.toml:20:10", "the period is a time", "column angle"}, kInTime);
  check_against("time [ms], load_x [N], load_y [N]\n0,0,-1\n9,0,-2\n",
                {"case.toml:20:10", "the period is a crank angle", "column time"});
  check_parts(against(kInDegrees, kRows, "0 rpm"),
              {"case.toml:16:9", "operation.speed", "zero", "give the crank's speed"});
  check_against(kRows, {"case.toml:20:10", "neither a crank angle nor a time"},
                "[load_cycle]\nfile = \"load.csv\"\nperiod = \"360\"\n");
  check_against(kRows, {"case.toml:20:10", "must be positive"},
                "[load_cycle]\nfile = \"load.csv\"\nperiod = \"-360 deg\"\n");
}

TEST_CASE("ABearingAtRestMayBeSqueezed") {
  const LoadCycle c =
      cycle_of(kInTime, "time [ms], load_x [N], load_y [N]\n0,0,-1000\n9,0,-2000\n", "0 rpm");
  CHECK(c.crank_speed == 0.0);
}

TEST_CASE("AJournalsWeightThatCountsIsSaidToBeNoPartOfTheLoad") {
  // 200 kg weigh 1961 N, twice the largest load of 1 kN; 0.9 kg weigh 9 N, less than its hundredth.
  const std::string rows = "angle [deg], load_x [N], load_y [N]\n0, 0, -1000\n180, 0, -500\n";
  const auto said = [&](const char* mass) {
    const ScratchFolder folder;
    const auto c = read(folder, kInDegrees + "journal_mass = \"" + mass + "\"\n", rows);
    return std::any_of(c.assumptions.begin(), c.assumptions.end(), [](const std::string& s) {
      return s.find("1961 N, is no part of the load") != std::string::npos;
    });
  };
  CHECK(said("200 kg"));
  CHECK_FALSE(said("0.9 kg"));
}

TEST_CASE("ALoadThroughZeroNeedsAJournalsMass") {
  const std::string rows =
      "angle [deg], load_x [N], load_y [N]\n0, 0, -1000\n90, 0, -500\n180, 0, 900\n270,500,0\n";
  check_against(rows, {"load.csv:3:1", "at 90 deg the load vanishes", "load_cycle.journal_mass"});
  CHECK(cycle_of(kInDegrees + "journal_mass = \"1 kg\"\n", rows).journal_mass == 1.0);
  check_against(kRows, {"case.toml:21:16", "must not be negative"},
                kInDegrees + "journal_mass = \"-1 kg\"\n");
  check_against(kRows, {"case.toml:21:16", "a mass"}, kInDegrees + "journal_mass = \"1 mm\"\n");
}

TEST_CASE("ASplineHasAPeriodAndNoJumps") {
  check_against(kRows, {"case.toml:20:17", "needs a period"},
                "[load_cycle]\nfile = \"load.csv\"\ninterpolation = \"periodic_spline\"\n");
  check_against("angle [deg], load_x [N], load_y [N]\n0,0,-1\n90,0,-1\n90,0,-2\n",
                {"load.csv:4:1", "a spline is smooth", "linear"},
                kInDegrees + "interpolation = \"periodic_spline\"\n");
  check_against(kRows, {"case.toml:21:17", "did you mean \"linear\"?"},
                kInDegrees + "interpolation = \"linaer\"\n");
}

TEST_CASE("ALoadStandsInOnePlace") {
  const std::string text = sample_with("load = \"5 kN\"\n", "load = \"5 kN\"\n" + kInDegrees);
  check_parts(refusal(text), {"case.toml:17:8", "operation.load", "[load_cycle]", "keep one"});
  check_against(kRows, {"case.toml:18:1", "load_cycle.file", "missing"},
                "[load_cycle]\nperiod = \"360 deg\"\n");
  check_against(kRows, {"case.toml:21:1", "unknown key \"preiod\"", "did you mean \"period\"?"},
                kInDegrees + "preiod = \"1 deg\"\n");
  check_against(kRows, {"case.toml:21:9", "[crank], which is not given"},
                kInDegrees + "frame = \"rod\"\n");
}

TEST_CASE("CheckTellsWhatACycleComesTo") {
  const auto c = read_case(case_path("flores-slider-crank").string());
  std::ostringstream out;
  print_check(out, c);
  check_parts(out.str(), {"Load cycle", "720 deg", "60 ms", "2457 N", "at 630.66 deg", "180 deg",
                          "1.524 MPa", "2000 rpm", "0.2 kg", "it vanishes in between"});
  CHECK(out.str().find("heat in lumps; tier estimate") < out.str().find("Below: as if"));
}

TEST_CASE("CheckTellsOfAJournalThatDoesNotTurn") {
  const ScratchFolder folder;
  const auto c =
      read(folder, kInTime, "time [ms], load_x [N], load_y [N]\n0,0,-1000\n9,0,-2000\n", "0 rpm");
  std::ostringstream out;
  print_check(out, c);
  check_parts(out.str(), {"20 ms", "2000 N", "mean speed", "0 rpm"});
  CHECK(out.str().find("Petroff") == std::string::npos);
}

TEST_CASE("InitWritesTheTablesOfACaseBesideIt") {
  const ScratchFolder folder;
  std::ostringstream out;
  write_case("big-end", folder.path("a.toml"), out);
  check_parts(out.str(), {"big-end-pressure.csv written", "a.toml written"});
  CHECK(read_case(folder.path("a.toml")).cycle.has_value());
  CHECK_NOTHROW(write_case("big-end", folder.path("b.toml"), out));  // the same table serves
  folder.write("big-end-pressure.csv", "mine\n");
  CHECK_THROWS_AS(write_case("big-end", folder.path("c.toml"), out), FileError);
  CHECK_FALSE(std::filesystem::exists(folder.path("c.toml")));
}

TEST_CASE("WhatIsToldAtThePeriodsEndLiesOnIt") {
  // Angles over the speed and angles times its reciprocal differ by a last digit at every third
  // speed: 1150 rpm before the end, 1200 rpm behind it.
  for (const char* speed :
       {"600 rpm", "1150 rpm", "1200 rpm", "1550 rpm", "2300 rpm", "2400 rpm"}) {
    INFO(speed);
    const auto c = cycle_of(kInDegrees + "fields_at = [\"0 deg\", \"360 deg\"]\n", kRows, speed);
    REQUIRE(c.fields_at.size() == 2);
    CHECK(c.fields_at[1] == c.period);
  }
}

TEST_CASE("FieldsEndAtWhatSeparatesThoseOfTheFirstLine") {
  // Any of three was taken in every line: "0,5;1" under semicolons was 0 ms, 5 kN and 1 kN.
  const ScratchFolder folder;
  const std::string head = "angle [deg];load_x [kN];load_y [kN]";
  const std::string rows = "\n0;0.5;-1\n90;0.5;-2\n180;0;-3\n270;0;-2\n";
  const auto plain = read(folder, kInDegrees, head + rows);
  REQUIRE(plain.cycle);
  CHECK(plain.cycle->x[1] == 500.0);
  // A separator behind the last field, quotes and a column that is not meant.
  std::string more = "\"angle [deg]\";#remark;\"load_x [kN]\";load_y [kN];" + rows;
  for (const char* row : {"\n0;", "\n90;", "\n180;", "\n270;"}) {
    more.replace(more.find(row), std::string(row).size(), std::string(row) + "a word;");
  }
  more.insert(more.find("\n90"), ";");
  const auto read_so = read(folder, kInDegrees, more);
  CHECK(read_so.cycle->x == plain.cycle->x);
  CHECK(read_so.cycle->y == plain.cycle->y);
  check_against(head + "\n0;0.5;-1\n90,5;1;-2\n",
                {"load.csv:3:1", "90,5", "decimals after a point"});
  check_against(head + "\n0;0.5;-1\n0,5;1\n", {"load.csv:3:", "2 fields", "3 columns"});
}

TEST_CASE("OnlyItsVersionIsTheMarkOfATable") {
  const ScratchFolder folder;
  const std::string head = "angle [deg],load_x [kN],load_y [kN],shellback\n0,0,-1,0.2.0\n";
  const auto c = read(folder, kInDegrees, head + "90,0.5,-2,0.2.0\n180,0,-3,\n270,0,-2,0.2.0\n");
  CHECK(c.cycle->y[2] == -3000.0);
  check_against(head + "90,0,5,-2\n",
                {"load.csv:3:8", "4 fields", "3 columns"});  // 0.5 with a comma
}

TEST_CASE("WordsBesideTheNameOfAColumnBelongToIt") {
  const std::string rows = "0, 0, -1\n90, 0, -2\n";
  for (const std::string column : {"load_x per 10 [kN]", "load_x [kN] [N]", "load_x [kN] mean"}) {
    check_against("angle [deg], " + column + ", load_y [N]\n" + rows,
                  {"load.csv:1:14", "\"load_x ", "for example angle [deg]"});
  }
}

TEST_CASE("ATableOfOursMayHaveASeparatorBehindItsMarkAndQuotesWithOneInThem") {
  const ScratchFolder folder;
  const std::string head = "angle [deg],#remark,load_x [kN],load_y [kN],shellback,\n";
  const auto c =
      read(folder, kInDegrees,
           head + "0,\"a, b\",0,-1,0.2.0,\n90,c,0,-2,0.2.0,\n180,,0,-3,,\n270,,0,-2,0.2.0,\n");
  CHECK(c.cycle->y[2] == -3000.0);
  check_against("angle [deg],load_x [kN],load_y [kN]\n0;0;-1\n",
                {"load.csv:2:1", "1 fields", "end at \",\""});
  check_against("angle (deg), load_x [kN], load_y [kN]\n0,0,-1\n",
                {"load.csv:1:1", "\"angle (deg)\"", "brackets"});
}
