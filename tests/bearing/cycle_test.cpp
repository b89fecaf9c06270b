// Load cycles: the film in time against steady films, linear theory, its own symmetries and order.
#include "bearing/over_time/cycle.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "bearing/over_time/cycle_endings.hpp"
#include "bearing/over_time/cycle_steps.hpp"
#include "tests/bearing/pulsed_case.hpp"
#include "tests/bearing/solved.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

TEST_CASE("ALoadThatStandsStillGivesTheSteadyBearing", "[cycle]") {
  Case c = pulsed_case();
  set_load(c, 2e3);
  c.cycle = over_two_turns(c, [](double) { return Load{0.0, -2e3}; });
  const Quantities steady = steady_values(c);
  const CycleResult r = converged(c);
  // Cycles are repeated until two agree within 1e-4.
  CHECK(value(r, "h_min") == Approx(steady.h_min).epsilon(2e-4));
  CHECK(value(r, "friction_torque") == Approx(steady.friction_torque).epsilon(2e-4));
  CHECK(value(r, "p_max") == Approx(steady.p_max).epsilon(2e-3));
  CHECK(value(r, "side_flow") == Approx(steady.side_flow).epsilon(2e-3));
}

TEST_CASE("AFilmOfOneTemperatureTellsOnceThatItsOilIsOutOfRange", "[cycle]") {
  Case c = pulsed_case();
  c.model.grid = {48, 4};
  c.oil.range.T_max = c.oil_temperature.value() - 1.0;
  const auto told = [](const Case& of) {
    const CycleResult r = converged(of);
    return std::count_if(r.warnings.begin(), r.warnings.end(), [](const Note& n) {
      return std::holds_alternative<note::BeyondOilRange>(n);
    });
  };
  CHECK(told(c) == 1);
  c.oil.range.T_max = c.oil_temperature.value() + 1.0;
  CHECK(told(c) == 0);
}

TEST_CASE("ALoadThatTurnsIsASteadyLoadAtAnotherSpeed", "[cycle]") {
  // In a frame that turns with the load, at a quarter of the journal's speed, oil is drawn in at
  // (omega - 2 omega/4)/2: the steady bearing of half the speed. The supply is a ring, which knows
  // no direction.
  Case c = plain_case();
  c.supplies[0].arc = 2.0 * kPi;
  c.supplies[0].length = 4e-3;
  c.supplies[0].pressure = 2e5;
  c.model.grid = {96, 12};
  LoadCycle turning;
  const double omega = c.operation.omega;
  turning.period = 8.0 * kPi / omega;
  for (int k = 0; k < 96; ++k) {
    const double angle = 2.0 * kPi * k / 96;
    turning.t.push_back(turning.period * k / 96);
    turning.x.push_back(1e3 * std::cos(angle));
    turning.y.push_back(1e3 * std::sin(angle));
  }
  turning.interpolation = LoadInterpolation::periodic_spline;
  c.cycle = turning;
  c.model.tolerance = 3e-3;
  const CycleResult r = converged(c);
  c.operation.omega = 0.5 * omega;
  set_load(c, 1e3);
  const Quantities steady = steady_values(c);
  // The upstream fill is carried over the grid in one of the two: half a cell of 96 in the place of
  // the film's end.
  CHECK(value(r, "h_min") == Approx(steady.h_min).epsilon(0.01));
  double least = INFINITY;
  double most = 0.0;
  double pressure = 0.0;  // its mean: the peak jumps as cells fill
  for (const CycleInstant& i : r.instants) {
    pressure += i.dt * i.p_max / r.period;
    least = std::min(least, std::hypot(i.ex, i.ey));
    most = std::max(most, std::hypot(i.ex, i.ey));
  }
  CHECK(pressure == Approx(steady.p_max).epsilon(0.02));
  CHECK(most / least < 1.01);  // the orbit is a circle
}

TEST_CASE("WithFrontsKeptSharpALoadThatStandsStillGivesTheSteadyBearing", "[cycle]") {
  Case c = pulsed_case();
  set_load(c, 2e3);
  c.cycle = over_two_turns(c, [](double) { return Load{0.0, -2e3}; });
  const Quantities steady = steady_values(c);
  c.model.methods.transport = FillTransport::van_leer;
  const CycleResult r = converged(c);
  // The steady film counts the fill of a cell at its downstream face, the cycle in its middle: the
  // flow is the same, and so are film and friction but for the square of the cell.
  CHECK(value(r, "friction_torque") == Approx(steady.friction_torque).epsilon(2e-4));
}

