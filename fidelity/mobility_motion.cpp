#include "fidelity/mobility_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/round_off.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

double length(const Pair& v) { return std::hypot(v[0], v[1]); }
double dot(const Pair& a, const Pair& b) { return a[0] * b[0] + a[1] * b[1]; }
/// a x b, positive if b lies counter-clockwise of a.
double cross(const Pair& a, const Pair& b) { return a[0] * b[1] - a[1] * b[0]; }

}  // namespace

MobilityMotion::MobilityMotion(const Case& c, const LoadCourse& course)
    : c_(c), course_(course), scene_(c), map_(scene_.b()), curve_(scene_.b()) {
  drilled_ = std::any_of(c.supplies.begin(), c.supplies.end(),
                         [](const Supply& s) { return s.kind == SupplyKind::drilling; });
}

MobilityMotion::Now MobilityMotion::look(double t, bool before_jump, const Pair& x) const {
  Now now;
  now.load = course_.at(t, before_jump);
  now.eps = length(x);
  const double W = std::hypot(now.load.x, now.load.y);
  now.eta = scene_.viscosity(now.eps, T_, W, std::abs(now.load.omega));
  now.film = {now.load.x, now.load.y};
  if (scene_.touches() && now.eps > kRoundOff) {
    const double pushed = scene_.contact_load(now.eps) / now.eps;
    for (int k = 0; k < 2; ++k) now.film[k] -= pushed * x[k];
  }
  const double F = length(now.film);
  const double alpha = std::atan2(cross(now.film, x), dot(now.film, x));
  now.m = map_.at(now.eps, now.eps > kRoundOff ? alpha : 0.0);
  if (F == 0.0) return now;
  const double unit = scene_.psi() * scene_.psi() / (now.eta * scene_.area());  // |F| in F below
  now.seen = {unit * (now.m.along * now.film[0] - now.m.across * now.film[1]),
              unit * (now.m.along * now.film[1] + now.m.across * now.film[0])};
  return now;
}

bool MobilityMotion::rate(double t, bool before_jump, const Pair& x, Pair& out) const {
  if (!(length(x) < 1.0)) return false;
  const Now now = look(t, before_jump, x);
  const double half = 0.5 * now.load.omega;
  out = {now.seen[0] - half * x[1], now.seen[1] + half * x[0]};
  return true;
}

void MobilityMotion::add_torque(const Now& now, CycleInstant& i) const {
  const double omega = std::abs(now.load.omega);
  const ContactSum touching = scene_.contact(now.eps, now.eta, omega);
  const double fill = curve_.at(std::max(now.eps, kRoundOff)).couette;
  const double sheared = scene_.couette(now.eps, fill, now.eta, omega);
  i.p_asperity_max = touching.pressure;
  i.torque_asperity = std::copysign(touching.torque, now.load.omega);
  i.torque = std::copysign(sheared, now.load.omega) + 0.5 * cross(now.film, {i.ex, i.ey}) +
             i.torque_asperity;
  i.power = i.torque * now.load.omega + now.load.x * i.vx + now.load.y * i.vy;
}

CycleInstant MobilityMotion::instant(double t, bool before_jump, const Pair& x) const {
  const Now now = look(t, before_jump, x);
  const double clearance = c_.bearing.radial_clearance;
  Pair v{};
  static_cast<void>(rate(t, before_jump, x, v));
  CycleInstant i;
  i.t = t;
  i.load_x = now.load.x;
  i.load_y = now.load.y;
  i.omega = now.load.omega;
  i.ex = clearance * x[0];
  i.ey = clearance * x[1];
  i.vx = clearance * v[0];
  i.vy = clearance * v[1];
  i.tilt_x = i.tilt_y = i.supply_flow = i.oil = i.breakaway = NAN;  // not this method's
  i.h_min = clearance * (1.0 - now.eps);
  const double angle = std::atan2(x[1], x[0]);
  i.h_min_angle = angle < 0.0 ? angle + 2.0 * kPi : angle;
  i.p_max = now.m.pressure * length(now.film) / scene_.area();
  add_torque(now, i);
  i.side_flow = (scene_.has_ring() ? 0.0 : now.m.side) * 2.0 * c_.bearing.radius * scene_.width() *
                    clearance * length(now.seen) +
                pressure_fed_flow(c_, now.eps, angle, now.eta, drilled_ ? course_.turned(t) : 0.0);
  return i;
}

double MobilityMotion::asperity_share(double t, bool before_jump, const Pair& x) const {
  const LoadNow load = course_.at(t, before_jump);
  const double W = std::hypot(load.x, load.y);
  return scene_.touches() && W > 0.0 ? scene_.contact_load(length(x)) / W : 0.0;
}

}  // namespace shellback::fidelity
