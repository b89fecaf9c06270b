/// An elasto-plastic layer under a film, steady and over load cycles.
#include "bearing/pressed_layer.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/judge/judge_case.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/told_ranges.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// Table 3 of Offner and Knaus on steel, with another hardness.
Case coated(double hardness) {
  Case c = plain_case();
  c.supplies[0].length = 0.02;
  c.supplies[0].arc = 20.0 * kDegree;
  solid::Material polymer{"polymer", 0.3, 1450.0, 1000.0, 2e9, 0.4, 40e-6, hardness, 1.0, 1e-4};
  c.shell = Shell{{{polymer, 20e-6, true}, {steel(), 2e-3}},
                  Housing{steel(), 0.06, HousingSupport::held},
                  ConvectiveBack{200.0, 303.15},
                  50.0};
  c.shaft = Shaft{steel(), 0.05, 100.0, 303.15};
  c.model.switches.elastic_deformation = true;
  return c;
}

/// `pulses` of up to `most` over 1 kN, one every two turns.
LoadCycle pulsing(const Case& c, double most, int pulses = 1) {
  LoadCycle cycle;
  cycle.period = 4.0 * kPi / c.operation.omega;
  for (int k = 0; k < 48 * pulses; ++k) {
    const double s = std::sin(kPi * k / 48.0);
    cycle.t.push_back(cycle.period * k / 48.0);
    cycle.x.push_back(0.0);
    cycle.y.push_back(-(1e3 + (most - 1e3) * std::pow(s, 8.0)));
  }
  cycle.journal_mass = 0.5;
  return cycle;
}

Result solved_in_tier(const Case& c) {
  const Result r = solve(c);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  return r;
}

bool tells_of_flow(const std::vector<Note>& notes) {
  return std::any_of(notes.begin(), notes.end(),
                     [](const Note& n) { return std::holds_alternative<note::LayerFlown>(n); });
}

double largest_total(const Fields& f) { return largest(f.p); }

}  // namespace

TEST_CASE("ALayerThatHoldsIsElastic", "[layer]") {
  // Under 5 MPa r = s p/(E + p): the same bearing with an elastic coating of that stiffness, whose
  // columns cannot swell (1 - 2 nu -> 1: nu = 0 makes E/s of it).
  Case c = coated(120e6);
  const Result layer = solved_in_tier(c);
  CHECK(layer.values().layer_depth == 0.0);
  c.shell->layers[0].elasto_plastic = false;
  c.shell->layers[0].material.poisson_ratio = 0.0;
  const Result elastic = solved_in_tier(c);
  // The elastic body resolves what spreads along the layer, too, and is linear: r differs by p/E.
  CHECK(layer.values().h_min == Approx(elastic.values().h_min).epsilon(5e-3));
  CHECK(layer.values().p_max == Approx(elastic.values().p_max).epsilon(1e-2));
}

TEST_CASE("AFilmEndsAtTheHardnessOfItsLayer", "[layer]") {
  const double free = solved_in_tier(coated(120e6)).values().p_max;
  const double hardness = 0.8 * free;
  const Result r = solved_in_tier(coated(hardness));
  CHECK(r.values().layer_depth > 0.0);
  const double depth = r.values().layer_depth;
  const double stiffness =
      2e9 / 20e-6 * (1.0 + hardness / 2e9);  // c_y = (E + hardness)/s for N = 1
  CHECK(largest_total(r.fields) <
        hardness + 1.001e-4 * (depth * stiffness + hardness));  // (1) of the header
  for (std::size_t k = 0; k < r.fields.p.size(); ++k) {  // it has flowed where it is pressed so
    if (r.fields.layer_depth[k] > 0.0) CHECK(r.fields.p[k] > hardness * (1.0 - 1e-9));
  }
}

TEST_CASE("ASteadyStateThatIsNotFoundNamesTheLayerThatIsToFlow", "[layer]") {
  Case c = coated(30e6);
  set_load(c, 60e3);  // sixty megapascals on the projected area
  const Result r = solve(c);
  REQUIRE(r.verdict.status == Status::iteration_limit);
  CHECK(r.verdict.is(ending::Plain::layer_may_flow));
  CHECK(app::words_of(r.verdict).cure.find("[load_cycle]") != std::string::npos);
}

