// A height map is read as it is written, or refused with its place and a cure.
#include <fmt/format.h>

#include <random>

#include "app/reading/read_height_map.hpp"
#include "app/reading/surface_report.hpp"
#include "surface/gaussian_surface.hpp"
#include "tests/app/sample_case.hpp"

using namespace shellback;
using namespace shellback::app;

namespace {

/// 8 rows of 9 heights, row j from the top: 10 j + i.
std::string rows(const char* separator = "\t") {
  std::string text;
  for (int j = 0; j < 8; ++j) {
    for (int i = 0; i < 9; ++i) text += fmt::format("{}{}", i == 0 ? "" : separator, 10 * j + i);
    text += "\n";
  }
  return text;
}

const std::string kHeader =
    "# Channel: Topography\n# Width: 18 µm\n# Height: 4.0 um\n# Value units: nm\n";

std::string columns() {
  std::string text = "y [um], x [mm], z [nm]\n";
  for (int j = 0; j < 8; ++j) {
    for (int i = 0; i < 9; ++i) text += fmt::format("{}, {}, {}\n", 0.5 * j, 0.002 * i, 10 * j + i);
  }
  return text;
}

std::string map_refusal(const std::string& text) {
  const ScratchFolder scratch;
  try {
    static_cast<void>(read_height_map(scratch.write("map.txt", text), Motion::x));
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

void check_words(const std::string& said, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    INFO(said);
    CHECK(said.find(part) != std::string::npos);
  }
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string report_refusal(const SurfaceOptions& options) {
  try {
    static_cast<void>(describe_surface(options));
  } catch (const InputError& error) {
    return error.what();
  }
  return "described";
}

/// As a matrix with a pitch, in nm.
std::string written(const surface::HeightMap& map) {
  std::string text = fmt::format("# Pitch: {} um\n# Value units: nm\n", 1e6 * map.dx);
  for (int j = map.ny - 1; j >= 0; --j) {
    for (int i = 0; i < map.nx; ++i) text += fmt::format("{:.1f} ", 1e9 * map.at(i, j));
    text += "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("AMatrixOfGwyddionIsReadFromItsTop") {
  const ScratchFolder scratch;
  for (const char* separator : {"\t", ", ", ";", "  "}) {
    const auto map =
        read_height_map(scratch.write("map.txt", kHeader + rows(separator)), Motion::x);
    REQUIRE((map.nx == 9 && map.ny == 8));
    CHECK(map.dx == Approx(2e-6).epsilon(1e-12));
    CHECK(map.dy == Approx(0.5e-6).epsilon(1e-12));
    CHECK(map.at(0, 7) == Approx(0.0).margin(1e-20));
    CHECK(map.at(3, 6) == Approx(13e-9).epsilon(1e-12));
    CHECK(map.at(8, 0) == Approx(78e-9).epsilon(1e-12));
  }
}

TEST_CASE("PointsInColumnsAreTheSameMapInAnyOrder") {
  const ScratchFolder scratch;
  const auto map = read_height_map(scratch.write("map.csv", columns()), Motion::x);
  REQUIRE((map.nx == 9 && map.ny == 8));
  CHECK(map.dx == Approx(2e-6).epsilon(1e-12));
  CHECK(map.at(3, 1) == Approx(13e-9).epsilon(1e-12));
  const std::string gone = changed(columns(), "1, 0.004, 22\n", "");
  const auto holed = read_height_map(scratch.write("map.csv", gone), Motion::x);
  CHECK(std::isnan(holed.at(2, 2)));
  const auto turned = read_height_map(scratch.write("map.csv", columns()), Motion::y);
  CHECK((turned.nx == 8 && turned.at(1, 3) == map.at(3, 1)));
}

TEST_CASE("PositionsOfAStageScatterAboutTheirLines") {
  // By up to 2 % of a pitch; a row is missing, and some points.
  const ScratchFolder scratch;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> off(-0.02, 0.02);
  std::string text = "x [um], y [um], z [nm]\n";
  for (int j = 0; j < 20; ++j) {
    for (int i = 0; i < 30; ++i) {
      if (j == 7 || (i == 4 && j == 3)) continue;
      text +=
          fmt::format("{}, {}, {}\n", 2.0 * (i + off(random)), 0.5 * (j + off(random)), 10 * j + i);
    }
  }
  const auto map = read_height_map(scratch.write("map.csv", text), Motion::x);
  REQUIRE((map.nx == 30 && map.ny == 20));
  CHECK(map.dx == Approx(2e-6).epsilon(0.02 / 29.0 * 2.0));
  CHECK(map.at(3, 1) == Approx(13e-9).epsilon(1e-12));
  CHECK(std::isnan(map.at(5, 7)));
  CHECK(std::isnan(map.at(4, 3)));
  CHECK(surface::holes_of(map).count == 31);
}

TEST_CASE("StripesOfExactColumnsAreOneMap") {
  const ScratchFolder scratch;
  std::string text = "x [um], y [um], z [nm]\n";
  for (int i = 0; i < 200; ++i) {
    if (i % 20 >= 14) continue;  // nine gaps of seven pitches
    for (int j = 0; j < 8; ++j) text += fmt::format("{}, {}, {}\n", 2 * i, j, (7 * i + 3 * j) % 11);
  }
  const auto map = read_height_map(scratch.write("map.csv", text), Motion::x);
  CHECK(map.nx == 194);
  CHECK(map.dx == Approx(2e-6).epsilon(1e-12));
}

TEST_CASE("PlacesOfAMapAreThoseOfItsFile") {
  const ScratchFolder scratch;
  std::string text = "x [um], y [um], z [nm]\n";
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 10; ++i) {
      const std::string z = i == 6 && j == 2 ? "nan" : fmt::format("{}", (7 * i + 3 * j) % 11);
      text += fmt::format("{}, {}, {}\n", 100 + 2 * i, 40 + j, z);
    }
  }
  SurfaceOptions options;
  options.path = scratch.write("map.csv", text);
  for (const Motion motion : {Motion::x, Motion::y}) {
    options.motion = motion;
    check_words(report_refusal(options), {"x = 112 um, y = 42 um"});
  }
}

TEST_CASE("AMarkBehindEveryRowIsNoColumn") {
  const ScratchFolder scratch;
  std::string text = rows();
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.insert(at, "\t");
  const auto map = read_height_map(scratch.write("map.txt", kHeader + text), Motion::x);
  REQUIRE((map.nx == 9 && map.ny == 8));
  CHECK(map.dx == Approx(2e-6).epsilon(1e-12));
  CHECK(surface::holes_of(map).count == 0);
}

TEST_CASE("HolesAreEmptyOrNamed") {
  const ScratchFolder scratch;
  for (const char* hole : {"", "nan", "NaN", "bad", "BAD"}) {
    const std::string text = kHeader + changed(rows(), "\t33\t", fmt::format("\t{}\t", hole));
    const auto map = read_height_map(scratch.write("map.txt", text), Motion::x);
    CHECK(std::isnan(map.at(3, 4)));
    CHECK(surface::holes_of(map).count == 1);
  }
}

TEST_CASE("WrongOrMissingUnitsOfAMapAreRefusedAtTheirLine") {
  check_words(map_refusal(changed(kHeader, "# Value units: nm\n", "") + rows()),
              {"map.txt:4:1", "no unit of the heights", "# Value units: nm"});
  check_words(map_refusal(changed(kHeader, ": nm", ": V") + rows()),
              {"map.txt:4:1", "Value units"});
  check_words(map_refusal(changed(kHeader, ": nm", ": Pa") + rows()), {"map.txt:4:1", "a length"});
  check_words(map_refusal(changed(kHeader, "18 µm", "18") + rows()),
              {"map.txt:2:1", "Width", "no unit"});
  check_words(map_refusal(changed(kHeader, "# Height: 4.0 um\n", "") + rows()),
              {"map.txt:4:1", "no Height", "# Pitch"});
  check_words(map_refusal("# Pitch: 1 um\n" + kHeader + rows()), {"map.txt:1:1", "keep one"});
  check_words(map_refusal(changed(columns(), "z [nm]", "z")), {"map.txt:1:17", "names no unit"});
  check_words(map_refusal(changed(columns(), "z [nm]", "z [s]")), {"map.txt:1:17", "a length"});
  check_words(map_refusal(changed(columns(), "z [nm]", "q [nm]")), {"not known", "x [um]"});
}

TEST_CASE("AHeaderValueThatIsGivenTwiceIsRefusedAtItsSecondLine") {
  check_words(map_refusal("# width: 192 um\n" + kHeader + rows()),
              {"map.txt:3:1", "Width is given in line 1 already", "keep one"});
  check_words(map_refusal(kHeader + "# Value units: um\n" + rows()),
              {"map.txt:5:1", "Value units is given in line 4 already"});
  check_words(map_refusal("# Channel: Topography\n" + kHeader + rows()), {"read"});
}

TEST_CASE("AMapThatIsNoGridIsRefusedAtItsLine") {
  check_words(map_refusal(kHeader + changed(rows(), "\t33\t", "\t")),
              {"map.txt:8:", "8 heights", "the first one has 9"});
  check_words(map_refusal(kHeader + changed(rows(), "33", "3x3")), {"map.txt:8:", "no height"});
  check_words(map_refusal(kHeader + changed(rows(), "33", "1e999")), {"no height"});
  check_words(map_refusal(kHeader + changed(rows(), "33", "3,3")),
              {"map.txt:8:", "\"3,3\"", "decimals after a point"});
  check_words(map_refusal(changed(columns(), "1, 0.004, 22", "1, 0.0045, 22")), {"resample"});
  check_words(map_refusal(columns() + "0, 0, 3\n"), {"map.txt:74:1", "given before"});
  check_words(map_refusal(changed(columns(), "1, 0.004, 22", "1, 22")), {"2 fields"});
  check_words(map_refusal("# Pitch: 1 um\n# Value units: um\n1 2\n3 4\n"), {"2 x 2", "8 or more"});
  check_words(map_refusal("# nothing\n"), {"no heights"});
}

TEST_CASE("HolesAreRefusedWithCountAndPlaceUnlessTheyAreToBeFilled") {
  const ScratchFolder scratch;
  surface::HeightMap map = surface::gaussian_surface({90, 80, 1e-6, 1e-6, 2e-7, 5e-6, 5e-6});
  for (int i = 20; i < 30; ++i) map.z[map.index(i, 40)] = NAN;
  SurfaceOptions options;
  options.path = scratch.write("map.txt", written(map));
  options.gaps = {1.0, 2.0, 4.0};
  check_words(report_refusal(options),
              {"map.txt", "10 of 7200", "x = 20 um, y = 40 um", "--fill laplace"});
  options.fill = true;
  const SurfaceReport report = describe_surface(options);
  CHECK(report.holes.count == 10);
  CHECK(surface::holes_of(report.map).count == 0);
  CHECK(report.notes.size() > 0);
  for (std::size_t c = 0; c < 1000; ++c) map.z[c] = NAN;
  options.path = scratch.write("map.txt", written(map));
  check_words(report_refusal(options), {"more than the 10 %"});
  for (double& z : map.z) z = NAN;
  options.path = scratch.write("map.txt", written(map));
  check_words(report_refusal(options), {"7200 of 7200 heights (100 %)"});
}

TEST_CASE("APatchTooSmallIsRefusedWithTheSizeThatWouldDo") {
  const ScratchFolder scratch;
  const auto map = surface::gaussian_surface({60, 50, 1e-6, 1e-6, 2e-7, 10e-6, 10e-6});
  SurfaceOptions options;
  options.path = scratch.write("map.txt", written(map));
  options.gaps = {1.0, 2.0, 4.0};
  options.form = 1;
  check_words(report_refusal(options),
              {"60 x 50 um", "too small", "10.6 correlation lengths", "10 % is allowed"});
  options.error = 0.9;
  CHECK(report_refusal(options) == "described");
}

TEST_CASE("APointThatNoSurfaceHasIsToldWithItsPlace") {
  const ScratchFolder scratch;
  auto map = surface::gaussian_surface({200, 160, 1e-6, 1e-6, 2e-7, 5e-6, 5e-6});
  SurfaceOptions options;
  options.gaps = {1.0, 2.0, 4.0};
  options.form = 1;
  options.path = scratch.write("map.txt", written(map));
  for (const std::string& note : describe_surface(options).notes) {
    CHECK(note.find("stands out") == std::string::npos);
  }
  map.z[map.index(70, 40)] = 10e-6;  // fifty times its Rq
  options.path = scratch.write("map.txt", written(map));
  check_words(report_refusal(options), {"a point stands out", "x = 70 um", "y = 40 um", "--fill"});
  map.z[map.index(70, 40)] = 500e-6;  // so that the slopes, too, are those of no surface
  options.path = scratch.write("steep.txt", written(map));
  check_words(report_refusal(options), {"steeper", "a point stands out", "x = 70 um"});
  map.z[map.index(70, 40)] = 10e-6;
  options.path = scratch.write("map.txt", written(map));
  options.error = 0.9;
  const SurfaceReport r = describe_surface(options);
  CHECK(std::any_of(r.notes.begin(), r.notes.end(), [](const std::string& note) {
    return note.find("stands out") != std::string::npos;
  }));
}

TEST_CASE("APlateauIsNoGaussianSurfaceHoweverSmoothItIs") {
  // A Gaussian surface cut off at its mean plane, as honing does, with what is left of it on top:
  // its summits all lie within this of one plane, where two such surfaces meet.
  const ScratchFolder scratch;
  const auto valleys = surface::gaussian_surface({160, 160, 1e-6, 1e-6, 4e-7, 8e-6, 8e-6});
  const auto told = [&](double left, bool cut) {
    auto map = surface::gaussian_surface(
        {160, 160, 1e-6, 1e-6, left, 3e-6, 3e-6, surface::CorrelationShape::smooth, 7});
    for (std::size_t k = 0; k < map.z.size(); ++k) {
      map.z[k] += cut ? std::min(valleys.z[k], 0.0) : valleys.z[k];
    }
    SurfaceOptions options;
    options.gaps = {3.0, 4.0};
    options.error = 0.9;
    options.path = scratch.write("map.txt", written(map));
    const auto notes = describe_surface(options).notes;
    return std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
      return note.find("apart by a factor") != std::string::npos;
    });
  };
  for (const double left : {40e-9, 20e-9, 5e-9}) {
    INFO(left);
    CHECK(told(left, true));
    CHECK_FALSE(told(left, false));
  }
}

TEST_CASE("AFlatMapHasNoRoughness") {
  const ScratchFolder scratch;
  std::string text = "# Pitch: 1 um\n# Value units: um\n";
  for (int j = 0; j < 10; ++j) text += "0 0 0 0 0 0 0 0 0 0\n";
  SurfaceOptions options;
  options.path = scratch.write("map.txt", text);
  check_words(report_refusal(options), {"no roughness"});
}

TEST_CASE("ASurfaceHasALayWhereItIsLongerOneWayThanAnother") {
  const auto lay = [](surface::CorrelationLength longest, surface::CorrelationLength shortest) {
    surface::Correlation c;
    c.longest = longest;
    c.shortest = shortest;
    return has_lay(c);
  };
  CHECK(lay({3e-5}, {1e-5}));
  CHECK_FALSE(lay({1.2e-5}, {1e-5}));
  CHECK(lay({1.2e-5, true}, {1e-5}));            // at least so long
  CHECK_FALSE(lay({1e-5, true}, {1e-5, true}));  // longer than the patch to all sides
}
