/// Film and walls together over time steps, the flow being that of a solved bearing.
#include <catch2/catch.hpp>

#include "bearing/heat/film_heat.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// Temperatures of film and walls on the flow of one film.
struct WarmUpByHand {
  const Solution& bearing;
  std::vector<double> T = bearing.film.columns.T;  ///< of the film's nodes [K]
  SolidTemperature walls{};
  thermal::EnergyBalance film{};  ///< half a bearing
  double change = INFINITY;       ///< of a wall in the last round [K]

  [[nodiscard]] const BearingModel& model() const { return bearing.model; }
  [[nodiscard]] const Solids& solids() const { return *bearing.model.solids; }

  /// Everything at one temperature.
  void start(double temperature) {
    std::fill(T.begin(), T.end(), temperature);
    walls = solids().at(solids().uniform_state(temperature));
  }
  void impose_walls() {
    const FilmGrid& g = model().domain.grid;
    const int n = model().gl.n;
    for (int c = 0; c < g.cells(); ++c) {
      T[c * n] = walls.shell.surface[c];
      T[c * n + n - 1] = walls.shaft.temperature[c % g.nz];
    }
  }
  [[nodiscard]] WallFlux flux(const thermal::FilmEnergy& energy,
                              const thermal::WallResponse& response) const {
    const FilmGrid& g = model().domain.grid;
    const thermal::WallHeat heat = energy.wall_heat(T);
    WallFlux q{heat.shell, std::vector<double>(g.nz, 0.0), response};
    for (int c = 0; c < g.cells(); ++c) {
      q.shell[c] /= g.area(c);
      q.shaft[c % g.nz] += heat.shaft[c] / (2.0 * kPi * g.radius * g.dz[c % g.nz]);
    }
    return q;
  }
  /// Film and walls to the end of a step; without `oil` and `step` to the steady state.
  void solve(std::optional<thermal::FilmStorage> oil, const SolidStep* step) {
    FilmEquilibrium now = bearing.film;
    now.columns.T = T;
    thermal::FilmEnergy energy(
        film_energy_problem(model(), bearing.point, now,
                            friction_of(model(), bearing.point, bearing.film), std::move(oil)));
    const auto response = energy.wall_response(3);
    change = INFINITY;
    for (int round = 0; change > 1e-10 && round < 400; ++round) {
      impose_walls();
      for (int k = 0; k < 4; ++k) energy.sweep(T);
      const Field shell = walls.shell.surface;
      const std::vector<double> shaft = walls.shaft.temperature;
      walls = solids().answer(flux(energy, response), shell, shaft, {true, true}, step);
      change = std::max(largest_difference(shell, walls.shell.surface),
                        largest_difference(shaft, walls.shaft.temperature));
    }
    impose_walls();
    for (int k = 0; k < 40; ++k) energy.sweep(T);
    walls = solids().answer(flux(energy, response), walls.shell.surface, walls.shaft.temperature,
                            {true, true}, step);
    film = energy.balance(T);
  }
  /// Oil of the cells, whose mass does not change [kg].
  [[nodiscard]] Field mass() const {
    const FilmGrid& g = model().domain.grid;
    Field m(g.cells());
    for (int c = 0; c < g.cells(); ++c) {
      m[c] = bearing.film.oil.density[c] * bearing.film.film.theta[c] * bearing.film.shear_gap[c] *
             g.area(c);
    }
    return m;
  }
};

}  // namespace

TEST_CASE("WarmUpStoresWhatItDoesNotLoseAndEndsSteady", "[warm_up]") {
  Case c = grooved_case();
  c.model.grid = {60, 9};
  const Solution s = solve_tier(c, Tier::thd);
  REQUIRE(s.verdict.good());
  WarmUpByHand steady{s};
  steady.start(313.15);
  steady.solve({}, nullptr);
  REQUIRE(steady.change < 1e-9);
  WarmUpByHand warm{s};
  warm.start(293.15);
  SolidState state = warm.solids().uniform_state(293.15);
  SolidStep step;
  double before = 0.0;
  for (const double dt : {0.01, 1.0, 30.0, 30.0, 1e3, 1e4, 1e5, 1e7, 1e9, 1e9}) {
    step = warm.solids().step(dt, state, &step);
    warm.solve(
        thermal::FilmStorage{dt, warm.mass(), warm.mass(),
                             thermal::heat_content(warm.mass(), film_enthalpy(s.model, warm.T))},
        &step);
    state = warm.solids().state(warm.walls, &step);
    const double in = 2.0 * (warm.film.heat + warm.film.carried_in - warm.film.carried_out);
    const auto& w = warm.walls;
    const double out = w.shell.heat_back + w.shell.heat_ends + w.shaft.heat_out;
    const double stored = w.shell.stored + w.shaft.stored + 2.0 * warm.film.stored;
    CHECK(std::abs(in - out - stored) < 1e-8 * 2.0 * warm.film.heat);
    CHECK(w.shaft.temperature[0] > before);  // it only warms
    before = w.shaft.temperature[0] - 1e-9;
  }
  CHECK(largest_difference(warm.T, steady.T) < 1e-6);  // [K]; the walls stop at 1e-10 a round
  CHECK(largest_difference(warm.walls.shell.surface, steady.walls.shell.surface) < 1e-6);
}

TEST_CASE("SteadyBearingStaysSteadyInTime", "[warm_up]") {
  Case c = grooved_case();
  c.model.grid = {60, 9};
  const Solution s = solve_tier(c, Tier::thd);
  WarmUpByHand w{s};
  w.start(313.15);
  w.solve({}, nullptr);
  const std::vector<double> T = w.T;
  const SolidState state = w.solids().state(w.walls);
  for (const double dt : {1e-3, 1.0, 1e3}) {
    const SolidStep step = w.solids().step(dt, state);
    w.solve(thermal::FilmStorage{dt, w.mass(), w.mass(),
                                 thermal::heat_content(w.mass(), film_enthalpy(s.model, T))},
            &step);
    CHECK(largest_difference(w.T, T) < 1e-6);  // [K]
    CHECK(std::abs(w.walls.shell.stored + w.walls.shaft.stored + 2.0 * w.film.stored) <
          1e-6 * w.film.heat * std::max(1.0, 1.0 / dt));
  }
}
