#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <sstream>

#include "app/pictures/svg_axes.hpp"
#include "app/pictures/svg_colour.hpp"
#include "app/pictures/svg_contour.hpp"
#include "app/pictures/svg_film.hpp"
#include "app/pictures/svg_lines.hpp"
#include "app/pictures/svg_waterfall.hpp"
#include "core/constants.hpp"
#include "core/make_grid.hpp"
#include "synthetic.hpp"

using namespace shellback;

namespace {

/// Loops of a path of M, L and Z.
std::vector<std::vector<app::Point>> loops(std::string path) {
  std::vector<std::vector<app::Point>> all;
  for (char& c : path) {
    if (c == 'L' || c == 'Z') c = ' ';
  }
  std::istringstream in(path);
  std::string part;
  while (std::getline(in, part, 'M')) {
    std::istringstream numbers(part);
    std::vector<app::Point> loop;
    for (app::Point p; numbers >> p.x >> p.y;) loop.push_back(p);
    if (!loop.empty()) all.push_back(loop);
  }
  return all;
}

/// Signed area: inner loops run the other way round and take away.
double area(const std::string& path) {
  double sum = 0.0;
  for (const auto& loop : loops(path)) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto& a = loop[k];
      const auto& b = loop[(k + 1) % loop.size()];
      sum += 0.5 * (a.x * b.y - b.x * a.y);
    }
  }
  return sum;
}

template <class F>
app::Surface sampled(int n, F f) {
  app::Surface s;
  for (int i = 0; i <= n; ++i) s.x.push_back(-1.0 + 2.0 * i / n);
  s.y = s.x;
  for (const double x : s.x) {
    for (const double y : s.y) s.value.push_back(f(x, y));
  }
  return s;
}

/// Large, so that the printed tenth of a pixel does not matter.
constexpr double kScale = 1e4;
app::Point enlarged(double x, double y) { return {kScale * x, kScale * y}; }

/// OKLab lightness of "#rrggbb", by the forward matrices (textbook).
double lightness(const std::string& colour) {
  const auto linear = [&](int k) {
    const double v = std::stoi(colour.substr(1 + 2 * k, 2), nullptr, 16) / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const double r = linear(0);
  const double g = linear(1);
  const double b = linear(2);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
}

}  // namespace

TEST_CASE("ContourOfAConeEnclosesItsCircleToSecondOrder") {
  // {1 - r >= 0.4} is the disc of radius 0.6; chords of linear interpolation: second order.
  const auto error = [](int n) {
    const auto s = sampled(n, [](double x, double y) { return 1.0 - std::hypot(x, y); });
    return std::abs(area(app::superlevel_path(s, 0.4, enlarged)) / (kScale * kScale) - kPi * 0.36);
  };
  const double order = std::log2(error(20) / error(80)) / 2.0;
  CHECK(order == Approx(2.0).margin(0.3));  // single points of the fit scatter with the grid
  CHECK(error(80) < 1e-3 * kPi * 0.36);
}

TEST_CASE("AContourWithAHoleIsARing") {
  // {0.04 - (r - 0.5)^2 >= 0}: the ring from 0.3 to 0.7.
  const auto s = sampled(120, [](double x, double y) {
    const double d = std::hypot(x, y) - 0.5;
    return 0.04 - d * d;
  });
  const std::string path = app::superlevel_path(s, 0.0, enlarged);
  CHECK(loops(path).size() == 2);
  // Chords on 120 intervals: a relative error of some 1e-3.
  CHECK(area(path) / (kScale * kScale) == Approx(kPi * (0.49 - 0.09)).epsilon(3e-3));
}

TEST_CASE("TheSidesCloseAContour") {
  const auto s = sampled(10, [](double x, double) { return x; });
  CHECK(area(app::superlevel_path(s, -1.0, enlarged)) / (kScale * kScale) == Approx(4.0));
  // Linear fields are exact: {x >= 0.25} is 0.75 wide and 2 high.
  CHECK(area(app::superlevel_path(s, 0.25, enlarged)) / (kScale * kScale) == Approx(1.5));
  CHECK(app::superlevel_path(s, 1.5, enlarged).empty());
}

TEST_CASE("HigherLevelsEncloseLess") {
  const auto s = sampled(40, [](double x, double y) { return std::sin(3 * x) * std::cos(5 * y); });
  double before = 4.1 * kScale * kScale;
  for (double level = -1.0; level < 1.0; level += 0.1) {
    const double now = area(app::superlevel_path(s, level, enlarged));
    CHECK(now < before);
    before = now;
  }
}

TEST_CASE("TheUnrolledFieldIsPeriodicAndCoversTheBearing") {
  const auto grid = make_grid(0.025, 0.02, 36, 9, false);
  Field field;
  for (int i = 0; i < grid.nt; ++i) {
    for (int j = 0; j < grid.nz; ++j) field.push_back(std::cos(grid.phi[i]) + 50.0 * grid.z[j]);
  }
  const auto s = app::unrolled(grid, field);
  CHECK(s.x.front() == 0.0);
  CHECK(s.x.back() == 360.0);
  CHECK(s.y.front() == Approx(-10.0));
  CHECK(s.y.back() == Approx(10.0));
  CHECK(std::is_sorted(s.x.begin(), s.x.end()));
  for (int j = 0; j < static_cast<int>(s.y.size()); ++j) {
    CHECK(s.at(0, j) == Approx(s.at(static_cast<int>(s.x.size()) - 1, j)));
  }
  // A field that is linear in z is continued to the rim, within the range of its values.
  const int mid = static_cast<int>(s.x.size()) / 4;
  CHECK(s.at(mid, 0) < s.at(mid, 1));
}

