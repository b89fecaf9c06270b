#include "bearing/crank.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/range.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

/// Crank angles of the rows: n steps of equal size, and the points of the pressure.
std::vector<double> row_angles(const Crank& crank, int n) {
  std::vector<double> angles = crank.angle;
  for (int k = 0; k < n; ++k) angles.push_back(crank.period * k / n);
  std::sort(angles.begin(), angles.end());
  const auto same = [](double a, double b) { return b - a < kRoundOff; };
  angles.erase(std::unique(angles.begin(), angles.end(), same), angles.end());
  return angles;
}

}  // namespace

CrankMotion crank_motion(const Crank& crank, double theta, double omega) {
  EXPECTS(2.0 * crank.rod_length > crank.stroke && omega >= 0.0);
  const double r = 0.5 * crank.stroke;
  const double l = crank.rod_length;
  const double sine = r / l * std::sin(theta);
  const double cosine = std::sqrt(1.0 - sine * sine);
  CrankMotion m;
  m.rod_angle = std::asin(sine);
  m.rod_rate = r / l * omega * std::cos(theta) / cosine;
  const double rod_acceleration =
      (m.rod_rate * m.rod_rate * sine - r / l * omega * omega * std::sin(theta)) / cosine;
  m.piston = r * std::cos(theta) + l * cosine;
  m.piston_velocity = -r * omega * std::sin(theta) - l * m.rod_rate * sine;
  m.piston_acceleration = -r * omega * omega * std::cos(theta) -
                          l * (rod_acceleration * sine + m.rod_rate * m.rod_rate * cosine);
  return m;
}

double cylinder_pressure(const Crank& crank, double theta) {
  const std::vector<double>& x = crank.angle;
  const std::vector<double>& p = crank.pressure;
  EXPECTS(x.size() == p.size());
  if (x.empty()) return 0.0;
  const double turned = theta - crank.period * std::floor(theta / crank.period);
  const auto next =
      static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), turned) - x.begin());
  const std::size_t b = next % x.size();
  const std::size_t a = (next + x.size() - 1) % x.size();
  const double begin = next == 0 ? x[a] - crank.period : x[a];
  const double end = next == x.size() ? x[b] + crank.period : x[b];
  return end > begin ? p[a] + (p[b] - p[a]) * (turned - begin) / (end - begin) : p[a];
}

LoadNow crank_load_at(const Crank& crank, double theta, double omega) {
  const double turn = omega < 0.0 ? -1.0 : 1.0;
  const CrankMotion m = crank_motion(crank, theta, std::abs(omega));
  const double area = 0.25 * kPi * crank.bore * crank.bore;
  const double thrust =
      (crank.piston_mass * m.piston_acceleration + cylinder_pressure(crank, theta) * area) /
      std::cos(m.rod_angle);
  const double pull = crank.rod_mass * 0.5 * crank.stroke * omega * omega;
  const double angle = theta + m.rod_angle;  // between rod and crank
  return {turn * pull * std::sin(angle), thrust - pull * std::cos(angle),
          omega + turn * m.rod_rate};
}

LoadNow main_bearing_load_at(const Crank& crank, double theta, double omega) {
  const double turn = omega < 0.0 ? -1.0 : 1.0;
  const LoadNow pin = crank_load_at(crank, theta, std::abs(omega));
  const double beta = crank_motion(crank, theta, std::abs(omega)).rod_angle;
  const double sine = std::sin(beta);
  const double cosine = std::cos(beta);
  const double pull = crank.counterweight * omega * omega;
  const double x = -(pin.x * cosine + pin.y * sine) + pull * std::sin(theta);
  const double y = pin.x * sine - pin.y * cosine - pull * std::cos(theta);
  return {turn * crank.share * x, crank.share * y, omega};
}

namespace {

void expect_number(const char* key, double value, const Range& range = kAnyValue) {
  if (std::isfinite(value) && range.holds(value)) return;
  throw InputError(key, std::isfinite(value)
                            ? fmt::format("{:.6g} is not possible (it must {})", value, range.words)
                            : "it is not a finite number");
}

/// As many pressures as angles, which rise within the period.
void expect_trace(const Crank& crank) {
  const std::vector<double>& angle = crank.angle;
  if (angle.size() != crank.pressure.size()) {
    throw InputError("crank.pressure", fmt::format("{} angles and {} pressures make no table",
                                                   angle.size(), crank.pressure.size()));
  }
  for (std::size_t k = 0; k < angle.size(); ++k) {
    expect_number("crank.pressure", crank.pressure[k]);
    const double least = k > 0 ? angle[k - 1] : 0.0;
    if (angle[k] >= least && (k == 0 || angle[k] > least) && angle[k] < crank.period) continue;
    throw InputError("crank.pressure",
                     fmt::format("angle {} of the table, {:.6g} rad, does not rise within the "
                                 "period of {:.6g} rad",
                                 k, angle[k], crank.period));
  }
}

void expect_crank(const Crank& crank) {
  expect_number("crank.stroke", crank.stroke, kPositive);
  expect_number("crank.rod_length", crank.rod_length, kPositive);
  if (!(2.0 * crank.rod_length > crank.stroke)) {
    throw InputError("crank.rod_length", "the rod is no longer than the radius of the crank");
  }
  expect_number("crank.bore", crank.bore, crank.angle.empty() ? kNotNegative : kPositive);
  expect_number("crank.piston_mass", crank.piston_mass, kNotNegative);
  expect_number("crank.rod_mass", crank.rod_mass, kNotNegative);
  expect_number("crank.counterweight", crank.counterweight, kNotNegative);
  expect_number("crank.share", crank.share);
  expect_number("load_cycle.period", crank.period, kPositive);
  expect_trace(crank);
}

}  // namespace

LoadCycle crank_load(const Crank& crank, double omega, CrankFrame frame, int n) {
  expect_crank(crank);
  expect_number("operation.speed", omega);
  if (omega == 0.0 || n < 1) {
    throw InputError("operation.speed", "a crank at rest passes no cycle, nor does one of no rows");
  }
  LoadCycle cycle;
  cycle.crank_speed = std::abs(omega);
  cycle.period = crank.period / cycle.crank_speed;
  for (const double theta : row_angles(crank, n)) {
    const LoadNow load = frame == CrankFrame::rod ? crank_load_at(crank, theta, omega)
                                                  : main_bearing_load_at(crank, theta, omega);
    cycle.t.push_back(theta / cycle.crank_speed);
    cycle.x.push_back(load.x);
    cycle.y.push_back(load.y);
    cycle.omega.push_back(load.omega);
  }
  return cycle;
}

}  // namespace shellback::bearing