TEST_CASE("AStarvedFilmNeedsAQuarterOfTheCellsWithFrontsKeptSharp", "[cycle]") {
  // A load that turns with the journal: the hole feeds the film once in a turn.
  Case c = pulsed_case();
  c.cycle = over_two_turns(c, [](double a) { return Load{1e3 * std::cos(a), 1e3 * std::sin(a)}; });
  const auto film = [&](int cells, FillTransport transport) {
    c.model.grid = {cells, 7};
    c.model.methods.transport = transport;
    return value(converged(c), "h_min");
  };
  const double upwind = film(32, FillTransport::upwind), finer = film(64, FillTransport::upwind);
  // Fronts that are smeared leave the film too thick; the error falls with the root of the cell,
  // so that four times as many cells leave half of it.
  CHECK(finer < upwind);
  CHECK(film(32, FillTransport::van_leer) < finer);
}

TEST_CASE("OilThatManyCyclesGatherIsLedOnToWhereTheyLead", "[cycle]") {
  // A short groove that feeds a light load that turns with the journal.
  Case c = pulsed_case();
  c.cycle = over_two_turns(c, [](double a) { return Load{300 * std::cos(a), 300 * std::sin(a)}; });
  c.supplies[0].pressure = 1e4;
  c.supplies[0].length = 0.004;
  c.model.grid = {32, 7};
  c.cycle->step = 8.0 * kDegree / c.cycle->crank_speed;
  const CycleResult r = converged(c);
  // The judge: one cycle after the other in the same steps, each from where the last one ended.
  const double length = c.cycle->length();
  const LoadCourse course(*c.cycle, c.operation.omega);
  FilmSteps film(make_bearing(c, physics_of(c, Tier::isothermal), c.model.grid), course,
                 c.cycle->journal_mass, {});
  CycleSteps steps(film, course, length, {1e-3, length, 1e-7 * length, length, *c.cycle->step});
  FilmInTime now = film.at_rest(equivalent_temperature(c));
  EquilibriumCost cost;
  Closure closure;
  double least = INFINITY, before = 0.0;
  int cycles = 0, until_closed = 0;
  while (std::abs(least / before - 1.0) > 1e-6) {
    before = std::exchange(least, INFINITY);
    const auto tell = [&](const FilmStep& s, double) {
      least = std::min(least, s.after.film.least.h);
    };
    REQUIRE(steps.pass(now, cost, {}, tell, [] {}).verdict.good());
    ++cycles;
    closure.add(std::abs(least / before - 1.0));
    if (until_closed == 0 && closure.closed()) until_closed = cycles;
  }
  CHECK(value(r, "h_min") == Approx(least).epsilon(1e-4));  // to which a search closes
  CHECK(r.cycles < until_closed);
}

TEST_CASE("AGivenStepIsKeptInEveryPeriod", "[cycle]") {
  // A tenth of the first step behind a jump, which came back twice as long in the second period.
  Case c = pulsed_case();
  c.model.grid = {32, 4};
  const double length = c.cycle->length(), given = length / 1000.0;
  const LoadCourse course(*c.cycle, c.operation.omega);
  FilmSteps film(make_bearing(c, physics_of(c, Tier::isothermal), c.model.grid), course,
                 c.cycle->journal_mass, {});
  CycleSteps steps(film, course, length, {1.0, length, 1e-7 * length, 10.0 * given, given});
  FilmInTime now = film.at_rest(equivalent_temperature(c));
  EquilibriumCost cost;
  for (int period = 0; period < 3; ++period) {
    double longest = 0.0;
    const auto tell = [&](const FilmStep&, double dt) { longest = std::max(longest, dt); };
    REQUIRE(steps.pass(now, cost, {}, tell, [] {}).verdict.good());
    CHECK(longest <= given * (1.0 + 1e-9));  // round-off
  }
}

