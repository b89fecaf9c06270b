/// Solves that end without a solution say so, and by name.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/film/fed_flow.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/steady/compare.hpp"
#include "bearing/told_ranges.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// A case whose film heats itself without bound: viscosity that rises with temperature, heat that
/// leaves with the oil alone.
Case runaway_case() {
  Case c = warm_case();
  c.oil.temperature = rheology::ReynoldsSlope{0.03, 313.15, -0.05};
  c.operation.omega *= 2.0;
  c.shell->back = ConvectiveBack{1.0, 303.15};
  c.shell->end_heat_transfer = 0.0;
  c.shaft->heat_transfer = 0.0;
  c.model.switches.thermal_deformation = false;  // the shaft would seize first
  return c;
}

/// Film and walls run away, or more heat is made than carried off at every temperature.
bool runs_away(const Verdict& v) {
  const auto* lumped = v.as<ending::NoHeatBalance>();
  const auto* branch = v.as<ending::BranchEnded>();
  return v.as<ending::RanAway>() || (lumped && lumped->surplus_low > 0.0) ||
         (branch && branch->end == ending::BranchEnd::turned && branch->with_heat);
}

}  // namespace

TEST_CASE("ThermalRunawayIsRefusedByName", "[refusal]") {
  for (const Tier tier : {Tier::lumped, Tier::thd, Tier::tehd}) {
    INFO(to_string(tier));
    const Solution s = solve_tier(runaway_case(), tier);
    INFO(app::reason_of(s.verdict));
    CHECK(s.verdict.status == Status::no_steady_state);
    CHECK(runs_away(s.verdict));
    const Result r = summarize(s, tier);  // the last state can be looked at
    CHECK(r.verdict.status == Status::no_steady_state);
  }
}

TEST_CASE("RigidBarusLimitIsRefusedWithItsName", "[refusal]") {
  Case c = rig_case();
  c.surfaces = {};
  set_load(c, 80e3);
  const Solution s = solve_tier(c, Tier::isothermal);
  CHECK(s.verdict.status == Status::no_steady_state);
  CHECK(load_beyond_bound(s.verdict) == Approx(80e3));
  CHECK(std::isfinite(s.verdict.place.phi));
}

/// Rigid smooth surfaces of constant viscosity carry any load, if only the film is thin enough:
/// W falls as a power of h. Cells as wide as the film's wedge is long carry a part of it.
TEST_CASE("WhatCellsCannotCarryIsNotTheBearingsLimit", "[refusal]") {
  Case slow = plain_case();
  slow.operation.omega = 0.5 * kRpm;
  Case lobed = plain_case();  // a bore that runs along a straight line from 1 mm to nothing
  lobed.bearing.profile = Profile{{10.0 * kDegree, 200.0 * kDegree}, {0.0}, {1e-3, 0.0}};
  for (Case c : {slow, lobed}) {
    for (const auto grid : {std::array{36, 5}, std::array{54, 7}}) {
      c.model.grid = grid;
      const Solution s = solve_tier(c, Tier::isothermal);
      INFO(grid[0] << " cells: " << app::reason_of(s.verdict));
      CHECK(s.verdict.status == Status::iteration_limit);
    }
    c.model.grid = {360, 7};
    const Solution s = solve_tier(c, Tier::isothermal);
    INFO(app::reason_of(s.verdict));
    CHECK(s.verdict.good());
    CHECK(s.film.least.h > 2e-9);
  }
}

TEST_CASE("ATiltedRigidJournalHasALimitLoad", "[refusal]") {
  // Where it meets the side edge oil leaves: per length the load tends to eta U/tilt^2, however
  // near the two are, so that grids agree on what it comes to.
  Case c = plain_case();
  c.bearing.radial_clearance = 40e-6;
  c.operation.alignment = TiltGiven{2.4e-3, 0.0};
  set_load(c, 5e3);
  std::vector<double> ends;
  for (const auto grid : {std::array{48, 8}, std::array{72, 12}}) {
    c.model.grid = grid;
    const Solution s = solve_tier(c, Tier::isothermal);
    INFO(grid[0] << " cells: " << app::reason_of(s.verdict));
    CHECK(s.verdict.status == Status::no_steady_state);
    REQUIRE(s.verdict.as<ending::BranchEnded>());
    ends.push_back(s.verdict.as<ending::BranchEnded>()->carried.part);
  }
  CHECK(ends[1] == Approx(ends[0]).epsilon(0.1));
}

