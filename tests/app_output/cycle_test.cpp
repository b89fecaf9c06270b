#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/labels/cycle_shown.hpp"
#include "app/pictures/svg_cycle.hpp"
#include "app/pictures/svg_cycle_frames.hpp"
#include "app/pictures/svg_orbit.hpp"
#include "app/write_cycle_html.hpp"
#include "app/write_cycle_json.hpp"
#include "app/write_cycle_table.hpp"
#include "app/write_json.hpp"
#include "core/constants.hpp"
#include "markup.hpp"
#include "synthetic_cycle.hpp"
#include "tests/contains.hpp"

using namespace shellback;
using nlohmann::json;
using test::contains;

namespace {

json read_back(const bearing::CycleResult& cycle) {
  return json::parse(app::cycle_json(test::cycle_case(), cycle));
}

std::string table(const bearing::CycleResult& cycle) {
  std::ostringstream out;
  app::write_cycle_table(out, test::cycle_case(), cycle);
  return out.str();
}

/// All numbers of a path of M and L.
std::vector<app::Point> points(std::string path) {
  for (char& c : path) {
    if (c == 'M' || c == 'L' || c == 'Z') c = ' ';
  }
  std::istringstream in(path);
  std::vector<app::Point> all;
  for (app::Point p; in >> p.x >> p.y;) all.push_back(p);
  return all;
}

/// The longest path without filling: the journal's.
std::vector<app::Point> longest_line(const std::string& svg) {
  std::vector<app::Point> longest;
  for (std::size_t at = svg.find("<path d=\""); at != std::string::npos;
       at = svg.find("<path d=\"", at + 1)) {
    const std::size_t begin = at + 9;
    const std::size_t end = svg.find('"', begin);
    if (svg.compare(end, 13, "\" fill=\"none\"") != 0) continue;
    auto line = points(svg.substr(begin, end - begin));
    if (line.size() > longest.size()) longest = std::move(line);
  }
  return longest;
}

}  // namespace

TEST_CASE("ACycleTellsWhetherItsBarsMeetWhatWasAsked") {
  bearing::Case c = test::cycle_case();
  for (const double asked : {0.1, 0.001}) {  // bars of grid and steps: 1.2 % together
    c.model.tolerance = asked;
    const auto told = json::parse(app::cycle_json(c, test::synthetic_cycle()))["tolerance"];
    CHECK(told["asked"] == asked);
    CHECK(told["met"] == (asked > 0.012));
    CHECK(told["h_min"].get<double>() == Approx(0.012).epsilon(1e-6));
  }
}

TEST_CASE("ACycleHasTheBindingKeys") {
  const auto j = read_back(test::synthetic_cycle());
  for (const char* key :
       {"status", "converged", "tier", "title", "quantities", "audit", "cycle", "limiters",
        "warnings", "assumptions", "grid", "cost", "provenance", "case", "changes"}) {
    INFO(key);
    CHECK(j.contains(key));
  }
  CHECK(j["status"] == "converged");
  CHECK_FALSE(j.contains("reason"));
  for (const char* key : {"mass", "impulse", "load"}) CHECK(j["audit"].contains(key));
  for (const char* key : {"angle",
                          "h_min",
                          "eccentricity_x",
                          "eccentricity_y",
                          "p_max",
                          "friction_torque",
                          "friction_torque_asperity",
                          "power_loss",
                          "load_x",
                          "load_y",
                          "speed",
                          "supply_flow",
                          "side_flow",
                          "tilt_x",
                          "tilt_y",
                          "closure",
                          "cycles",
                          "steps",
                          "rejected_steps",
                          "period"}) {
    INFO(key);
    CHECK(j["cycle"].contains(key));
  }
  CHECK(j["cycle"]["period"]["unit"] == "s");
  CHECK_FALSE(j["cycle"].contains("time"));
  CHECK_FALSE(j["cycle"].contains("T_film_max"));  // the tier does not know it
}