TEST_CASE("OilThatIsLedOnIsNotTakenFromEmptyCells", "[cycle]") {
  // A light journal between rough surfaces, its load standing, in periods of a twentieth of a turn:
  // the oil of twelve of them empties cells. "A step takes more oil out of a cell than it holds"
  // was the end.
  Case c = plain_case();
  c.bearing = {0.015, 0.015, 15e-6, 353.15, {}};
  c.supplies[0].arc = 20.0 * kDegree;
  c.supplies[0].length = 0.01;
  c.supplies[0].pressure = 2e5;
  c.oil.temperature = rheology::ConstantViscosity{0.01};
  c.surfaces.shell = {0.3e-6, 1.0, 0.25e-6, 0.3e-6};
  c.surfaces.shaft = {0.2e-6, 1.0, 0.15e-6, 0.2e-6};
  c.surfaces.contact = solid::ContactParameters{0.001, 80e9, 0.1, solid::ContactIntegral::exact};
  c.operation.omega = 300.0 * kPi / 30.0;
  c.model.grid = {60, 9};
  c.model.axial_spacing = AxialSpacing::even;
  set_load(c, 3e3);
  const Quantities steady = steady_values(c);
  c.cycle = over_two_turns(c, [](double) { return Load{0.0, -3e3}; });
  c.cycle->t = {0.0, 0.005};
  c.cycle->x = {0.0, 0.0};
  c.cycle->y = {-3e3, -3e3};
  c.cycle->interpolation = LoadInterpolation::linear;
  c.cycle->period = 0.01;
  c.cycle->journal_mass = 1.0;
  const CycleResult r = converged(c);
  CHECK(value(r, "h_min") == Approx(steady.h_min).epsilon(2e-4));
  CHECK(value(r, "friction_torque") == Approx(steady.friction_torque).epsilon(1e-3));
}

TEST_CASE("FilmAndTorqueAreOfSecondOrderInTime", "[cycle]") {
  Case c = pulsed_case();
  c.model.tolerance = 1e-4;  // films that are known far better than the steps err
  const double degree = kDegree / c.cycle->crank_speed;
  const auto with_step = [&](double step) {
    c.cycle->step = step * degree;
    return converged(c);
  };
  const CycleResult truth = with_step(0.25);
  /// Mean deviation of a value at common instants, every 4 degrees.
  const auto off = [&](const CycleResult& r, double step, double CycleInstant::*v) {
    const auto stride = static_cast<std::size_t>(std::lround(4.0 / step));
    double sum = 0.0;
    for (std::size_t k = 1; k <= 180; ++k) {
      sum += std::abs(r.instants[k * stride].*v / truth.instants[k * 16].*v - 1.0);
    }
    return sum / 180.0;
  };
  const CycleResult coarse = with_step(4.0);
  const CycleResult fine = with_step(2.0);
  const auto near_two = [](double coarse, double fine) {
    const double order = std::log2(coarse / fine);
    CHECK(order > 1.85);
    CHECK(order < 2.15);
  };
  near_two(off(coarse, 4.0, &CycleInstant::h_min), off(fine, 2.0, &CycleInstant::h_min));
  // Torque as its mean: at one instant it holds the moment of the pressure, which jumps as cells
  // fill.
  const auto mean_off = [&](const CycleResult& r) {
    return std::abs(value(r, "friction_torque") / value(truth, "friction_torque") - 1.0);
  };
  near_two(mean_off(coarse), mean_off(fine));
}

TEST_CASE("StepsChosenByTheirErrorKeepTheToleranceAskedFor", "[cycle]") {
  Case c = pulsed_case();
  c.model.tolerance = 1e-3;
  const CycleResult fine = converged(c);
  c.model.tolerance = 1e-2;
  const CycleResult usual = converged(c);
  CHECK(usual.steps < fine.steps);
  for (const char* name : {"h_min", "friction_torque", "p_max", "side_flow"}) {
    INFO(name);
    CHECK(value(usual, name) == Approx(value(fine, name)).epsilon(1e-2));
  }
}