TEST_CASE("SmoothJournalBeyondTheClearanceIsRefused", "[refusal]") {
  Case c = plain_case();
  place_journal(c, 1.02, 0.3);
  const Solution s = solve_tier(c, Tier::isothermal);
  CHECK(s.verdict.status == Status::no_steady_state);
  const auto* e = s.verdict.as<ending::GapClosed>();
  REQUIRE(e != nullptr);
  // c (1 - 1.02 cos), looked at in cells and faces: the least lies up to a quarter cell away.
  const double clearance = c.bearing.radial_clearance, away = 0.5 * kPi / c.model.grid[0];
  CHECK(e->h == Approx(-0.02 * clearance).margin(0.51 * clearance * away * away));
  CHECK_FALSE(e->by_growth());
}

TEST_CASE("ShrunkenClearanceIsRefused", "[refusal]") {
  Case c = warm_case();  // 100 K above the reference on a shell that cannot grow: 30 um are gone
  c.bearing.reference_temperature = 213.15;
  c.shell->housing->support = HousingSupport::clamped;
  const Solution s = solve_tier(c, Tier::tehd);
  INFO(app::reason_of(s.verdict));
  CHECK(s.verdict.status == Status::no_steady_state);
  const auto* e = s.verdict.as<ending::GapClosed>();
  REQUIRE(e != nullptr);
  CHECK(e->by_growth());
}

TEST_CASE("StopFlagEndsEverySolve", "[refusal]") {
  const std::atomic<bool> stop{true};
  SolveControl control;
  control.stop = &stop;
  for (const Tier tier : {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd}) {
    const Solution s = solve_tier(rig_case(), tier, control);
    CHECK(s.verdict.status == Status::interrupted);
    CHECK(summarize(s, tier).verdict.status == Status::interrupted);
  }
}

TEST_CASE("StopDuringTheThermalLoopKeepsTheState", "[refusal]") {
  for (const Tier tier : {Tier::lumped, Tier::thd, Tier::tehd}) {
    std::atomic<bool> stop{false};
    SolveControl control;
    control.stop = &stop;
    int calls = 0;
    control.progress = [&](const Progress&) { stop = ++calls >= 3; };
    const Solution s = solve_tier(rig_case(), tier, control);
    CHECK(s.verdict.status == Status::interrupted);
    CHECK(calls == 3);
    const Result r = summarize(s, tier);
    CHECK(r.value("friction_torque") > 0.0);
  }
}

TEST_CASE("InterruptedComparisonKeepsWhatIsFinished", "[refusal]") {
  std::atomic<bool> stop{false};
  SolveControl control;
  control.stop = &stop;
  control.progress = [&](const Progress&) { stop = true; };  // the isothermal tier sends none
  const Comparison c = compare(grooved_case(), {Tier::isothermal, Tier::thd, Tier::tehd}, control);
  REQUIRE(c.results.size() == 2);
  CHECK(c.results[0].verdict.good());
  CHECK(c.results[1].verdict.status == Status::interrupted);
  CHECK(c.split.steps.empty());
}

TEST_CASE("AFilmThatIsNotLaminarIsMarked", "[refusal]") {
  // Taylor vortices from Re = rho U c/eta = 41.2 sqrt(R/c) on
  Case c = plain_case();
  place_journal(c, 0.3, 0.0);
  const double R = c.bearing.radius, gap = c.bearing.radial_clearance;
  const double rho = std::get<rheology::ConstantDensity>(c.oil.density).rho;
  c.oil.temperature = rheology::ConstantViscosity{1e-3};
  const double U = 41.2 * std::sqrt(R / gap) * 1e-3 / (rho * gap);
  const auto marked = [&](double part) {
    c.operation.omega = part * U / R;
    const Result r = summarize(solve_tier(c, Tier::isothermal), Tier::isothermal);
    REQUIRE(r.verdict.good());
    return std::any_of(r.warnings.begin(), r.warnings.end(),
                       [](const Note& w) { return std::holds_alternative<note::NotLaminar>(w); });
  };
  CHECK_FALSE(marked(0.99));
  CHECK(marked(1.01));
  CHECK(marked(-1.01));
}