TEST_CASE("AllSeriesOfACycleAreAsLong") {
  const auto cycle = test::synthetic_cycle();
  const auto j = read_back(cycle);
  int series = 0;
  for (const auto& [name, entry] : j["cycle"].items()) {
    if (!entry.is_object() || !entry.contains("values")) continue;
    INFO(name);
    CHECK(entry["values"].size() == cycle.instants.size());
    CHECK(entry["unit"].is_string());
    ++series;
  }
  CHECK(series > 15);
}

TEST_CASE("InstantsAreToldAsCrankAnglesIfThereIsACrank") {
  const auto cycle = test::synthetic_cycle();
  const auto j = read_back(cycle);
  const double degrees = cycle.crank_speed * 180.0 / kPi;
  const auto& angle = j["cycle"]["angle"];
  CHECK(angle["unit"] == "deg");
  for (std::size_t k = 0; k < cycle.instants.size(); ++k) {
    CHECK(angle["values"][k].get<double>() == Approx(cycle.instants[k].t * degrees));
  }
  CHECK(angle["values"].back().get<double>() == Approx(720.0));
  for (const auto& q : cycle.quantities) {
    const auto& read = j["quantities"][q.quantity.name];
    CHECK(read.contains("at") == std::isfinite(q.at));
    if (!std::isfinite(q.at)) continue;
    CHECK(read["at"]["unit"] == "deg");
    CHECK(read["at"]["value"].get<double>() == Approx(q.at * degrees));
  }
}

TEST_CASE("AndAsTimesIfThereIsNone") {
  const auto cycle = test::timed_cycle();
  const auto j = read_back(cycle);
  CHECK_FALSE(j["cycle"].contains("angle"));
  CHECK(j["cycle"]["time"]["unit"] == "s");
  CHECK(j["cycle"]["time"]["values"].back().get<double>() == cycle.instants.back().t);
  CHECK(j["quantities"]["h_min"]["at"]["unit"] == "s");
}

TEST_CASE("BarsOfACycleAddUpGridAndTimeSteps") {
  const auto cycle = test::synthetic_cycle();
  const auto j = read_back(cycle);
  const auto& h = j["quantities"]["h_min"];
  CHECK(h["error"].get<double>() ==
        Approx(h["error_grid"].get<double>() + h["error_time"].get<double>()));
  CHECK_FALSE(j["quantities"]["friction_torque"].contains("error"));
}

TEST_CASE("ACycleToldAsOneResultKeepsTheBarOfItsSteps") {
  const auto cycle = test::synthetic_cycle();
  const bearing::Result r = bearing::as_result(cycle);
  REQUIRE(r.quantities.size() == cycle.quantities.size());
  const auto j = json::parse(app::result_json(test::cycle_case(), r))["quantities"];
  int bars = 0;
  for (std::size_t k = 0; k < r.quantities.size(); ++k) {
    const bearing::CycleQuantity& of = cycle.quantities[k];
    if (!std::isfinite(of.quantity.error_grid) || !(of.quantity.error_time > 0.0)) continue;
    ++bars;
    const auto told = j[of.quantity.name];
    CHECK(told["error_grid"].get<double>() == of.quantity.error_grid);
    CHECK(told["error_time"].get<double>() == of.quantity.error_time);
    const double physics = told.contains("error_model") ? told["error_model"].get<double>() : 0.0;
    CHECK(told["error"].get<double>() ==
          Approx(of.quantity.error_grid + of.quantity.error_time + physics).epsilon(1e-12));
  }
  CHECK(bars > 0);
}

TEST_CASE("ExtremesInTheQuantitiesAreThoseOfTheSeries") {
  const auto j = read_back(test::synthetic_cycle());
  const auto values = j["cycle"]["h_min"]["values"].get<std::vector<double>>();
  const auto angles = j["cycle"]["angle"]["values"].get<std::vector<double>>();
  const auto least = std::min_element(values.begin(), values.end());
  CHECK(j["quantities"]["h_min"]["value"].get<double>() == *least);
  CHECK(j["quantities"]["h_min"]["at"]["value"].get<double>() == angles[least - values.begin()]);
}

