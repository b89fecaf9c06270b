#include "app/pictures/cycle_axis.hpp"

#include <cmath>

#include "app/labels/cycle_shown.hpp"

namespace shellback::app {

using bearing::CycleResult;

namespace {

bool in_seconds(const CycleResult& cycle) {
  constexpr double kLong = 2.0;  // [s]
  const double last = cycle.instants.empty() ? 0.0 : cycle.instants.back().t;
  return (std::isfinite(cycle.period) ? cycle.period : last) > kLong;
}

}  // namespace

Axis cycle_axis(const CycleResult& cycle) {
  const bool whole = std::isfinite(cycle.period) && cycle.period > 0.0;
  const double last = whole ? cycle.period : cycle.instants.empty() ? 0.0 : cycle.instants.back().t;
  const double end = on_axis(cycle, last);
  if (!has_crank(cycle)) {
    return tight_axis(0.0, end > 0.0 ? end : 1.0, 8, in_seconds(cycle) ? "time [s]" : "time [ms]");
  }
  Axis axis{0.0, end > 0.0 ? end : 720.0, {}, 0, "crank angle [°]"};
  constexpr double kFewest = 45.0;  // [deg]
  double step = kFewest;
  while (axis.high / step > 8.5) step *= 2.0;
  for (double tick = 0.0; tick <= axis.high * (1.0 + 1e-9); tick += step) {
    axis.ticks.push_back(tick);
  }
  return axis;
}

double on_axis(const CycleResult& cycle, double t) {
  constexpr double kPerMilli = 1e3;  // ms per s
  if (has_crank(cycle)) return shown_instant(cycle, t);
  return in_seconds(cycle) ? t : kPerMilli * t;
}

}  // namespace shellback::app