TEST_CASE("OilThatIsFedTooFastIsTold", "[refusal]") {
  // A ring groove in the middle of a concentric bearing at a crawl: u = c^2 p/(12 eta L) over lands
  // of length L, whatever the cells.
  Case c = plain_case();
  place_journal(c, 0.0, 0.0);
  c.operation.omega = 1e-3;
  c.oil.temperature = rheology::ConstantViscosity{5e-3};
  c.model.cavitation_pressure = 0.0;
  Supply& groove = c.supplies[0];
  groove.kind = SupplyKind::circumferential_groove;
  groove.arc = 2.0 * kPi;
  groove.z = 0.0;
  groove.length = 0.25 * c.bearing.width;
  const double land = 0.5 * (c.bearing.width - groove.length);
  const double gap = c.bearing.radial_clearance;
  const double rho = std::get<rheology::ConstantDensity>(c.oil.density).rho;
  const auto told = [&](double head) {  // of the pressure that drives it
    const double per_pressure = gap * gap / (12.0 * 5e-3 * land);
    groove.pressure = 2.0 * head / (rho * per_pressure * per_pressure);
    const Solution s = solve_tier(c, Tier::isothermal);
    REQUIRE(s.verdict.good());
    const note::FedFlow flow = fed_flow(s.point.scene, s.film);
    CHECK(flow.part == Approx(head).epsilon(1e-6));
    CHECK(flow.velocity == Approx(per_pressure * groove.pressure).epsilon(1e-6));
    CHECK(flow.reynolds == Approx(rho * flow.velocity * gap / 5e-3).epsilon(1e-6));
    const Result r = summarize(s, Tier::isothermal);
    return std::any_of(r.warnings.begin(), r.warnings.end(),
                       [](const Note& w) { return std::holds_alternative<note::FedFlow>(w); });
  };
  CHECK_FALSE(told(0.09));
  CHECK(told(0.11));
}

TEST_CASE("OilFedOutOfAGrooveHasASpeedOfItsOwn", "[refusal]") {
  // Single faces at a groove's corners are the faster the smaller they are (by a half between these
  // grids). Arcs about a piece's own length are cut alike.
  Case c = plain_case();
  c.supplies[0].pressure = 5e5;
  c.supplies[0].length = 0.7 * c.bearing.width;
  std::vector<double> parts;
  for (const double arc : {29.0, 31.0}) {
    c.supplies[0].arc = arc * kDegree;
    for (const auto& grid : {std::array{60, 12}, std::array{120, 24}}) {
      c.model.grid = grid;
      const Solution s = solve_tier(c, Tier::isothermal);
      REQUIRE(s.verdict.good());
      parts.push_back(fed_flow(s.point.scene, s.film).part);
    }
  }
  const auto [least, most] = std::minmax_element(parts.begin(), parts.end());
  CHECK(*least > 0.0);
  CHECK(*most < 1.35 * *least);
}

TEST_CASE("WhereAFilmWithHeatEndsIsItsOwnEnd", "[refusal]") {
  // Far beyond what it carries the film in oil of the supply's temperature ends elsewhere: thicker
  // oil carries more. What a refusal names must be carried, a tenth less at least, and no more.
  Case c = warm_case();
  c.oil.pressure = rheology::Barus{2e-8};
  c.model.switches.thermal_deformation = false;
  set_load(c, 1e6);
  const Solution cool = solve_tier(c, Tier::isothermal);
  const Solution far = solve_tier(c, Tier::thd);
  REQUIRE_FALSE(far.verdict.good());
  REQUIRE_FALSE(far.limits.empty());
  const double carried = far.limits.back().part * 1e6;
  set_load(c, 0.97 * carried);
  CHECK(solve_tier(c, Tier::thd).verdict.good());
  set_load(c, 1.03 * carried);
  CHECK_FALSE(solve_tier(c, Tier::thd).verdict.good());
  REQUIRE_FALSE(cool.limits.empty());
  CHECK(cool.limits.back().part * 1e6 > 1.05 * carried);  // else this test tells nothing
}