TEST_CASE("AStoppedCycleKeepsWhatWasFound") {
  const auto cycle = test::stopped_cycle();
  const auto j = read_back(cycle);
  CHECK(j["status"] == "iteration limit");
  for (const char* key : {"reason", "place", "cure"}) CHECK(!j[key].get<std::string>().empty());
  CHECK(j["cycle"]["h_min"]["values"].size() == 3);
  CHECK(j["cycle"]["closure"].is_null());
  const std::string printed = table(cycle);
  for (const char* part : {"NOT CONVERGED", "no step in time is found at 0.0312 s", "phi 301.9 deg",
                           "more oil out of a cell", "a lower load"}) {
    CHECK(contains(printed, part));
  }
  CHECK(test::unbalanced_tag(app::cycle_svg(test::cycle_case(), cycle)) == "");
  const std::string html = app::cycle_html(test::cycle_case(), cycle);
  CHECK(contains(html, "no step in time is found"));
  CHECK(test::unbalanced_tag(html) == "");
}

TEST_CASE("ACycleWithoutAnyInstantIsStillWritten") {
  auto cycle = test::stopped_cycle();
  cycle.instants.clear();
  CHECK(read_back(cycle)["cycle"]["angle"]["values"].empty());
  CHECK(read_back(cycle)["audit"]["mass"].is_null());  // nothing was found to be in balance
  CHECK(contains(table(cycle), "No instant"));
  CHECK(test::unbalanced_tag(app::cycle_svg(test::cycle_case(), cycle)) == "");
  CHECK(test::unbalanced_tag(app::cycle_html(test::cycle_case(), cycle)) == "");
}

TEST_CASE("TheTableOfACycleTellsMeansExtremesAndHowItRan") {
  const std::string printed = table(test::synthetic_cycle());
  for (const char* part : {"friction torque, mean", "smallest film, h_min", "at [deg]", "3 cycles",
                           "2.1e-05", "144 steps, 7 rejected", "content 5.0e-07", "impulse 4.0e-08",
                           "load cycle over 720 deg", "flooded edges"}) {
    INFO(part);
    CHECK(contains(printed, part));
  }
}

TEST_CASE("WhatWasMeasuredStandsBesideTheCycle") {
  const auto cycle = test::synthetic_cycle();
  bearing::Case c = test::cycle_case();
  c.measured = {};
  const auto printed = [&] {
    std::ostringstream out;
    app::write_cycle_table(out, c, cycle);
    return out.str();
  };
  CHECK_FALSE(contains(printed(), "measured"));
  CHECK_FALSE(contains(app::cycle_html(c, cycle), "<th>measured</th>"));
  const bearing::CycleQuantity& torque = cycle.quantities.front();
  REQUIRE(torque.quantity.name == "friction_torque");
  c.measured.friction_torque = std::abs(torque.quantity.value) / 1.25;
  CHECK(contains(printed(), "measured"));
  CHECK(contains(printed(), "+25.0 %"));
  CHECK(contains(app::cycle_html(c, cycle), "<th>measured</th>"));
  CHECK(contains(app::cycle_html(c, cycle), "+25.0 %"));
}

TEST_CASE("TheTableOfACycleTellsThatItsToleranceIsMissedAndWhatWouldMeetIt") {
  auto cycle = test::synthetic_cycle();
  for (auto& q : cycle.quantities) q.quantity.error_grid = 0.1 * q.quantity.size();
  const std::string printed = table(cycle);
  CHECK(contains(printed, "is not met: friction torque +-"));
  CHECK(contains(printed, "shellback run"));
  for (auto& q : cycle.quantities) {
    q.quantity.error_grid = q.quantity.error_time = 1e-6 * q.quantity.size();
  }
  CHECK_FALSE(contains(table(cycle), "not met"));
}

