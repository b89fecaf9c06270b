// Running-in over load cycles: against loads that stand still, friction work, mirror and pieces.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/words/ending_words.hpp"
#include "bearing/judge/judge_case.hpp"
#include "bearing/over_time/running_in.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

constexpr double kWear = 1e-6;       ///< [-]
constexpr double kHardness = 350e6;  ///< [Pa]

/// The KS bearing, elastic, at a speed at which its edges rub, under a load of one turn's period:
/// `mean` - `swing` cos downwards [N].
Case cycle_case(double mean, double swing) {
  constexpr int kRows = 24;
  Case c = rig_case();
  c.model.tier = Tier::isothermal;
  c.model.switches.elastic_deformation = true;
  c.model.grid = {40, 9};
  c.model.axial_spacing = AxialSpacing::graded;
  c.operation.omega = 600.0 * kPi / 30.0;
  c.operation.position = LoadGiven{mean, 270.0 * kDegree};
  LoadCycle cycle;
  cycle.period = 0.1;
  for (int k = 0; k < kRows; ++k) {
    cycle.t.push_back(cycle.period * k / kRows);
    cycle.x.push_back(0.0);
    cycle.y.push_back(-mean + swing * std::cos(2.0 * kPi * k / kRows));
  }
  cycle.interpolation = LoadInterpolation::periodic_spline;
  cycle.journal_mass = 5.0;
  c.cycle = cycle;
  c.running_in = RunningIn{kWear, kHardness, 30.0, 0.0, {}, 0.0};
  return c;
}

RunningInRun worn(const Case& c, Tier tier = Tier::isothermal) {
  const RunningInRun run = run_in(c, tier);
  INFO(app::reason_of(run.verdict));
  REQUIRE(run.verdict.good());
  return run;
}

}  // namespace

TEST_CASE("ACycleWhoseLoadStandsStillWearsAsTheStandingLoad") {
  const Case c = cycle_case(8e3, 0.0);
  Case standing = c;
  standing.cycle.reset();
  const RunningInState over = worn(c).states.back();
  const RunningInState still = worn(standing).states.back();
  REQUIRE(still.depth > 0.1e-6);
  // each may err by a step in wear (0.1 % of the depth, a few of one sign); cycles end within 0.1 %
  CHECK(over.depth == Approx(still.depth).epsilon(0.005));
  CHECK(over.volume == Approx(still.volume).epsilon(0.005));
  CHECK(over.p_asperity_max == Approx(still.p_asperity_max).epsilon(0.01));
  CHECK(over.torque == Approx(still.torque).epsilon(0.002));
}

TEST_CASE("WornVolumeIsTheFrictionWorkOfAsperities") {
  // Archard's law over a cycle: V = (C/H) <int p_a |U| dA> t = C/(H mu) <T_a omega> t, with the
  // asperities' torque as it is told of the cycle.
  Case c = cycle_case(6e3, 5e3);
  const double t = 1e-4;
  c.running_in->duration = t;
  const RunningInRun run = worn(c);
  const double torque = value_of(*run.cycle, "friction_torque_asperity");
  const double mu = c.surfaces.contact->friction;
  const double volume = kWear / (kHardness * mu) * torque * c.operation.omega * t;
  REQUIRE(torque > 0.0);
  // in a tenth of a millisecond the contact pressure falls by less than 0.1 %
  CHECK(run.states.back().volume == Approx(volume).epsilon(2e-3));
  double profile = 0.0;
  for (int k = 0; k < run.grid.cells(); ++k) {
    profile += run.wear[k] * run.grid.area(k);
  }
  CHECK(run.states.back().volume == Approx(profile).epsilon(1e-12));
}

TEST_CASE("WearOverACycleDoesNotHangOnItsStepsInTime") {
  Case c = cycle_case(6e3, 5e3);
  const RunningInState usual = worn(c).states.back();
  c.model.tolerance = 0.002;  // steps shorter by 1.7, each five times more exact
  const RunningInState fine = worn(c).states.back();
  REQUIRE(usual.depth > 0.1e-6);
  // 1e-3 of the film in a step is about 1 % of a contact pressure that falls by e within its sigma
  CHECK(usual.depth == Approx(fine.depth).epsilon(0.01));
  CHECK(usual.volume == Approx(fine.volume).epsilon(0.01));
}

TEST_CASE("ABearingThatTurnsTheOtherWayWearsInTheMirror") {
  Case c = cycle_case(6e3, 5e3);
  const RunningInRun run = worn(c);
  c.operation.omega = -c.operation.omega;
  const RunningInRun mirror = worn(c);
  // the load and the oil hole stand on the mirror's axis; iterations leave 1e-5 of a film
  CHECK(mirror.states.size() == run.states.size());
  CHECK(mirror.states.back().volume == Approx(run.states.back().volume).epsilon(1e-3));
  const auto place = [](const RunningInRun& r) {
    const auto at = std::max_element(r.wear.begin(), r.wear.end()) - r.wear.begin();
    return r.grid.phi[static_cast<int>(at) / r.grid.nz];
  };
  const double across = std::remainder(place(run) + place(mirror) - kPi, 2.0 * kPi);
  CHECK(std::abs(across) < 1e-9);
}