TEST_CASE("ALimitAsNearAsGridsDifferIsNoProof", "[refusal]") {
  // Rigid surfaces, Barus oil, a groove beside the load: what the film carries goes up and down
  // with the cells. Where one grid carries the load none is to say that there is no steady state.
  Case c = rig_case();
  c.bearing = {0.0523, 0.1205, 31.7e-6, 323.15, {}};
  c.supplies[0].kind = SupplyKind::axial_groove;
  c.supplies[0].angle = 59.0 * kDegree;
  c.supplies[0].arc = 12.0 * kDegree;
  c.supplies[0].length = 0.0629;
  c.supplies[0].pressure = 3e5;
  c.supplies[0].temperature = 323.15;
  c.operation.omega = 286.0 * kRpm;
  c.operation.position = LoadGiven{365.687e3, 90.0 * kDegree};
  c.shell = Shell{{{steel(), 3.557e-3}},
                  Housing{steel(), 0.08895, HousingSupport::held},
                  ConvectiveBack{500.0, 343.15},
                  50.0};
  c.shaft = Shaft{steel(), 0.0314, 100.0, 333.15};
  c.surfaces.shell = {0.12e-6, 1.0, 0.10e-6, 0.11e-6};
  c.surfaces.shaft = {0.06e-6, 1.0, 0.05e-6, 0.05e-6};
  int found = 0;
  std::vector<Solution> refused;
  for (const std::array<int, 2> grid :
       {std::array{48, 7}, std::array{80, 11}, std::array{100, 13}}) {
    c.model.grid = grid;
    Solution s = solve_tier(c, Tier::thd);
    INFO(app::reason_of(s.verdict));
    found += s.verdict.good() ? 1 : 0;
    if (s.verdict.good()) continue;
    CHECK(s.verdict.status == Status::iteration_limit);
    CHECK(s.verdict.as<ending::LimitMoves>() != nullptr);
    refused.push_back(std::move(s));
  }
  CHECK(found > 0);  // else this test tells nothing
  CHECK_FALSE(refused.empty());
}

TEST_CASE("ALiningBeyondItsLimitTemperatureIsTold", "[refusal]") {
  Case c = rig_case();
  c.model.grid = {48, 9};
  const auto told = [&](double limit) {
    c.shell->layers[0].material.limit_temperature = limit;
    const Result r = summarize(solve_tier(c, Tier::tehd), Tier::tehd);
    REQUIRE(r.verdict.good());
    const auto hot = std::find_if(r.warnings.begin(), r.warnings.end(), [](const Note& w) {
      return std::holds_alternative<note::LiningTooHot>(w);
    });
    if (hot == r.warnings.end()) return 0.0;
    CHECK(std::get<note::LiningTooHot>(*hot).T == Approx(r.value("T_shell_max")).epsilon(1e-9));
    return r.value("T_shell_max");
  };
  CHECK(told(0.0) == 0.0);  // not known
  const double T = told(300.0);
  CHECK(T > 300.0);
  CHECK(told(T + 1.0) == 0.0);
  CHECK(told(T - 1.0) == T);
}

TEST_CASE("AFilmShearedByMoreThanOilBearsIsTold", "[refusal]") {
  // 12 MPa of shear stress at 100 MPa are within what oil bears, 18 MPa not; nor are 6 MPa at none.
  Case c = plain_case();
  const BearingModel m = make_bearing(c, physics_of(c, c.model.tier), c.model.grid);
  const FilmGrid& g = m.domain.grid;
  const auto told = [&](double stress, double pressure) {
    Field p(g.cells(), 0.0), tau(g.cells(), 1e3);
    p[7] = pressure;
    tau[7] = -stress;
    const note::OilSheared worst = sheared_oil(g, p, tau);
    CHECK(worst.place == fluid::place_of(g, 7));
    CHECK(worst.part == Approx(stress / (5e6 + 0.1 * pressure)));
    std::vector<Note> notes;
    add_sheared_oil(worst, notes);
    return !notes.empty();
  };
  CHECK_FALSE(told(12e6, 100e6));
  CHECK(told(18e6, 100e6));
  CHECK(told(6e6, 0.0));
}

TEST_CASE("ASteadyFilmAndACycleTellOilThatIsShearedTooMuch", "[refusal]") {
  // An oil of 100 Pa s: 5 m/s over some 30 um shear it by 17 MPa.
  Case c = plain_case();
  c.oil.temperature = rheology::ConstantViscosity{100.0};
  const auto told = [](const std::vector<Note>& notes) {
    return std::any_of(notes.begin(), notes.end(),
                       [](const Note& n) { return std::holds_alternative<note::OilSheared>(n); });
  };
  CHECK(told(solve(c).warnings));
  LoadCycle cycle;
  cycle.period = 4.0 * kPi / c.operation.omega;
  for (int k = 0; k < 4; ++k) {
    cycle.t.push_back(0.25 * k * cycle.period);
    cycle.x.push_back(0.0);
    cycle.y.push_back(-2000.0 - 200.0 * (k % 2));
  }
  Case swings = c;
  swings.operation.position = LoadGiven{};
  swings.cycle = cycle;
  swings.model.tolerance = 0.05;
  CHECK(told(solve_cycle(swings, Tier::isothermal).warnings));
  c.oil.temperature = rheology::ConstantViscosity{0.015};
  CHECK_FALSE(told(solve(c).warnings));
}

