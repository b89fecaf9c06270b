/// Shell, housing and shaft over time steps: balance, limits, thermal deformation, the walls'
/// predictor.
#include <algorithm>
#include <catch2/catch.hpp>

#include "bearing/solids.hpp"
#include "core/contract.hpp"
#include "core/make_grid.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

FilmGrid grid_of(const Case& c, int nt = 48) {
  return make_grid(c.bearing.radius, c.bearing.width, nt, 9, true);
}

/// A film that gives each wall heat as its temperature asks: warm all round, warmer where thin.
struct Film {
  const FilmGrid& grid;
  double temperature = 370.0;                 // [K]
  double shell = 4e3, shaft = 5e3;            // [W/(m2 K)]
  double from_shell = 2e3, from_shaft = 3e3;  // of what a wall gives, this reaches the other

  [[nodiscard]] WallFlux operator()(const Field& T_shell,
                                    const std::vector<double>& T_shaft) const {
    double ts = 0.0, tj = 0.0;  // area means
    for (int i = 0; i < grid.nt; ++i) {
      for (int j = 0; j < grid.nz; ++j) {
        const double part = grid.dphi[i] * grid.dz[j] / (2.0 * kPi * grid.z_face[grid.nz]);
        ts += part * T_shell[grid.index(i, j)];
        tj += part * T_shaft[j];
      }
    }
    WallFlux q{Field(grid.cells()), std::vector<double>(grid.nz), {}};
    for (int i = 0; i < grid.nt; ++i) {
      const double hot = 20.0 * std::cos(0.5 * (grid.phi_face[i] + grid.phi_face[i + 1]));
      for (int j = 0; j < grid.nz; ++j) {
        const int c = grid.index(i, j);
        q.shell[c] = shell * (temperature + hot - T_shell[c]) + from_shaft * (tj - temperature);
        q.shaft[j] = shaft * (temperature - T_shaft[j]) + from_shell * (ts - temperature);
      }
    }
    q.response = {shell, shaft, from_shaft, from_shell, shell, shell, shaft};
    return q;
  }
};

struct Walls {
  SolidTemperature answer;
  int rounds = 0;
  double change = INFINITY;  // [K]
};

/// Film and solids in balance at the end of a step, from the temperatures of `first`.
Walls balance(const Solids& solids, const Film& film, const SolidTemperature& first,
              const SolidStep* step) {
  Walls w{first};
  while (w.change > 1e-11 && w.rounds < 60) {
    const Field T = w.answer.shell.surface;
    const auto shaft = w.answer.shaft.temperature;
    w.answer = solids.answer(film(T, shaft), T, shaft, {true, true}, step);
    w.change = std::max(largest_difference(T, w.answer.shell.surface),
                        largest_difference(shaft, w.answer.shaft.temperature));
    ++w.rounds;
  }
  return w;
}

double imbalance(const SolidTemperature& t) {
  return std::abs(t.shell.heat_in - t.shell.heat_back - t.shell.heat_ends - t.shell.stored) +
         std::abs(t.shaft.heat_in - t.shaft.heat_out - t.shaft.stored);
}

Case steel_bearing(HousingSupport support) {
  Case c = warm_case();
  c.shell->housing->material = steel();
  c.shell->housing->support = support;
  return c;
}

}  // namespace

TEST_CASE("HeatIntoTheSolidsLeavesOrIsStored", "[solids_in_time]") {
  for (const bool prescribed : {false, true}) {
    Case c = warm_case();
    if (prescribed) c.shell->back = PrescribedBack{320.0};
    const FilmGrid grid = grid_of(c);
    const Solids solids(c, grid, {false, true, true});
    const Film film{grid};
    SolidState state = solids.uniform_state(293.15);
    SolidStep step;
    SolidTemperature now = solids.at(state);
    for (int k = 0; k < 5; ++k) {
      step = solids.step(2.0, state, &step);
      now = balance(solids, film, now, &step).answer;
      CHECK(std::abs(now.shell.stored + now.shaft.stored) > 10.0);
      CHECK(imbalance(now) < 1e-12 * (now.shell.heat_in + now.shaft.heat_in));
      state = solids.state(now, &step);
      const SolidTemperature again = solids.at(state);
      CHECK(largest_difference(again.shell.surface, now.shell.surface) < 1e-10);
      CHECK(largest_difference(again.thermal_deformation, now.thermal_deformation) <
            1e-9 * c.bearing.radial_clearance);
    }
  }
}

