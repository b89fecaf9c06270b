/// Makes the table of the plain bearing that the tier `estimate` interpolates.
///
///   make_bearing_table > data/tables/plain_bearing.csv
///   make_bearing_table --between > FILE     the same at the middle of each field of the table
///
/// Full cylindrical bearing, smooth, rigid, isoviscous, mass-conserving (JFO), flooded edges at
/// ambient pressure, oil fed at ambient pressure along an axial line at the widest gap. Solved at
/// given eccentricity on 800 x 100 cells and the coarser grids of the ladder; extrapolated to the
/// limit of fine cells by the observed order of the three finest grids where the sequence has
/// one, else the finest value; the last column says how far the limit lies from the finest grid.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "app/words/ending_words.hpp"
#include "bearing/steady/solve.hpp"
#include "core/constants.hpp"

namespace {

using namespace shellback;
using namespace shellback::bearing;

constexpr double kRadius = 0.05;      ///< any: the numbers have no dimension [m]
constexpr double kClearance = 50e-6;  ///< any [m]
constexpr double kViscosity = 0.01;   ///< any [Pa s]
constexpr double kOmega = 100.0;      ///< any [rad/s]

/// The numbers of one bearing, as fidelity/bearing_table.hpp defines them.
struct Row {
  double so = 0.0;        ///< F psi^2/(B D eta omega)
  double attitude = 0.0;  ///< [deg]
  double couette = 0.0;   ///< Couette torque over that of the full film, filled rule
  double side = 0.0;      ///< side flow over omega R c B
  double pressure = 0.0;  ///< p_max over F/(B D)
};
constexpr int kNumbers = 5;
double& number(Row& row, int k) {
  return k == 0   ? row.so
         : k == 1 ? row.attitude
         : k == 2 ? row.couette
         : k == 3 ? row.side
                  : row.pressure;
}

Case plain_bearing(double eps, double b) {
  Case c;
  c.bearing = {kRadius, 2.0 * kRadius * b, kClearance, kZeroCelsius, {}};
  Supply line;
  line.kind = SupplyKind::axial_groove;
  line.angle = kPi;
  line.length = c.bearing.width;
  line.temperature = kZeroCelsius;
  c.supplies = {line};
  c.operation.omega = kOmega;
  c.operation.position = EccentricityGiven{eps, 0.0, 0.0};
  c.oil.temperature = rheology::ConstantViscosity{kViscosity};
  c.model.tier = Tier::isothermal;
  c.model.grid = {800, 100};
  return c;
}

Row numbers_of(const std::vector<Quantity>& quantities, double eps, double b) {
  const auto value = [&](const char* name) { return value_in(quantities, name); };
  const double psi = kClearance / kRadius;
  const double B = 2.0 * kRadius * b;
  const double area = B * 2.0 * kRadius;
  const double x = value("load_x");
  const double y = value("load_y");
  const double force = std::hypot(x, y);
  const double full = 2.0 * kPi * kViscosity * kOmega * kRadius * kRadius * kRadius * B /
                      (kClearance * std::sqrt(1.0 - eps * eps));
  Row r;
  r.so = force * psi * psi / (area * kViscosity * kOmega);
  r.attitude = std::abs(std::atan2(y, -x)) * 180.0 / kPi;  // the line of centres is +X
  r.couette = 0.5 * (value("friction_torque") + value("friction_torque_shell")) / full;
  r.side = value("side_flow") / (kOmega * kRadius * kClearance * B);
  r.pressure = value("p_max") / (force / area);
  return r;
}

/// Limit of fine cells of a sequence on grids that are halved from one to the next.
double limit(double coarse, double middle, double fine) {
  constexpr double kLeast = 0.8;  // orders outside this range are no convergence yet
  constexpr double kMost = 2.6;
  const double order = std::log2((middle - coarse) / (fine - middle));
  if (!(order > kLeast) || order > kMost) return fine;
  return fine + (fine - middle) / (std::pow(2.0, order) - 1.0);
}

/// Nodes of the table, or the middles between them.
std::vector<double> nodes(std::vector<double> x, bool between) {
  if (!between) return x;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) x[k] = 0.5 * (x[k] + x[k + 1]);
  x.pop_back();
  return x;
}

}  // namespace

int main(int argc, char** argv) {
  const bool between = argc > 1 && std::strcmp(argv[1], "--between") == 0;
  const std::vector<double> widths =
      nodes({0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0, 1.4, 2.0, 3.0, 5.0, 8.0}, between);
  const std::vector<double> eccentricities =
      nodes({0.01, 0.05, 0.1,  0.15, 0.2,  0.3,  0.4,   0.5,  0.6,   0.7,   0.75,  0.8,   0.85,
             0.9,  0.93, 0.95, 0.96, 0.97, 0.98, 0.985, 0.99, 0.993, 0.995, 0.997, 0.998, 0.999},
            between);
  fmt::print("# Made by make_bearing_table: see docs/auto-tier.md. Do not edit.\n");
  fmt::print("B_over_D,eps,so,attitude_deg,couette,side,p_max,largest_extrapolation\n");
  for (const double b : widths) {
    for (const double eps : eccentricities) {
      const Solution s = solve_tier(plain_bearing(eps, b), Tier::isothermal);
      if (!s.verdict.good() || s.levels.size() < 3) {
        fmt::print(stderr, "B/D {} eps {}: {}\n", b, eps, app::reason_of(s.verdict));
        return 3;
      }
      const std::size_t n = s.levels.size();
      Row coarse = numbers_of(s.levels[n - 3].quantities, eps, b);
      Row middle = numbers_of(s.levels[n - 2].quantities, eps, b);
      Row fine = numbers_of(s.levels[n - 1].quantities, eps, b);
      double largest = 0.0;
      Row row;
      for (int k = 0; k < kNumbers; ++k) {
        number(row, k) = limit(number(coarse, k), number(middle, k), number(fine, k));
        largest = std::max(largest, std::abs(number(row, k) / number(fine, k) - 1.0));
      }
      fmt::print("{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.1e}\n", b, eps, row.so, row.attitude,
                 row.couette, row.side, row.pressure, largest);
      std::fflush(stdout);
    }
  }
  return 0;
}