TEST_CASE("AnEdgeThatIsClosedWhileNoCellIsIsMarked", "[refusal]") {
  const auto marked = [](const Case& c, double edge) {
    const BearingModel m = make_bearing(c, physics_of(c, c.model.tier), c.model.grid);
    const Field h(m.domain.grid.cells(), 1e-6);
    const auto notes = range_warnings(m, {NAN, NAN, 1e6, h, {edge, 0.0, 0.0125}});
    return std::any_of(notes.begin(), notes.end(), [](const Note& w) {
      return std::holds_alternative<note::EdgeNotResolved>(w);
    });
  };
  CHECK(marked(plain_case(), -0.1e-6));
  CHECK_FALSE(marked(plain_case(), 0.1e-6));
  // Of smooth surfaces that give way it stays open: there half of the thinnest cell says enough.
  Case soft = warm_case();
  soft.model.tier = Tier::isothermal;
  soft.model.switches.elastic_deformation = true;
  CHECK(marked(soft, 0.4e-6));
  CHECK_FALSE(marked(soft, 0.6e-6));
}

TEST_CASE("SurfacesPressedBeyondTheContactLawAreMarked", "[refusal]") {
  Case c = rig_case();
  c.model.switches.pressure_dependence = false;
  place_journal(c, 1.1, 0.3);  // 2.4 um into each other, where the law ends at 1.3 um
  const auto marked = [](const Result& r) {
    return std::any_of(r.warnings.begin(), r.warnings.end(), [](const Note& w) {
      return std::holds_alternative<note::BeyondContactLaw>(w);
    });
  };
  const Result r = summarize(solve_tier(c, Tier::isothermal), Tier::isothermal);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  const double sigma = std::hypot(0.28e-6, 0.13e-6), delta = 0.60e-6;  // of the two surfaces
  REQUIRE(r.value("h_min") < delta - 6.3 * sigma);
  CHECK(marked(r));
  CHECK(std::any_of(r.limiters.begin(), r.limiters.end(), [](const LimiterCount& l) {
    return l.what == Limiter::beyond_contact_law && l.count > 0;
  }));
  const Result usual = summarize(solve_tier(rig_case(), Tier::isothermal), Tier::isothermal);
  CHECK_FALSE(marked(usual));
}

TEST_CASE("AFilmSoughtFromOneNearByProvesNothingOfOthers", "[refusal]") {
  // A smooth rigid bearing of Barus oil under twice what its bound lets it carry.
  Case c = plain_case();
  c.oil.pressure = rheology::Barus{4e-8};
  c.model.grid = {36, 6};
  const Solution near = solve_tier(c, Tier::isothermal);
  REQUIRE(near.verdict.good());
  set_load(c, 4e5);
  CHECK(solve_tier(c, Tier::isothermal).verdict.status == Status::no_steady_state);
  const Solution s = solve_tier_from(c, Tier::isothermal, near, {}, Otherwise::failure);
  INFO(app::reason_of(s.verdict));
  CHECK(s.verdict.status == Status::iteration_limit);
}

TEST_CASE("OnlyBarusLawBoundsTheLoadOfARigidFilm", "[refusal]") {
  Case c = plain_case();
  c.model.grid = {36, 6};
  for (const double load : {1e5, 1e6, 1e7}) {
    set_load(c, load);
    c.oil.pressure = rheology::Roelands{0.6};
    const Solution s = solve_tier(c, Tier::isothermal);
    INFO(load << " N: " << app::reason_of(s.verdict));
    CHECK(s.verdict.as<ending::BeyondPressureBound>() == nullptr);
  }
}

namespace {

template <class Wanted>
bool told_of(const Case& c) {
  const Result r = solve(c);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  return std::any_of(r.warnings.begin(), r.warnings.end(),
                     [](const Note& w) { return std::holds_alternative<Wanted>(w); });
}

}  // namespace