TEST_CASE("AJointDropsItsTemperature", "[solids_in_time]") {
  // Without heat through the ends what enters at the bore passes the joint: q/h less hot behind it.
  Case c = warm_case();
  c.shell->end_heat_transfer = 0.0;
  const double h = 2e3;
  c.shell->housing->joint_conductance = h;
  const FilmGrid grid = grid_of(c);
  const Solids solids(c, grid, {false, true, true});
  const Film film{grid};
  const SolidTemperature cold = solids.at(solids.uniform_state(303.15));
  const SolidTemperature t = balance(solids, film, cold, nullptr).answer;
  const WallFlux q = film(t.shell.surface, t.shaft.temperature);
  double mean = 0.0;
  for (const double x : q.shell) mean += x / static_cast<double>(q.shell.size());
  const double joint = c.bearing.radius + 5e-3;
  const std::vector<double> r = solids.section_radii();
  const std::vector<double> T = solids.section(t.shell);
  const auto inner = static_cast<std::size_t>(
      std::find_if(r.begin(), r.end(), [&](double x) { return x > joint - 1e-9; }) - r.begin());
  const auto outer = static_cast<std::size_t>(
      std::find_if(r.begin(), r.end(), [&](double x) { return x > joint + 1.9e-6; }) - r.begin());
  double drop = 0.0;
  for (int i = 0; i < grid.nt; ++i) {
    drop += (T[i * r.size() + inner] - T[i * r.size() + outer]) / grid.nt;
  }
  // 2 um on a radius of 30 mm: the cylinder's logarithm is 3e-5 of it off a plane.
  CHECK(drop == Approx(mean * c.bearing.radius / joint / h).epsilon(1e-4));
  CHECK(imbalance(t) < 1e-10 * (t.shell.heat_in + t.shaft.heat_in));
}

TEST_CASE("LongMarchOfTheSolidsEndsInTheSteadyAnswer", "[solids_in_time]") {
  for (const int nt : {48, 100}) {  // 12 harmonics; 25, of which some would be interpolated
    const Case c = warm_case();
    const FilmGrid grid = grid_of(c, nt);
    const Solids solids(c, grid, {false, true, true, true});
    const Film film{grid};
    SolidState state = solids.uniform_state(293.15);
    SolidTemperature now = solids.at(state);
    const SolidTemperature steady = balance(solids, film, now, nullptr).answer;
    SolidStep step;
    for (int k = 0; k < 30; ++k) {
      step = solids.step(1e4, state, &step);
      now = balance(solids, film, now, &step).answer;
      state = solids.state(now, &step);
    }
    CHECK(largest_difference(now.shell.surface, steady.shell.surface) < 1e-9);  // [K]
    CHECK(largest_difference(now.shell.back, steady.shell.back) < 1e-9);
    CHECK(largest_difference(now.shaft.temperature, steady.shaft.temperature) < 1e-9);
    CHECK(largest_difference(now.thermal_deformation, steady.thermal_deformation) <
          1e-9 * c.bearing.radial_clearance);
    CHECK(std::abs(now.shell.stored) + std::abs(now.shaft.stored) < 1e-8 * now.shell.heat_in);
    CHECK(largest_difference(solids.section(state), solids.section(steady.shell)) < 1e-9);
    const SolidState end = solids.state(steady);
    CHECK((end.shell - state.shell).cwiseAbs().maxCoeff() < 1e-9);
  }
}

TEST_CASE("InterpolatedHarmonicsMoveTheEndOfAMarchByLess", "[solids_in_time]") {
  const Case c = warm_case();
  const FilmGrid grid = grid_of(c, 100);
  const Solids solids(c, grid, {false, true, true});
  WallFlux q{random_field(static_cast<std::size_t>(grid.cells()), 3, 0.0, 4e4),
             std::vector<double>(grid.nz, 1e4),
             {}};
  const Field T(q.shell.size(), 350.0);
  const std::vector<double> shaft(grid.nz, 350.0);
  const SolidTemperature steady = solids.answer(q, T, shaft, {true, true});
  const SolidStep step = solids.step(1e9, solids.uniform_state(350.0));
  const SolidTemperature end = solids.answer(q, T, shaft, {true, true}, &step);
  // 1.3e-4 of their norm (HarmonicSample), of harmonics that hold a few kelvin here
  CHECK(largest_difference(end.shell.surface, steady.shell.surface) < 2e-4);
  CHECK(largest_difference(end.thermal_deformation, steady.thermal_deformation) <
        1e-4 * c.bearing.radial_clearance);
}

TEST_CASE("StepWithoutEndIsTheSteadyAnswer", "[solids_in_time]") {
  const Case c = warm_case();
  const FilmGrid grid = grid_of(c);
  const Solids solids(c, grid, {false, true, true});
  const Film film{grid};
  const Field T(grid.cells(), 330.0);
  const std::vector<double> shaft(grid.nz, 340.0);
  const SolidStep step = solids.step(INFINITY, solids.uniform_state(300.0));
  const auto a = solids.answer(film(T, shaft), T, shaft, {true, true}, &step);
  const auto b = solids.answer(film(T, shaft), T, shaft, {true, true});
  CHECK(a.shell.surface == b.shell.surface);
  CHECK(a.shaft.temperature == b.shaft.temperature);
  CHECK(a.thermal_deformation == b.thermal_deformation);
}