TEST_CASE("ALayerThatFlowsAwayIsTold", "[layer]") {
  // The same mark in a layer that is thick, and in one that has less than twice as much.
  const auto told = [](double thickness, double depth) {
    Case c = coated(50e6);
    c.shell->layers[0].thickness = thickness;
    const BearingModel m = make_bearing(c, physics_of(c, Tier::isothermal), {16, 5});
    const Field h(m.domain.grid.cells(), 10e-6);
    FilmReach reach{300.0, 300.0, 1e6, h};
    reach.layer_depth = depth;
    for (const Note& n : range_warnings(m, reach)) {
      if (const auto* flown = std::get_if<note::LayerFlown>(&n)) {
        CHECK(flown->depth == depth);
        CHECK(flown->thickness == thickness);
        return true;
      }
    }
    return false;
  };
  CHECK_FALSE(told(20e-6, 9e-6));
  CHECK(told(20e-6, 11e-6));
  CHECK(told(5e-6, 9e-6));
  CHECK_FALSE(told(5e-6, 0.0));
}

TEST_CASE("ALoadThatStandsHoldsTheLayerAsTheSteadyFilmDoes", "[layer]") {
  Case c = coated(120e6);
  c.cycle = pulsing(c, 1e3);
  const CycleResult r = solve_cycle(c, Tier::isothermal);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  c.cycle.reset();
  c.operation.position = LoadGiven{1e3, 1.5 * kPi};
  const Quantities steady = solved_in_tier(c).values();
  CHECK(value_of(r, "h_min") == Approx(steady.h_min).epsilon(1e-3));
  CHECK(value_of(r, "friction_torque") == Approx(steady.friction_torque).epsilon(1e-3));
  CHECK(value_of(r, "layer_depth") == 0.0);
}

TEST_CASE("EveryPulseLeavesItsMarkAndEachOneLess", "[layer]") {
  Case c = coated(10e6);
  std::vector<double> depth{0.0};
  double p_max = INFINITY;
  for (const int pulses : {1, 2, 3}) {
    c.cycle = pulsing(c, 8e3, pulses);
    c.cycle->period = INFINITY;
    const CycleResult r = solve_cycle(c, Tier::isothermal);
    INFO(app::reason_of(r.verdict));
    REQUIRE(r.verdict.good());
    CHECK(value_of(r, "layer_loss") > 0.0);
    CHECK(r.audit.mass < 1e-12);
    depth.push_back(value_of(r, "layer_depth"));
    CHECK(largest(r.fields.layer_depth) == depth.back());
    if (pulses == 1) p_max = value_of(r, "p_max");
    CHECK(tells_of_flow(r.warnings) == (depth.back() > 0.5 * c.shell->layers[0].thickness));
  }
  CHECK(depth[1] > 0.0);
  Case thin = c;
  thin.shell->layers[0].thickness = 0.25 * depth[1];  // of what a thick one loses
  thin.shell->layers[0].material.hardness = 5e6;
  thin.cycle = pulsing(c, 8e3);
  thin.cycle->period = INFINITY;
  const CycleResult flown = solve_cycle(thin, Tier::isothermal);
  REQUIRE(flown.verdict.good());
  CHECK(value_of(flown, "layer_depth") > 0.5 * thin.shell->layers[0].thickness);
  CHECK(tells_of_flow(flown.warnings));
  CHECK(depth[2] > depth[1]);
  CHECK(depth[2] - depth[1] < depth[1]);  // the mark spreads the load
  CHECK(depth[3] - depth[2] < depth[2] - depth[1]);
  c.shell->layers[0].material.hardness = 1e9;
  c.cycle = pulsing(c, 8e3);
  c.cycle->period = INFINITY;
  const CycleResult hard = solve_cycle(c, Tier::isothermal);
  REQUIRE(hard.verdict.good());
  CHECK(value_of(hard, "layer_depth") == 0.0);
  CHECK(value_of(hard, "p_max") > p_max);
}

