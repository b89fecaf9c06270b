#include "thermal/shaft_fin.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::thermal {
namespace {

/// Solves the symmetric tridiagonal system in place (Thomas); the matrix is positive definite.
void solve_tridiagonal(std::vector<double>& diagonal, const std::vector<double>& link,
                       std::vector<double>& x) {
  const std::size_t n = diagonal.size();
  for (std::size_t j = 1; j < n; ++j) {
    const double f = link[j - 1] / diagonal[j - 1];
    diagonal[j] -= f * link[j - 1];
    x[j] += f * x[j - 1];
  }
  x[n - 1] /= diagonal[n - 1];
  for (std::size_t j = n - 1; j-- > 0;) x[j] = (x[j] + link[j] * x[j + 1]) / diagonal[j];
}

/// Both overhangs over a step; a half grid has no low one.
struct Ends {
  Overhang high, low;
};
Ends ends_of(const FilmGrid& grid, const ShaftFin& shaft, const ShaftStep& step) {
  const int last = grid.nz - 1;
  Ends e{
      Overhang(grid.radius, shaft, grid.z_face[grid.nz] - grid.z[last], step.dt, step.before.high),
      {}};
  if (!grid.half) {
    e.low = Overhang(grid.radius, shaft, grid.z[0] - grid.z_face[0], step.dt, step.before.low);
  }
  return e;
}

void require_possible(const ShaftFin& shaft, const ShaftStep& step, double g) {
  if (!(shaft.conductivity > 0.0) || shaft.heat_transfer < 0.0 || shaft.overhang < 0.0) {
    throw InputError(fmt::format(
        "shaft with conductivity {} W/(m K), overhang {} m, heat transfer {} W/(m2 K) (the first "
        "must be positive, the others must not be negative)",
        shaft.conductivity, shaft.overhang, shaft.heat_transfer));
  }
  if (std::isfinite(step.dt) && !(step.dt > 0.0 && shaft.capacity > 0.0)) {
    throw InputError(
        fmt::format("shaft of {} J/(m3 K) over a time step of {} s (both must be positive)",
                    shaft.capacity, step.dt));
  }
  if (std::isinf(step.dt) && g == 0.0 && shaft.heat_transfer * shaft.overhang == 0.0) {
    throw InputError(
        "no heat can leave the shaft: its overhang or heat transfer coefficient is zero");
  }
}

/// Heat capacity of a film cell over the time step [W/K]; 0 in the steady state.
double store_of(const FilmGrid& grid, const ShaftFin& shaft, double dt, int j) {
  return shaft.capacity * kPi * grid.radius * grid.radius * grid.dz[j] / dt;
}

}  // namespace

double fin_conductance(double radius, const ShaftFin& shaft) {
  if (shaft.heat_transfer == 0.0 || shaft.overhang == 0.0) return 0.0;
  const double k = shaft.conductivity;
  const double m = std::sqrt(2.0 * shaft.heat_transfer / (k * radius));
  return k * kPi * radius * radius * m * std::tanh(m * shaft.overhang);
}

double shaft_conductance(const FilmGrid& grid, const ShaftFin& shaft, double dt) {
  if (std::isinf(dt)) return 2.0 * fin_conductance(grid.radius, shaft);
  const Ends ends = ends_of(grid, shaft, {dt, uniform_shaft(grid, shaft, shaft.ambient)});
  double sum = ends.high.conductance() + ends.low.conductance();
  for (int j = 0; j < grid.nz; ++j) sum += store_of(grid, shaft, dt, j);
  return grid.multiplicity() * sum;
}

ShaftTemperature solve_shaft(const FilmGrid& grid, const ShaftFin& shaft,
                             const std::vector<double>& q, double g,
                             const std::vector<double>& t_old, const ShaftStep& step) {
  const int nz = grid.nz;
  const bool steady = std::isinf(step.dt);
  EXPECTS(static_cast<int>(q.size()) == nz && static_cast<int>(t_old.size()) == nz && g >= 0.0);
  EXPECTS(steady || static_cast<int>(step.before.cells.size()) == nz);
  require_possible(shaft, step, g);
  const Ends ends = ends_of(grid, shaft, step);
  const double R = grid.radius, kA = shaft.conductivity * kPi * R * R, T0 = shaft.ambient;
  std::vector<double> diagonal(nz), link(nz > 1 ? nz - 1 : 0), rise(nz);
  for (int j = 0; j + 1 < nz; ++j) link[j] = kA / (grid.z[j + 1] - grid.z[j]);
  for (int j = 0; j < nz; ++j) {  // in temperatures above ambient, to keep the last digits
    const double surface = 2.0 * kPi * R * grid.dz[j];
    diagonal[j] = surface * g + (j > 0 ? link[j - 1] : 0.0) + (j + 1 < nz ? link[j] : 0.0);
    rise[j] = surface * (q[j] + g * (t_old[j] - T0));
    if (steady) continue;
    diagonal[j] += store_of(grid, shaft, step.dt, j);
    rise[j] += store_of(grid, shaft, step.dt, j) * (step.before.cells[j] - T0);
  }
  diagonal.front() += ends.low.conductance();
  diagonal.back() += ends.high.conductance();
  rise.front() += ends.low.returned();
  rise.back() += ends.high.returned();
  solve_tridiagonal(diagonal, link, rise);

  ShaftTemperature out;
  for (int j = 0; j < nz; ++j) {
    out.temperature.push_back(T0 + rise[j]);
    const double flux = q[j] - g * (rise[j] - (t_old[j] - T0));
    out.heat_in += 2.0 * kPi * R * grid.dz[j] * flux;
    if (!steady)
      out.stored += store_of(grid, shaft, step.dt, j) * (T0 + rise[j] - step.before.cells[j]);
  }
  const OverhangHeat high = ends.high.solve(rise.back()), low = ends.low.solve(rise.front());
  out.high = high.temperature;
  out.low = low.temperature;
  out.heat_in *= grid.multiplicity();
  out.heat_out = grid.multiplicity() * (high.lost + low.lost);
  out.stored = grid.multiplicity() * (out.stored + high.stored + low.stored);
  return out;
}

double shaft_imbalance(const FilmGrid& grid, const ShaftFin& shaft, const std::vector<double>& q,
                       const std::vector<double>& t, const ShaftStep& step) {
  const Ends ends = ends_of(grid, shaft, step);
  double heat = ends.high.returned() - ends.high.conductance() * (t.back() - shaft.ambient) +
                ends.low.returned() - ends.low.conductance() * (t.front() - shaft.ambient);
  for (int j = 0; j < grid.nz; ++j) {
    heat += 2.0 * kPi * grid.radius * grid.dz[j] * q[j];
    if (std::isinf(step.dt)) continue;
    heat -= store_of(grid, shaft, step.dt, j) * (t[j] - step.before.cells[j]);
  }
  return grid.multiplicity() * heat;
}

ShaftState uniform_shaft(const FilmGrid& grid, const ShaftFin& shaft, double T) {
  const std::vector<double> nodes(overhang_nodes(shaft), T);
  return {std::vector<double>(grid.nz, T), nodes, grid.half ? std::vector<double>{} : nodes};
}

}  // namespace shellback::thermal
