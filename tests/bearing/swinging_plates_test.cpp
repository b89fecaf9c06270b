// Two surfaces that move apart: the front of the film that ruptures between them and fills again,
// through the integrator of load cycles.
//
// In x from a line of pressure p_b to the middle of the circumference, C/2,
// d/dx(h^3/(12 eta) dp/dx) = d(theta h)/dt, p_cav = 0. Where the film has ruptured it is full up to
// the front a(t), and keeps the oil h(t_r(x)) that it ruptured with:
//   rupturing:  a = sqrt(p_b h^3/(6 eta dh/dt))                                            (1)
//   filling:    d/dt [h a + int_a^C/2 h(t_r(x)) dx] = (h^3/(12 eta)) (p_b/a + B a),
//               B = 6 eta (dh/dt)/h^3                                                      (2)
// After Ausas, Jai and Buscaglia 2009, for a gap that grows once.
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/film_step.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

constexpr double kNarrow = 20e-6;       ///< the gap before [m]
constexpr double kWider = 20e-6;        ///< by which it grows [m]
constexpr double kTime = 0.9;           ///< within which it grows [s]
constexpr double kPressure = 1e5;       ///< p_b [Pa]
constexpr double kViscosity = 0.015;    ///< [Pa s]
constexpr double kRadius = 0.025;       ///< [m]
constexpr double kEnd = kPi * kRadius;  ///< C/2 [m]

/// h and dh/dt at a time, as FilmSteps::set_walls lets walls grow.
struct Gap {
  double h, rate;
};
Gap gap_at(double t) {
  const double s = std::min(t / kTime, 1.0);
  return {kNarrow + kWider * s * s * (3.0 - 2.0 * s), kWider * 6.0 * s * (1.0 - s) / kTime};
}

/// (1), beyond C/2 while the film is whole.
double rupturing(double t) {
  const Gap g = gap_at(t);
  return std::sqrt(kPressure * g.h * g.h * g.h / (6.0 * kViscosity * g.rate));
}

/// The front as time goes on, by (1) and then (2).
class Front {
 public:
  /// On to time t by a part of a step so short that (2) is known far better than a cell.
  void go_on(double t, double dt) {
    const Gap g = gap_at(t);
    const double ruptures = t < kTime ? rupturing(t) : INFINITY;
    if (!fills_ && ruptures < a_) {
      const double h = behind_.size() > 1 ? 0.5 * (g.h + h_) : g.h;
      behind_.push_back({ruptures, behind_.back().oil + h * (a_ - ruptures)});
      a_ = ruptures;
      h_ = g.h;
    } else if (a_ < kEnd) {
      if (!fills_) oil_ = g.h * a_ + behind_.back().oil;
      fills_ = true;
      fill(g, dt);
    }
  }
  [[nodiscard]] double place() const { return a_; }

 private:
  struct Point {
    double x, oil;  ///< oil: from x to C/2 as it ruptured [m2]
  };
  void fill(const Gap& g, double dt) {
    const double B = 6.0 * kViscosity * g.rate / (g.h * g.h * g.h);
    oil_ += dt * g.h * g.h * g.h / (12.0 * kViscosity) * (kPressure / a_ + B * a_);
    double full = kEnd;
    for (int k = 0; k < 50; ++k) {  // bisection, to round-off
      const double middle = 0.5 * (a_ + full);
      (g.h * middle + behind(middle) < oil_ ? a_ : full) = middle;
    }
  }
  /// Oil from x to C/2 as it ruptured [m2].
  [[nodiscard]] double behind(double x) const {
    const auto at = std::lower_bound(behind_.begin() + 1, behind_.end() - 1, x,
                                     [](const Point& p, double v) { return p.x > v; });
    const Point& q = *(at - 1);
    return q.oil + (at->oil - q.oil) * (x - q.x) / (at->x - q.x);
  }

  std::vector<Point> behind_{{kEnd, 0.0}};  ///< x falling
  double a_ = kEnd;
  double h_ = 0.0;    ///< where it ruptured last [m]
  double oil_ = 0.0;  ///< from 0 to C/2 [m2]
  bool fills_ = false;
};

/// Plates as the developed surfaces of a bearing that does not turn, so wide that nothing flows out
/// sideways, its journal so heavy that it stays in the middle.
Case plates() {
  Case c = warm_case();
  c.bearing.radius = kRadius;
  c.bearing.width = 50.0;
  c.bearing.radial_clearance = kNarrow;
  c.supplies[0].angle = 0.0;
  c.supplies[0].arc = 0.0;
  c.supplies[0].length = c.bearing.width;
  c.supplies[0].pressure = kPressure;
  c.operation.omega = 0.0;
  place_journal(c, 0.0, 0.0);
  c.oil.temperature = rheology::ConstantViscosity{kViscosity};
  for (ShellLayer& l : c.shell->layers) l.material.expansion = 0.0;
  c.shell->housing->material.expansion = c.shaft->material.expansion = 0.0;
  return c;
}

}  // namespace

TEST_CASE("TheFrontBetweenPlatesThatMoveApartIsWithinACell", "[cycle]") {
  constexpr int kCells = 120;
  constexpr int kSteps = 200;
  const Case c = plates();
  LoadCycle load;
  load.t = {0.0, 100.0};
  load.x = {0.0, 0.0};
  load.y = {-1.0, -1.0};
  const LoadCourse course(load, 0.0);
  const Physics physics{.film_energy = true, .thermal_deformation = true};
  const BearingModel model = make_bearing(c, physics, {kCells, 4});
  FilmSteps steps(model, course, 0.0, {});
  const double T = c.supplies[0].temperature;
  EquilibriumCost cost;
  FilmInTime now = steps.at_rest(T);
  WallMeans walls = uniform_walls(model, T);
  walls.thermal_deformation.assign(now.oil.size(), 0.0);
  REQUIRE(steps.set_walls(walls, 10.0 * kTime, kTime / kSteps, now));
  walls.thermal_deformation.assign(now.oil.size(), kWider);
  REQUIRE(steps.set_walls(walls, 10.0 * kTime, kTime / kSteps, now));
  const FilmGrid& g = model.domain.grid;
  const double cell = 2.0 * kEnd / g.nt;
  const double dt = 2.0 * kTime / kSteps;
  const auto take = [&](double length) {
    FilmStep s = steps.take(length, now, cost, nullptr);
    INFO(app::reason_of(s.verdict));
    REQUIRE(s.verdict.good());
    now = std::move(s.after);
  };
  Front front;
  take(0.02 * dt);  // as cycles do: the first step knows no slope and errs more
  for (int n = 1; n <= kSteps; ++n) {
    take(n * dt - now.t);
    for (int part = 1; part <= 40; ++part) front.go_on((n - 1 + part / 40.0) * dt, dt / 40.0);
    CHECK(now.film.gap.cell[0] ==
          Approx(gap_at(n * dt).h).epsilon(1e-6));  // what walls are told to be
    int full = 0;
    while (full < g.nt && now.film.film.full[g.index(full, 0)]) ++full;
    INFO("t " << now.t << ": " << full << " cells are full, the front lies at " << front.place());
    if (front.place() < kEnd) {
      CHECK(std::abs((full + 0.5) * cell - front.place()) < cell);
    } else {
      CHECK(full == g.nt);
    }
  }
  CHECK(front.place() > 0.8 * kEnd);  // it has been at 0.3 of it
}