TEST_CASE("ColourStepsAreEqualStepsOfLightness") {
  for (const auto& map : {app::kCool, app::kWarm}) {
    for (int k = 0; k <= 20; ++k) {
      const double t = k / 20.0;
      const double wanted = map.dark + t * (map.light - map.dark);
      // Eight bits a channel resolve lightness to about 0.004.
      CHECK(lightness(app::colour_at(map, t)) == Approx(wanted).margin(0.006));
    }
  }
}

TEST_CASE("RoundAxesEncloseTheDataWithTicksOfOneTwoOrFive") {
  for (const auto& [low, high] :
       {std::pair{0.0, 59.6}, {98.3, 124.1}, {-3e-4, 7e-4}, {5.0, 5.0}, {0.0, 0.0}, {-1e6, -9e5}}) {
    const auto axis = app::round_axis(low, high, 6, "");
    CHECK(axis.low <= low + 1e-9 * std::abs(low));
    CHECK(axis.high >= high - 1e-9 * std::abs(high));
    REQUIRE(axis.ticks.size() >= 2);
    CHECK(axis.ticks.size() <= 9);
    const double step = axis.ticks[1] - axis.ticks[0];
    const double digit = step / std::pow(10.0, std::floor(std::log10(step * (1 + 1e-9))));
    const bool is_round =
        std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6;
    CHECK(is_round);
  }
  CHECK(app::degree_axis().ticks.size() == 9);
}

TEST_CASE("LabelsOfALogarithmicAxisDoNotRunIntoEachOther") {
  const auto labels = [](double width) {
    app::Svg svg(width, 200.0);
    const app::Frame frame{{50.0, 20.0, width - 60.0, 140.0},
                           app::log_axis(30.0, 3000.0, "time [s]"),
                           app::round_axis(0.0, 1.0, 5, "")};
    app::draw_axes(svg, frame, app::Theme{}, app::GridLines::none);
    const std::string picture = svg.document("");
    return std::pair{picture.find(">1000<") != std::string::npos,
                     picture.find(">2000<") != std::string::npos};
  };
  CHECK(labels(1000.0) == std::pair{true, true});
  const auto [thousand, two_thousand] = labels(200.0);
  CHECK(thousand != two_thousand);  // 21 px apart, each 24 px wide: one gives way
}

TEST_CASE("ABandCoversItsBarsWhereverItsLineGoes") {
  // A run-up and its run-down: what lies over it twice is shaded, too. A frame of 1000 px for x
  // from 0 to 4 and y from 0 to 2; bars of 0.5 over two speeds are half of it times 250 px a unit.
  app::Svg svg(2000.0, 2000.0);
  app::LinePlot plot;
  plot.x = app::round_axis(0.0, 4.0, 5, "");
  plot.y = app::round_axis(0.0, 2.0, 5, "");
  plot.series.push_back({"", {3.0, 1.0, 3.0}, {1.0, 1.0, 1.0}, "#123456", "", {0.5, 0.5, 0.5}});
  const app::Frame frame =
      app::draw_lines(svg, {0.0, 0.0, 1068.0, 1082.0}, plot, app::print_theme());
  const std::string text = svg.document("");
  const std::size_t end = text.find("\" fill=\"#123456\" fill-opacity");
  REQUIRE(end != std::string::npos);
  const std::size_t begin = text.rfind("d=\"", end) + 3;
  const double once = 0.5 * frame.box.width * 0.5 * frame.box.height;
  CHECK(std::abs(area(text.substr(begin, end - begin))) == Approx(2.0 * once).epsilon(1e-3));
}

TEST_CASE("TheWaterfallLeadsFromOneTorqueToTheOther") {
  const auto split = test::synthetic_comparison().split;
  const auto bars = app::waterfall_bars(split);
  REQUIRE(bars.size() == split.steps.size() + 2);
  CHECK(bars.front().end == split.from);
  CHECK(bars.back().end == split.to);
  for (std::size_t k = 1; k + 1 < bars.size(); ++k) {
    CHECK(bars[k].begin == bars[k - 1].end);
    CHECK(bars[k].end - bars[k].begin == Approx(split.steps[k - 1].change));
  }
  // The last step ends at the full torque, but for round-off of the sum.
  CHECK(bars[bars.size() - 2].end == Approx(split.to).epsilon(1e-12));
}

