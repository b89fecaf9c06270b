#include "bearing/film/closed_gap.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace shellback::bearing {
namespace {

/// The cell whose centre is nearest to a place on the bearing.
int cell_at(const FilmGrid& g, const fluid::SmallestGap& place) {
  int column = 0;
  int line = 0;
  const auto away = [&](int i) {
    return std::abs(std::remainder(g.phi[i] - place.phi, 2.0 * kPi));
  };
  for (int i = 1; i < g.nt; ++i) {
    if (away(i) < away(column)) column = i;
  }
  for (int j = 1; j < g.nz; ++j) {
    if (std::abs(g.z[j] - place.z) < std::abs(g.z[line] - place.z)) line = j;
  }
  return g.index(column, line);
}

/// Least sum of the gaps at the two ends of a diameter [m]: no journal position changes it. `h`: of
/// every cell, with the depth of supplies.
double least_across(const FilmGrid& g, const Field& h) {
  double least = INFINITY;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int other = cell_at(g, {0.0, g.phi[i] + kPi, g.z[j]});
      least = std::min(least, h[g.index(i, j)] + h[other]);
    }
  }
  return least;
}

}  // namespace

Verdict closed_gap(const BearingModel& model, const OperatingPoint& point,
                   const Field& thermal_deformation, const FilmEquilibrium& s) {
  const int cell = cell_at(model.domain.grid, s.least);
  const Field h = fluid::nominal_depth(s.gap, model.supply);
  ending::GapClosed e{s.least.h, s.least.h, NAN, NAN, least_across(model.domain.grid, h)};
  if (!thermal_deformation.empty()) e.by_position -= e.by_heat = thermal_deformation[cell];
  if (!s.elastic.empty()) e.by_position -= e.by_elasticity = s.elastic[cell];
  const bool rigid = s.elastic.empty();
  const bool proven = (rigid && point.load.unknowns == 0) || e.across <= 0.0;
  return {proven ? Status::no_steady_state : Status::iteration_limit, e, s.least.place()};
}

}  // namespace shellback::bearing
