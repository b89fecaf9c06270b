// Supplies that live on what a vessel holds.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/heat/film_heat.hpp"
#include "bearing/judge/judge_case.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/film_step.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// A journal that neither turns nor moves in the middle of a bearing with a groove all round, whose
/// line is shut: the film lets out oil in proportion to the vessel's pressure.
Case leaking_case() {
  Case c = plain_case();
  Supply& s = c.supplies[0];
  s.kind = SupplyKind::circumferential_groove;
  s.arc = 2.0 * kPi;
  s.length = 5e-3;
  s.pressure = 2e5;
  s.vessel = Vessel{1e-5, 1.5e9, {}};
  c.model.cavitation_pressure = -1e5;
  c.model.grid = {24, 10};
  c.model.tolerance = 1e-3;
  c.operation.omega = 0.0;
  LoadCycle cycle;
  cycle.t = {0.0, 4e-3};
  cycle.x = {1.0, 1.0};
  cycle.y = {0.0, 0.0};
  cycle.journal_mass = 1e4;  // moves by a picometre
  c.cycle = cycle;
  return c;
}

/// Rate of (dp/dt)/p: two lands of length (B - groove)/2, each a slot of the clearance.
double leak_rate(const Case& c) {
  const Supply& s = c.supplies[0];
  const double land = 0.5 * (c.bearing.width - s.length);
  const double h = c.bearing.radial_clearance;
  const double eta = std::get<rheology::ConstantViscosity>(c.oil.temperature).eta;
  const double flow = 2.0 * 2.0 * kPi * c.bearing.radius * h * h * h / (12.0 * eta * land);
  return flow * s.vessel->bulk_modulus / s.vessel->volume;
}

CycleResult with_vessels(const Case& c) {
  CycleResult r = solve_cycle(c, Tier::isothermal);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  CHECK(r.audit.mass < 1e-10);  // film, and film with vessels: carried as what flows
  return r;
}

/// A load that stands, and a groove whose line is shut for half of the cycle.
Case cut_off_case(double volume) {
  Case c = plain_case();
  Supply& s = c.supplies[0];
  s.arc = 20.0 * kDegree;
  s.length = 0.02;
  s.pressure = 2e5;
  c.cycle = LoadCycle{};
  c.cycle->period = 4.0 * kPi / c.operation.omega;
  const double t = c.cycle->period;
  c.cycle->t = {0.0, 0.25 * t, 0.5 * t, 0.75 * t};
  c.cycle->x = {0.0, 300.0, 0.0, -300.0};
  c.cycle->y = {-1e3, -1e3, -1e3, -1e3};
  c.cycle->journal_mass = 1.0;
  c.model.grid = {48, 8};
  s.vessel = Vessel{volume, 1.5e9, {{0.0, 0.5 * t}}};
  return c;
}

/// Oil that flows into the film while the line is shut [m3], and the pressures of the vessel then.
struct Shut {
  double oil = 0.0;
  double p_begin = NAN, p_end = NAN, p_least = INFINITY;
};
Shut while_shut(const CycleResult& r) {
  Shut shut;
  for (std::size_t k = 1; k < r.instants.size(); ++k) {
    const CycleInstant& i = r.instants[k];
    if (i.t < 0.5 * r.period * (1.0 + 1e-9)) shut.p_begin = i.p_vessel;
    if (i.t < 0.5 * r.period * (1.0 + 1e-9)) continue;
    shut.oil += i.dt * i.supply_flow;
    shut.p_end = i.p_vessel;
    shut.p_least = std::min(shut.p_least, i.p_vessel);
  }
  return shut;
}

}  // namespace

TEST_CASE("AVesselThatLeaksEmptiesExponentially", "[vessel]") {
  Case c = leaking_case();
  const double p = c.supplies[0].pressure;
  const auto off = [&](double step) {
    c.cycle->step = step;
    const CycleResult r = with_vessels(c);
    const CycleInstant& end = r.instants.back();
    return std::abs(end.p_vessel / (p * std::exp(-leak_rate(c) * end.t)) - 1.0);
  };
  const double coarse = off(2e-4);
  const double fine = off(1e-4);
  CHECK(fine < 5e-3);
  CHECK(std::log2(coarse / fine) == Approx(2.0).margin(0.15));  // TR-BDF2 and SDIRK2
}