TEST_CASE("ShearBeyondTheOilsLawIsTold", "[refusal]") {
  Case c = plain_case();
  place_journal(c, 0.6, 0.5);
  const double least = c.bearing.radial_clearance * 0.4;
  const double rate = c.operation.omega * c.bearing.radius / least;  // where the film is thinnest
  c.oil.range.rate_max = 1.1 * rate;
  CHECK_FALSE(told_of<note::ShearBeyondLaw>(c));
  c.oil.range.rate_max = 0.9 * rate;
  CHECK(told_of<note::ShearBeyondLaw>(c));
}

TEST_CASE("FlowFactorsBelowTheirFitsAreTold", "[refusal]") {
  // Along the bearing grooves that lie around it act as ones across: gamma = 9 there is 1/9, whose
  // fit begins at h = sigma, not at half of it.
  Case c = plain_case();
  place_journal(c, 0.6, 0.5);
  const double least = c.bearing.radial_clearance * 0.4;
  for (const auto& [gamma, part] : {std::pair{1.0, 0.5}, std::pair{9.0, 1.0}}) {
    for (const bool below : {false, true}) {
      c.surfaces.shell.roughness = least / part * (below ? 1.05 : 0.9);
      c.surfaces.shell.orientation = gamma;
      c.model.switches.flow_factors = true;
      INFO(gamma << ", " << below);
      CHECK(told_of<note::FactorsContinued>(c) == below);
    }
  }
}

TEST_CASE("TheInertiaOfASqueezedFilmIsMarked", "[refusal]") {
  // rho v c/eta beyond 1, with the largest velocity v of a journal that does not turn; a film of
  // constant viscosity knows eta times v alone, and v goes with the load.
  Case c = plain_case();
  c.model.grid = {24, 5};
  c.bearing.radial_clearance = 100e-6;
  c.supplies[0].kind = SupplyKind::circumferential_groove;
  c.supplies[0].arc = 2.0 * kPi;
  c.supplies[0].length = 0.002;
  c.supplies[0].pressure = 5e5;
  const double rho = std::get<rheology::ConstantDensity>(c.oil.density).rho;
  const double eta = 2e-3;
  c.oil.temperature = rheology::ConstantViscosity{eta};
  const auto of = [&](double force) {
    LoadCycle cycle;
    cycle.period = 0.001;
    cycle.interpolation = LoadInterpolation::periodic_spline;
    for (int k = 0; k < 24; ++k) {
      cycle.t.push_back(cycle.period * k / 24);
      cycle.x.push_back(force * std::cos(2.0 * kPi * k / 24));
      cycle.y.push_back(force * std::sin(2.0 * kPi * k / 24));
      cycle.omega.push_back(0.0);
    }
    c.cycle = cycle;
    return solve_cycle(c, Tier::isothermal);
  };
  const auto marked = [](const CycleResult& r) {
    return std::any_of(r.warnings.begin(), r.warnings.end(), [](const Note& w) {
      const auto* inertia = std::get_if<note::FilmInertia>(&w);
      return inertia != nullptr && inertia->squeezed;
    });
  };
  for (const double force : {1.0, 40.0}) {
    const CycleResult r = of(force);
    INFO(app::reason_of(r.verdict));
    REQUIRE(r.verdict.good());
    double v = 0.0;
    for (const CycleInstant& i : r.instants) v = std::max(v, std::hypot(i.vx, i.vy));
    INFO("force " << force << " N, rho v c/eta " << rho * v * 100e-6 / eta);
    CHECK(marked(r) == (rho * v * 100e-6 / eta > 1.0));
    CHECK(marked(r) == (force > 10.0));
  }
}

TEST_CASE("ALayerPressedBeyondItsHardnessIsMarkedWhereItIsElastic", "[refusal]") {
  Case c = rig_case();
  c.model.grid = {40, 7};
  c.model.switches.elastic_deformation = true;
  const auto solved = [&] { return summarize(solve_tier(c, Tier::isothermal), Tier::isothermal); };
  const auto marked = [](const Result& r) {
    return std::any_of(r.warnings.begin(), r.warnings.end(), [](const Note& w) {
      return std::holds_alternative<note::LayerBeyondHardness>(w);
    });
  };
  solid::Material& lining = c.shell->layers.front().material;
  lining.hardness = 0.0;  // not known
  const Result free = solved();
  REQUIRE(free.verdict.good());
  CHECK_FALSE(marked(free));
  lining.hardness = 0.9 * free.value("p_max");
  CHECK(marked(solved()));
  lining.hardness = 1.1 * free.value("p_max");
  CHECK_FALSE(marked(solved()));
}