TEST_CASE("ALayerThatFlowsOnKeepsCyclesApartByItsName", "[layer]") {
  // Every cycle leaves its mark, for longer than is looked: what it flows by opens the film.
  Case c = coated(10e6);
  c.model.grid = {36, 5};
  c.cycle = pulsing(c, 8e3);
  SolveControl control;
  control.most_work = 8e5;  // some twenty cycles
  const CycleResult r = solve_cycle(c, Tier::isothermal, control);
  REQUIRE(r.verdict.status == Status::iteration_limit);
  const auto* told = r.verdict.as<ending::Unsettled>();
  REQUIRE(told != nullptr);
  INFO(app::reason_of(r.verdict));
  CHECK(told->of == ending::Iteration::layer_of_cycles);
  CHECK(told->left > 1e-4 * value_of(r, "h_min"));
  CHECK(told->left <
        value_of(r, "layer_depth") / static_cast<double>(told->steps));  // less than the mean mark
  c.shell->layers[0].material.hardness = 1e9;
  const CycleResult held = solve_cycle(c, Tier::isothermal, control);
  INFO(app::reason_of(held.verdict));
  CHECK(held.verdict.good());
}

TEST_CASE("ALayerWithoutItsLawIsRefused", "[layer]") {
  const auto refused = [](const Case& c) {
    for (const Finding& f : judge(c)) {
      if (f.refused()) return f.problem;
    }
    return std::string();
  };
  Case c = coated(120e6);
  CHECK(refused(c).empty());
  c.shell->layers[0].material.damping_ratio = 0.0;
  CHECK(refused(c).find("needs the damping_ratio") != std::string::npos);
  c = coated(0.0);
  CHECK(refused(c).find("needs the hardness") != std::string::npos);
  c = coated(-1.0);
  CHECK(!refused(c).empty());
  c = coated(120e6);
  c.shell->layers[0].thickness = 50e-6;
  CHECK(refused(c).find("thicker than the clearance") != std::string::npos);
  c = coated(120e6);
  c.shell->layers[0].material.youngs_modulus = 0.05e9;  // r_y = s p/(E + p): two thirds of s
  CHECK(refused(c).find("less than half of its thickness") != std::string::npos);
  c = coated(120e6);
  std::swap(c.shell->layers[0], c.shell->layers[1]);
  CHECK(refused(c).find("only the first layer") != std::string::npos);
}

TEST_CASE("AnEventBeginsWithTheLayerOfItsSteadyState", "[layer]") {
  Case c = coated(120e6);
  c.oil.temperature = rheology::ReynoldsSlope{0.03, 313.15, 0.035};
  c.cycle = pulsing(c, 1e3);  // a load that stands
  c.cycle->period = INFINITY;
  for (const Tier tier : {Tier::isothermal, Tier::thd}) {
    const CycleResult r = solve_cycle(c, tier);
    CAPTURE(app::reason_of(r.verdict));
    REQUIRE(r.verdict.good());
    // Nothing moves: of the power of friction the layer takes none.
    CHECK(value_of(r, "layer_loss") < 1e-6 * value_of(r, "power_loss"));
    for (const CycleInstant& i : r.instants) {
      CHECK(i.h_min == Approx(r.instants.front().h_min).epsilon(2e-3));
    }
  }
}

TEST_CASE("ALayerLosesAsMuchOnHalfABearingAsOnTheWhole", "[layer]") {
  Case c = coated(10e6);
  c.model.grid = {48, 8};
  c.cycle = pulsing(c, 8e3);
  c.cycle->period = INFINITY;
  std::vector<double> loss;
  for (const double z : {0.0, 1e-9}) {  // off the middle: both halves are solved
    c.supplies[0].z = z;
    const CycleResult r = solve_cycle(c, Tier::isothermal);
    REQUIRE(r.verdict.good());
    loss.push_back(value_of(r, "layer_loss"));
  }
  CHECK(loss[1] ==
        Approx(loss[0]).epsilon(1e-3));  // the same steps but for round-off of their choice
}