TEST_CASE("WhatFlowsFromAShutVesselIsWhatItsPressureLoses", "[vessel]") {
  const double volume = 2e-6;
  const CycleResult r = with_vessels(cut_off_case(volume));
  const Shut shut = while_shut(r);
  CHECK(shut.p_begin == Approx(2e5).epsilon(1e-12));
  CHECK(shut.p_end < 1.9e5);
  CHECK(shut.p_least >= 0.0);
  const double lost = volume / 1.5e9 * (shut.p_begin - shut.p_end);
  CHECK(shut.oil / lost == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("NoOilFlowsFromAVesselAtTheCavitationPressure", "[vessel]") {
  const double volume = 1e-8;  // a drilling: it lasts for a part of a degree
  const CycleResult r = with_vessels(cut_off_case(volume));
  const Shut shut = while_shut(r);
  CHECK(shut.p_least >= 0.0);
  CHECK(shut.p_least < 2e3);
  // All that it had and no more, but for what the film in time is solved to.
  CHECK(shut.oil / (volume / 1.5e9 * 2e5) == Approx(1.0).epsilon(1e-3));
  REQUIRE(!r.warnings.empty());
  const auto* told = std::get_if<note::VesselEmpty>(&r.warnings.back());
  REQUIRE(told != nullptr);
  // it is empty for all but the first part of a degree of the half cycle in which it is shut
  CHECK(told->part == Approx(0.5).margin(0.01));
}

TEST_CASE("ACourseBeginsWithFullVesselsWhateverWasBefore", "[vessel]") {
  const Case c = cut_off_case(1e-6);
  const LoadCourse course(*c.cycle, c.operation.omega, 0.0);
  FilmSteps steps(make_bearing(c, physics_of(c, Tier::isothermal), c.model.grid, nullptr), course,
                  1.0, EquilibriumOptions{});
  FilmSteps::Supplies drained = steps.supplies();
  drained.patches[0].pressure = 0.0;
  drained.patches[0].fill = 0.5;
  EquilibriumCost cost;
  steps.put_back(drained);
  const FilmInTime rest = steps.at_rest(313.15);
  CHECK(steps.point().scene.supply.patches[0].pressure == 2e5);
  CHECK(steps.point().scene.supply.patches[0].fill == 1.0);
  CHECK(rest.vessels == steps.vessels().full());
  steps.put_back(drained);
  REQUIRE(steps.steady(313.15, {}, cost, nullptr));
  CHECK(steps.point().scene.supply.patches[0].pressure == 2e5);
  CHECK(steps.point().scene.supply.patches[0].fill == 1.0);
}

TEST_CASE("AGrooveTakesTheOilThatAJournalLeavesOverIt", "[vessel]") {
  // A journal of a ton falls from the middle, faster than the film can hold it: by Newton's law
  // alone. The groove over it, half round and nearly as wide as the bearing, takes the oil for
  // 2 R L s: what its line gives, less what goes into the film and out at the sides.
  Case c = plain_case();
  Supply& s = c.supplies[0];
  s.angle = 0.5 * kPi;
  s.arc = kPi;
  s.length = 0.8 * c.bearing.width;
  s.pressure = 2e5;
  c.operation.omega = 0.0;
  c.model.grid = {48, 10};
  LoadCycle cycle;
  cycle.t = {0.0, 2e-3};
  cycle.x = {0.0, 0.0};
  cycle.y = {-1e4, -1e4};
  cycle.journal_mass = 1e3;
  cycle.step = 1e-4;
  c.cycle = cycle;
  const double rho =
      reference_density(make_bearing(c, physics_of(c, Tier::isothermal), c.model.grid));
  // Supplied, lost at the sides and gathered in the film [m3].
  const auto into_groove = [&](const CycleResult& r) {
    double oil = (r.instants.front().oil - r.instants.back().oil) / rho;
    for (const CycleInstant& i : r.instants) oil += i.dt * (i.supply_flow - i.side_flow);
    return oil;
  };
  const auto opened = [&](const CycleResult& r) {
    CHECK(-r.instants.back().ey > 0.05 * c.bearing.radial_clearance);
    return 2.0 * c.bearing.radius * s.length * -r.instants.back().ey;
  };
  const CycleResult fed = with_vessels(c);
  // Cells of 7.5 degrees: their sum of cosines is the integral to a part in a thousand.
  CHECK(into_groove(fed) / opened(fed) == Approx(1.0).epsilon(2e-3));
  const double volume = 1e-3;
  s.vessel = Vessel{volume, 1.5e9, {}};
  const CycleResult shut = with_vessels(c);
  CHECK(into_groove(shut) / opened(shut) == Approx(1.0).epsilon(2e-3));
  double fell = 0.0;  // the vessel's pressure, by what it gave
  for (const CycleInstant& i : shut.instants) fell += i.dt * i.supply_flow * 1.5e9 / volume;
  CHECK(fell > 1e3);
  CHECK(s.pressure - shut.instants.back().p_vessel == Approx(fell).epsilon(1e-3));
}

TEST_CASE("OilThatAGrooveTakesBackCarriesNoHeatAway", "[vessel]") {
  // The load turns from the groove to the other side: more oil goes back into the groove than the
  // film is fed with, and tier lumped still has its through-flow.
  Case c = warm_case();
  Supply& s = c.supplies[0];
  s.arc = 60.0 * kDegree;
  s.length = 0.02;
  s.pressure = 1e5;
  LoadCycle cycle;
  cycle.t = {0.0, 4e-3};
  cycle.x = {0.0, 0.0};
  cycle.y = {-1.5e3, 1.5e3};
  cycle.journal_mass = 1.0;
  c.cycle = cycle;
  const CycleResult r = solve_cycle(c, Tier::lumped);
  INFO(app::reason_of(r.verdict));
  CHECK(r.verdict.good());
  CHECK(value_of(r, "supply_flow") < 0.0);
}

TEST_CASE("AnEmptyVesselIsFilledByAFilmThatDoesNotFeelIt", "[vessel]") {
  const Case c = leaking_case();
  const BearingModel model = make_bearing(c, physics_of(c, Tier::isothermal), c.model.grid);
  fluid::FilmScene scene = operating_point(model).scene;
  Vessels vessels(model);
  std::vector<double> oil = vessels.begin(scene);
  (void)vessels.set_lines(0.0, oil);  // shut
  fluid::SupplyPatch& patch = scene.supply.patches[0];
  const double p_cav = scene.p_cavitation;
  const double own = 1e-3;  // [s]
  // A film that lets out 1e-7 kg/s per pascal: its slope is remembered.
  const auto leaks = [&](fluid::OilFlows& flows) {
    flows.patch = {1e-7 * (patch.pressure - p_cav)};
    return Verdict{};
  };
  REQUIRE(vessels.solve(own, oil, scene, leaks).good());
  // Then one that drives oil in, as much whatever the vessel holds, which begins empty.
  const double in = 1e-6;  // [kg/s]
  patch.pressure = p_cav;
  patch.fill = 0.01;
  const auto drives = [&](fluid::OilFlows& flows) {
    flows.patch = {-in};
    return Verdict{};
  };
  REQUIRE(vessels.solve(own, {0.0}, scene, drives).good());
  const double kappa = 860.0 * c.supplies[0].vessel->volume / c.supplies[0].vessel->bulk_modulus;
  CHECK(patch.fill == 1.0);
  CHECK(patch.pressure - p_cav == Approx(own * in / kappa).epsilon(1e-3));
}

TEST_CASE("AVeryLargeVesselIsASupplyOfGivenPressure", "[vessel]") {
  Case c = cut_off_case(1.0);
  const CycleResult large = with_vessels(c);
  c.supplies[0].vessel.reset();
  const CycleResult given = with_vessels(c);
  // The steps differ, as they end where the line opens and shuts: by what they err.
  CHECK(value_of(large, "h_min") == Approx(value_of(given, "h_min")).epsilon(3e-3));
  CHECK(value_of(large, "friction_torque") ==
        Approx(value_of(given, "friction_torque")).epsilon(3e-3));
  CHECK(value_of(large, "supply_flow") == Approx(value_of(given, "supply_flow")).epsilon(1e-2));
}

TEST_CASE("AVesselBelongsToALoadCycle", "[vessel]") {
  Case c = cut_off_case(1e-6);
  const auto refused = [&](const char* key) {
    for (const Finding& f : judge(c, {Tier::isothermal})) {
      if (f.refused() && f.key == key) return true;
    }
    return false;
  };
  CHECK_FALSE(refused("supply.0.vessel_volume"));
  c.supplies[0].vessel->open = {{0.0, 1.0}};
  CHECK(refused("supply.0.open"));
  c.supplies[0].vessel->open = {{1e-3, 0.5e-3}};
  CHECK(refused("supply.0.open"));
  c.supplies[0].vessel->open.clear();
  const auto told = [&] {
    int of_open = 0;
    for (const Finding& f : judge(c, {Tier::isothermal})) of_open += f.key == "supply.0.open";
    return of_open;
  };
  CHECK(told() == 1);  // nothing makes up for what leaves the bearing
  c.supplies.push_back(c.supplies[0]);
  c.supplies[1].vessel.reset();
  c.supplies[1].angle += 1.0;
  CHECK(told() == 0);
  c.supplies.pop_back();
  for (const double volume : {0.0, 1e12}) {  // so much oil that a gap's is lost in its round-off
    c.supplies[0].vessel->volume = volume;
    CHECK(refused("supply.0.vessel_volume"));
  }
  c.supplies[0].vessel->volume = 1e-6;
  c.supplies[0].pressure = c.model.cavitation_pressure + 1e-4;  // it would hold no drop
  CHECK(refused("supply.0.pressure"));
  c.cycle.reset();
  CHECK(refused("supply.0.vessel_volume"));
}

TEST_CASE("NoVesselStandsBesideAnotherSupplyWithoutALand", "[vessel]") {
  // Two grooves of 20 degrees that share an edge at 90: one took in what the journal dragged, to
  // more than twice the pressure of the other beside it.
  Case c = cut_off_case(1e-6);
  c.supplies[0].arc = 20.0 * kDegree;
  c.supplies[0].angle = 80.0 * kDegree;
  c.supplies.push_back(c.supplies[0]);
  c.supplies[1].vessel.reset();
  const auto refused = [&](double angle) {
    c.supplies[1].angle = angle * kDegree;
    const auto found = judge(c);
    return std::any_of(found.begin(), found.end(), [](const Finding& f) {
      return f.refused() && f.key == "supply.0.vessel_volume";
    });
  };
  CHECK(refused(100.0));
  CHECK(refused(60.0));
  CHECK_FALSE(refused(101.0));
}

TEST_CASE("AnEventsStepsEndWhereAVesselIsShut", "[vessel]") {
  // The end of an event, which has no period, was taken for every switching's own: no step ended on
  // any, and a given one passed it over (a pressure of 0 for 0.25 bar, with bars of 0).
  Case c = leaking_case();
  c.cycle->t = {0.0, 8e-3};
  c.supplies[0].vessel->open = {{0.0, 3.3e-3}};
  const double rate = leak_rate(c);
  for (const double step : {0.0, 1e-3}) {
    if (step > 0.0) c.cycle->step = step;
    const CycleResult r = with_vessels(c);
    const auto shut = std::find_if(r.instants.begin(), r.instants.end(), [](const CycleInstant& i) {
      return std::abs(i.t - 3.3e-3) < 1e-9;
    });
    REQUIRE(shut != r.instants.end());
    CHECK(shut->p_vessel == Approx(2e5));
    for (auto i = shut; i != r.instants.end(); ++i) {
      const double p = 2e5 * std::exp(-rate * (i->t - 3.3e-3));
      INFO(step << ", " << i->t);
      CHECK(i->p_vessel == Approx(p).margin(4e3));  // 2 % of the supply's
    }
  }
}

TEST_CASE("AShutVesselBehindASoftGrooveIsFound", "[vessel]") {
  // What a step left open in the gap over the groove was as much as the vessel holds: whether its
  // pressure was found hung on the volume.
  Case c = warm_case();
  c.supplies.resize(1);
  Supply& s = c.supplies[0];
  s.kind = SupplyKind::circumferential_groove;
  s.arc = 2.0 * kPi;
  s.length = 0.3 * c.bearing.width;
  s.pressure = 2e5;
  c.model.switches.elastic_deformation = true;
  c.model.grid = {36, 7};
  c.model.tolerance = 0.05;
  LoadCycle cycle;
  cycle.period = 20e-3;
  cycle.t = {0.0, 5e-3, 10e-3, 15e-3};
  cycle.x = {0.0, 1.5e3, 0.0, -1.5e3};
  cycle.y = {-4e3, -2e3, -1e3, -2e3};
  c.cycle = cycle;
  std::vector<double> torque;
  for (const double volume : {0.1e-6, 0.3e-6, 1e-6, 3e-6}) {
    s.vessel = Vessel{volume, 1.5e9, {{4e-3, 8e-3}}};
    INFO(volume << " m3");
    torque.push_back(value_of(with_vessels(c), "friction_torque"));
  }
  for (const double t : torque) CHECK(t == Approx(torque.front()).epsilon(0.01));
}