TEST_CASE("ThePageOfACycleTellsItsToleranceAsTheTableDoes") {
  bearing::CycleResult cycle = test::synthetic_cycle();
  for (auto& q : cycle.quantities) q.quantity.error_grid = 0.3 * q.quantity.size();
  const std::string page = app::cycle_html(test::cycle_case(), cycle);
  CHECK(contains(page, "is not met: friction torque +-"));
  CHECK(contains(page, "shellback run"));
}

TEST_CASE("APressureThatNoGridDeterminesIsToldAsOne") {
  bearing::CycleResult cycle = test::synthetic_cycle();
  const auto with_bars = [&](double part) {
    for (auto& q : cycle.quantities) {
      if (q.quantity.name == "p_max") q.quantity.error_grid = part * q.quantity.value;
    }
    return table(cycle);
  };
  CHECK_FALSE(contains(with_bars(0.9), "not determined"));
  CHECK(contains(with_bars(3.4), "not determined by these grids: largest film pressure"));
}

TEST_CASE("ASingleEventIsNoCycle") {
  const bearing::CycleResult cycle = test::timed_cycle();
  bearing::Case c = test::cycle_case();
  CHECK(contains(app::how_it_ran(c, cycle), "periodic within"));
  c.cycle->period = std::numeric_limits<double>::infinity();
  CHECK(app::how_it_ran(c, cycle).starts_with("an event of "));
}

TEST_CASE("SpeedIsDrawnWhereItVaries") {
  bearing::CycleResult cycle = test::synthetic_cycle();
  const std::string steady = app::cycle_svg(test::cycle_case(), cycle);
  cycle.instants[3].omega *= 1.5;
  const std::string varied = app::cycle_svg(test::cycle_case(), cycle);
  CHECK_FALSE(contains(steady, "Speed of the journal"));
  CHECK(contains(varied, "Speed of the journal"));
}

TEST_CASE("TheOrbitLiesWithinTheClearanceCircle") {
  const auto c = test::cycle_case();
  const auto cycle = test::synthetic_cycle();
  app::Svg svg(500.0, 520.0);
  const auto orbit = app::draw_orbit(svg, {0.0, 0.0, 480.0, 512.0}, c, cycle, app::print_theme());
  const std::string text = svg.document("orbit");
  CHECK(test::unbalanced_tag(text) == "");
  const auto path = longest_line(text);
  REQUIRE(path.size() == cycle.instants.size());
  for (std::size_t k = 0; k < path.size(); ++k) {
    const double dx = path[k].x - orbit.centre.x;
    const double dy = path[k].y - orbit.centre.y;
    CHECK(std::hypot(dx, dy) < orbit.radius);
    constexpr double kRounded = 0.06;  // one decimal [px]
    CHECK(std::abs(dx - orbit.radius * cycle.instants[k].ex / c.bearing.radial_clearance) <
          kRounded);
    CHECK(std::abs(dy + orbit.radius * cycle.instants[k].ey / c.bearing.radial_clearance) <
          kRounded);
  }
}

TEST_CASE("WhereABoreIsNotRoundTheOrbitLiesInItsRoom") {
  auto c = test::cycle_case();
  const double d = 0.4 * c.bearing.radial_clearance;
  c.bearing.shape =
      bearing::Profile{{0.0, 1.5707963, 3.1415927, 4.7123890}, {0.0}, {d, 0.0, d, 0.0}};
  app::Svg svg(480.0, 512.0);
  const auto orbit = app::draw_orbit(svg, {0.0, 0.0, 480.0, 512.0}, c, test::synthetic_cycle(),
                                     app::print_theme());
  const std::string text = svg.document("orbit");
  CHECK(test::unbalanced_tag(text) == "");
  CHECK_FALSE(contains(text, "the circle is the cold clearance"));
  const auto room = longest_line(text);  // of more points than the path
  REQUIRE(room.size() > 300);
  for (const auto& p : room) {
    CHECK(p.x < 480.0);
    const double r = std::hypot(p.x - orbit.centre.x, p.y - orbit.centre.y) / orbit.radius;
    CHECK(r > 0.99);
    CHECK(r < 1.41);
  }
}