TEST_CASE("SmallOscillationsAnswerAsStiffnessAndDampingSay", "[cycle]") {
  // Once in twenty turns: the damping is that of motions slower than the oil's way through the
  // cavitated film.
  Case c = plain_case();
  c.model.coefficients = true;
  c.model.grid = {144, 12};  // half the cells err by twice as much: the film's ends stand on cells
  const Solution steady = solve_tier(c, Tier::isothermal);
  REQUIRE(steady.coefficients);
  const Matrix2 K = forces_of(steady.coefficients->K);
  const Matrix2 C = forces_of(steady.coefficients->C);
  constexpr double kShake = 100.0;  // [N], a twentieth of the load
  const double shaken = c.operation.omega / 20.0;
  c.cycle = over_two_turns(c, [&](double a) { return Load{kShake * std::cos(0.5 * a), -2e3}; });
  for (double& t : c.cycle->t) t *= 10.0;
  c.cycle->period *= 10.0;
  c.cycle->journal_mass = 0.0;
  c.model.tolerance = 1e-4;
  const CycleResult r = converged(c);
  using Complex = std::complex<double>;
  Complex x = 0.0;
  Complex y = 0.0;
  for (std::size_t k = 1; k < r.instants.size(); ++k) {  // first harmonic
    const auto& a = r.instants[k - 1];
    const auto& b = r.instants[k];
    const auto turn = [&](double t) { return std::polar(1.0, -shaken * t); };
    x += 0.5 * b.dt * (a.ex * turn(a.t) + b.ex * turn(b.t));
    y += 0.5 * b.dt * (a.ey * turn(a.t) + b.ey * turn(b.t));
  }
  x *= 2.0 / r.period;
  y *= 2.0 / r.period;
  const auto force = [&](int i) {
    const Complex s(0.0, shaken);
    return (K[i][0] + s * C[i][0]) * x + (K[i][1] + s * C[i][1]) * y;
  };
  CHECK(std::abs(force(0) - kShake) < 0.02 * kShake);
  CHECK(std::abs(force(1)) < 0.02 * kShake);
}

TEST_CASE("ACycleDoesNotKnowWhereItsPeriodBegins", "[cycle]") {
  Case c = pulsed_case();
  const CycleResult a = converged(c);
  c.cycle = over_two_turns(c, [](double angle) { return pulse(angle + 1.3 * kPi); });
  const CycleResult b = converged(c);
  for (const char* name : {"h_min", "friction_torque", "side_flow"}) {
    INFO(name);
    CHECK(value(b, name) == Approx(value(a, name)).epsilon(3e-3));  // other steps in time
  }
  const double turned = (named(a, "p_max").at - named(b, "p_max").at) * c.operation.omega;
  CHECK(turned == Approx(1.3 * kPi).margin(0.1));  // the pulse is this much earlier
}

TEST_CASE("TheMirroredCycleIsTheMirroredOrbit", "[cycle]") {
  Case c = pulsed_case();
  const CycleResult a = converged(c);
  c.operation.omega = -c.operation.omega;
  for (Supply& s : c.supplies) s.angle = kPi - s.angle;
  for (double& x : c.cycle->x) x = -x;
  const CycleResult b = converged(c);
  CHECK(value(b, "h_min") == Approx(value(a, "h_min")).epsilon(1e-5));
  CHECK(value(b, "friction_torque") == Approx(-value(a, "friction_torque")).epsilon(1e-5));
  REQUIRE(a.instants.size() == b.instants.size());
  for (std::size_t k = 0; k < a.instants.size(); ++k) {
    CHECK(std::abs(a.instants[k].ex + b.instants[k].ex) < 1e-4 * c.bearing.radial_clearance);
    CHECK(std::abs(a.instants[k].ey - b.instants[k].ey) < 1e-4 * c.bearing.radial_clearance);
  }
}

TEST_CASE("ElasticSurfacesCarryThePulseOnAThickerFilm", "[cycle]") {
  // A pulse of 60 MPa squeezes rigid surfaces nearer than elastic ones, and to a higher pressure.
  Case c = rig_case();
  c.model.grid = {48, 7};
  c.supplies[0].pressure = 2e5;
  c.cycle = over_two_turns(c, [](double a) {
    const double from = std::remainder(a - 2.0 * kPi, 4.0 * kPi);
    return Load{2e3 * std::cos(a), 2e3 * std::sin(a) - 24e3 * std::exp(-from * from / 0.2)};
  });
  const CycleResult rigid = converged(c);
  c.model.switches.elastic_deformation = true;
  const CycleResult elastic = converged(c);
  CHECK(value(elastic, "p_max") < value(rigid, "p_max"));
  CHECK(value(elastic, "p_max") > 24e3 / (2.0 * c.bearing.radius * c.bearing.width));
}

TEST_CASE("AMomentTiltsTheJournalOverTheCycle", "[cycle]") {
  Case c = pulsed_case();
  c.operation.alignment = MomentGiven{0.5, 0.0};
  const CycleResult r = converged(c);
  double most = 0.0;
  for (const CycleInstant& i : r.instants) most = std::max(most, std::abs(i.tilt_x));
  CHECK(most > 1e-6);
  c.operation.alignment = TiltGiven{};
  CHECK(value(r, "h_min") < value(converged(c), "h_min"));
}
