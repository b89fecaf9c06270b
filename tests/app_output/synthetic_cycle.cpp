#include "synthetic_cycle.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/make_grid.hpp"
#include "synthetic.hpp"

namespace shellback::test {
namespace {

using namespace bearing;

constexpr int kSteps = 144;
constexpr int kFrames = 24;
constexpr double kCrankSpeed = 314.159265358979;     // 3000 rpm [rad/s]
constexpr double kPeriod = 4.0 * kPi / kCrankSpeed;  // two turns [s]
constexpr double kPeak = 18e3;                       // largest load [N]

/// Where the journal is, over the clearance: an ellipse, off the middle.
std::array<double, 2> place(double turn) {
  return {0.05 + 0.62 * std::cos(turn), -0.12 + 0.8 * std::sin(turn)};
}

/// Force of the gas once a cycle, and of the mass that turns.
std::array<double, 2> load(double turn) {
  const double gas = std::exp(-4.0 * (1.0 - std::cos(0.5 * turn - kPi)));
  return {0.22 * kPeak * std::cos(turn), -0.75 * kPeak * gas + 0.22 * kPeak * std::sin(turn)};
}

CycleInstant instant(double share, double c) {
  const double turn = 4.0 * kPi * share;
  CycleInstant i;
  i.t = share * kPeriod;
  i.dt = kPeriod / kSteps;
  i.omega = kCrankSpeed;
  const auto [ex, ey] = place(turn);
  const auto [wx, wy] = load(turn);
  i.ex = c * ex;
  i.ey = c * ey;
  i.load_x = wx;
  i.load_y = wy;
  const double e = std::hypot(ex, ey);
  i.h_min = c * (1.0 - e);
  i.h_min_angle = std::atan2(ey, ex);
  i.p_max = 4e6 + 9e3 * std::hypot(wx, wy) / (1.3 - e);
  i.p_asperity_max = std::max(0.0, e - 0.85) * 3e8;
  i.torque_asperity = std::max(0.0, e - 0.85) * 4.0;
  i.torque = 0.5 / std::sqrt(1.0 - e * e) + i.torque_asperity;
  i.power = i.torque * i.omega;
  i.supply_flow = 4e-6 * (1.0 + 0.3 * std::cos(turn));
  i.side_flow = 4e-6;
  i.oil = 5e-5;
  i.tilt_x = 1e-5 * std::sin(turn);
  return i;
}

CycleFrame frame(const FilmGrid& grid, const CycleInstant& i, double c) {
  CycleFrame f;
  f.t = i.t;
  for (int a = 0; a < grid.nt; ++a) {
    const double phi = grid.phi[a];
    const double h = c - i.ex * std::cos(phi) - i.ey * std::sin(phi);
    const double psi = std::cos(phi - i.h_min_angle + 0.35);
    for (int j = 0; j < grid.nz; ++j) {
      const double z = 2.0 * grid.z[j] / grid.width;
      const double peak = std::max(0.0, psi) * (1.0 - z * z);
      f.p.push_back(i.p_max * peak * peak * peak);
      f.theta.push_back(psi > 0.0 ? 1.0 : 1.0 + 0.6 * psi);
      f.h.push_back(h);
    }
  }
  return f;
}

void gather(CycleFields& fields, const CycleFrame& f) {
  for (std::size_t k = 0; k < f.p.size(); ++k) {
    fields.p_max[k] = std::max(fields.p_max[k], f.p[k]);
    fields.h_min[k] = std::min(fields.h_min[k], f.h[k]);
    fields.p_asperity_max[k] = std::max(fields.p_asperity_max[k], (2.5e-6 - f.h[k]) * 1e13);
    fields.friction_power[k] += 2.0 / f.h[k] / kFrames;
  }
}

CycleQuantity extreme(const CycleResult& r, const char* name, const char* unit,
                      double CycleInstant::*value, double sign) {
  const auto best = std::max_element(
      r.instants.begin(), r.instants.end(),
      [&](const auto& a, const auto& b) { return sign * (a.*value) < sign * (b.*value); });
  CycleQuantity q{{name, (*best).*value, unit}, best->t};
  q.quantity.error_grid = 0.01 * std::abs(q.quantity.value);
  q.quantity.error_time = 0.002 * std::abs(q.quantity.value);
  return q;
}

CycleQuantity mean(const CycleResult& r, const char* name, const char* unit,
                   double CycleInstant::*value) {
  double sum = 0.0;
  for (const CycleInstant& i : r.instants) sum += i.*value;
  CycleQuantity q;
  q.quantity = {name, sum / static_cast<double>(r.instants.size()), unit};
  return q;
}

void add_quantities(CycleResult& r) {
  r.quantities = {mean(r, "friction_torque", "N m", &CycleInstant::torque),
                  mean(r, "friction_torque_asperity", "N m", &CycleInstant::torque_asperity),
                  mean(r, "power_loss", "W", &CycleInstant::power),
                  mean(r, "side_flow", "m3/s", &CycleInstant::side_flow),
                  extreme(r, "h_min", "m", &CycleInstant::h_min, -1.0),
                  extreme(r, "p_max", "Pa", &CycleInstant::p_max, 1.0),
                  extreme(r, "p_asperity_max", "Pa", &CycleInstant::p_asperity_max, 1.0)};
}

}  // namespace

Case cycle_case() {
  Case c = synthetic_case();
  LoadCycle cycle;
  cycle.period = kPeriod;
  cycle.crank_speed = kCrankSpeed;
  for (int k = 0; k <= 36; ++k) {
    const auto [x, y] = load(4.0 * kPi * k / 36.0);
    cycle.t.push_back(k * kPeriod / 36.0);
    cycle.x.push_back(x);
    cycle.y.push_back(y);
  }
  c.cycle = cycle;
  return c;
}

CycleResult synthetic_cycle() {
  const Case c = cycle_case();
  CycleResult r;
  r.title = c.title;
  r.period = kPeriod;
  r.crank_speed = kCrankSpeed;
  r.cycles = 3;
  r.closure = 2.1e-5;
  const double clearance = c.bearing.radial_clearance;
  for (int k = 0; k <= kSteps; ++k) {
    r.instants.push_back(instant(static_cast<double>(k) / kSteps, clearance));
  }
  r.grid = {60, 9};
  r.fields.grid = make_grid(c.bearing.radius, c.bearing.width, 60, 9, false);
  const auto cells = static_cast<std::size_t>(r.fields.grid.cells());
  r.fields.p_max.assign(cells, 0.0);
  r.fields.p_asperity_max.assign(cells, 0.0);
  r.fields.h_min.assign(cells, 1.0);
  r.fields.friction_power.assign(cells, 0.0);
  for (int k = 0; k < kFrames; ++k) {
    r.frames.push_back(frame(r.fields.grid, r.instants[k * kSteps / kFrames], clearance));
    gather(r.fields, r.frames.back());
  }
  add_quantities(r);
  r.audit = {3e-13, 5e-7, 4e-8, 2e-9};
  r.limiters = {{Limiter::rejected_steps, 2}};
  r.warnings = {"pressure above the oil's fitted range in 3 cells"};
  r.assumptions = {"flooded edges"};
  r.steps = kSteps;
  r.rejected_steps = 7;
  r.cost = {1.8, 0.0, 640, 512, 144, 0.0};
  return r;
}

CycleResult timed_cycle() {
  CycleResult r = synthetic_cycle();
  r.crank_speed = 0.0;
  return r;
}

CycleResult stopped_cycle() {
  CycleResult r = synthetic_cycle();
  r.verdict = {Status::iteration_limit,
               ending::NoStep{31.2e-3, 0.0},
               {5.27, 0.3e-3},
               {{Status::iteration_limit, ending::Plain::overdrawn}}};
  r.instants.resize(3);
  r.frames.clear();
  r.fields = {};
  r.quantities.clear();
  r.closure = std::nan("");
  return r;
}

}  // namespace shellback::test