TEST_CASE("FrictionOfAJournalThatTurnsClockwiseIsSplitAsThatOfItsMirrorImage") {
  const bearing::FrictionSplit split{1.0, 1.02, {{"viscosity level", 0.12}, {"rest", -0.10}}};
  const bearing::FrictionSplit mirror{-1.0, -1.02, {{"viscosity level", -0.12}, {"rest", 0.10}}};
  const auto drawn = [](const bearing::FrictionSplit& s, const std::optional<double>& measured) {
    app::Svg svg(580.0, 300.0);
    app::draw_waterfall(svg, {0.0, 0.0, 580.0, 300.0}, s, measured, app::print_theme());
    return svg.document("");
  };
  CHECK(drawn(mirror, {}) == drawn(split, {}));
  CHECK(drawn(mirror, -1.1) == drawn(split, 1.1));
}

TEST_CASE("AWaterfallThatDoesNotAddUpShowsTheRest") {
  auto split = test::synthetic_comparison().split;
  split.steps.pop_back();
  const auto bars = app::waterfall_bars(split);
  const auto& rest = bars[bars.size() - 2];
  CHECK(rest.name == "not accounted for");
  CHECK(rest.end == split.to);
}

TEST_CASE("SupplyOutlinesHaveTheSizeOfTheFeature") {
  bearing::Supply groove;
  groove.kind = bearing::SupplyKind::axial_groove;
  groove.angle = kPi / 2;
  groove.arc = kPi / 10;
  groove.length = 12e-3;
  groove.z = 1e-3;
  const auto outline = app::supply_outline(groove, 0.025);
  CHECK(outline[0].x == Approx(81.0));
  CHECK(outline[1].x == Approx(99.0));
  CHECK(outline[0].y == Approx(-5.0));
  CHECK(outline[2].y == Approx(7.0));
  bearing::Supply hole;
  hole.diameter = 5e-3;
  for (const auto& p : app::supply_outline(hole, 0.025)) {
    const double x = p.x * kPi / 180.0 * 25.0;  // [mm]
    CHECK(std::hypot(x, p.y) == Approx(2.5));
  }
}

TEST_CASE("AFeatureAcrossTheSeamIsDrawnOnBothSides") {
  auto c = test::synthetic_case();
  c.supplies[0].angle = 0.0;
  const auto result = test::synthetic_result();
  const auto scale = app::common_scale({&result}, app::FilmField::pressure);
  const auto map = app::film_map(c, result, app::FilmField::pressure, scale, "");
  CHECK(map.outlines.size() == 2);
  c.supplies[0].angle = -kPi / 2;  // any branch of the angle
  CHECK(app::film_map(c, result, app::FilmField::pressure, scale, "").outlines.size() == 1);
}

TEST_CASE("MidWidthLineIsInterpolatedToThePlaneOfSymmetry") {
  for (const int nz : {24, 25}) {
    bearing::Result result;
    result.fields.grid = make_grid(0.025, 0.02, 40, nz, false);
    const auto& grid = result.fields.grid;
    Field field;
    for (int i = 0; i < grid.nt; ++i) {
      for (int j = 0; j < nz; ++j) field.push_back(i + 100.0 * grid.z[j]);  // linear: exact
    }
    const auto line = app::mid_line(result, field, {}, false);
    for (int i = 0; i < grid.nt; ++i) CHECK(line.y[i] == Approx(i).margin(1e-12));
  }
}

TEST_CASE("BesideAGrooveAllRoundTheLineLiesOnALand") {
  for (const int nz : {24, 25}) {
    bearing::Result result;
    auto& f = result.fields;
    f.grid = make_grid(0.025, 0.02, 40, nz, false);
    Field field;
    double edge = 0.0;  // of the groove [m]
    for (int i = 0; i < f.grid.nt; ++i) {
      for (int j = 0; j < nz; ++j) {
        const bool groove = std::abs(f.grid.z[j]) < 0.003;
        if (groove) edge = std::max(edge, f.grid.z_face[j + 1]);
        f.supplied.push_back(groove ? 1 : 0);
        field.push_back(100.0 * f.grid.z[j]);
      }
    }
    const auto line = app::mid_line(result, field, {}, true);
    for (const double y : line.y) CHECK(y == Approx(50.0 * (edge + 0.01)).epsilon(1e-12));
    CHECK(app::words_of_mid_line(result).starts_with("midway on a land, z = 6."));
    for (int j = 0; j < nz; ++j) f.supplied[f.grid.index(0, j)] = 0;  // no longer all round
    CHECK(app::words_of_mid_line(result) == "at mid-width");
  }
}

TEST_CASE("LongLinesEndWithAnEllipsisWithinTheirWidth", "[svg]") {
  const std::string words = "shell.layers = [{ material = \"AlSn20\", thickness = \"0,3 µm\" }]";
  CHECK(app::fitted_to(words, 12.0, 2000.0) == words);
  for (const double width : {60.0, 200.0, 300.0}) {
    const std::string cut = app::fitted_to(words, 12.0, width);
    CHECK(app::text_width(cut, 12.0) <= width);
    CHECK(app::text_width(cut, 12.0) > width - 2.0 * app::text_width("w", 12.0));
    CHECK(cut.ends_with("…"));
    CHECK(words.starts_with(cut.substr(0, cut.size() - 3)));  // no letter is cut in two
  }
}
