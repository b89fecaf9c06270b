// Work over load cycles and events: what load, moment and shaft spend is the heat that is made.
#include <catch2/catch.hpp>
#include <limits>

#include "bearing/over_time/cycle.hpp"
#include "tests/bearing/solved.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// Loads downwards at instants, once.
LoadCycle event_of(std::vector<double> t, const std::vector<double>& downwards) {
  LoadCycle event;
  event.t = std::move(t);
  for (const double load : downwards) {
    event.x.push_back(0.0);
    event.y.push_back(-load);
  }
  return event;
}

/// The load falls to a third within ten turns and stays.
Case unloaded(const Case& still, double load) {
  Case c = still;
  set_load(c, load);
  const double turn = 2.0 * kPi / std::abs(c.operation.omega);
  c.cycle = event_of({0.0, turn, 2.0 * turn, 4.0 * turn}, {load, load, load / 3.0, load / 3.0});
  return c;
}

}  // namespace

TEST_CASE("TheWorkOfAMomentIsCountedWhereAnEventEndsWithAnotherTilt", "[cycle_heat]") {
  Case still = warm_case();
  still.model.grid = {36, 6};
  Case c = unloaded(still, 6e3);
  c.operation.alignment = MomentGiven{10.0, 5.0};
  const CycleResult r = converged(c, Tier::thd);
  const CycleInstant& first = r.instants.front();
  const CycleInstant& last = r.instants.back();
  const double by_moment =
      (10.0 * (last.tilt_x - first.tilt_x) + 5.0 * (last.tilt_y - first.tilt_y)) / last.t;
  const double power = value(r, "power_loss");
  // What is left is of second order in the steps; the moment's part must stand well above it.
  CHECK(std::abs(by_moment) > 5e-4 * power);
  CHECK(std::abs(r.audit.work) < 0.2 * std::abs(by_moment) / power);
  // The series has it, too.
  double sum = 0.0;
  for (std::size_t k = 1; k < r.instants.size(); ++k) {
    const CycleInstant& i = r.instants[k];
    sum += i.dt * (i.power - i.torque * i.omega - i.load_x * i.vx - i.load_y * i.vy);
  }
  CHECK(sum / last.t == Approx(by_moment).epsilon(1e-9));
}

TEST_CASE("WorkThatElasticSurfacesHoldAtTheEndOfAnEventIsNotLost", "[cycle_heat]") {
  Case still = warm_case();
  still.model.grid = {36, 6};
  still.shell->layers[0].material.youngs_modulus = 10e9;
  Case c = unloaded(still, 6e3);
  std::vector<double> lost;
  for (const double steps : {48.0, 96.0}) {
    c.cycle->step = c.cycle->t.back() / steps;
    lost.push_back(std::abs(converged(c, Tier::tehd).audit.work));
  }
  INFO(lost[0] << ", " << lost[1]);
  CHECK(lost[0] < 1e-4);           // what is held at the end is 1.4e-3
  CHECK(lost[1] < lost[0] / 3.0);  // of second order, 4
}

TEST_CASE("ThePowerOfAShortPulseOrAJumpIsItsWorkHoweverFewItsSteps", "[cycle]") {
  const bool jump = GENERATE(false, true);
  Case c = plain_case();
  c.model.grid = {40, 6};
  set_load(c, 1e3);
  c.cycle = event_of({0.0, 0.5e-3, 0.505e-3, 0.51e-3, 1e-3}, {1e3, 1e3, 20e3, 1e3, 1e3});
  if (jump) c.cycle = event_of({0.0, 0.5e-3, 0.5e-3, 1e-3}, {1e3, 1e3, 9e3, 9e3});
  const CycleResult coarse = converged(c);
  c.cycle->step = 1e-6;
  const double fine = value(converged(c), "power_loss");
  double trapezia = 0.0;  // of the product: up to a half too much of a flank's work
  for (std::size_t k = 1; k < coarse.instants.size(); ++k) {
    trapezia +=
        0.5 * coarse.instants[k].dt * (coarse.instants[k].power + coarse.instants[k - 1].power);
  }
  INFO(value(coarse, "power_loss") << ", " << fine);
  CHECK(value(coarse, "power_loss") == Approx(fine).epsilon(1e-3));  // the tolerance of a step
  const double by_trapezia = std::abs(trapezia / coarse.instants.back().t / fine - 1.0);
  CHECK((jump || by_trapezia > 5e-3));  // what the pulse is to show
}