TEST_CASE("ACycleRunInInPiecesIsTheWhole") {
  const Case c = cycle_case(6e3, 5e3);
  const RunningInState whole = worn(c).states.back();
  Case piece = c;
  piece.running_in->duration = 10.0;
  const RunningInRun first = worn(piece);
  piece.bearing.shape = wear_table(first.grid, first.wear);
  piece.running_in->duration = 20.0;
  const RunningInState second = worn(piece).states.back();
  // the second piece begins anew, with a short step of first order
  CHECK(first.states.back().volume + second.volume == Approx(whole.volume).epsilon(0.005));
  CHECK(second.p_asperity_max == Approx(whole.p_asperity_max).epsilon(0.01));
}

TEST_CASE("WallsFollowAShellThatWearsOverCycles") {
  // The worn shape given to a case that is solved from cold: the same walls, the same contact.
  Case c = cycle_case(6e3, 5e3);
  c.model.tier = Tier::tehd;
  c.model.switches.elastic_deformation.reset();
  const RunningInRun run = worn(c, Tier::tehd);
  REQUIRE(run.states.back().depth > 0.05e-6);
  c.bearing.shape = wear_table(run.grid, run.wear);
  const CycleResult cold = solve_cycle(c, Tier::tehd);
  REQUIRE(cold.verdict.good());
  // walls within 0.1 K, which is 0.3 % of the viscosity and a third of a per cent of the film
  CHECK(run.states.back().h_min == Approx(value_of(cold, "h_min")).epsilon(0.004));
  CHECK(run.states.back().torque == Approx(value_of(cold, "friction_torque")).epsilon(0.004));
  CHECK(value_of(*run.cycle, "T_shell_max") == Approx(value_of(cold, "T_shell_max")).margin(0.3));
  CHECK(run.cycle->audit.energy < 1e-8);
}

TEST_CASE("ARunningInThatIsStoppedKeepsWhatItHas") {
  std::atomic<bool> stop{false};
  SolveControl control;
  control.stop = &stop;
  const auto seen = [&](const RunningInRun& run) { stop = run.states.size() == 3; };
  const RunningInRun run = run_in(cycle_case(6e3, 5e3), Tier::isothermal, control, seen);
  CHECK(run.verdict.status == Status::interrupted);
  REQUIRE(run.states.size() == 3);
  CHECK(*std::max_element(run.wear.begin(), run.wear.end()) == run.states.back().depth);
  CHECK(run.cycle->verdict.good());
}

TEST_CASE("WearOfLessThanACycleOrOfImpossibleSurfacesIsRefused") {
  const auto refused = [](const char* key, auto change) {
    Case c = cycle_case(8e3, 4e3);
    change(*c.running_in);
    const auto found = judge(c);
    return std::any_of(found.begin(), found.end(),
                       [key](const Finding& f) { return f.refused() && f.key == key; });
  };
  CHECK_FALSE(refused("running_in.until", [](RunningIn& r) { r.duration = 0.11; }));
  CHECK(refused("running_in.until", [](RunningIn& r) { r.duration = 0.09; }));
  CHECK(refused("running_in.hardness", [](RunningIn& r) { r.hardness = 350.0; }));
  CHECK(refused("running_in.wear_coefficient", [](RunningIn& r) { r.wear_coefficient = 2.0; }));
}

TEST_CASE("TheShapeWornInOverACycleIsWhereLongRunningArrives") {
  Case c = cycle_case(6e3, 5e3);
  c.model.grid = {24, 7};
  c.running_in->limit_pressure = 2e6;
  c.running_in->duration = 4e4;
  const RunningInState long_run = worn(c).states.back();
  c.running_in->duration.reset();
  const RunningInRun end = worn(c);
  CHECK(end.complementarity <= 1e-6);
  REQUIRE(end.states.back().depth > 0.1e-6);
  // (3) as it stands: nowhere harder than the limit, and at it where there is wear
  CHECK(end.states.back().p_asperity_max == Approx(2e6).epsilon(1e-4));
  CHECK(*std::min_element(end.wear.begin(), end.wear.end()) == 0.0);
  // in time a cell that its neighbours relieve later stays worn, and each step errs by 0.1 %
  CHECK(long_run.depth == Approx(end.states.back().depth).epsilon(0.01));
  CHECK(long_run.volume / end.states.back().volume == Approx(1.0).margin(0.03));
  CHECK(long_run.volume > end.states.back().volume * 0.998);
  CHECK(long_run.p_asperity_max <= 2e6 * 1.001);
}

TEST_CASE("TheShapeWornInOverACycleWithHeatIsFound") {
  Case c = cycle_case(6e3, 5e3);
  c.model.tier = Tier::tehd;
  c.model.switches.elastic_deformation.reset();
  c.model.grid = {24, 7};
  c.running_in->limit_pressure = 2e6;
  c.running_in->duration.reset();
  const RunningInRun end = worn(c, Tier::tehd);
  CHECK(end.complementarity <= 1e-6);
  CHECK(end.states.back().p_asperity_max == Approx(2e6).epsilon(1e-4));
  CHECK(end.cycle->audit.energy < 1e-8);
}