TEST_CASE("TheOrbitOfAnElasticBearingStaysOnTheSheet") {
  auto cycle = test::synthetic_cycle();
  for (auto& i : cycle.instants) i.ex *= 2.0;
  app::Svg svg(480.0, 512.0);
  static_cast<void>(app::draw_orbit(svg, {0.0, 0.0, 480.0, 512.0}, test::cycle_case(), cycle,
                                    app::print_theme()));
  for (const auto& p : longest_line(svg.document("orbit"))) {
    CHECK(p.x > 0.0);
    CHECK(p.x < 480.0);
  }
}

TEST_CASE("ThePictureOfACycleShowsOrbitCurvesAndMaps") {
  const std::string svg = app::cycle_svg(test::cycle_case(), test::synthetic_cycle());
  CHECK(test::unbalanced_tag(svg) == "");
  for (const char* title :
       {"Path of the journal", "Smallest film", "Largest pressure", "Friction torque",
        "of asperities", "Load on the journal", "Largest film pressure", "Largest contact"}) {
    INFO(title);
    CHECK(contains(svg, title));
  }
  CHECK_FALSE(contains(svg, "nan"));
  CHECK(contains(app::cycle_svg(test::cycle_case(), test::timed_cycle()), "time [ms]"));
}

TEST_CASE("TheAxisIsThatOfTheWholeCycleWhereverItStopped") {
  CHECK(app::cycle_axis(test::stopped_cycle()).high == Approx(720.0));
  auto event = test::timed_cycle();
  event.period = std::numeric_limits<double>::infinity();
  CHECK(app::cycle_axis(event).high == Approx(1e3 * event.instants.back().t));
}

TEST_CASE("ACycleWithoutContactHasNoMapOfIt") {
  auto cycle = test::synthetic_cycle();
  const auto has = [&] {
    return app::cycle_map(test::cycle_case(), cycle, app::CycleMap::contact).has_value();
  };
  CHECK(has());
  for (double& p : cycle.fields.p_asperity_max) p = 0.0;
  CHECK_FALSE(has());
  cycle.fields.p_asperity_max.clear();
  CHECK_FALSE(has());
}

TEST_CASE("TheCyclesPageNeedsNothingFromOutside") {
  const auto cycle = test::synthetic_cycle();
  const std::string html = app::cycle_html(test::cycle_case(), cycle);
  for (const char* load :
       {"http://", "https://", "<link", "@import", "url(", "src=", "fetch(", "import("}) {
    CHECK_FALSE(contains(html, load));
  }
  CHECK(test::unbalanced_tag(html) == "");
  CHECK(html.size() < 3'000'000);
  CHECK(test::count(html, "<g class=\"frame") == static_cast<int>(cycle.frames.size()));
  CHECK(test::count(html, "<g class=\"frame now\"") == 1);
  for (const auto& q : cycle.quantities) {
    CHECK(contains(html, "data-quantity=\"" + q.quantity.name + "\""));
  }
}

TEST_CASE("AnAnimationIsThinnedOutToItsSize") {
  const auto cycle = test::synthetic_cycle();
  const std::string all = app::animation_svg(test::cycle_case(), cycle);
  const std::string few = app::animation_svg(test::cycle_case(), cycle, all.size() / 3);
  CHECK(few.size() <= all.size() / 3);
  CHECK(test::count(few, "<g class=\"frame") >= 3);
  auto none = cycle;
  none.frames.clear();
  CHECK(app::animation_svg(test::cycle_case(), none).empty());
}
