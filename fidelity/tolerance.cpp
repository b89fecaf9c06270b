#include "fidelity/tolerance.hpp"

#include <algorithm>
#include <cmath>

#include "fidelity/grid_error.hpp"
#include "fidelity/grid_limit.hpp"

namespace shellback::fidelity {

using namespace coupling;

namespace {

constexpr int kRound = 10;  ///< cells around are proposed in tens [-]

/// Refinement per direction after which the bar of the grid is `allowed`.
double refinement(const RelativeBars& bars, double allowed) {
  return std::max(1.0, std::pow(bars.grid / allowed, 1.0 / bars.order));
}

double expected_on(const RelativeBars& bars, double refined) {
  const double grid = bars.grid * std::pow(refined, -bars.order);
  return RelativeBars{grid, bars.model, bars.order}.total();
}

/// What is left of the tolerance for the grid; little: the physics is what matters.
double allowed_for_grid(const RelativeBars& bars, double tolerance) {
  return tolerance - (std::isfinite(bars.model) ? bars.model : 0.0);
}

void propose_grid(const Result& r, Shortfall& s) {
  double wanted = 1.0;
  for (const RelativeBars* bars : {&s.friction, &s.h_min}) {
    if (!std::isfinite(bars->grid)) continue;
    wanted = std::max(wanted, refinement(*bars, allowed_for_grid(*bars, s.tolerance)));
  }
  const auto [nt, nz] = r.grid;
  s.grid = {kRound * static_cast<int>(std::ceil(std::min(nt * wanted, 1e6) / kRound)),
            static_cast<int>(std::ceil(std::min(nz * wanted, 1e6)))};
  for (int k = 0; k < 2; ++k) {
    s.grid[k] = std::min(s.grid[k], std::max(r.grid[k], kFineGrid[k]));
  }
  const double refined = std::sqrt(static_cast<double>(s.grid[0]) * s.grid[1] / (nt * nz));
  s.expected = 0.0;
  for (const RelativeBars* bars : {&s.friction, &s.h_min}) {
    if (std::isfinite(bars->grid)) s.expected = std::max(s.expected, expected_on(*bars, refined));
  }
}

}  // namespace

double RelativeBars::total() const {
  if (!std::isfinite(grid)) return model;
  return grid + (std::isfinite(model) ? model : 0.0);
}

RelativeBars relative_bars(const Result& r, const std::string& quantity) {
  for (const Quantity& q : r.quantities) {
    if (q.name != quantity || q.value == 0.0) continue;
    const double size = std::abs(q.value);
    return {q.error_grid / size, q.error_model / size,
            std::isfinite(q.order) ? q.order : kLeastOrder};
  }
  return {NAN, NAN, kLeastOrder};
}

Shortfall shortfall(const Result& r, double tolerance) {
  constexpr double kWorthAGrid = 0.25;  // of the tolerance; for less the cells grow without end [-]
  Shortfall s;
  s.tolerance = tolerance;
  s.friction = relative_bars(r, "friction_torque");
  s.h_min = relative_bars(r, "h_min");
  for (const RelativeBars* bars : {&s.friction, &s.h_min}) {
    if (bars->total() > tolerance) s.met = false;
    if (allowed_for_grid(*bars, tolerance) < kWorthAGrid * tolerance) s.physics = true;
  }
  s.grid = r.grid;
  if (!s.met && !s.physics && r.grid[0] > 0) propose_grid(r, s);
  return s;
}

bool told_apart(const Quantity& a, const Quantity& b) {
  const double bars = a.error_grid + b.error_grid;
  return !(std::abs(a.value - b.value) < bars);
}

}  // namespace shellback::fidelity
