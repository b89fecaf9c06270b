#include "thermal/shaft_fin.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::thermal {
namespace {

/// Conductance from the centre of an end cell to the surroundings of the overhang [W/K].
double end_conductance(double radius, const ShaftFin& shaft, double to_edge) {
  const double fin = fin_conductance(radius, shaft);
  const double cell = shaft.conductivity * kPi * radius * radius / to_edge;
  return fin * cell / (fin + cell);
}

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

}  // namespace

double fin_conductance(double radius, const ShaftFin& shaft) {
  if (shaft.heat_transfer == 0.0 || shaft.overhang == 0.0) return 0.0;
  const double k = shaft.conductivity;
  const double m = std::sqrt(2.0 * shaft.heat_transfer / (k * radius));
  return k * kPi * radius * radius * m * std::tanh(m * shaft.overhang);
}

ShaftTemperature solve_shaft(const FilmGrid& grid, const ShaftFin& shaft,
                             const std::vector<double>& q, double g,
                             const std::vector<double>& t_old) {
  const int nz = grid.nz;
  EXPECTS(static_cast<int>(q.size()) == nz && static_cast<int>(t_old.size()) == nz && g >= 0.0);
  if (!(shaft.conductivity > 0.0) || shaft.heat_transfer < 0.0 || shaft.overhang < 0.0) {
    throw InputError(fmt::format(
        "shaft with conductivity {} W/(m K), overhang {} m, heat transfer {} W/(m2 K) (the first "
        "must be positive, the others must not be negative)",
        shaft.conductivity, shaft.overhang, shaft.heat_transfer));
  }
  const double R = grid.radius, kA = shaft.conductivity * kPi * R * R;
  const double high = end_conductance(R, shaft, grid.z_face[nz] - grid.z[nz - 1]);
  const double low = grid.half ? 0.0 : end_conductance(R, shaft, grid.z[0] - grid.z_face[0]);
  if (high == 0.0 && g == 0.0) {
    throw InputError(
        "no heat can leave the shaft: its overhang or heat transfer coefficient is zero");
  }
  std::vector<double> diagonal(nz), link(nz > 1 ? nz - 1 : 0), rise(nz);
  for (int j = 0; j + 1 < nz; ++j) link[j] = kA / (grid.z[j + 1] - grid.z[j]);
  for (int j = 0; j < nz; ++j) {  // in temperatures above ambient, to keep the last digits
    const double surface = 2.0 * kPi * R * grid.dz[j];
    diagonal[j] = surface * g + (j > 0 ? link[j - 1] : 0.0) + (j + 1 < nz ? link[j] : 0.0);
    rise[j] = surface * (q[j] + g * (t_old[j] - shaft.ambient));
  }
  diagonal.front() += low;
  diagonal.back() += high;
  solve_tridiagonal(diagonal, link, rise);

  ShaftTemperature out;
  for (int j = 0; j < nz; ++j) {
    out.temperature.push_back(shaft.ambient + rise[j]);
    const double flux = q[j] - g * (rise[j] - (t_old[j] - shaft.ambient));
    out.heat_in += grid.multiplicity() * 2.0 * kPi * R * grid.dz[j] * flux;
  }
  out.heat_out = grid.multiplicity() * (high * rise.back() + low * rise.front());
  return out;
}

double shaft_imbalance(const FilmGrid& grid, const ShaftFin& shaft, const std::vector<double>& q,
                       const std::vector<double>& t) {
  const int nz = grid.nz;
  const double R = grid.radius;
  const double high = end_conductance(R, shaft, grid.z_face[nz] - grid.z[nz - 1]);
  const double low = grid.half ? 0.0 : end_conductance(R, shaft, grid.z[0] - grid.z_face[0]);
  double heat = -high * (t.back() - shaft.ambient) - low * (t.front() - shaft.ambient);
  for (int j = 0; j < nz; ++j) heat += 2.0 * kPi * R * grid.dz[j] * q[j];
  return grid.multiplicity() * heat;
}

}  // namespace shellback::thermal