TEST_CASE("UniformStateOfAFreeBearingGrowsWithItsRadius", "[solids_in_time]") {
  const double T = 273.15, R = warm_case().bearing.radius, dT = T - 293.15;
  Case c = steel_bearing(HousingSupport::free);  // surroundings at 303.15 K: no part of this
  const FilmGrid grid = grid_of(c);
  const double one = std::abs(steel().expansion * dT * R);
  const Solids same(c, grid, {false, true, true});
  CHECK(largest_magnitude(same.at(same.uniform_state(T)).thermal_deformation) < 1e-6 * one);
  CHECK(largest_magnitude(same.at(same.uniform_state(293.15)).thermal_deformation) < 1e-6 * one);
  c.shell->layers[0].material = aluminium();
  c.shell->housing->material = aluminium();
  const Solids other(c, grid, {false, true, true});
  for (const double x : other.at(other.uniform_state(T)).thermal_deformation) {
    CHECK(x == Approx(R * (23e-6 - 11e-6) * dT).epsilon(1e-6));
  }
}

TEST_CASE("ClampedHousingGrowsIntoTheGap", "[solids_in_time]") {
  const Case c = steel_bearing(HousingSupport::clamped);
  const FilmGrid grid = grid_of(c);
  const Solids solids(c, grid, {false, true, true});
  const double dT = 60.0, R = c.bearing.radius;
  const Field warm = solids.at(solids.uniform_state(293.15 + dT)).thermal_deformation;
  const Field cold = solids.at(solids.uniform_state(293.15 - dT)).thermal_deformation;
  for (std::size_t k = 0; k < warm.size(); ++k) {
    CHECK(warm[k] < -steel().expansion * dT * R);  // the shaft's part, and the bore's on top
    CHECK(cold[k] == Approx(-warm[k]).epsilon(1e-9));
  }
  CHECK(largest_magnitude(solids.at(solids.uniform_state(293.15)).thermal_deformation) < 1e-15);
}

TEST_CASE("WarmShaftClosesTheGapBeforeTheHousingOpensIt", "[solids_in_time]") {
  // the warm-up of a bearing: least clearance is on the way, not at its end
  Case c = steel_bearing(HousingSupport::free);
  c.shell->back = ConvectiveBack{200.0, 293.15};
  c.shaft->ambient = 293.15;
  const FilmGrid grid = grid_of(c);
  const Solids solids(c, grid, {false, true, true});
  const Film film{grid};
  SolidState state = solids.uniform_state(293.15);
  SolidTemperature now = solids.at(state);
  const Field end = balance(solids, film, now, nullptr).answer.thermal_deformation;
  double least = 0.0;
  SolidStep step;
  for (int k = 0; k < 20; ++k) {
    step = solids.step(5.0, state, &step);
    now = balance(solids, film, now, &step).answer;
    state = solids.state(now, &step);
    for (const double x : now.thermal_deformation) least = std::min(least, x);
  }
  CHECK(least < -2e-6);
  CHECK(least < *std::min_element(end.begin(), end.end()));
}

TEST_CASE("MeansOfTheWallsAreFoundAtOnceWhateverTheStep", "[solids_in_time]") {
  const Case c = warm_case();
  const FilmGrid grid = grid_of(c);
  const Solids solids(c, grid, {false, true, true});
  const Film film{grid};
  const SolidState cold = solids.uniform_state(293.15);
  for (const double dt : {1e-3, 1.0, 1e3, double{INFINITY}}) {
    const SolidStep step = solids.step(dt, cold);
    const Walls w = balance(solids, film, solids.at(cold), &step);
    CHECK(w.change < 1e-11);
    CHECK(w.rounds < 12);
  }
}

TEST_CASE("ContactGrowthOfAStepIsThatOfItsFlux", "[solids_in_time]") {
  const Case c = warm_case();
  const FilmGrid grid = grid_of(c);
  const Solids solids(c, grid, {true, true, true});
  const SolidStep step = solids.step(0.5, solids.uniform_state(c.bearing.reference_temperature));
  const Field one(grid.cells(), 1.0);
  const Field brief = solids.widening(solids.contact_widening(1e3, {}, &step), one);
  const Field steady = solids.widening(solids.contact_widening(1e3, {}), one);
  WallFlux q{Field(grid.cells(), 1e3), std::vector<double>(grid.nz, 0.0), {}};
  const Field cold(grid.cells(), 300.0);
  const std::vector<double> shaft(grid.nz, 300.0);
  const Field with = solids.answer(q, cold, shaft, {true, false}, &step).thermal_deformation;
  std::fill(q.shell.begin(), q.shell.end(), 0.0);
  const Field without = solids.answer(q, cold, shaft, {true, false}, &step).thermal_deformation;
  for (std::size_t k = 0; k < brief.size(); ++k) {
    CHECK(brief[k] == Approx(with[k] - without[k]).epsilon(1e-6));
    CHECK(std::abs(brief[k]) < std::abs(steady[k]));
  }
}

TEST_CASE("SolidsWithoutHeatCapacityAreRefusedInTime", "[solids_in_time]") {
  Case c = warm_case();
  c.shell->housing->material.heat_capacity = 0.0;
  const FilmGrid grid = grid_of(c);
  const Solids solids(c, grid, {false, true, false});
  CHECK_THROWS_AS(solids.step(1.0, solids.uniform_state(300.0)), InputError);
  CHECK_THROWS_AS(solids.step(0.0, solids.uniform_state(300.0)), InputError);
}
